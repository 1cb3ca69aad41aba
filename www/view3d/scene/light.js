/**
 * Light: a sky, a sun that casts shadows, and a weak light beside the camera, so that what the sun does not reach keeps its shape.
 */
import { DirectionalLight, HemisphereLight, Vector3 } from 'three';

/** How far beside a surface its shadow is looked up, as a share of the scene's radius: less shows stripes, more detaches shadows. */
const NORMAL_BIAS = 0.01;

/** @param {boolean} shadows whether the first picture has them */
export function createLight(shadows) {
  const sky = new HemisphereLight(0xffffff, 0xb9b4ac, 1.6);
  sky.position.set(0, 0, 1);
  const sun = new DirectionalLight(0xffffff, 2.0);
  sun.castShadow = shadows;
  sun.shadow.mapSize.set(1024, 1024);
  sun.shadow.radius = 5;
  sun.shadow.bias = -0.0006;

  const fill = new DirectionalLight(0xffffff, 0.9);
  fill.target = sun.target;

  return {
    objects: [sky, sun, sun.target, fill],
    sun,
    sky,
    /** @param {Vector3} centre @param {number} radius of what is lit */
    aim(centre, radius) {
      sun.position.copy(centre).add(new Vector3(0.9, -0.7, 2.2).multiplyScalar(radius * 1.6));
      sun.target.position.copy(centre);
      sun.shadow.normalBias = NORMAL_BIAS * radius;
      const reach = 1.7 * radius;
      Object.assign(sun.shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach, near: 0.1 * radius, far: 9 * radius });
      sun.shadow.camera.updateProjectionMatrix();
    },
    /** Called at every draw. @param {import('three').Camera} camera @param {boolean} shadows whether this picture has them */
    beforeDraw({ position, matrixWorld }, shadows) {
      // From the left of the camera, as far as it is away: the sun stands on the right of the view that is seen first.
      const left = new Vector3().setFromMatrixColumn(matrixWorld, 0).negate();
      fill.position.copy(position).addScaledVector(left, position.distanceTo(fill.target.position));
      sun.castShadow = shadows;
    },
  };
}
