// Ranges of plots and the values at which their axes have labels.

/** Fewest labels of an axis. */
const FEWEST = 3;
/** A limit is drawn to scale where the values come this near to it. */
const NEAR = 0.25;
/** Decades that a logarithmic axis shows, at least and at most. */
const DECADES = [2, 5];

/** A linear range with some room: it includes zero where that is near, and the limits that the values come near to. */
export function linearRange(values, limits) {
  const known = values.filter((value) => value !== null);
  let [low, high] = [Math.min(...known), Math.max(...known)];
  const size = Math.max(Math.abs(low), Math.abs(high));
  const near = limits.filter((limit) => size >= NEAR * Math.abs(limit));
  [low, high] = [Math.min(low, ...near), Math.max(high, ...near)];
  if (low > 0 && low < 0.5 * high) low = 0;
  if (high < 0 && high > 0.5 * low) high = 0;
  if (!(high - low > 1e-9)) return low === 0 ? [0, 1] : [low - 0.5 * size, high + 0.5 * size];
  const room = 0.08 * (high - low);
  return [low === 0 ? 0 : low - room, high === 0 ? 0 : high + room];
}

/** A logarithmic range that shows the limits and where each list of values ends. */
export function logarithmicRange(lists, limits) {
  const positive = (values) => values.filter((value) => value > 0);
  const high = 1.5 * Math.max(1e-9, ...positive(lists.flat()), ...limits);
  const ends = positive(lists.map((values) => values.findLast((value) => value !== null)));
  const least = 0.5 * Math.min(high, ...ends, ...limits);
  const [fewest, most] = DECADES;
  return [Math.min(Math.max(least, high / 10 ** most), high / 10 ** fewest), high];
}

/** Round values within a linear range, at least three. */
export function linearTicks([low, high], wanted) {
  for (let count = Math.max(wanted, FEWEST); ; count += 1) {
    const step = roundStep((high - low) / count);
    const first = Math.ceil(low / step - 1e-9);
    const last = Math.floor(high / step + 1e-9);
    // Whole multiples, so that zero is zero.
    if (last - first + 1 >= FEWEST) return Array.from({ length: last - first + 1 }, (_, index) => rounded((first + index) * step));
  }
}

/** Powers of ten within a range; where these are fewer than three, what is between them as well. */
export function logarithmicTicks([low, high]) {
  const among = (factors) => {
    const decades = Array.from({ length: 40 }, (_, index) => index - 20);
    const all = decades.flatMap((decade) => factors.map((factor) => rounded(factor * 10 ** decade)));
    return all.filter((value) => value >= low && value <= high);
  };
  const powers = among([1]);
  return powers.length >= FEWEST ? powers : among([1, 3]);
}

/** The nearest of 1, 2, 5, 10 ... that is not above a step. */
function roundStep(step) {
  const decade = 10 ** Math.floor(Math.log10(step));
  return decade * [5, 2, 1].find((factor) => factor * decade <= step * (1 + 1e-9));
}

const rounded = (value) => Number(value.toPrecision(9));
