'use client';
import 'synthetica/element';

export function Linkage({ linkage }) {
  return <synthetica-linkage linkage={linkage} controls />;
}
