import { FloatType, HalfFloatType, LinearFilter, RGBAFormat, RGFormat, UnsignedByteType } from 'three/src/constants.js';

/**
 * The textures that there are: a table of the lit materials, the places of packed bodies, which are others in each picture, the
 * depths of shadows, and pictures that are read back. None has smaller copies of itself, and none is drawn with several samples.
 */
export function WebGLTextures(gl, extensions, state, properties, capabilities, utils, info) {
  const made = new Set();
  let units = 0;

  /** @param {import('three').Texture} texture */
  function filter({ magFilter, minFilter, compareFunction }) {
    const set = (name, value) => gl.texParameteri(gl.TEXTURE_2D, name, value);
    for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) set(name, gl.CLAMP_TO_EDGE);
    set(gl.TEXTURE_MAG_FILTER, magFilter === LinearFilter ? gl.LINEAR : gl.NEAREST);
    set(gl.TEXTURE_MIN_FILTER, minFilter === LinearFilter ? gl.LINEAR : gl.NEAREST);
    if (!compareFunction) return;
    set(gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE);
    // The library's numbers are those of WebGL.
    set(gl.TEXTURE_COMPARE_FUNC, compareFunction);
  }

  function forget({ target }) {
    target.removeEventListener('dispose', forget);
    made.delete(target);
    const own = properties.get(target);
    if (own.__webglTexture) {
      gl.deleteTexture(own.__webglTexture);
      info.memory.textures--;
    }
    if (own.__webglFramebuffer) gl.deleteFramebuffer(own.__webglFramebuffer);
    if (own.__webglDepthbuffer) gl.deleteRenderbuffer(own.__webglDepthbuffer);
    if (target.isRenderTarget) for (const texture of [target.texture, target.depthTexture]) if (texture) forget({ target: texture });
    properties.remove(target);
  }

  /** How a texture lies in the graphics card, and how what is given to it does. @param {import('three').Texture} texture */
  function formOf({ format, type, isDepthTexture, isRenderTargetTexture }) {
    if (isDepthTexture) return [gl.DEPTH_COMPONENT24];
    if (format === RGFormat && type === HalfFloatType) return [gl.RG16F, gl.RG, gl.HALF_FLOAT];
    if (format === RGBAFormat && type === FloatType) return [gl.RGBA32F, gl.RGBA, gl.FLOAT];
    if (isRenderTargetTexture && type === UnsignedByteType) return [gl.RGBA8];
    throw new Error('A texture has a form that tools/three leaves out.');
  }

  /** Bound, with its contents: new where its size is. @param {import('three').Texture} texture */
  function load(texture, slot, { width, height, data }) {
    const own = properties.get(texture);
    const [within, given, type] = formOf(texture);
    own.__version = texture.version;
    const size = `${width} ${height}`;
    const isThere = own.__webglTexture && own.size === size;
    if (!isThere) {
      if (own.__webglTexture) gl.deleteTexture(own.__webglTexture);
      else {
        texture.addEventListener('dispose', forget);
        made.add(texture);
        info.memory.textures++;
      }
      own.__webglTexture = gl.createTexture();
      own.size = size;
    }
    state.bindTexture(gl.TEXTURE_2D, own.__webglTexture, gl.TEXTURE0 + slot);
    if (!isThere) {
      filter(texture);
      gl.texStorage2D(gl.TEXTURE_2D, 1, within, width, height);
    }
    if (!data) return;
    state.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    state.pixelStorei(gl.UNPACK_ALIGNMENT, 4);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, given, type, data);
  }

  const textures = {
    allocateTextureUnit: () => units++,
    resetTextureUnits() {
      units = 0;
    },
    getTextureUnits: () => units,
    setTextureUnits(value) {
      units = value;
    },
    setTexture2D(texture, slot) {
      const own = properties.get(texture);
      if (!texture.isRenderTargetTexture && texture.version > 0 && own.__version !== texture.version) load(texture, slot, texture.image);
      else state.bindTexture(gl.TEXTURE_2D, own.__webglTexture, gl.TEXTURE0 + slot);
    },
    setupRenderTarget(target) {
      const { width, height, texture, depthTexture } = target;
      if (target.samples > 0 || target.textures.length > 1) throw new Error('A target of pictures has a form that tools/three leaves out.');
      target.addEventListener('dispose', forget);
      made.add(target);
      const own = properties.get(target);
      own.__webglFramebuffer = gl.createFramebuffer();
      load(texture, 0, { width, height });
      state.bindFramebuffer(gl.FRAMEBUFFER, own.__webglFramebuffer);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, properties.get(texture).__webglTexture, 0);
      if (depthTexture) {
        own.__boundDepthTexture = depthTexture;
        load(depthTexture, 0, { width, height });
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, properties.get(depthTexture).__webglTexture, 0);
      } else if (target.depthBuffer) {
        own.__webglDepthbuffer = gl.createRenderbuffer();
        gl.bindRenderbuffer(gl.RENDERBUFFER, own.__webglDepthbuffer);
        gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT24, width, height);
        gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, own.__webglDepthbuffer);
      }
      state.unbindTexture();
      state.bindFramebuffer(gl.FRAMEBUFFER, null);
    },
    updateMultisampleRenderTarget() {},
    updateRenderTargetMipmap() {},
    dispose() {
      for (const target of [...made]) if (made.has(target)) forget({ target });
    },
  };
  for (const name of ['setTexture3D', 'setTexture2DArray', 'setTextureCube', 'rebindTextures']) {
    textures[name] = () => {
      throw new Error(`The renderer calls ${name}, which tools/three leaves out.`);
    };
  }
  textures.setupDepthRenderbuffer = () => {};
  return textures;
}
