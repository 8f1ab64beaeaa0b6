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
  const target = quaternionOf(goal);
  return rows(poses).map((pose) => {
    // From the sine, which is exact for small angles.
    const { x, y, z, w } = quaternionOf(pose).conjugate().multiply(target);
    return 2 * Math.atan2(Math.hypot(x, y, z), Math.abs(w));
  });
}

/** Velocity (m/s, world frame) in every step. */
export function velocities(poses, timeStep) {
  return steps(poses).map(([one, other]) => [0, 1, 2].map((axis) => (other[axis] - one[axis]) / timeStep));
}

/** Angular velocity (rad/s, body frame) in every step. */
export function angularVelocities(poses, timeStep) {
  return steps(poses).map(([one, other]) => {
    const turn = quaternionOf(one).conjugate().multiply(quaternionOf(other));
    // The shorter of the two turns; its half angle from the sine, which is exact where it is small.
    const sine = Math.hypot(turn.x, turn.y, turn.z);
    const angle = 2 * Math.atan2(sine, Math.abs(turn.w)) * Math.sign(turn.w || 1);
    return [turn.x, turn.y, turn.z].map((part) => (sine === 0 ? 0 : (part / sine) * angle) / timeStep);
  });
}

const quaternionOf = (pose) => new Quaternion(pose[4], pose[5], pose[6], pose[3]).normalize();

function steps(poses) {
  const all = rows(poses);
  return all.slice(1).map((pose, index) => [all[index], pose]);
}

function rows(poses) {
  return Array.from({ length: knots(poses) }, (_, index) => poses.slice(7 * index, 7 * index + 7));
}

/** The eight corners of the box around some parts, the first and the last of them opposite. */
export function box(parts) {
  const along = [0, 1, 2].map((axis) => parts.flatMap(({ vertices }) => vertices.filter((_, index) => index % 3 === axis)));
  const ends = along.map((all) => [all.reduce((one, other) => Math.min(one, other)), all.reduce((one, other) => Math.max(one, other))]);
  return Array.from({ length: 8 }, (_, corner) => new Vector3(...ends.map((end, axis) => end[(corner >> axis) & 1])));
}
