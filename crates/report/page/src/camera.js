// Where a camera stands to see all of some points.
import { Vector3 } from "three";

/**
 * The nearest place from which a camera that looks along a direction, z up, sees all points within a part of its picture, and
 * the point in its middle line that is nearest to them. The tangents are those of half of its angles of view, across and up.
 */
export function fitted(points, direction, [across, up]) {
  const back = direction.clone().normalize();
  const right = new Vector3(0, 0, 1).cross(back).normalize();
  const top = back.clone().cross(right);
  // A point p is seen where |p.right - x| <= tangent (z - p.back), and likewise along the other axis.
  const [x, distanceAcross] = centred(points, right, back, across);
  const [y, distanceUp] = centred(points, top, back, up);
  const away = Math.max(distanceAcross, distanceUp);
  const depths = points.map((point) => point.dot(back));
  const middle = 0.5 * (Math.min(...depths) + Math.max(...depths));
  const at = (distance) => right.clone().multiplyScalar(x).addScaledVector(top, y).addScaledVector(back, distance);
  return { position: at(away), target: at(Math.min(middle, away - 1e-3)) };
}

/** Place along an axis and least distance along the line of sight. */
function centred(points, axis, back, tangent) {
  const most = (sign) => Math.max(...points.map((point) => sign * point.dot(axis) + tangent * point.dot(back)));
  const [one, other] = [most(1), most(-1)];
  return [0.5 * (one - other), (0.5 * (one + other)) / tangent];
}
