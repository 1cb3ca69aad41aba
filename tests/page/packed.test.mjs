// Bodies that are drawn as one: where each is, what it looks like, what costs nothing; and what waits for rest.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { BoxGeometry, FrontSide, Group, InstancedMesh, Mesh, MeshBasicMaterial, MeshStandardMaterial, Raycaster, Scene, SphereGeometry, Vector3 } from 'three';
import { Packed, pack } from '../../www/view3d/scene/packed.js';
import { createRest } from '../../www/view3d/scene/rest.js';

/** A scene with bodies of two materials in a group, and what draws them. */
function twoBodies() {
  const [red, blue] = [new MeshStandardMaterial({ color: 0xff0000, roughness: 0.25, metalness: 0.5 }), new MeshBasicMaterial({ color: 0x0000ff, opacity: 0.5 })];
  const root = new Scene();
  const group = new Group();
  const [box, ball] = [new Mesh(new BoxGeometry(), red), new Mesh(new SphereGeometry(1, 8, 6).toNonIndexed(), blue)];
  root.add(group.add(box, ball));
  const packed = new Packed(new MeshStandardMaterial(), { shadows: true });
  root.add(packed);
  const draw = () => {
    root.updateMatrixWorld();
    pack(root, new Map([[red, packed], [blue, packed]]));
  };
  const shader = { uniforms: {}, vertexShader: '#include <beginnormal_vertex> #include <begin_vertex>', fragmentShader: '#include <color_fragment>' };
  packed.material.onBeforeCompile(shader, null);
  /** The numbers of a part, as the shader has them. */
  const texel = (part, which) => [...shader.uniforms.parts.value.image.data.slice(4 * (5 * part + which), 4 * (5 * part + which) + 4)];
  /** Where a corner is drawn, as the shader works it out. */
  const placeOf = (corner) => {
    const { position, part } = packed.geometry.attributes;
    const columns = [0, 1, 2, 3].map((which) => new Vector3(...texel(part.getX(corner), which)));
    const at = [position.getX(corner), position.getY(corner), position.getZ(corner), 1];
    return columns.reduce((sum, column, i) => sum.addScaledVector(column, at[i]), new Vector3()).add(packed.position);
  };
  return { root, group, box, ball, packed, draw, shader, texel, placeOf };
}

test('every corner is drawn where its body has it, also far from the origin', () => {
  const { group, box, ball, packed, draw, placeOf } = twoBodies();
  group.position.set(1e6, -2e6, 0);
  group.rotation.set(0.3, 0.2, 0.1);
  box.scale.set(3, 1, 0.2);
  ball.position.set(1, 2, 3);
  draw();
  let corner = 0;
  for (const { geometry, matrixWorld } of [box, ball]) {
    for (let own = 0; own < geometry.attributes.position.count; own++, corner++) {
      const wanted = new Vector3().fromBufferAttribute(geometry.attributes.position, own).applyMatrix4(matrixWorld);
      assert.ok(wanted.distanceTo(placeOf(corner)) < 1e-6, `corner ${corner}`);
    }
  }
  assert.equal(corner, packed.geometry.attributes.position.count);
  assert.equal(packed.geometry.index.count, box.geometry.index.count + ball.geometry.attributes.position.count);
  assert.ok(packed.geometry.index.array.every((at) => at < corner));
});

test('each has its own colour and look, and follows what changes', () => {
  const { box, ball, packed, draw, texel } = twoBodies();
  draw();
  assert.deepEqual([texel(0, 0)[3], texel(0, 1)[3], texel(0, 2)[3]], [0.25, 0.5, 1]);
  assert.deepEqual(texel(0, 4).slice(0, 3), [1, 0, 0]);
  assert.deepEqual([texel(1, 2)[3], ...texel(1, 4).slice(0, 3)], [0.5, 0, 0, 1]);
  const { geometry } = packed;
  box.material.color.set(0x00ff00);
  ball.visible = false;
  draw();
  assert.deepEqual(texel(0, 4).slice(0, 3), [0, 1, 0]);
  assert.deepEqual([0, 1, 2, 3].map((which) => texel(1, which)), Array(4).fill([0, 0, 0, 0]), 'what is not seen has no size');
  assert.equal(packed.geometry, geometry, 'nothing is laid anew for that');
  box.geometry = new BoxGeometry(2, 2, 2);
  draw();
  assert.notEqual(packed.geometry, geometry);
});

