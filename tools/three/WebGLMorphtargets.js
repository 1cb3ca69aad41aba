/** No body has morph targets. */
export function WebGLMorphtargets() {
  return {
    update() {
      throw new Error('A body has morph targets, which tools/three leaves out.');
    },
  };
}
