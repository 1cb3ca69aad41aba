/**
 * What is drawn into in place of the canvas where edges are to be smooth: a framebuffer with several samples to a pixel, of which the
 * canvas gets the mean. A canvas of its own accord has either always several or never, and without a graphics card they take as
 * long as all else of a picture.
 */
import { SRGBColorSpace, WebGLRenderTarget } from 'three';

/** To a pixel, as browsers have it. */
const SAMPLES = 4;

/** @param {import('three').WebGLRenderer} renderer @param {WebGL2RenderingContext} gl its context */
export function createSmoothScreen(renderer, gl) {
  // Its types leave this method out.
  const { setRenderTargetFramebuffer } = /** @type {import('three').WebGLRenderer & {setRenderTargetFramebuffer: (target: WebGLRenderTarget, framebuffer: WebGLFramebuffer) => void}} */ (renderer);
  const target = /** @type {WebGLRenderTarget & {isXRRenderTarget?: boolean}} */ (new WebGLRenderTarget(1, 1, { colorSpace: SRGBColorSpace }));
  // What is drawn into it has the colours that the canvas has, and the same programs: so three.js has it for framebuffers of others.
  target.isXRRenderTarget = true;
  target.scissorTest = true;
  const { FRAMEBUFFER, READ_FRAMEBUFFER, RENDERBUFFER } = gl;
  /** @type {WebGLFramebuffer | null} */
  let framebuffer = null;
  /** @type {(WebGLRenderbuffer | null)[]} */
  let buffers = [];
  let [width, height] = [0, 0];

  /** A context that comes back has none of what was made in it. */
  function forget() {
    for (const buffer of buffers) gl.deleteRenderbuffer(buffer);
    gl.deleteFramebuffer(framebuffer);
    framebuffer = null;
  }
  gl.canvas.addEventListener('webglcontextrestored', () => (framebuffer = null));

  /** As large as the canvas. */
  function reserve() {
    const { drawingBufferWidth, drawingBufferHeight } = gl;
    if (framebuffer && width === drawingBufferWidth && height === drawingBufferHeight) return;
    [width, height] = [drawingBufferWidth, drawingBufferHeight];
    if (framebuffer) forget();
    framebuffer = gl.createFramebuffer();
    setRenderTargetFramebuffer(target, /** @type {WebGLFramebuffer} */ (framebuffer));
    renderer.setRenderTarget(target);
    const samples = Math.min(SAMPLES, gl.getParameter(gl.MAX_SAMPLES));
    buffers = [
      [gl.RGBA8, gl.COLOR_ATTACHMENT0],
      [gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT],
    ].map(([format, place]) => {
      const buffer = gl.createRenderbuffer();
      gl.bindRenderbuffer(RENDERBUFFER, buffer);
      gl.renderbufferStorageMultisample(RENDERBUFFER, samples, format, width, height);
      gl.framebufferRenderbuffer(FRAMEBUFFER, place, RENDERBUFFER, buffer);
      return buffer;
    });
  }

  return {
    /** What is drawn next comes into this part of it, in pixels from the lower left. @param {number} x @param {number} y @param {number} across @param {number} up */
    begin(x, y, across, up) {
      reserve();
      target.viewport.set(x, y, across, up);
      target.scissor.copy(target.viewport);
      renderer.setRenderTarget(target);
    },
    /** The same part of the canvas gets what was drawn. */
    end() {
      const { x, y, z, w } = target.viewport;
      const part = /** @type {const} */ ([x, y, x + z, y + w]);
      renderer.setRenderTarget(null);
      // The canvas's own scissor cuts what is copied too, and belongs to what was last drawn without this: to nothing yet, or to
      // another view.
      renderer.setScissorTest(false);
      gl.bindFramebuffer(READ_FRAMEBUFFER, framebuffer);
      gl.blitFramebuffer(...part, ...part, gl.COLOR_BUFFER_BIT, gl.NEAREST);
      gl.bindFramebuffer(READ_FRAMEBUFFER, null);
      renderer.setScissorTest(true);
    },
  };
}
