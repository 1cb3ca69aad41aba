/** Pictures of more than 8 bits a colour and effects on the whole picture: the renderer is not asked for them. */
export class WebGLOutput {
  constructor() {
    throw new Error('The renderer was asked for an output buffer that tools/three leaves out.');
  }
}
