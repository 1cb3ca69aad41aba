/**
 * In Node the program plans by itself: whoever wants it otherwise has worker threads.
 */
export function startWorker() {
  throw new Error('there is no worker here');
}
