'use client';
import { useEffect, useRef } from 'react';
import 'synthetica/element';

export function Linkage({ linkage }) {
  const element = useRef(null);
  // React sets no object on an element that the server has rendered.
  useEffect(() => {
    element.current.linkage = linkage;
  }, [linkage]);
  return <synthetica-linkage ref={element} controls />;
}
