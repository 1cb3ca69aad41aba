// A motion on which a slider runs away: the package that is loaded first leaves it to the whole one, which looks for a finite pose.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { createAnswers } from '../../www/planner/calls.js';

const at = (path) => new URL(`../../${path}`, import.meta.url);
const packages = await Promise.all(['pkg-first', 'pkg'].map((folder) => import(at(`www/${folder}/synthetica.js`))));
const [first, whole] = packages;
['pkg-first', 'pkg'].forEach((folder, i) => packages[i].initSync({ module: readFileSync(at(`www/${folder}/synthetica_bg.wasm`)) }));
/** With 15 digits: the first package reads no more. */
const rounded = (_, value) => (typeof value === 'number' ? Number(value.toPrecision(15)) : value);
const text = JSON.stringify(JSON.parse(readFileSync(at('tests/field/runaway-606.json'), 'utf8'), rounded));

test('it is planned by the whole package, from the first question on', async () => {
  const answered = new Map();
  const { receive } = createAnswers((answer) => {
    if (!['received', 'begun', 'progress'].includes(answer.kind)) answered.get(answer.id)(answer);
  });
  const ask = (id, call, about) =>
    new Promise((resolve) => {
      answered.set(id, resolve);
      receive({ kind: 'ask', id, call, args: [], ...about });
    });
  const session = first.Session.open(text);
  assert.throws(() => session.plan(), (error) => error === null);
  assert.throws(() => session.advance_plan(1000), (error) => error === null);
  const { value: motion } = await ask(1, 'plan', { doc: 1, text });
  const wanted = whole.Session.open(text).plan();
  assert.deepEqual([...motion.joints], [...wanted.joints]);
  // By a closed walk: f at frame 3 is 0.0217 on the followed branch, where the slider runs away.
  assert.ok(motion.metric[3] < 0.0022, `${motion.metric[3]}`);
  assert.ok(motion.report.warnings.every(({ message }) => message));
  // Asked again it is the same.
  const { value: again } = await ask(2, 'plan', { doc: 1 });
  assert.deepEqual([...again.joints], [...wanted.joints]);
});
