/** No material shares groups of uniforms with another. */
export function WebGLUniformsGroups() {
  return {
    update() {
      throw new Error('A material has groups of uniforms, which tools/three leaves out.');
    },
    dispose() {},
  };
}
