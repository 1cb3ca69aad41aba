/**
 * Which triangles are seen at all: each is drawn in a colour of its own, and the colours in the picture are counted.
 */
import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, NearestFilter, ShaderMaterial, WebGLRenderTarget } from 'three';

/** Pixels to a CSS pixel: what is narrower than a third of one may be lost. */
const FINE = 3;
const LARGEST = 4096;

/**
 * @param {import('three').WebGLRenderer} renderer
 * @param {import('./triangles.js').Triangle[]} triangles
 * @param {import('./picture.js').Scene['camera']} camera
 * @param {number} width @param {number} height
 */
export function onlyVisible(renderer, triangles, camera, width, height) {
  const fine = Math.min(FINE, LARGEST / Math.max(width, height));
  const size = [Math.round(width * fine), Math.round(height * fine)];
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(triangles.flatMap(({ corners }) => corners)), 3));
  const marks = new Float32Array(9 * triangles.length);
  // The number from 1, in three bytes, at each of the three corners.
  for (let at = 0; at < 3 * triangles.length; at++) {
    const number = Math.floor(at / 3) + 1;
    marks.set([number & 255, (number >> 8) & 255, number >> 16].map((byte) => byte / 255), 3 * at);
  }
  geometry.setAttribute('mark', new BufferAttribute(marks, 3));
  const material = new ShaderMaterial({
    side: DoubleSide,
    vertexShader: 'attribute vec3 mark; flat out vec3 shown; void main() { shown = mark; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }',
    fragmentShader: 'flat in vec3 shown; void main() { gl_FragColor = vec4(shown, 1.0); }',
  });
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  const target = new WebGLRenderTarget(size[0], size[1], { minFilter: NearestFilter, magFilter: NearestFilter });
  renderer.setRenderTarget(target);
  renderer.setClearColor(0, 0);
  renderer.clear();
  renderer.render(mesh, camera);
  const pixels = new Uint8Array(4 * size[0] * size[1]);
  renderer.readRenderTargetPixels(target, 0, 0, size[0], size[1], pixels);
  renderer.setRenderTarget(null);
  for (const made of [geometry, material, target]) made.dispose();
  const seen = new Uint8Array(triangles.length + 1);
  for (let at = 0; at < pixels.length; at += 4) seen[pixels[at] + 256 * pixels[at + 1] + 65536 * pixels[at + 2]] = 1;
  return triangles.filter((_, index) => seen[index + 1]);
}
