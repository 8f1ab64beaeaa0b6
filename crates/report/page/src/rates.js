// Rates of success and how certain they are.
import { element } from "./dom.js";
import { percent } from "./words.js";

/** Standard deviations of the normal distribution that hold 95 %. */
const Z = 1.959963984540054;

/** Wilson's interval of 95 % of a rate of success. */
export function interval({ successes, rollouts }) {
  if (rollouts === 0) return [0, 1];
  const rate = successes / rollouts;
  const shrink = 1 + Z ** 2 / rollouts;
  const middle = rate + Z ** 2 / (2 * rollouts);
  const half = Z * Math.sqrt((rate * (1 - rate)) / rollouts + Z ** 2 / (4 * rollouts ** 2));
  return [Math.max((middle - half) / shrink, 0), Math.min((middle + half) / shrink, 1)];
}

/** Some groups of rollouts together. */
export const together = (groups) =>
  groups.reduce(
    (sum, { successes, rollouts }) => ({ successes: sum.successes + successes, rollouts: sum.rollouts + rollouts }),
    { successes: 0, rollouts: 0 },
  );

/** A rate with its counts and interval. Few rollouts prove little: the ground is as green as the interval's lower end. */
export function rateCell(group) {
  const { successes, rollouts } = group;
  if (rollouts === 0) return "–";
  const [low, high] = interval(group);
  return element(
    "span",
    { class: "rate", style: `--rate:${low}` },
    element("b", {}, percent(successes / rollouts)),
    element("small", {}, `${successes}/${rollouts}, ${(100 * low).toFixed(0)}–${(100 * high).toFixed(0)} %`),
  );
}
