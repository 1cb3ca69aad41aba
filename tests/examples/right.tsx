// What a TSX page may write.
import 'synthetica/element';
import type {} from 'synthetica/react';

export const right = (
  <synthetica-linkage type="3RPS" controls loop bounce speed={0.5} frame={3} view="top" interaction="none" loading="eager" poster="3rps.png" onframechange={({ detail }) => detail.frame.toFixed()} style={{ height: 300 }} className="wide" />
);
