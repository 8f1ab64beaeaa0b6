// The stage of a plan: its 3D view with a bar of buttons, and what it shows at first.
import { forceScale, viewChoice } from "./controls.js";
import { element } from "./dom.js";
import { sceneView } from "./scene.js";
import { speaker } from "./share.js";

/** What the page of a plan shows at first. */
export const atFirst = (data) => ({
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

/** What a robot did, else the first rollouts with hard contact. */
function firstShown(motions) {
  const first = (holds) => motions.findIndex(holds);
  const executed = first(({ execution }) => execution);
  return executed >= 0 ? executed : Math.max(first(({ source }) => source === "rollouts"), 0);
}

/**
 * The 3D view below its bar; null and a sentence where the browser cannot draw it. The view has room for `plans`, and its bar the
 * buttons that `share` makes for it.
 */
export function openView(stage, data, shown, { plans = [data], share }) {
  const canvas = element("canvas", { tabindex: 0, role: "img", "aria-label": "Parts in motion; drag to rotate, pinch or scroll to zoom" });
  const viewport = element("div", { class: "viewport" }, canvas);
  const { scale, setPixels } = forceScale(shown);
  stage.append(viewport);
  try {
    const view = sceneView(canvas, data, plans, shown, setPixels);
    const { said, say } = speaker();
    const buttons = element("div", { class: "views share", role: "group", "aria-label": "Share" }, share(view, say));
    viewport.before(element("div", { class: "toolbar" }, scale, viewChoice(view), buttons));
    viewport.append(said);
    return view;
  } catch (error) {
    viewport.replaceWith(element("p", { class: "notice" }, `This browser cannot draw in 3D (${error.message}). The plots work without.`));
    return null;
  }
}
