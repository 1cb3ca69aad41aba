// The planner's worker as a thread of Node: answers the messages that the program posts to it.
import { parentPort } from 'node:worker_threads';
import { buffers } from '../../www/planner/buffers.js';
import { createAnswers } from '../../www/planner/calls.js';

const { receive } = createAnswers((answer) => parentPort.postMessage(answer, buffers(answer)));
parentPort.on('message', receive);
