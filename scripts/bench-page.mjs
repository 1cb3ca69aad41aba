// Prints what the built page costs: bytes, time to the first animated frame, script time per pointer move while
// something is dragged. Run by `scripts/dev.sh bench` after a build; fails only where the bytes are over their budget.
//
// - Bytes: every file that the page asks for until its first motion is drawn and the page is idle, after gzip -9.
//   Files asked for later (`import()`) are listed apart.
// - First animated frame: from the navigation's start to the first frame in which the playhead has moved, by the
//   page's own clock; the median of several loads, each in a fresh context (nothing cached, local server).
// - Script per move: the sum of top-level task time on the main thread that a pointer move costs, from Chromium's
//   trace: all tasks of the page's main thread between two moves, which include event handlers, store, tables, the
//   messages from the worker and the drawing commands; without idle time. Without a graphics card, drawing is done by
//   the processor in another process and is not counted. Throttled by Emulation.setCPUThrottlingRate.
// - Round trip: from posting a call to the worker to its answer, by wrapping Worker.postMessage in the page.
import { readFileSync, readdirSync, statSync } from 'node:fs';
import { extname, join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { chromium } from 'playwright-core';
import { preview } from 'vite';

const BUDGET = 400_000; // bytes after gzip
const LOADS = 7;
const MOVES = 80;
const RATES = [1, 4];

process.chdir(new URL('..', import.meta.url).pathname);