test('what can be looked through is drawn after what is solid, whatever their order in the scene', () => {
  const { group, box, ball, draw, texel } = twoBodies();
  group.remove(box);
  group.add(box);
  draw();
  assert.deepEqual(group.children, [ball, box]);
  assert.deepEqual([texel(0, 2)[3], texel(1, 2)[3]], [1, 0.5]);
});

test('bodies cast shadows by the sides that are turned away from the light: no stripes on those that it shines on', () => {
  const { packed } = twoBodies();
  assert.ok(packed.castShadow && packed.customDepthMaterial);
  assert.equal(packed.material.side, FrontSide);
  assert.equal(packed.material.shadowSide, null, 'of a body seen from its front the back casts them');
});

test('thousands of bodies are drawn, in a texture that every graphics card takes', () => {
  const { group, box, packed, draw, shader } = twoBodies();
  const many = Array.from({ length: 3000 }, (_, i) => {
    const one = new Mesh(box.geometry, box.material);
    one.position.set(i, 2 * i, 0);
    return one;
  });
  group.add(...many);
  draw();
  const { width, height, data } = shader.uniforms.parts.value.image;
  assert.ok(width <= 2048 && height <= 2048 && data.length === 4 * width * height, `${width} × ${height}`);
  const { part } = packed.geometry.attributes;
  const numbers = new Set(part.array);
  assert.equal(numbers.size, 3002);
  for (const [i, one] of many.entries()) {
    // The ball, which can be looked through, comes last.
    const own = 1 + i;
    const at = 4 * ((own % 1024) * width + 5 * Math.floor(own / 1024) + 3);
    assert.deepEqual([...data.slice(at, at + 3)], new Vector3().setFromMatrixPosition(one.matrixWorld).sub(packed.position).toArray(), `body ${i}`);
  }
});

test('what is drawn packed is not drawn by itself, and can still be pointed at; other things are left as they are', () => {
  const { root, group, box, ball, packed, draw } = twoBodies();
  const other = new InstancedMesh(new BoxGeometry(), new MeshBasicMaterial(), 1);
  group.add(other);
  draw();
  assert.deepEqual([box, ball, other, packed].map(({ layers }) => layers.isEnabled(0)), [false, false, true, true]);
  const ray = new Raycaster(new Vector3(0, 0, 9), new Vector3(0, 0, -1));
  ray.layers.enableAll();
  assert.ok(ray.intersectObjects([group]).some(({ object }) => object === box));
  assert.deepEqual(ray.intersectObjects([packed]), []);
  group.visible = false;
  draw();
  assert.ok(!packed.visible);
  root.remove(group);
  draw();
  assert.ok(!packed.visible, 'without parts there is nothing to draw');
});

test('without a graphics card a picture has shadows and smooth edges once nothing has moved for a while and no pointer is down', (t) => {
  t.mock.timers.enable({ apis: ['setTimeout'] });
  let again = 0;
  let held = true;
  const slow = createRest(true, () => again++, () => held);
  assert.deepEqual([slow.next(), slow.next()], [false, false]);
  t.mock.timers.tick(1000);
  assert.equal(again, 0);
  held = false;
  t.mock.timers.tick(250);
  assert.equal(again, 1);
  assert.deepEqual([slow.next(), slow.next()], [true, false], 'one picture, then it moves again');
  const quick = createRest(false, () => again++, () => held);
  assert.deepEqual([quick.next(), quick.next()], [true, true]);
  t.mock.timers.tick(200);
  assert.equal(again, 1);
});
