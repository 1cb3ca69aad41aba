/**
 * The graphics context of a view, given back while the view is out of sight: a browser has few contexts.
 */

/**
 * @param {HTMLCanvasElement} canvas
 * @param {WebGL2RenderingContext} context its context
 */
export function createLease(canvas, context) {
  const extension = context.getExtension('WEBGL_lose_context');
  let seen = true;
  /** Lost because we asked for it; what the browser took, the browser restores. */
  let givenBack = false;
  let asked = false;

  function settle() {
    if (asked || !extension) return;
    const lost = context.isContextLost();
    if (!seen && !lost) {
      asked = givenBack = true;
      extension.loseContext();
    } else if (seen && lost && givenBack) {
      asked = true;
      extension.restoreContext();
    }
  }
  // A context is restored only after the event of its loss has been handled (specification of WEBGL_lose_context), so
  // a view scrolled away and back at once waits for that event, and then for a task after it.
  const told = () =>
    setTimeout(() => {
      asked = false;
      settle();
    });
  canvas.addEventListener('webglcontextlost', told);
  canvas.addEventListener('webglcontextrestored', () => {
    givenBack = false;
    told();
  });

  return {
    /** Whether the context was lost at our own wish, and is not there again. */
    get givenBack() {
      return givenBack;
    },
    /** Whether it can be drawn into. */
    get ready() {
      return seen && !context.isContextLost();
    },
    /** @param {boolean} next whether the view is in sight */
    setSeen(next) {
      seen = next;
      settle();
    },
  };
}
