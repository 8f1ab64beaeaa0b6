// Parts as objects of the 3D view, with their edges and the faces of a cut, and the axes of the goal.
import {
  AxesHelper,
  Color,
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
} from "three";
import { edgeGeometry, exactGeometry, sectionGeometry } from "./solids.js";

/** The axes of the goal, red green blue, seen through everything. */
export function goalAxes(goal, length) {
  const axes = new AxesHelper(length);
  axes.setColors(new Color("#e0483e"), new Color("#36a84c"), new Color("#3f86e8"));
  Object.assign(axes.material, { depthTest: false, transparent: true });
  axes.renderOrder = 3;
  axes.position.fromArray(goal);
  axes.quaternion.set(goal[4], goal[5], goal[6], goal[3]);
  return axes;
}

/** Parts as one mesh with their edges, and the faces of a cut. */
export function placedParts(parts) {
  const group = new Group();
  const material = new MeshLambertMaterial({ side: DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
  const lines = new LineBasicMaterial({ transparent: true });
  const faces = new MeshBasicMaterial({ side: DoubleSide, polygonOffset: true });
  const mesh = new Mesh(exactGeometry(parts), material);
  const edges = new LineSegments(edgeGeometry(parts), lines);
  const section = new Mesh(undefined, faces);
  section.matrixAutoUpdate = false;
  section.visible = false;
  const toGroup = new Matrix4();
  group.add(mesh, edges, section);
  return {
    group,
    setShape(shape) {
      if (mesh.geometry !== shape) mesh.geometry.dispose();
      mesh.geometry = shape;
    },
    setColours(fill, edge) {
      material.color = new Color(fill);
      faces.color = new Color(fill).multiplyScalar(0.72);
      lines.color = new Color(edge);
    },
    setOpacity(opacity) {
      const isSolid = opacity === 1;
      [material, faces].forEach((one) => Object.assign(one, { opacity, transparent: !isSolid, depthWrite: isSolid }));
      lines.opacity = isSolid ? 0.85 : 0.4;
      // All cuts lie in one plane; that of the selected body is in front.
      faces.polygonOffsetUnits = isSolid ? -8 : -4;
    },
    setCut(plane) {
      const planes = plane ? [plane] : [];
      [material, lines].forEach((one) => (one.clippingPlanes = planes));
      section.visible = plane !== null;
      if (plane === null) return;
      group.updateMatrixWorld();
      section.geometry.dispose();
      section.geometry = sectionGeometry(parts, group.matrixWorld, plane);
      // The section is in world coordinates.
      section.matrix.copy(toGroup.copy(group.matrixWorld).invert());
    },
  };
}
