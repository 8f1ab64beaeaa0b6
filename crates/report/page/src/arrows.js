// Arrows of contact forces, seen through everything.
import { Color, ConeGeometry, CylinderGeometry, InstancedMesh, Matrix4, MeshBasicMaterial, Quaternion, Vector3 } from "three";

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
