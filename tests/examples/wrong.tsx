// What a TSX page may not write.
import 'synthetica/element';
import type {} from 'synthetica/react';

export const wrong = <synthetica-linkage type="3RPS" interaction="some" />;
