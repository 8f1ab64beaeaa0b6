// Numbers as people read them.

const DEGREES = 180 / Math.PI;

/** A length in m as mm. */
export const millimetres = (metres, decimals = 2) => `${(1e3 * metres).toFixed(decimals)} mm`;

/** A length in m as mm, with no more decimals than it has. */
export const magnitude = (metres) => `${Number((1e3 * metres).toFixed(3))} mm`;

/** An angle in rad as degrees. */
export const degrees = (radians) => `${(DEGREES * radians).toFixed(1)}°`;

/** A force. */
export const newtons = (force) => `${short(force)} N`;

/** A rate, 0 to 1, in percent; 100 % means all. */
export const percent = (rate) => (rate === 1 ? "100 %" : `${(100 * rate).toFixed(1)} %`);

/** A number with three digits. */
export function short(number) {
  if (number === null || number === undefined) return "–";
  if (number === 0) return "0";
  const size = Math.abs(number);
  return size >= 1e4 || size < 1e-3 ? number.toExponential(1) : String(Number(number.toPrecision(3)));
}

/** Names as a list in a sentence. */
export const listed = (names) => (names.length < 2 ? names.join() : `${names.slice(0, -1).join(", ")} and ${names.at(-1)}`);

/** An offset (m) in words. */
function offsetInWords(offset) {
  if (offset.every((component) => Math.abs(component) < 5e-7)) return "no offset";
  return `${offset.map((component) => Number((1e3 * component).toFixed(3))).join(", ")} mm`;
}

/** The name of a scenario of a motion: what a robot did has one, and so has the rollout beside it. */
export const scenarioName = (motion, index) =>
  motion.execution ? ["robot", `rollout, friction ${short(motion.execution.friction)}`][index] : `scenario ${index + 1}`;

/** What is injected into a scenario, in words. */
export function injectionInWords({ offset, rotation, disturbances }) {
  const angle = Math.hypot(...rotation);
  const turned = angle < 1e-4 ? [] : [`rotated ${degrees(angle)}`];
  return [offsetInWords(offset), ...turned, ...disturbances].join(", ");
}
