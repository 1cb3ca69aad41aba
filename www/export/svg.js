/**
 * The view as an SVG drawing: ground, shadow, bodies and names as shapes that can be scaled and edited.
 *
 * @typedef {import('./picture.js').Scene} Scene
 * @typedef {import('./picture.js').Wish} Wish
 */
import { DirectionalLight, LineSegments, Vector3 } from 'three';
import { hull } from './hull.js';
import { legendFont, legendShapes } from './legend.js';
import { NAME, dressed, pictureRenderer, placedNames, viewStyle, withoutTools } from './picture.js';
import { cornersOf, eachBody, viewTriangles } from './triangles.js';
import { onlyVisible } from './visible.js';

/** Steps in which the ground's lines fade. */
const FADES = 8;

/** @param {Scene} scene @param {string} title @param {string} description @param {Wish} wish */
export const drawing = (scene, title, description, wish) => dressed(scene, wish.background ?? 'view', () => draw(scene, title, description, wish));

/** @param {Scene} scene @param {string} title @param {string} description @param {Wish} wish */
function draw(scene, title, description, wish) {
  const { width, height, background = 'view', names = true, legend = [] } = wish;
  const style = viewStyle(scene, background);
  /** @type {string[]} */
  const parts = [];
  withoutTools(scene, wish, (camera) => {
    const [ground, ...bodies] = scene.pictured.filter((object) => object.type === 'Group');
    parts.push('<g id="ground">', ...groundLines(ground, camera, width, height), shadow(scene, ground, bodies, camera, width, height), '</g>');
    const { triangles, fronts, veils } = viewTriangles(scene, bodies, camera, width, height);
    const seen = onlyVisible(pictureRenderer(), triangles, camera, width, height);
    // A line of a shape's own colour around it closes the seams to its neighbours.
    parts.push('<g id="linkage" fill="currentColor" stroke="currentColor" stroke-width=".6" stroke-linejoin="round">');
    const shapes = [...[...seen, ...veils].sort((a, b) => b.depth - a.depth), ...fronts];
    for (let at = 0; at < shapes.length; at++) {
      const shape = shapes[at];
      if ('outline' in shape) {
        parts.push(`<path color="${shape.colour}" stroke="none" opacity="${shape.opacity}" d="${path(shape.outline)}"/>`);
        continue;
      }
      let d = '';
      for (let next = shapes[at]; next && 'points' in next && next.colour === shape.colour; next = shapes[++at]) {
        const [ax, ay, bx, by, cx, cy] = next.points;
        d += path([[ax, ay], [bx, by], [cx, cy]]);
      }
      at--;
      parts.push(`<path color="${shape.colour}" d="${d}"/>`);
    }
    parts.push('</g>', `<g id="names" font-family="${escaped(style.font.replace(/^\S+ /, ''))}" font-size="11.5">`);
    const paper = fill(style.paper);
    for (const { text, box, leader } of names ? placedNames(scene, camera, wish, textWidth(style.font)) : []) {
      const [x1, y1, x2, y2] = leader.map(short);
      parts.push(
        `<line x1="${x1}" y1="${y1}" x2="${x2}" y2="${y2}" stroke="${style.ink}" opacity="${NAME.leader}"/>`,
        `<rect x="${short(box.x)}" y="${short(box.y)}" width="${short(box.width)}" height="${NAME.height}" rx="${NAME.corner}" ${paper}/>`,
        `<text x="${short(box.x + box.width / 2)}" y="${short(box.y + 12.5)}" text-anchor="middle" fill="${style.ink}">${escaped(text)}</text>`,
      );
    }
    parts.push(...legendShapes(legend, wish, textWidth(legendFont(style.font)), { ink: style.ink, paper }, escaped), '</g>');
  });
  const stops = style.sky.map((colour, index) => `<stop offset="${index / Math.max(1, style.sky.length - 1)}" stop-color="${colour}"/>`);
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" role="img" aria-labelledby="title description">`,
    `<title id="title">${escaped(title)}</title>`,
    `<desc id="description">${escaped(description)}</desc>`,
    `<defs><linearGradient id="sky" x2="0" y2="1">${stops.join('')}</linearGradient></defs>`,
    ...(background === 'clear' ? [] : [`<rect id="background" width="${width}" height="${height}" fill="${background === 'white' ? '#fff' : 'url(#sky)'}"/>`]),
    ...parts,
    '</svg>\n',
  ].join('\n');
}

