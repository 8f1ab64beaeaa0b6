// What the page begins with: whether the plan may be relied on, by which numbers, and what nobody has tested.
import { element, explained, facts, table } from "./dom.js";
import { rateCell, together } from "./rates.js";
import { duration } from "./state.js";
import { degrees, listed, magnitude, millimetres, newtons, short } from "./words.js";

/** Remarks that are shown at once. */
const SHOWN = 2;

/** Whether a plan may be relied on: `good`, `open` where it is planned only, or `bad`. */
export function standing({ done, converged, goal_reached: reached, robust }) {
  if (done && robust) return "good";
  return converged && reached && !robust ? "open" : "bad";
}

/** The panel at the top of the page of a plan. */
export function verdict(data) {
  const { result, tolerance } = data;
  return element(
    "section",
    { class: `verdict ${standing(result)}`, "aria-labelledby": "verdict" },
    element("h2", { id: "verdict" }, conclusion(data)),
    element("p", {}, `Success means to end within ${magnitude(tolerance[0])} and ${degrees(tolerance[1])} of the goal.`),
    element(
      "div",
      { class: "evidence" },
      element("div", {}, ends(data), ...evidence(data)),
      element("div", {}, facts(numbers(data))),
    ),
    remarks(result.done, data.notes),
  );
}

/** The whole in a sentence. */
function conclusion({ result, motions }) {
  const rollouts = hardContact(motions).flatMap(({ scenarios }) => scenarios);
  const succeed = rollouts.filter(({ success }) => success).length;
  const played = `${succeed} of ${rollouts.length} rollouts of the planned offsets with hard contact reach it`;
  return {
    good: `The plan reaches the goal: ${played}.`,
    open: `The plan reaches the goal in the smoothed model only; ${played}.`,
    bad: `The plan does not do what was asked for: ${result.status}; ${played}.`,
  }[standing(result)];
}

/** The rollouts with hard contact. */
export const hardContact = (motions) => motions.filter(({ source }) => source === "rollouts");

/** Success rates of rollouts with random errors. */
export const ratesOf = ({ robust, tested }) => robust?.after ?? tested?.rates ?? [];

/** How scenarios end, by model and friction. */
function ends({ result, motions }) {
  const rates = ratesOf(result);
  const smoothed = motions.filter(({ source }) => source === "plan");
  const rows = [...smoothed, ...hardContact(motions)].map((motion) => {
    const all = motion.scenarios;
    const largest = (of) => Math.max(...all.map(of));
    const reached = all.filter(({ success }) => success).length;
    return {
      cells: [
        motion.source === "plan" ? "smoothed model" : `hard contact, friction ${short(motion.friction)}`,
        ...(rates.length === 0 ? [] : [rateCell(together(rates.filter(({ friction }) => friction === motion.friction)))]),
        element("span", { class: reached < all.length ? "missed" : "" }, `${reached} of ${all.length}`),
        `${millimetres(largest(({ errors }) => errors[0]))}, ${degrees(largest(({ errors }) => errors[1]))}`,
        newtons(largest(({ max_force: force }) => force)),
      ],
    };
  });
  const header = [
    "contact",
    ...(rates.length === 0 ? [] : [explained("success", "share of rollouts with random errors that end at the goal, with Wilson's interval of 95 %")]),
    explained("planned offsets", "how many of the planned offsets end at the goal"),
    explained("end at most", "distance from the goal and angle to it, of the planned offsets"),
    explained("largest force", "contact force of a pair of parts, of the planned offsets"),
  ];
  return table("How the plan ends", header, rows);
}

/** Numbers that matter to who executes the plan. */
export function numbers({ result, motions, engagement_depth: depth }) {
  const { limits, gains, motion, reached } = result;
  const at = ({ largest, time_s: time }, inWords) => `${inWords(largest)} at ${time.toFixed(2)} s`;
  const played = hardContact(motions).flatMap(({ scenarios }) => scenarios.map(({ max_force: force }) => force));
  const force = Math.max(motion?.max_force_n ?? reached.contact_force_n, ...played);
  const allowed = limits.contact_force_n === null ? "no limit is set" : `of ${newtons(limits.contact_force_n)} allowed`;
  const known = [
    ["largest contact force", `${newtons(force)}, ${allowed}`],
    motion && ["rotation from the straight motion", at(motion.rotation, degrees)],
    motion && ["departure from the straight path", at(motion.departure, magnitude)],
    ["duration", `${duration(motions[0]).toFixed(2)} s`],
    ["stiffness of the controller", `${short(gains.translational_stiffness_n_m)} N/m, ${short(gains.rotational_stiffness_nm_rad)} Nm/rad`],
    ["offsets", covered(result)],
    depth && ["parts engage", `${magnitude(depth)} deep`],
  ];
  return known.filter(Boolean);
}

/** Which offsets a plan covers. */
function covered({ delta_m: delta, coverage }) {
  const radius = magnitude(coverage?.radius_m ?? delta);
  return {
    hull: `inside the hull of the planned ones, ${radius} in the worst direction`,
    disc: `up to ${radius} in any direction across the insertion`,
    ball: `up to ${radius} in any direction`,
  }[coverage?.kind] ?? radius;
}

/** What the plan was tested with, what not, and whether no plan is needed. */
function evidence({ result, motions, errors: { varied, left_out: missing } }) {
  const rates = ratesOf(result);
  const [logs, isPlayed] = [motions.filter(({ execution }) => execution).length, rates.length > 0];
  const rollouts = `${together(rates).rollouts} rollouts with hard contact and random offsets`;
  const planned = "rollouts of the planned offsets with hard contact, made for this page";
  const tested = [isPlayed ? rollouts : planned, isPlayed ? varied : [], logs > 0 ? `a robot (${logs === 1 ? "1 log" : `${logs} logs`})` : []];
  const untested = [isPlayed ? missing : ["random offsets", ...missing], "elastic parts", logs > 0 ? [] : "a robot"];
  const push = (result.robust ?? result.tested)?.push;
  const paragraph = (name, words) => element("p", {}, element("b", {}, name), ` ${listed(words.flat())}.`);
  return [
    paragraph("Tested with", tested),
    paragraph("Not tested with", untested),
    push?.reached && element("p", {}, element("b", {}, "A straight push does it too"), ": this insertion needs no plan."),
  ];
}

/** Warnings and reasons, the first of them at once. */
function remarks(done, all) {
  if (all.length === 0) return null;
  const list = (some) => element("ul", { class: "notes" }, some.map((note) => element("li", {}, note)));
  const others = all.slice(SHOWN);
  return element(
    "div",
    { class: "remarks" },
    element("h3", {}, done ? "Warnings" : "What to look at"),
    list(all.slice(0, SHOWN)),
    others.length === 0 ? null : element("details", {}, element("summary", {}, `${others.length} more`), list(others)),
  );
}
