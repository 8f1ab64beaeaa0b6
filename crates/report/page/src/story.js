// How the plan came about: homotopy, time, what it was made from, what to watch.
import { card, element, table } from "./dom.js";
import { millimetres, sentence, short } from "./words.js";

const SPLIT = [
  ["distances", "Distances", "--part-1"],
  ["model", "Model", "--part-2"],
  ["linear_solver", "Linear solver", "--part-3"],
  ["rest", "Ipopt", "--part-4"],
];

/** One row per homotopy iteration; a click on its number shows it. */
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
  const key = SPLIT.map(([, name, mark]) => element("span", { class: "key", style: `--mark:var(${mark})` }, name));
  const total = `${result.iterations} iterations of Ipopt in ${result.wall_s.toFixed(2)} s, linear solver ${result.linear_solver}.`;
  return card(
    "Convergence",
    element("p", {}, total),
    table("Homotopy iterations", ["no.", "τ (N m)", "steps", "iterations", "cost", "violation", "overlap", "status", "time"], rows),
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
export function madeFrom({ made_from: facts, result }) {
  const all = [
    ...facts,
    ["written by", `assembly-plan ${result.versions.assembly_plan}, Ipopt ${result.versions.ipopt}`],
    ["identity", result.made_from.problem.slice(0, 16)],
  ];
  const pairs = all.map(([name, value]) => element("div", {}, element("dt", {}, name), element("dd", {}, value)));
  return card("Made from", element("dl", {}, pairs));
}

/** What the logs of robots tell. */
export function executions({ motions }) {
  const executed = motions.filter(({ execution }) => execution);
  if (executed.length === 0) return null;
  const story = ({ execution: { log, sentences } }) => [
    element("h3", {}, log),
    element("ul", { class: "notes" }, sentences.map((words) => element("li", {}, sentence(words)))),
  ];
  return card("Executed", ...executed.flatMap(story));
}

/** Warnings, and why a plan is not done. */
export function notes({ result, notes: all }) {
  if (all.length === 0) return null;
  const list = all.map((note) => element("li", {}, sentence(note)));
  return card(result.done ? "Warnings" : "What to look at", element("ul", { class: "notes" }, list));
}