/** @param {import('three').Object3D} ground @param {Scene['camera']} camera @param {number} width @param {number} height */
function groundLines(ground, camera, width, height) {
  const lines = ground.children.find((child) => child instanceof LineSegments);
  if (!lines?.visible) return [];
  const position = lines.geometry.getAttribute('position');
  const faded = lines.geometry.getAttribute('color');
  const paths = Array.from({ length: FADES + 1 }, () => '');
  for (let at = 0; at + 1 < position.count; at += 2) {
    const ends = [at, at + 1].map((vertex) => new Vector3().fromBufferAttribute(position, vertex).applyMatrix4(lines.matrixWorld).project(camera));
    const outside = [ends.every(({ x }) => x < -1), ends.every(({ x }) => x > 1), ends.every(({ y }) => y < -1), ends.every(({ y }) => y > 1)];
    if (ends.some(({ z }) => !(z < 1 && z > -1)) || outside.includes(true)) continue;
    const fade = Math.round(((faded.getW(at) + faded.getW(at + 1)) / 2) * FADES);
    paths[fade] += ends.map(({ x, y }, end) => `${'ML'[end]}${short(((x + 1) / 2) * width)} ${short(((1 - y) / 2) * height)}`).join('');
  }
  const colour = `#${lines.material.color.getHexString()}`;
  return paths.map((d, fade) => (d && fade ? `<path fill="none" stroke="${colour}" stroke-width=".8" opacity="${fade / FADES}" d="${d}"/>` : '')).filter(Boolean);
}

/**
 * The shadow on the ground: the outlines of all bodies, along the sun's rays, as one shape.
 * @param {Scene} scene @param {import('three').Object3D} ground @param {import('three').Object3D[]} bodies
 * @param {Scene['camera']} camera @param {number} width @param {number} height
 */
function shadow(scene, ground, bodies, camera, width, height) {
  const sun = scene.pictured.find((object) => object instanceof DirectionalLight);
  if (!sun) return '';
  const ray = sun.target.position.clone().sub(sun.position);
  let d = '';
  eachBody(bodies, (mesh, place) => {
    if (!mesh.castShadow) return;
    const position = mesh.geometry.getAttribute('position');
    const points = [...new Set(cornersOf(mesh.geometry))].map((vertex) => {
      const point = new Vector3().fromBufferAttribute(position, vertex).applyMatrix4(place);
      point.addScaledVector(ray, (ground.position.z - point.z) / ray.z).project(camera);
      return [((point.x + 1) / 2) * width, ((1 - point.y) / 2) * height, point.z];
    });
    if (points.length && points.every(([, , z]) => z < 1 && z > -1)) d += path(hull(points));
  });
  return d && `<path id="shadow" opacity=".16" d="${d}"/>`;
}

/** How wide a text is, in CSS pixels. @param {string} font @returns {(text: string) => number} */
function textWidth(font) {
  const pen = new OffscreenCanvas(1, 1).getContext('2d');
  if (pen) pen.font = font;
  return (text) => pen?.measureText(text).width ?? 0;
}

/** A colour of the style sheet as every reader of SVG knows it. @param {string} colour */
function fill(colour) {
  const pen = new OffscreenCanvas(1, 1).getContext('2d');
  if (!pen) return 'fill="none"';
  pen.fillStyle = colour;
  pen.fillRect(0, 0, 1, 1);
  const [red, green, blue, opacity] = pen.getImageData(0, 0, 1, 1).data;
  return `fill="rgb(${red},${green},${blue})" fill-opacity="${(opacity / 255).toFixed(2)}"`;
}

/** @param {number[][]} points */
const path = (points) => `M${points.map(([x, y]) => `${short(x)} ${short(y)}`).join(' ')}Z`;

/** A tenth of a pixel is enough. @param {number} x */
const short = (x) => String(Math.round(x * 10) / 10);

/** @param {string} text */
const escaped = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;').replace(/[\u0000-\u001f]/g, ' ');
