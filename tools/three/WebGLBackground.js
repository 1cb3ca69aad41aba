/** What is behind all: nothing, through which the page is seen. */
export function WebGLBackground(renderer, environments, state, objects, alpha, premultipliedAlpha) {
  let clearAlpha = alpha ? 0 : 1;
  const setClear = () => state.buffers.color.setClear(0, 0, 0, clearAlpha, premultipliedAlpha);
  return {
    getClearColor: () => ({ r: 0, g: 0, b: 0 }),
    getClearAlpha: () => clearAlpha,
    setClearColor(color, opacity = 1) {
      if (color !== 0) throw new Error('The renderer is given a background, which tools/three leaves out.');
      clearAlpha = opacity;
      setClear();
    },
    render(scene) {
      if (scene.background) throw new Error('The scene has a background, which tools/three leaves out.');
      setClear();
      if (!renderer.autoClear) return;
      // What is not written to is not cleared.
      state.buffers.depth.setTest(true);
      state.buffers.depth.setMask(true);
      state.buffers.color.setMask(true);
      renderer.clear();
    },
    addToRenderList() {},
    dispose() {},
  };
}
