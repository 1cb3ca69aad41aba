// Prints what the built page costs, each number with its limit and whether it holds; each part alone by its name, as in
// `node scripts/bench-page.mjs edits use`. Run by `scripts/dev.sh bench` after a build; fails only where bytes or the canvas's
// shares of the window are over their bar: times are of the machine too. How each is measured stands in scripts/bench/, beside
// the limits; how long a plan takes against natively is told by scripts/wasm-ratio.mjs.
import { best } from './bench/best.mjs';
import { canvasShares } from './bench/canvas.mjs';
import { editRatios } from './bench/edits.mjs';
import { firstFrame } from './bench/first-frame.mjs';
import { moves } from './bench/moves.mjs';
import { openBench } from './bench/page.mjs';
import { holds, print } from './bench/print.mjs';
import { transfer } from './bench/transfer.mjs';
import { use } from './bench/use.mjs';

process.chdir(new URL('..', import.meta.url).pathname);

/** @type {Record<string, {measure: (bench: import('./bench/page.mjs').Bench) => Promise<import('./bench/print.mjs').Bar[]>, strict?: true}>} `strict`: it is the same on every machine */
const PARTS = {
  bytes: { measure: transfer, strict: true },
  canvas: { measure: canvasShares, strict: true },
  first: { measure: firstFrame },
  moves: { measure: moves },
  edits: { measure: editRatios },
  best: { measure: best },
  use: { measure: use },
};

const wanted = process.argv.slice(2);
const unknown = wanted.find((name) => !(name in PARTS));
if (unknown) throw new Error(`no measurement is called “${unknown}”: there are ${Object.keys(PARTS).join(', ')}`);

const bench = await openBench();
try {
  for (const [name, { measure, strict }] of Object.entries(PARTS)) {
    if (wanted.length && !wanted.includes(name)) continue;
    const bars = await measure(bench);
    bars.forEach(print);
    if (strict && !bars.every(holds)) process.exitCode = 1;
  }
} finally {
  await bench.close();
}
