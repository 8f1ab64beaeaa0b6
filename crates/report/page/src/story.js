// How the plan came about: homotopy, time, what it was made from, what robots did.
import { card, drawer, element, explained, facts, table } from "./dom.js";
import { millimetres, short } from "./words.js";

const SPLIT = [
  ["distances", "Distances", "--part-1"],
  ["model", "Model", "--part-2"],
  ["linear_solver", "Linear solver", "--part-3"],
  ["rest", "Ipopt", "--part-4"],
];
const COLUMNS = [
  "no.",
  explained("τ (N m)", "smoothing of the shapes: the smaller, the harder the contact"),
  explained("steps", "steps of its grid of time"),
  explained("iterations", "iterations of the solver Ipopt"),
  "cost",
  explained("violation", "how far the worst constraint is from being kept, in its own unit"),
  explained("penetration", "how deep the exact shapes lie within each other"),
  "status",
  "time",
];

/** One row per homotopy step; a click on its number shows it. */
export function convergence({ result, motions }, shown) {
  const longest = Math.max(...result.stages.map(({ wall_s: time }) => time));
  const rows = result.stages.map((stage, index) => ({
    class: index + 1 === result.chosen_stage ? "chosen" : "",
    cells: [
      element("button", { class: "link", type: "button", click: () => show(motions, shown, index + 1) }, String(index + 1)),
      short(stage.tau),
      String(stage.steps),
      String(stage.iterations),
      short(stage.objective),
      short(stage.constraint_violation),
      millimetres(stage.max_penetration_m, 2),
      stage.status,
      timeBar(stage, longest),
    ],
  }));
  const key = SPLIT.map(([, name, mark]) => element("span", { class: "key mark", style: `--mark:var(${mark})` }, name));
  const total = `${result.iterations} iterations of Ipopt in ${result.wall_s.toFixed(2)} s, linear solver ${result.linear_solver}.`;
  return drawer(
    "Convergence of the homotopy",
    "how the solver found the plan, iteration by iteration",
    element("p", {}, "The solver plans with smoothed shapes first and hardens them in each homotopy step. A click on a number shows it. ", total),
    table("Homotopy steps", COLUMNS, rows),
    element("p", { class: "keys" }, key),
    attempts(result.attempts ?? []),
  );
}

function show(motions, shown, number) {
  const motion = motions.findIndex((one) => one.source === "iteration" && one.number === number);
  shown.set({ motion, selected: 0, hidden: new Set(), time: 0 });
  document.querySelector(".stage").scrollIntoView({ block: "nearest" });
}

function timeBar({ wall_s: time, wall_split_s: split }, longest) {
  const parts = SPLIT.map(([key, name, mark]) =>
    element("span", { style: `width:${(100 * split[key]) / longest}%;background:var(${mark})`, title: `${name}: ${split[key].toFixed(3)} s` }),
  );
  return element("span", { class: "time" }, element("span", { class: "bar", "aria-hidden": "true" }, parts), `${time.toFixed(2)} s`);
}

function attempts(tried) {
  if (tried.length === 0) return null;
  const rows = tried.map((attempt) => ({
    cells: [attempt.planned, attempt.status, millimetres(attempt.position_error_m), String(attempt.iterations), `${attempt.wall_s.toFixed(1)} s`],
  }));
  return table("What was tried", ["tried", "status", "ends from the goal", "iterations", "time"], rows);
}

/** Facts of the scene, and versions. */
export function madeFrom({ made_from: known, result }) {
  const all = [
    ...known,
    ["written by", `assembly-plan ${result.versions.assembly_plan}, Ipopt ${result.versions.ipopt}`],
    ["identity of the problem", result.made_from.problem.slice(0, 16)],
  ];
  return card("Made from", facts(all));
}

/** The executions of robots, from their logs. */
export function executions({ motions }) {
  const executed = motions.filter(({ execution }) => execution);
  if (executed.length === 0) return null;
  const story = ({ execution: { log, sentences } }) => [
    element("h3", {}, log),
    element("ul", { class: "notes" }, sentences.map((words) => element("li", {}, words))),
  ];
  return card("Executed", ...executed.flatMap(story));
}
