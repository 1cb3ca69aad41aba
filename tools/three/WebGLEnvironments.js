/** No material reflects a picture of what is around, and the background is a colour. */
export function WebGLEnvironments() {
  return {
    get(texture) {
      if (texture?.isTexture) throw new Error('A material or the background has a picture, which tools/three leaves out.');
      return texture;
    },
    dispose() {},
  };
}
