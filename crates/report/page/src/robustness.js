// How often the plan succeeds in rollouts, by friction and magnitude.
import { card, element, explained, table } from "./dom.js";
import { rateCell } from "./rates.js";
import { magnitude, percent, short } from "./words.js";

const LEGEND = "Cells show the rate, its counts and Wilson's interval of 95 %; they are as green as the lower end of the interval.";

const keyOf = ({ magnitude_m: length, region, planned }) => `${length}${region}${planned}`;

/** The offsets of a group, such as `up to 0.8 mm`. */
function offsets({ magnitude_m: length, region, planned }) {
  if (planned) return `${magnitude(length)}, planned`;
  const where = { inside: "up to ", rim: "on the rim, " };
  return `${where[region] ?? ""}${magnitude(length)}`;
}

/** Success rates before and after refinement, and the weakest corner. */
export function robustness(robust, weakest, reached) {
  const lead =
    `${percent(robust.rate_after)} of rollouts with hard contact succeed, ${percent(robust.rate_before)} before refinement; ` +
    `${percent(robust.target_rate)} are the target at each friction.`;
  return card(
    "Robustness",
    element("p", { class: "lead" }, reached ? lead : `${lead} Not every planned offset reaches the goal.`),
    element("p", {}, LEGEND),
    ratesOf("After refinement", robust.after),
    element("details", {}, element("summary", {}, "Before refinement"), ratesOf("Before refinement", robust.before)),
    weakestCorner(weakest),
    rounds(robust),
  );
}

/** How often a plan succeeds that was not refined. */
export function test({ rates, target_rate: wanted }) {
  return card(
    "Test with hard contact",
    element("p", {}, `A robust plan reaches ${percent(wanted)} at each friction, in many more rollouts than these. ${LEGEND}`),
    ratesOf("Test with hard contact", rates),
  );
}

function ratesOf(caption, all) {
  const columns = [...new Map(all.map((group) => [keyOf(group), group])).values()];
  columns.sort((one, other) => one.planned - other.planned || one.magnitude_m - other.magnitude_m);
  const frictions = [...new Set(all.map(({ friction }) => friction))];
  const header = ["friction", ...columns.map(offsets)];
  const rows = frictions.map((friction) => ({
    cells: [
      short(friction),
      ...columns.map((column) => {
        const group = all.find((one) => one.friction === friction && keyOf(one) === keyOf(column));
        return group ? rateCell(group) : "";
      }),
    ],
  }));
  return table(caption, header, rows);
}

function weakestCorner(words) {
  if (words.length === 0) return null;
  return element("div", { class: "weakest" }, element("h3", {}, "Weakest corner"), words.map((one) => element("p", {}, one)));
}

function rounds({ rounds: all, kept_round: kept }) {
  const rows = all.map((round, index) => ({
    class: index + 1 === kept ? "chosen" : "",
    cells: [
      `${index + 1}  ${round.planned}`,
      `${round.training_failures} of ${round.training_cases}`,
      String(round.changes),
      String(round.rollouts),
      round.rate === null ? "–" : percent(round.rate),
      `${(round.solve_s + round.refinement_s).toFixed(1)} s`,
    ],
  }));
  const header = [
    explained("round", "one planning problem, its solution and the refinement of that"),
    explained("failing cases at first", "training rollouts that failed before refinement"),
    explained("perturbations", "perturbations of the reference that improved it and were kept"),
    "rollouts",
    explained("rate", "success rate in the best evaluation"),
    "time",
  ];
  return element(
    "details",
    {},
    element("summary", {}, `Rounds of refinement (${all.length})`),
    table("Rounds of refinement", header, rows),
  );
}
