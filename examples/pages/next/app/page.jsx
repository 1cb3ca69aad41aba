// A server component: the motion is planned where the page is rendered, the element comes alive in the browser.
import { plan } from 'synthetica';
import linkage from 'synthetica/samples/3rps.json';
import { Linkage } from './linkage';

export default async function Page() {
  const { frames, report } = await plan(linkage);
  return (
    <>
      <h1>Next</h1>
      <p>{`${report.mobility_rank} freedoms, ${frames} frames`}</p>
      <Linkage linkage={linkage} />
    </>
  );
}
