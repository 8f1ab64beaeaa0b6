// Arrows of contact forces, seen through everything.
import { Color, ConeGeometry, CylinderGeometry, InstancedMesh, Matrix4, MeshBasicMaterial, Quaternion, Vector3 } from "three";
import { scenarioColour } from "./theme.js";

const MOST = 256;
const UP = new Vector3(0, 1, 0);

/** Arrows for a scene of a size (m): a shaft and a head each. Those of a later order lie upon others. */
export function arrows(size, { opacity, order }) {
  const material = () => new MeshBasicMaterial({ depthTest: false, transparent: true, opacity });
  // Both begin at their origin and point along y.
  const shafts = new InstancedMesh(new CylinderGeometry(1, 1, 1, 8).translate(0, 0.5, 0), material(), MOST);
  const heads = new InstancedMesh(new ConeGeometry(1, 1, 12).translate(0, 0.5, 0), material(), MOST);
  const meshes = [shafts, heads];
  meshes.forEach((mesh) => {
    mesh.frustumCulled = false;
    mesh.renderOrder = order;
  });
  const matrix = new Matrix4();
  const turn = new Quaternion();
  return {
    meshes,
    /** Shows forces on the body, each with the end of its arrow where it acts, scaled in m per N. */
    show(pushes, scale) {
      const shown = pushes.slice(0, MOST);
      meshes.forEach((mesh) => (mesh.count = shown.length));
      shown.forEach(({ force, point, direction, colour }, index) => {
        const length = scale * force;
        const head = Math.min(0.16 * size, 0.5 * length);
        turn.setFromUnitVectors(UP, direction.clone().normalize());
        shafts.setMatrixAt(index, matrix.compose(point, turn, new Vector3(0.018 * size, length - head, 0.018 * size)));
        const neck = point.clone().addScaledVector(direction, length - head);
        heads.setMatrixAt(index, matrix.compose(neck, turn, new Vector3(0.05 * size, head, 0.05 * size)));
        meshes.forEach((mesh) => mesh.setColorAt(index, new Color(colour).offsetHSL(0, 0.1, -0.08)));
      });
      meshes.forEach((mesh) => {
        mesh.instanceMatrix.needsUpdate = true;
        if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
      });
    },
  };
}

/** Contact forces of the visible scenarios in the step that a time lies in. */
export function pushes(scenarios, timeStep, time, hidden) {
  return scenarios.flatMap(({ contacts }, scenario) => {
    if (hidden.has(scenario) || time <= 0) return [];
    const step = Math.min(Math.ceil(time / timeStep - 1e-9) - 1, contacts.length - 1);
    const numbers = contacts[step] ?? [];
    return Array.from({ length: numbers.length / 8 }, (_, index) => {
      const [, force, x, y, z, ...direction] = numbers.slice(8 * index, 8 * index + 8);
      return { scenario, force, point: new Vector3(x, y, z), direction: new Vector3(...direction), colour: scenarioColour(scenario) };
    });
  });
}

const largest = new WeakMap();

/** The largest force of a pair in a motion: the length of arrows is relative to it. */
export function largestForce(motion) {
  if (!largest.has(motion)) {
    const forces = motion.scenarios.flatMap(({ contacts }) => contacts.flatMap((step) => step.filter((_, index) => index % 8 === 1)));
    largest.set(motion, forces.reduce((most, force) => Math.max(most, force), 0));
  }
  return largest.get(motion);
}
