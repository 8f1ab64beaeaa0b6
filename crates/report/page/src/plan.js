// The page of a plan.
import { chip, element, pageHead } from "./dom.js";
import { followKeys, motionChoice, runClock, scenarioChoice, transport, viewOptions } from "./controls.js";
import { plots } from "./plots.js";
import { robustness, test } from "./robustness.js";
import { followAddress, fullScreenButton, linkButton, pictureButton } from "./share.js";
import { rateMatrix } from "./simulation.js";
import { atFirst, openView } from "./stage.js";
import { duration, store } from "./state.js";
import { convergence, executions, madeFrom } from "./story.js";
import { themeButton } from "./theme.js";
import { tolerance } from "./tolerance.js";
import { standing, verdict } from "./verdict.js";
import { magnitude } from "./words.js";

export function planPage(root, data) {
  const shown = store(atFirst(data));
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
  const share = (view, say) => [pictureButton(view, data, shown), fullScreenButton(stage), linkButton(view, shown, say)];
  const view = openView(stage, data, shown, { share });
  const end = () => duration(motions[shown.values.motion]);
  stage.append(transport(shown, end), choices, scenarioChoice(data, shown), viewOptions(data, shown), drawer);
  side.append(plots(data, shown));
  runClock(shown, end);
  followKeys(shown, end, () => motions[shown.values.motion].time_step);
  followAddress(stage, view, data, shown);
}

function cards(data, shown) {
  const { result, simulation } = data;
  return [
    executions(data),
    result.robust ? robustness(result.robust, data.weakest, result.goal_reached) : null,
    result.tested ? test(result.tested) : null,
    simulation ? rateMatrix(simulation) : null,
    data.tolerated ? tolerance(data.tolerated) : null,
    convergence(data, shown),
    madeFrom(data),
  ];
}
