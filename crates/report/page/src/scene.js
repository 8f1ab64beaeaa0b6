// The 3D view: environment, reference, the body of every scenario, the arm, contact forces.
import {
  AmbientLight,
  Color,
  DirectionalLight,
  LineBasicMaterial,
  LineSegments,
  PerspectiveCamera,
  Plane,
  Quaternion,
  Scene,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { arrows, largestForce, pushes } from "./arrows.js";
import { fitted } from "./camera.js";
import { box, poseAt } from "./motion.js";
import { goalAxes, placedParts } from "./placed.js";
import { pointsAt, skeleton } from "./skeleton.js";
import { edgeGeometry, exactGeometry, smoothedGeometry } from "./solids.js";
import { colour, onTheme, scenarioColour } from "./theme.js";

/** Directions from which the view looks, by the names of its buttons. */
export const VIEWS = {
  Free: new Vector3(1.1, -1.6, 0.9),
  X: new Vector3(1, 0, 0),
  Y: new Vector3(0, -1, 0),
  Z: new Vector3(0, -1e-3, 1),
};
const AXES = { x: new Vector3(-1, 0, 0), y: new Vector3(0, 1, 0), z: new Vector3(0, 0, -1) };
const FIELD_OF_VIEW = 35;
/** Part of the picture that the parts fill at first, along each side. */
const FILLED = 0.88;
/** Instants of each motion at which the parts must be seen. */
const SEEN = 12;
/** Length of the arrow of the largest force, by the size of the parts. */
const LONGEST = 0.8;
/** Frames over which the time between two of them is taken; the longest that is smooth (ms). */
const FRAMES = 12;
const SLOW = 30;
/** Fewest pixels that are drawn per pixel of the page, along each side. */
const LEAST_PIXELS = 0.5;
/** Pixels of a saved picture per pixel of the page, at least. */
const PICTURE_PIXELS = 2;

/**
 * The view into a canvas, which has room for all of `plans`. It is drawn again when something that it shows has changed, never otherwise. `onScale` is told how
 * long (px) the arrow of a newton is, in the middle of the view; null where there are none.
 */
export function sceneView(canvas, data, plans, shown, onScale) {
  const isSlow = drawsWithoutGraphics();
  const renderer = new WebGLRenderer({ canvas, antialias: !isSlow });
  renderer.localClippingEnabled = true;
  const scene = new Scene();
  const camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 1e-3, 100);
  camera.up.set(0, 0, 1);
  const controls = new OrbitControls(camera, canvas);
  controls.enableDamping = false;

  const bodyRadius = radius(box(data.body));
  const size = Math.max(bodyRadius, 0.35 * radius(box(data.environment)));
  const target = new Vector3().fromArray(data.goal).lerp(new Vector3().fromArray(data.motions[0].reference), 0.4);
  const everything = plans.flatMap(placesOf);
  const plane = new Plane(AXES.y.clone(), 0);

  const light = new DirectionalLight(0xffffff, 2.6);
  scene.add(new AmbientLight(0xffffff, 1.15), light, camera);
  const axes = goalAxes(data.goal, 0.7 * size);
  scene.add(axes);

  const fixed = placedParts(data.environment);
  const reference = new LineSegments(edgeGeometry(data.body), new LineBasicMaterial());
  const most = Math.max(...data.motions.map(({ scenarios }) => scenarios.length));
  const bodies = Array.from({ length: most }, () => placedParts(data.body));
  // Those of the selected scenario lie upon the others.
  const others = arrows(size, { opacity: 0.4, order: 4 });
  const forces = arrows(size, { opacity: 1, order: 5 });
  scene.add(fixed.group, reference, ...bodies.map(({ group }) => group), ...others.meshes, ...forces.meshes);
  const courses = data.motions.flatMap((motion) => motion.courses);
  const arm = courses.length > 0 ? skeleton(courses[0].skeletons[0].length / 3, size) : null;
  if (arm) scene.add(...arm.meshes);

  let pending = false;
  let ratio = Math.min(devicePixelRatio, isSlow ? 1 : 2);
  let before = null;
  /** The view whose button was clicked last, until the reader rotates or zooms. */
  let kept = "Free";
  const intervals = [];

  function draw(now) {
    pending = false;
    slowDown(now);
    render();
  }

  function render() {
    place();
    // From the left shoulder of who looks, so that faces differ.
    light.position.set(-0.6, 0.9, 1).applyQuaternion(camera.quaternion);
    renderer.render(scene, camera);
    const height = 2 * Math.tan((FIELD_OF_VIEW * Math.PI) / 360) * camera.position.distanceTo(controls.target);
    onScale(largestForce(motion()) === 0 ? null : (arrowScale() * canvas.clientHeight) / height);
  }

  /** Length (m) of the arrow of a newton. */
  function arrowScale() {
    return (LONGEST * size) / largestForce(motion());
  }

  /** Draws fewer pixels where frames of a motion that plays come too late for the eye. */
  function slowDown(now) {
    if (shown.values.playing && before !== null) intervals.push(now - before);
    before = shown.values.playing ? now : null;
    if (intervals.length < FRAMES) return;
    const median = intervals.splice(0).sort((one, other) => one - other)[FRAMES / 2];
    if (median <= SLOW || ratio <= LEAST_PIXELS) return;
    ratio = Math.max(LEAST_PIXELS, 0.75 * ratio);
    canvas.parentElement.classList.add("coarse");
    resize();
  }

  function request() {
    if (!pending) {
      pending = true;
      requestAnimationFrame(draw);
    }
  }

  function motion() {
    return data.motions[shown.values.motion];
  }

  /** Puts everything where it is at the shown time. */
  function place() {
    const { time, selected, hidden, cut, showReference, showForces, showArm } = shown.values;
    const { scenarios, courses, time_step: timeStep } = motion();
    poseAt(motion().reference, timeStep, time, reference.position, reference.quaternion);
    reference.visible = showReference;
    bodies.forEach((one, index) => {
      one.group.visible = index < scenarios.length && !hidden.has(index);
      if (!one.group.visible) return;
      poseAt(scenarios[index].poses, timeStep, time, one.group.position, one.group.quaternion);
      one.setOpacity(index === selected ? 1 : 0.22);
      one.setCut(cut === "none" ? null : plane);
    });
    fixed.setCut(cut === "none" ? null : plane);
    const hasArm = arm !== null && showArm && courses.length > 0;
    arm?.setVisible(hasArm);
    if (hasArm) arm.place(pointsAt(courses[selected].skeletons, timeStep, time));
    const pushing = showForces ? pushes(scenarios, timeStep, time, hidden) : [];
    others.show(pushing.filter(({ scenario }) => scenario !== selected), arrowScale());
    forces.show(pushing.filter(({ scenario }) => scenario === selected), arrowScale());
  }

  /** Looks along a direction at everything. */
  function look(view) {
    kept = view;
    const up = FILLED * Math.tan((FIELD_OF_VIEW * Math.PI) / 360);
    const { position, target: middle } = fitted(everything, VIEWS[view], [up * camera.aspect, up]);
    controls.target.copy(middle);
    camera.position.copy(position);
    focus();
  }

  /** Draws what lies around the distance at which the camera looks. */
  function focus() {
    const distance = camera.position.distanceTo(controls.target);
    camera.near = distance / 200;
    camera.far = distance * 20;
    camera.updateProjectionMatrix();
    controls.update();
    request();
  }

  /** Where the reader looks from: the name of a view, or the places (m) of the camera and of what it looks at. */
  function viewpoint() {
    return kept ?? [...camera.position.toArray(), ...controls.target.toArray()];
  }

  /** Looks from such a viewpoint. */
  function lookFrom(viewpoint) {
    if (viewpoint in VIEWS) {
      look(viewpoint);
      return;
    }
    kept = null;
    camera.position.fromArray(viewpoint);
    controls.target.fromArray(viewpoint, 3);
    focus();
  }

  /** Hands over the view as a PNG, in full sharpness also where a motion that plays has fewer pixels. */
  function picture(receive) {
    setPixels(Math.max(PICTURE_PIXELS, ratio));
    render();
    // The browser copies the canvas here, and calls back when it has compressed it.
    canvas.toBlob(receive, "image/png");
    setPixels(ratio);
    render();
  }

  function setPixels(perPixel) {
    const { clientWidth, clientHeight } = canvas.parentElement;
    renderer.setPixelRatio(perPixel);
    renderer.setSize(clientWidth, clientHeight, false);
  }

  function resize() {
    const { clientWidth, clientHeight } = canvas.parentElement;
    if (clientWidth === 0) return;
    setPixels(ratio);
    camera.aspect = clientWidth / clientHeight;
    camera.updateProjectionMatrix();
    if (kept !== null) look(kept);
    request();
  }

  function setShapes() {
    const { source, tau } = motion();
    const smoothed = source === "iteration" && shown.values.showSmoothed;
    fixed.setShape(smoothed ? smoothedGeometry(data.environment, tau) : exactGeometry(data.environment));
    const shape = smoothed ? smoothedGeometry(data.body, tau) : exactGeometry(data.body);
    bodies.forEach((one) => one.setShape(shape));
    request();
  }

  function setPlane({ cut, cutAt }) {
    if (cut !== "none") {
      plane.normal.copy(AXES[cut]);
      const axis = "xyz".indexOf(cut);
      const middle = target.getComponent(axis);
      plane.constant = -plane.normal.dot(new Vector3().setComponent(axis, middle + cutAt * bodyRadius));
    }
    request();
  }

  controls.addEventListener("change", request);
  controls.addEventListener("start", () => (kept = null));
  new ResizeObserver(resize).observe(canvas.parentElement);
  shown.on(["time", "selected", "hidden", "showReference", "showForces", "showArm"], request);
  shown.on(["motion", "showSmoothed"], setShapes);
  shown.on(["cut", "cutAt"], setPlane);
  onTheme(() => {
    scene.background = new Color(colour("view"));
    reference.material.color = new Color(colour("text"));
    fixed.setColours(colour("environment"), colour("environment-edge"));
    arm?.setColour(colour("faint"));
    bodies.forEach((one, index) => one.setColours(scenarioColour(index), colour("body-edge")));
    request();
  });
  resize();
  // Printers want the picture at once.
  addEventListener("beforeprint", () => draw(performance.now()));
  const onMove = (listener) => controls.addEventListener("change", () => listener(viewpoint()));
  return { look, viewpoint, lookFrom, picture, onMove };
}

/** Corners of the boxes around the parts, of the body wherever a motion takes it. */
function placesOf({ environment, body, motions }) {
  const [position, quaternion] = [new Vector3(), new Quaternion()];
  const own = box(body);
  const moved = motions.flatMap(({ reference, scenarios, time_step: timeStep }) => {
    const end = timeStep * (reference.length / 7 - 1);
    return [reference, ...scenarios.map(({ poses }) => poses)].flatMap((poses) =>
      Array.from({ length: SEEN + 1 }, (_, index) => {
        poseAt(poses, timeStep, (end * index) / SEEN, position, quaternion);
        return own.map((corner) => corner.clone().applyQuaternion(quaternion).add(position));
      }).flat(),
    );
  });
  return [...box(environment), ...moved];
}

const radius = (box) => 0.5 * box[0].distanceTo(box.at(-1));

/** Whether the processor draws, which has no time for smooth edges. */
function drawsWithoutGraphics() {
  const context = document.createElement("canvas").getContext("webgl2");
  const info = context?.getExtension("WEBGL_debug_renderer_info");
  const name = info ? context.getParameter(info.UNMASKED_RENDERER_WEBGL) : "";
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software/i.test(name);
}
