// Poses along a motion, and errors.
import { Quaternion, Vector3 } from "three";

/** Number of knots in a list of poses. */
export const knots = (poses) => poses.length / 7;

const before = new Quaternion();
const after = new Quaternion();

/** Sets position and quaternion to those of a motion at a time, between knots as the robot interpolates. */
export function poseAt(poses, timeStep, time, position, quaternion) {
  const last = knots(poses) - 1;
  const place = Math.min(Math.max(time / timeStep, 0), last);
  const index = Math.min(Math.floor(place), Math.max(last - 1, 0));
  const [one, other] = [7 * index, 7 * Math.min(index + 1, last)];
  const fraction = place - index;
  position.set(...[0, 1, 2].map((axis) => poses[one + axis] + fraction * (poses[other + axis] - poses[one + axis])));
  before.set(poses[one + 4], poses[one + 5], poses[one + 6], poses[one + 3]);
  after.set(poses[other + 4], poses[other + 5], poses[other + 6], poses[other + 3]);
  quaternion.copy(before).slerp(after, fraction);
}

/** Distance (m) from a goal at every knot. */
export function positionErrors(poses, goal) {
  return rows(poses).map((pose) => Math.hypot(pose[0] - goal[0], pose[1] - goal[1], pose[2] - goal[2]));
}

/** Angle (rad) to a goal at every knot. */
export function orientationErrors(poses, goal) {
  const target = new Quaternion(goal[4], goal[5], goal[6], goal[3]).normalize();
  return rows(poses).map((pose) => new Quaternion(pose[4], pose[5], pose[6], pose[3]).normalize().angleTo(target));
}

function rows(poses) {
  return Array.from({ length: knots(poses) }, (_, index) => poses.slice(7 * index, 7 * index + 7));
}

/** The box around some parts: its centre and half of its diagonal. */
export function bounds(parts) {
  const corners = parts.flatMap(({ vertices }) =>
    Array.from({ length: vertices.length / 3 }, (_, index) => new Vector3().fromArray(vertices, 3 * index)),
  );
  const low = corners.reduce((least, corner) => least.min(corner), new Vector3(Infinity, Infinity, Infinity));
  const high = corners.reduce((most, corner) => most.max(corner), new Vector3(-Infinity, -Infinity, -Infinity));
  return { low, high, centre: low.clone().add(high).multiplyScalar(0.5), radius: 0.5 * high.distanceTo(low) };
}
