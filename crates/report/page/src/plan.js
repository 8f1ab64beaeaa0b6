// The page of a plan.
import { chip, element, pageHead } from "./dom.js";
import { followKeys, forceScale, motionChoice, runClock, scenarioChoice, transport, viewChoice, viewOptions } from "./controls.js";
import { plots } from "./plots.js";
import { robustness, test } from "./robustness.js";
import { sceneView } from "./scene.js";
import { followAddress, shareButtons } from "./share.js";
import { rateMatrix } from "./simulation.js";
import { duration, store } from "./state.js";
import { convergence, executions, madeFrom } from "./story.js";
import { themeButton } from "./theme.js";
import { standing, verdict } from "./verdict.js";
import { magnitude } from "./words.js";

export function planPage(root, data) {
  const shown = store({
    motion: firstShown(data.motions),
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
  const about = [
    `start ${result.start}`,
    `offsets of ${magnitude(result.delta_m)}`,
    `${motions[0].scenarios.length} scenarios`,
    `${duration(motions[0]).toFixed(1)} s`,
  ];
  const stage = element("section", { class: "stage", "aria-label": "Motion" });
  const side = element("div", { class: "side" });
  root.append(
    pageHead(result.scene, chip(result.status, standing(result)), about, themeButton()),
    element("main", {}, verdict(data), element("div", { class: "motion" }, stage, side), element("div", { class: "cards" }, cards(data, shown))),
  );
  const { choices, drawer } = motionChoice(data, shown);
  const view = openView(stage, data, shown);
  stage.append(transport(data, shown), choices, scenarioChoice(data, shown), viewOptions(data, shown), drawer);
  side.append(plots(data, shown));
  runClock(data, shown);
  followKeys(data, shown);
  followAddress(stage, view, data, shown);
}

/** What a robot did, else the first rollouts with hard contact. */
function firstShown(motions) {
  const first = (holds) => motions.findIndex(holds);
  const executed = first(({ execution }) => execution);
  return executed >= 0 ? executed : Math.max(first(({ source }) => source === "rollouts"), 0);
}

/** The 3D view below its bar; null and a sentence where the browser cannot draw it. */
function openView(stage, data, shown) {
  const canvas = element("canvas", { tabindex: 0, role: "img", "aria-label": "Parts in motion; drag to rotate, pinch or scroll to zoom" });
  const viewport = element("div", { class: "viewport" }, canvas);
  const { scale, setPixels } = forceScale(shown);
  stage.append(viewport);
  try {
    const view = sceneView(canvas, data, shown, setPixels);
    const { buttons, said } = shareButtons(stage, view, data, shown);
    viewport.before(element("div", { class: "toolbar" }, scale, viewChoice(view), buttons));
    viewport.append(said);
    return view;
  } catch (error) {
    viewport.replaceWith(element("p", { class: "notice" }, `This browser cannot draw in 3D (${error.message}). The plots work without.`));
    return null;
  }
}

function cards(data, shown) {
  const { result, simulation } = data;
  return [
    executions(data),
    result.robust ? robustness(result.robust, data.weakest, result.goal_reached) : null,
    result.tested ? test(result.tested) : null,
    simulation ? rateMatrix(simulation) : null,
    convergence(data, shown),
    madeFrom(data),
  ];
}
