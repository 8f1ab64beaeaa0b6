// The arm that holds the body, as rods between its joints.
import { Color, CylinderGeometry, InstancedMesh, Matrix4, MeshLambertMaterial, Quaternion, SphereGeometry, Vector3 } from "three";

const UP = new Vector3(0, 1, 0);
const RADIUS = 0.07;

/** Rods and balls for an arm of some points, beside parts of a size (m). */
export function skeleton(count, size) {
  const material = new MeshLambertMaterial();
  const rods = new InstancedMesh(new CylinderGeometry(1, 1, 1, 12), material, count - 1);
  const balls = new InstancedMesh(new SphereGeometry(1, 16, 12), material, count);
  const meshes = [rods, balls];
  meshes.forEach((mesh) => (mesh.frustumCulled = false));
  const [matrix, turn, thickness] = [new Matrix4(), new Quaternion(), RADIUS * size];
  return {
    meshes,
    setVisible(visible) {
      meshes.forEach((mesh) => (mesh.visible = visible));
    },
    setColour(colour) {
      material.color = new Color(colour);
    },
    /** Puts the arm where its points are. */
    place(points) {
      points.forEach((point, index) => {
        balls.setMatrixAt(index, matrix.compose(point, turn.identity(), new Vector3().setScalar(1.4 * thickness)));
        if (index === 0) return;
        const rod = point.clone().sub(points[index - 1]);
        const length = rod.length();
        turn.setFromUnitVectors(UP, length > 0 ? rod.divideScalar(length) : UP);
        const middle = point.clone().lerp(points[index - 1], 0.5);
        rods.setMatrixAt(index - 1, matrix.compose(middle, turn, new Vector3(thickness, length, thickness)));
      });
      meshes.forEach((mesh) => (mesh.instanceMatrix.needsUpdate = true));
    },
  };
}

/** The points of an arm between two knots. */
export function pointsAt(skeletons, timeStep, time) {
  const last = skeletons.length - 1;
  const place = Math.min(Math.max(time / timeStep, 0), last);
  const index = Math.floor(place);
  const [before, after] = [skeletons[index], skeletons[Math.min(index + 1, last)]];
  return Array.from({ length: before.length / 3 }, (_, point) =>
    new Vector3().fromArray(before, 3 * point).lerp(new Vector3().fromArray(after, 3 * point), place - index),
  );
}
