/**
 * The camera: orbit, pan and zoom by mouse, touch and keyboard.
 */
import { MathUtils, PerspectiveCamera, Spherical, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

/** Degrees of one arrow key's turn, share of one key's zoom. */
const TURN = 6;
const ZOOM = 0.9;

/** From where the scene is first seen: in front, to the right, from above. */
const FIRST_VIEW = new Vector3(0.78, -1, 0.62);

/** @param {HTMLCanvasElement} canvas @param {() => void} changed */
export function createCamera(canvas, changed) {
  const camera = new PerspectiveCamera(30, 1, 0.01, 1000);
  camera.up.set(0, 0, 1);
  const controls = new OrbitControls(camera, canvas);
  controls.addEventListener('change', changed);
  controls.maxPolarAngle = Math.PI * 0.98;

  /** @param {number} right @param {number} up in degrees */
  function orbit(right, up) {
    // Spherical measures from y; the scene's up is z.
    const arm = camera.position.clone().sub(controls.target);
    const place = new Spherical().setFromVector3(new Vector3(arm.x, arm.z, -arm.y));
    place.theta += right * MathUtils.DEG2RAD;
    place.phi = MathUtils.clamp(place.phi - up * MathUtils.DEG2RAD, 0.01, Math.PI - 0.01);
    arm.setFromSpherical(place);
    camera.position.set(arm.x, -arm.z, arm.y).add(controls.target);
    controls.update();
  }

  /** @param {number} factor */
  function zoom(factor) {
    camera.position.sub(controls.target).multiplyScalar(factor).add(controls.target);
    controls.update();
  }

  /** @param {number} right @param {number} up in shares of the view */
  function pan(right, up) {
    const reach = camera.position.distanceTo(controls.target) * Math.tan((camera.fov / 2) * MathUtils.DEG2RAD) * 2;
    const move = new Vector3(right * reach, up * reach, 0).applyQuaternion(camera.quaternion);
    camera.position.add(move);
    controls.target.add(move);
    controls.update();
  }

  const home = { centre: new Vector3(), radius: 1 };
  function fit() {
    const narrow = Math.min(1, camera.aspect);
    const distance = home.radius / (Math.sin((camera.fov / 2) * MathUtils.DEG2RAD) * narrow);
    controls.target.copy(home.centre);
    camera.position.copy(FIRST_VIEW).normalize().multiplyScalar(distance).add(home.centre);
    camera.near = home.radius / 100;
    camera.far = home.radius * 100;
    camera.updateProjectionMatrix();
    controls.update();
    changed();
  }

  canvas.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const turn = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (turn && event.shiftKey) pan(turn[0] * 0.05, turn[1] * 0.05);
    else if (turn) orbit(turn[0] * TURN, turn[1] * TURN);
    else if (event.key === '+' || event.key === '=') zoom(ZOOM);
    else if (event.key === '-') zoom(1 / ZOOM);
    else if (event.key === 'Home') fit();
    else return;
    event.preventDefault();
  });

  return {
    camera,
    controls,
    fit,
    /** What `fit` shows. @param {Vector3} centre @param {number} radius */
    setHome(centre, radius) {
      home.centre.copy(centre);
      home.radius = radius;
    },
    /** @param {number} aspect */
    setAspect(aspect) {
      camera.aspect = aspect;
      camera.updateProjectionMatrix();
    },
  };
}
