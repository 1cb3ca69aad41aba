/** Shadows of lamps that shine to all sides: there are none. */
export class WebGLCubeRenderTarget {
  constructor() {
    throw new Error('A light casts shadows to all sides, which tools/three leaves out.');
  }
}
