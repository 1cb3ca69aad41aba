import { useState } from 'react';
import { createRoot } from 'react-dom/client';
import 'synthetica/element';
import type {} from 'synthetica/react';
import linkage from 'synthetica/samples/3rps.json';

function Page() {
  const [frame, setFrame] = useState(0);
  return (
    <>
      <h1>React</h1>
      <synthetica-linkage linkage={linkage} controls onframechange={(event) => setFrame(event.detail.frame)} />
      <p>Frame {frame}</p>
    </>
  );
}

createRoot(document.getElementById('root')!).render(<Page />);
