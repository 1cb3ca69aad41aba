// The playhead: what happens at the end, speed, frames at times, typed frames.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Player } from '../../www/core/player.js';
import { advance, allTimes, frameAt, keyFrameFrames } from '../../www/core/playhead.js';
import { createStore } from '../../www/core/store.js';
import { readFrame } from '../../www/bar/frame-field.js';

/** A page's clock that the test winds. */
function clock() {
  let waiting = null;
  let now = 1000;
  globalThis.document = { hidden: false, addEventListener() {} };
  globalThis.requestAnimationFrame = (step) => {
    waiting = step;
    return 1;
  };
  return {
    /** Pictures are 50 ms apart. */
    tick(times) {
      for (let i = 0; i < times; i++) {
        const step = waiting;
        waiting = null;
        step?.((now += 50));
      }
    },
    get rests() {
      return waiting === null;
    },
  };
}

/** A motion of 101 frames from 2 s to 12 s. */
function opened({ loop, speed = 1, timed = true }) {
  const frames = clock();
  const doc = { version: 1, chains: [], motion: { key_frames: timed ? [{ time: 2 }, { time: 12 }] : [{}, {}] } };
  const store = createStore(doc);
  const player = new Player(store, () => {});
  const time = Float64Array.from({ length: 101 }, (_, i) => (timed ? 2 + i / 10 : i / 100));
  store.setResult({ motion: { frames: 101, time }, doc });
  frames.tick(2);
  player.loop = loop;
  player.playbackRate = speed;
  return { store, player, frames };
}

test('once: stops at the last frame, and begins anew from there', () => {
  const { player, frames } = opened({ loop: 'once' });
  player.frame = 90;
  player.play();
  frames.tick(40);
  assert.equal(player.paused, true);
  assert.equal(player.frame, 100);
  assert.ok(frames.rests, 'and nothing is drawn any more');
  player.play();
  frames.tick(11);
  assert.equal(player.paused, false);
  assert.equal(player.frame, 5);
});

test('loop: from the last frame to the first', () => {
  const { player, frames } = opened({ loop: 'loop' });
  player.frame = 95;
  player.play();
  frames.tick(1 + 20);
  assert.equal(player.frame, 5);
  assert.equal(player.paused, false);
});

test('bounce: to the last frame and back again', () => {
  const { player, frames } = opened({ loop: 'bounce' });
  player.frame = 95;
  player.play();
  frames.tick(1 + 20);
  assert.equal(player.frame, 95);
  frames.tick(10);
  assert.equal(player.frame, 90, 'on its way back');
});

test('the speed is a factor, with times and without', () => {
  const reached = (speed, timed) => {
    const { player, frames } = opened({ loop: 'once', speed, timed });
    player.play();
    frames.tick(1 + 20);
    return player.frame;
  };
  assert.deepEqual([0.5, 1, 2, 4].map((speed) => reached(speed, true)), [5, 10, 20, 40]);
  assert.deepEqual([0.5, 1, 2].map((speed) => reached(speed, false)), [10, 20, 40], 'five seconds from end to end');
});

test('scrubbing and playing end a posture', () => {
  const { store, player } = opened({ loop: 'once' });
  for (const act of [() => player.play(), () => (player.frame = 3), () => (player.currentTime = 1)]) {
    store.setView({ posture: {} });
    act();
    assert.equal(store.view.posture, null);
  }
  assert.equal(player.frame, 10);
});

test('long steps and motions without a length', () => {
  const span = { from: 0, to: 2 };
  const at = (time, forwards = true) => ({ time, forwards });
  assert.deepEqual(advance(at(1), 7.5, { ...span, loop: 'bounce' }), { time: 0.5, forwards: true, ended: false });
  assert.deepEqual(advance(at(1, false), 1.5, { ...span, loop: 'bounce' }), { time: 0.5, forwards: true, ended: false });
  assert.deepEqual(advance(at(1), 7.5, { ...span, loop: 'loop' }), { time: 0.5, forwards: true, ended: false });
  assert.deepEqual(advance(at(1, false), 0.25, { ...span, loop: 'loop' }), { time: 1.25, forwards: true, ended: false });
  for (const loop of ['once', 'loop', 'bounce']) assert.equal(advance(at(3), 1, { from: 3, to: 3, loop }).time, 3);
});

test('frames at times and at key frames', () => {
  const times = [0, 1, 2, 4];
  assert.deepEqual([-1, 0, 0.4, 0.6, 2.9, 3.1, 9].map((time) => frameAt(times, time)), [0, 0, 0, 1, 2, 3, 3]);
  const keys = (all) => keyFrameFrames({ motion: { key_frames: all } }, [0, 0.25, 0.5, 0.75, 1]);
  assert.deepEqual(keys([{}, {}, {}]), [0, 2, 4]);
  assert.deepEqual(keys([{ time: 0 }, { time: 0.7 }, { time: 1 }]), [0, 3, 4]);
});

test('key frames that are not planned have their frames too', () => {
  const time = Float64Array.of(0, 0.25);
  const part = { time, frames: 2, goal_frames: 5, partial: true };
  assert.deepEqual([...allTimes(part)], [0, 0.25, 0.5, 0.75, 1]);
  assert.deepEqual(keyFrameFrames({ motion: { key_frames: [{}, {}, {}] } }, allTimes(part)), [0, 2, 4]);
  assert.equal(allTimes({ ...part, partial: false }), time);
  assert.equal(allTimes({ ...part, time: Float64Array.of(2), frames: 1 }).length, 5);
});

test('a typed frame is taken, or refused in words', () => {
  assert.equal(readFrame(' 12 ', 129), 11);
  assert.equal(readFrame('12 / 129', 129), 11);
  assert.equal(readFrame('200', 129), 'There is no frame 200: type a whole number from 1 to 129.');
  for (const text of ['0', '-1', '1.5', 'x', '1e2']) assert.match(String(readFrame(text, 129)), /There is no frame .* from 1 to 129/);
  assert.match(String(readFrame('', 129)), /^Type a whole number/);
  assert.equal(readFrame('200', 129, 1000), 'Frame 200 is not planned: type a whole number from 1 to 129.');
});

test('a move of the hand and what follows it are one picture; alone it is drawn after a moment', (t) => {
  t.mock.timers.enable({ apis: ['setTimeout'] });
  const { player, frames } = opened({ loop: 'once' });
  let pictures = 0;
  player.draw = () => pictures++;
  player.invalidateSoon();
  frames.tick(1);
  assert.equal(pictures, 0, 'what follows is awaited');
  player.invalidate();
  frames.tick(1);
  t.mock.timers.tick(1000);
  frames.tick(1);
  assert.equal(pictures, 1, 'one picture shows both');
  player.invalidateSoon();
  player.invalidateSoon();
  t.mock.timers.tick(1000);
  frames.tick(2);
  assert.equal(pictures, 2, 'nothing followed');
});
