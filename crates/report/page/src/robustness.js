// How often the plan succeeds in rollouts, by friction and magnitude.
import { card, element, table } from "./dom.js";
import { magnitude, percent, sentence, short } from "./words.js";

const keyOf = ({ magnitude_m: length, planned }) => `${length}${planned}`;

/** Success rates before and after refinement, and the weakest corner. */
export function robustness({ robust, goal_reached: reached }, weakest) {
  const lead =
    `${percent(robust.rate_after)} of rollouts with hard contact succeed, ${percent(robust.rate_before)} before refinement; ` +
    `${percent(robust.wanted_rate)} were wanted at each friction.`;
  return card(
    "Robustness",
    element("p", { class: "lead" }, reached ? lead : `${lead} Not every planned offset reaches the goal.`),
    rates("After refinement", robust.after),
    element("details", {}, element("summary", {}, "Before refinement"), rates("Before refinement", robust.before)),
    weakestCorner(weakest),
    rounds(robust),
  );
}

function rates(caption, groups) {
  const columns = [...new Map(groups.map((group) => [keyOf(group), group])).values()];
  columns.sort((one, other) => one.planned - other.planned || one.magnitude_m - other.magnitude_m);
  const frictions = [...new Set(groups.map(({ friction }) => friction))];
  const header = ["friction", ...columns.map(({ magnitude_m: length, planned }) => `${magnitude(length)}${planned ? ", planned" : ""}`)];
  const rows = frictions.map((friction) => ({
    cells: [
      short(friction),
      ...columns.map((column) => {
        const group = groups.find((one) => one.friction === friction && keyOf(one) === keyOf(column));
        return group ? rateCell(group.successes, group.rollouts) : "";
      }),
    ],
  }));
  return table(caption, header, rows);
}

/** A rate with its counts, on a ground that is the darker the lower it is. */
export function rateCell(successes, rollouts, interval) {
  const rate = successes / rollouts;
  const counts = interval ? `${successes}/${rollouts}, ${interval}` : `${successes}/${rollouts}`;
  return element("span", { class: "rate", style: `--rate:${rate}` }, element("b", {}, percent(rate)), element("small", {}, counts));
}

function weakestCorner(words) {
  if (words.length === 0) return null;
  return element("div", { class: "weakest" }, element("h3", {}, "Weakest corner"), element("p", {}, words.map(sentence).join(" ")));
}

function rounds({ rounds: all, kept_round: kept }) {
  const rows = all.map((round, index) => ({
    class: index + 1 === kept ? "chosen" : "",
    cells: [
      `${index + 1}  ${round.planned}`,
      `${round.training_failures} of ${round.training_trials}`,
      String(round.changes),
      String(round.rollouts),
      round.rate === null ? "–" : percent(round.rate),
      `${(round.solve_s + round.refinement_s).toFixed(1)} s`,
    ],
  }));
  return element(
    "details",
    {},
    element("summary", {}, `Rounds of refinement (${all.length})`),
    table("Rounds of refinement", ["round", "failing trials at first", "changes", "rollouts", "rate", "time"], rows),
  );
}
