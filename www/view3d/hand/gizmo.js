/**
 * The gizmo of arrows, planes and rings that moves or turns a pose, along the axes of the world or its own.
 *
 * @typedef {import('./pointer-drags.js').Pointer} Pointer
 */
import { MathUtils, Mesh, MeshBasicMaterial, Object3D, PerspectiveCamera, Quaternion, Vector3 } from 'three';
import { TransformControls } from 'three/addons/controls/TransformControls.js';
import { Packed } from '../scene/packed.js';

/** From its middle to the ends of its arrows, in pixels, and at most in shares of the view's height. */
const LONG = 90;
const MOST = 0.3;

/** Where an arrow ends in the gizmo's own measure, and its name stands; and how that follows from the camera: as three.js draws it. */
const END = 0.6;
const TIP = 0.7;
const SCREEN_SHARE = 1.9;

/** Cosine between an arrow and the line of sight above which three.js leaves the arrow out. */
const END_ON = 0.99;

/** @param {NonNullable<import('../../element/workbench.js').App['scene']>} scene @param {() => void} follow its move is drawn with what follows it */
export function createGizmo(scene, follow) {
  const handle = new Object3D();
  const controls = new TransformControls(scene.camera, null);
  let moving = false;
  /** While a picture is drawn, which shows its size. */
  let drawn = false;
  controls.addEventListener('change', () => {
    if (moving) follow();
    else if (!drawn) scene.changed();
  });
  scene.root.add(handle, controls.getHelper());
  lighten(/** @type {any} */ (controls)._gizmo, scene);

  /** @param {Pointer} at @param {number} button */
  const pointer = (at, button) => /** @type {any} */ ({ ...at, button });

  /** From its middle to the ends of its arrows. */
  let long = 0;

  return {
    handle,
    /** @param {ArrayLike<number> | null} pose null takes it away */
    show(pose) {
      if (!pose) return controls.detach();
      handle.position.set(pose[0], pose[1], pose[2]);
      handle.quaternion.set(pose[3], pose[4], pose[5], pose[6]);
      if (controls.object !== handle) controls.attach(handle);
    },
    /** @param {{mode: 'translate' | 'rotate', space: 'world' | 'local'}} how */
    set({ mode, space }) {
      controls.mode = mode;
      controls.space = space;
    },
    /** @param {import('../scene/palette.js').Palette} palette */
    paint(palette) {
      controls.setColors(palette['axis-x'], palette['axis-y'], palette['axis-z'], palette.gap);
    },
    /** @returns {number[]} */
    pose: () => [...handle.position.toArray(), ...handle.quaternion.toArray()],
    /** Whether one of its handles is there, which it lights up. @param {Pointer} at */
    hover(at) {
      if (!controls.object) return false;
      controls.pointerHover(pointer(at, 0));
      return controls.axis !== null;
    },
    /** @param {Pointer} at */
    grab: (at) => controls.pointerDown(pointer(at, 0)),
    /** @param {Pointer} at @param {{length: number, angle: number} | null} snap length, degrees */
    move(at, snap) {
      controls.translationSnap = snap?.length ?? null;
      controls.rotationSnap = snap ? MathUtils.degToRad(snap.angle) : null;
      moving = true;
      controls.pointerMove(pointer(at, -1));
      moving = false;
    },
    release: () => controls.pointerUp(pointer({ x: 0, y: 0 }, 0)),
    /** Looks through the scene's present camera, at its size on the screen. @param {number} height of the view, in pixels */
    look(height) {
      const { camera } = scene;
      drawn = true;
      controls.camera = camera;
      const { elements } = camera.projectionMatrix;
      const depth = elements[15] + elements[11] * handle.position.clone().applyMatrix4(camera.matrixWorldInverse).z;
      long = (2 * depth * Math.min(LONG, MOST * height)) / elements[5] / height;
      const unit = camera instanceof PerspectiveCamera ? handle.position.distanceTo(camera.position) * SCREEN_SHARE : 2;
      controls.size = (4 * long * elements[5]) / END / unit;
      drawn = false;
    },
    /** The ends of its arrows, for their names; none for an arrow that is seen end on. @param {'world' | 'local'} space @returns {{at: Vector3, text: string}[]} */
    tips(space) {
      const { camera } = scene;
      const reach = (long * TIP) / END;
      const turn = space === 'local' ? handle.quaternion : new Quaternion();
      const sight = camera instanceof PerspectiveCamera ? handle.position.clone().sub(camera.position).normalize() : camera.getWorldDirection(new Vector3());
      return ['x', 'y', 'z'].flatMap((text, axis) => {
        const along = new Vector3().setComponent(axis, 1).applyQuaternion(turn);
        return Math.abs(along.dot(sight)) > END_ON ? [] : { at: along.multiplyScalar(reach).add(handle.position), text };
      });
    },
  };
}

/**
 * Nothing is scaled, and what moves and turns is drawn as one.
 * @param {Record<'gizmo' | 'picker' | 'helper', Record<'translate' | 'rotate' | 'scale', Object3D>>} gizmo of three.js
 * @param {Pick<NonNullable<import('../../element/workbench.js').App['scene']>, 'drawAsOne'>} scene
 */
function lighten({ gizmo, picker, helper }, { drawAsOne }) {
  for (const { scale } of [gizmo, picker, helper]) scale.removeFromParent();
  /** @type {Set<import('three').Material>} */
  const materials = new Set();
  for (const handles of [gizmo.translate, gizmo.rotate, helper.translate]) handles.traverse((part) => part instanceof Mesh && materials.add(part.material));
  const packed = new Packed(new MeshBasicMaterial({ depthTest: false, depthWrite: false, transparent: true }));
  packed.renderOrder = Infinity;
  drawAsOne(packed, [...materials]);
}
