/**
 * The camera: orbit, pan and zoom by mouse, touch and keyboard; perspective or parallel; moves that take a moment.
 *
 * @typedef {object} Look from where the scene is seen
 * @property {number} around radians about z, from the front towards the right
 * @property {number} down radians from straight above
 * @property {number} reach half the height of the view at the target, in lengths
 * @property {Vector3} target
 * @property {number} right where the target is seen, from the middle of the view, in shares of its width
 * @property {number} low the same downwards, in shares of its height
 */
import { OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';
import { STANDARD_VIEWS } from '../../core/standard-views.js';
import { onKeys } from '../../ui/keys.js';
import { aside, enclose, filled } from './enclosing.js';
import { createGlide } from './glide.js';
import { createOrbit } from './orbit.js';
import { hasLeft, showsWell } from './refit.js';

/** Radians of one arrow key's turn, share of the view of its shift, share of one key's zoom. */
const TURN = Math.PI / 30;
const SHIFT = 0.05;
/** Where each arrow key goes, in the order of the list of keys. */
const ARROWS = [[-1, 0], [1, 0], [0, 1], [0, -1]];
const ZOOM = 0.9;

/** The least and the most that the view may reach, and how far its target may go, in radii of the scene. */
const NEAREST = 0.02;
const FARTHEST = 12;
const FARTHEST_TARGET = 6;

/** Half the height of the view at distance 1. */
const SLOPE = Math.tan(Math.PI / 12);

/** @param {number} value @param {number} low @param {number} high */
const clamp = (value, low, high) => Math.max(low, Math.min(high, value));

/** Straight above and below, the view still needs to know what is up. */
const UPRIGHT = 1e-4;

/** Towards the camera. @param {number} around @param {number} down */
const armOf = (around, down) => new Vector3(Math.sin(down) * Math.sin(around), -Math.sin(down) * Math.cos(around), Math.cos(down));

/**
 * @param {HTMLCanvasElement} canvas @param {() => void} changed @param {() => void} turned by a person's hand
 * @param {() => import('./label-layout.js').Box} free the part of the view, in shares of it, into which the scene is fitted
 */
export function createCamera(canvas, changed, turned, free) {
  const perspective = new PerspectiveCamera(30, 1, 0.01, 1000);
  const parallel = new OrthographicCamera();
  for (const camera of [perspective, parallel]) camera.up.set(0, 0, 1);
  /** @type {PerspectiveCamera | OrthographicCamera} */
  let camera = perspective;
  /** What it turns about. */
  const aim = new Vector3();
  /** @type {import('./measure.js').Home} */
  let home = { centre: new Vector3(), radius: 1, each: () => {}, margin: 0 };
  const middle = { right: 0, low: 0 };
  /** The ball that the view was fitted to. */
  const fitted = { centre: new Vector3(), radius: 1 };
  /** It is as it was fitted: no hand has shifted it or come closer. */
  let untouched = false;
  const calm = matchMedia('(prefers-reduced-motion: reduce)');
  const glide = createGlide();

  const controls = createOrbit(canvas, {
    start() {
      turned();
      untouched = false;
      glide.stop();
    },
    turn(right, down) {
      const from = look();
      take({ ...from, around: from.around - 2 * Math.PI * right, down: from.down - 2 * Math.PI * down });
    },
    shift: (right, down) => take({ ...look(), target: shift(-right, down) }),
    zoom(times) {
      const from = look();
      take({ ...from, reach: from.reach * times });
    },
  });

  /** Near and far around the scene, wherever the camera is. */
  function clip() {
    const distance = camera.position.distanceTo(aim);
    perspective.near = Math.min(distance, home.radius) / 100;
    perspective.far = distance + 60 * home.radius;
    parallel.near = -60 * home.radius;
    parallel.far = perspective.far;
    camera.updateProjectionMatrix();
  }

  /** @returns {Look} */
  function look() {
    const arm = camera.position.clone().sub(aim);
    const distance = arm.length();
    return {
      around: Math.atan2(arm.x, -arm.y),
      down: Math.acos(clamp(arm.z / distance, -1, 1)),
      reach: camera === parallel ? parallel.top / parallel.zoom : distance * SLOPE,
      target: aim.clone(),
      ...middle,
    };
  }

  /** @param {Look} look */
  function take({ around, down, reach, target, right, low }) {
    const kept = clamp(reach, NEAREST * home.radius, FARTHEST * home.radius);
    const tilt = clamp(down, UPRIGHT, Math.PI - UPRIGHT);
    Object.assign(middle, { right, low });
    for (const one of [perspective, parallel]) one.view = { enabled: true, fullWidth: 1, fullHeight: 1, offsetX: -right, offsetY: -low, width: 1, height: 1 };
    aim.copy(target).sub(home.centre).clampLength(0, FARTHEST_TARGET * home.radius).add(home.centre);
    camera.position.copy(aim).addScaledVector(armOf(around, tilt), kept / SLOPE);
    camera.lookAt(aim);
    parallel.zoom = 1;
    Object.assign(parallel, { top: kept, bottom: -kept, right: kept * perspective.aspect, left: -kept * perspective.aspect });
    clip();
    changed();
  }

  /** @param {Partial<Look>} change @param {boolean} [smooth] */
  function go(change, smooth = true) {
    const from = look();
    const to = { ...(glide.to ?? from), ...change };
    if (!smooth || calm.matches) {
      glide.stop();
      return take(to);
    }
    glide.begin(from, to);
    changed();
  }

  /** @param {number} right @param {number} up in shares of the view */
  function shift(right, up) {
    const { reach, target } = look();
    return target.add(new Vector3(right, up, 0).multiplyScalar(2 * reach).applyQuaternion(camera.quaternion));
  }

  /**
   * What shows points whole in the free part of the view, each with a ball around it.
   * @param {Partial<Look>} from another direction
   * @param {Pick<import('./measure.js').Home, 'centre' | 'each' | 'margin'>} what
   * @returns {Partial<Look>}
   */
  function whole(from, { centre, each, margin }) {
    const { around, down } = { ...(glide.to ?? look()), ...from };
    const { x, y, width, height } = free();
    const [wide, high] = [SLOPE * perspective.aspect * width, SLOPE * height];
    const back = armOf(around, down);
    const right = new Vector3(Math.cos(around), Math.sin(around), 0);
    const up = back.clone().cross(right);
    const axes = { right, up, back };
    const edges = { left: wide, right: wide, low: high, high };
    const found = enclose(each, centre, axes, edges, camera === parallel, margin);
    const target = centre.clone().addScaledVector(right, found.across).addScaledVector(up, found.above);
    // What the free part has to spare brings it nearer to the middle of the view.
    const [across, above] = filled(each, target, axes, edges, found.distance, camera === parallel, margin);
    return { ...from, target, reach: found.distance * SLOPE, right: aside(x, width, across), low: aside(y, height, above) };
  }

  /** Shows all. @param {Partial<Look>} [from] another direction @param {boolean} [smooth] */
  function fit(from = {}, smooth = true) {
    fitted.centre.copy(home.centre);
    fitted.radius = home.radius;
    untouched = true;
    go(whole(from, home), smooth);
  }

  /** What was all in view stays so in another room. */
  function settle() {
    if (untouched && !glide.to) fit({}, false);
  }

  /** At once. @param {Partial<Look>} to @param {boolean} [fits] whether what fitted goes on to fit */
  function by(to, fits = false) {
    go(to, false);
    untouched &&= fits;
    turned();
  }

  /** By a hand. @param {number} right @param {number} low radians that the camera goes */
  function turn(right, low) {
    const { around, down } = look();
    by({ around: around + right, down: clamp(down + low, 0, Math.PI) }, true);
  }

  onKeys(canvas, {
    turnView(_, at) {
      const [x, y] = ARROWS[at];
      turn(x * TURN, -y * TURN);
    },
    shiftView: (_, at) => by({ target: shift(ARROWS[at][0] * SHIFT, ARROWS[at][1] * SHIFT) }),
    zoomIn: () => by({ reach: look().reach * ZOOM }),
    zoomOut: () => by({ reach: look().reach / ZOOM }),
  });

  return {
    controls,
    get camera() {
      return camera;
    },
    /** A move's next step; called before every draw. */
    step() {
      const now = glide.step();
      if (now) take(now);
    },
    /** Shows everything, from where it is seen now. */
    fit: () => fit(),
    /** Shows everything as it is seen first. */
    begin: () => fit(STANDARD_VIEWS.first, false),
    /** Shows everything where another scene has taken the place of the one that was looked at. */
    refit() {
      const { target, reach } = glide.to ?? look();
      if (!hasLeft(fitted, home) || showsWell({ target, reach: reach * Math.min(1, perspective.aspect) }, home)) return;
      fit({}, false);
    },
    /** Brings a ball into the middle. @param {Vector3} centre @param {number} radius */
    fitTo(centre, radius) {
      untouched = false;
      go(whole({}, { centre, each: (visit) => visit(centre), margin: radius }));
    },
    /** What was all in view stays so from another side. @param {Partial<Look>} from @param {boolean} [smooth] */
    turnTo(from, smooth) {
      if (untouched) fit(from, smooth);
      else go(from, smooth);
    },
    settle,
    turn,
    /** @param {boolean} flat whether parallel lines stay parallel */
    setParallel(flat) {
      const wanted = flat ? parallel : perspective;
      canvas.dataset.projection = flat ? 'orthographic' : 'perspective';
      if (camera === wanted) return;
      const now = look();
      camera = wanted;
      take(now);
    },
    /** What `fit` shows. @param {import('./measure.js').Home} next */
    setHome(next) {
      home = next;
      clip();
    },
    /** @param {number} aspect */
    setAspect(aspect) {
      perspective.aspect = aspect;
      parallel.right = parallel.top * aspect;
      parallel.left = -parallel.right;
      perspective.updateProjectionMatrix();
      parallel.updateProjectionMatrix();
      settle();
    },
  };
}
