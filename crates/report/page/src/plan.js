// The page of a plan.
import { chip, element, pageHead } from "./dom.js";
import { followKeys, motionChoice, runClock, scenarioChoice, transport, viewOptions } from "./controls.js";
import { plots } from "./plots.js";
import { robustness } from "./robustness.js";
import { sceneView } from "./scene.js";
import { rateMatrix } from "./simulation.js";
import { duration, store } from "./state.js";
import { convergence, executions, madeFrom, notes } from "./story.js";
import { themeButton } from "./theme.js";
import { magnitude } from "./words.js";

export function planPage(root, data) {
  // Who names a log wants to see what the robot did.
  const executed = data.motions.findIndex(({ execution }) => execution);
  const shown = store({
    motion: Math.max(executed, 0),
    time: 0,
    playing: false,
    speed: 1,
    selected: 0,
    hidden: new Set(),
    showReference: true,
    showForces: true,
    showArm: true,
    showSmoothed: true,
    cut: "none",
    cutAt: 0,
  });
  const { result, motions } = data;
  const facts = [
    `start ${result.start}`,
    `offsets of ${magnitude(result.delta_m)}`,
    `${motions[0].scenarios.length} scenarios`,
    `${duration(motions[0]).toFixed(1)} s`,
  ];
  const canvas = element("canvas", { tabindex: 0, role: "img", "aria-label": "Parts in motion; drag to turn, pinch or scroll to zoom" });
  const viewport = element("div", { class: "viewport" }, canvas);
  const side = element("div", { class: "side" });
  const stage = element("section", { class: "stage", "aria-label": "Motion" }, viewport);
  root.append(
    pageHead(result.scene, chip(result.status, result.done), facts, themeButton()),
    element("main", {}, stage, side, element("div", { class: "cards" }, cards(data, shown))),
  );
  const view = openView(canvas, data, shown);
  const { options, views } = viewOptions(data, shown, view);
  viewport.append(views);
  stage.append(transport(data, shown), ...motionChoice(data, shown), scenarioChoice(data, shown), options);
  side.append(plots(data, shown));
  runClock(data, shown);
  followKeys(data, shown);
}

/** The 3D view, or a sentence where the browser cannot draw it. */
function openView(canvas, data, shown) {
  try {
    return sceneView(canvas, data, shown);
  } catch (error) {
    canvas.replaceWith(element("p", { class: "notice" }, `This browser cannot draw in 3D (${error.message}). The plots work without.`));
    return { look() {} };
  }
}

function cards(data, shown) {
  const { result, simulation } = data;
  return [
    executions(data),
    notes(data),
    result.robust ? robustness(result, data.weakest) : null,
    simulation ? rateMatrix(simulation) : null,
    convergence(data, shown),
    madeFrom(data),
  ];
}
