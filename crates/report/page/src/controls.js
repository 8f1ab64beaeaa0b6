// Play, scrub, choose what is shown; keys.
import { drawing, element } from "./dom.js";
import { duration } from "./state.js";
import { scenarioColour } from "./theme.js";
import { VIEWS } from "./scene.js";
import { injectionInWords, newtons, scenarioName, short } from "./words.js";

const SPEEDS = [0.1, 0.25, 0.5, 1, 2];
/** An open eye, and a closed one: strokes in a square of 16. */
const EYES = {
  true: ["M1 8C3 4.5 5.3 3 8 3s5 1.5 7 5c-2 3.5-4.3 5-7 5S3 11.5 1 8Z", "M8 6a2 2 0 1 0 0 4a2 2 0 1 0 0-4Z"],
  false: ["M1 7c2 3.5 4.3 5 7 5s5-1.5 7-5", "M3 9.8L1.5 11.8M8 12v2.5M13 9.8l1.5 2"],
};
/** Shortest arrow of the scale (px). */
const SCALE = 34;

/** Time runs while the page plays; the motion restarts at its end (s). */
export function runClock(shown, end) {
  let before = null;
  function tick(now) {
    const { playing, time, speed } = shown.values;
    if (!playing) {
      before = null;
      return;
    }
    const passed = before === null ? 0 : (speed * (now - before)) / 1e3;
    before = now;
    // The end is shown for a moment.
    shown.set({ time: time >= end() ? 0 : Math.min(time + passed, end()) });
    requestAnimationFrame(tick);
  }
  shown.on(["playing"], ({ playing }) => playing && requestAnimationFrame(tick));
}

/** Play button, time and speed, for motions that end at a time (s). */
export function transport(shown, end) {
  const play = element("button", { class: "play", type: "button", click: () => toggle(shown) });
  const scrub = element("input", {
    type: "range",
    min: 0,
    step: "any",
    "aria-label": "Time",
    input: () => shown.set({ time: Number(scrub.value), playing: false }),
  });
  const clock = element("output", { class: "clock" });
  const speed = element(
    "select",
    { "aria-label": "Speed", change: () => shown.set({ speed: Number(speed.value) }) },
    SPEEDS.map((value) => element("option", { value, selected: value === shown.values.speed }, `${value}×`)),
  );
  shown.on(["playing"], ({ playing }) => {
    play.textContent = playing ? "❚❚" : "▶";
    play.setAttribute("aria-label", playing ? "Pause" : "Play");
  });
  shown.on(["motion", "time"], ({ time }) => {
    scrub.max = end();
    scrub.value = time;
    scrub.setAttribute("aria-valuetext", `${time.toFixed(2)} seconds`);
    clock.textContent = `${time.toFixed(2)} / ${end().toFixed(2)} s`;
  });
  return element("div", { class: "transport" }, play, scrub, clock, speed);
}

function toggle(shown) {
  shown.set({ playing: !shown.values.playing });
}

/** Which motion is shown: rollouts and what robots did first, how the plan was found in a drawer. */
export function motionChoice(data, shown) {
  const from = (source) => data.motions.filter((motion) => motion.source === source);
  const indexOf = (motion) => data.motions.indexOf(motion);
  const [iterations, smoothed] = [from("iteration"), from("plan")];
  const choose = (motion) => shown.set({ motion, selected: 0, hidden: new Set(), time: ofSameShare(data, shown.values, motion) });
  const button = (name, motion, isShown) => {
    const node = element("button", { type: "button", click: () => choose(indexOf(motion)) }, name);
    shown.on(["motion"], (values) => node.setAttribute("aria-pressed", isShown(data.motions[values.motion])));
    return node;
  };
  const slider = element("input", {
    type: "range",
    min: 1,
    max: iterations.length,
    step: 1,
    "aria-label": "Homotopy step",
    input: () => choose(indexOf(iterations[Number(slider.value) - 1])),
  });
  const label = element("output", {});
  const row = element("label", { class: "iteration" }, label, slider);
  const drawer = element(
    "details",
    { class: "homotopy" },
    element("summary", {}, "How the plan was found: smoothed model and homotopy"),
    element(
      "p",
      {},
      "The solver replaces hard contact by a smoothed model, in which shapes have rounded corners and push from a distance, " +
        "and hardens it from one homotopy step to the next. No robot moves like that.",
    ),
    element(
      "div",
      { class: "segments", role: "group", "aria-label": "Smoothed motion" },
      smoothed.map((motion) => button("Smoothed plan", motion, ({ source }) => source === "plan")),
      button("Homotopy", iterations.at(-1), ({ source }) => source === "iteration"),
    ),
    row,
  );
  shown.on(["motion"], ({ motion }) => {
    const { source, number, tau } = data.motions[motion];
    row.hidden = source !== "iteration";
    drawer.open ||= source === "iteration" || source === "plan";
    if (source !== "iteration") return;
    slider.value = number;
    slider.setAttribute("aria-valuetext", `${number} of ${iterations.length}`);
    label.textContent = `Homotopy step ${number} of ${iterations.length}, τ = ${short(tau)} N m`;
  });
  const choices = element(
    "div",
    { class: "segments", role: "group", "aria-label": "Motion" },
    [...from("executed"), ...from("rollouts")].map((motion) => button(motionName(motion), motion, (other) => other === motion)),
  );
  return { choices, drawer };
}

function motionName({ friction, scenarios, execution }) {
  if (execution) return `Executed: ${execution.log}`;
  const failed = scenarios.filter(({ success }) => !success).length;
  const result = failed === 0 ? "" : ` (${failed} of ${scenarios.length} ${failed === 1 ? "fails" : "fail"})`;
  return `Hard contact, friction ${short(friction)}${result}`;
}

/** The time of another motion with the same share of it done. */
function ofSameShare(data, { motion, time }, other) {
  return (time / Math.max(duration(data.motions[motion]), 1e-9)) * duration(data.motions[other]);
}

/** Buttons of the scenarios: a click selects one, its eye hides it. */
export function scenarioChoice(data, shown) {
  const list = element("div", { class: "scenarios", role: "group", "aria-label": "Scenarios" });
  shown.on(["motion", "selected", "hidden"], ({ motion, selected, hidden }) => {
    const focused = list.contains(document.activeElement) ? document.activeElement.dataset.name : null;
    list.replaceChildren(
      ...data.motions[motion].scenarios.map((scenario, index) => {
        const { execution } = data.motions[motion];
        const ownName = scenarioName(data.motions[motion], index);
        const isShown = !hidden.has(index);
        const name = `${ownName}: ${injectionInWords(scenario)}`;
        const select = element(
          "button",
          {
            type: "button",
            "aria-pressed": String(index === selected),
            "data-name": `select ${index}`,
            click: () => shown.set({ selected: index, hidden: without(hidden, index) }),
          },
          element("span", { class: "dot", style: `--mark:${scenarioColour(index)}` }),
          execution ? ownName : `${index + 1}  ${injectionInWords(scenario)}`,
          scenario.success ? null : element("span", { class: "missed" }, failure(execution, index)),
        );
        const eye = element(
          "button",
          {
            class: "eye",
            type: "button",
            title: `${isShown ? "Hide" : "Show"} ${ownName}`,
            "aria-label": `Show ${name}`,
            "aria-pressed": String(isShown),
            "data-name": `show ${index}`,
            click: () => shown.set({ hidden: hidden.has(index) ? without(hidden, index) : new Set([...hidden, index]) }),
          },
          drawing("svg", { viewBox: "0 0 16 16", "aria-hidden": "true" }, EYES[isShown].map((d) => drawing("path", { d }))),
        );
        return element("span", { class: "scenario" }, select, eye);
      }),
    );
    list.querySelector(`[data-name="${focused}"]`)?.focus();
  });
  return list;
}

/** How a scenario that does not reach the goal ends; the first one of an execution is the robot. */
function failure(execution, index) {
  return index === 0 && execution?.stopped ? `stopped after ${execution.stopped.toFixed(2)} s` : "misses the goal";
}

function without(set, member) {
  return new Set([...set].filter((other) => other !== member));
}

/** What is drawn besides the bodies, and the cut. */
export function viewOptions(data, shown) {
  const check = (name, key) => {
    const box = element("input", { type: "checkbox", change: () => shown.set({ [key]: box.checked }) });
    shown.on([key], (values) => (box.checked = values[key]));
    return element("label", { class: "check" }, box, name);
  };
  const smoothed = check("Smoothed shapes", "showSmoothed");
  shown.on(["motion"], ({ motion }) => (smoothed.hidden = data.motions[motion].source !== "iteration"));
  const arm = data.joints.length > 0 ? check("Arm", "showArm") : null;
  if (arm) shown.on(["motion"], ({ motion }) => (arm.hidden = data.motions[motion].courses.length === 0));
  const cut = element(
    "select",
    { change: () => shown.set({ cut: cut.value }) },
    ["none", "x", "y", "z"].map((axis) => element("option", { value: axis }, axis === "none" ? "no cut" : `cut along ${axis}`)),
  );
  const depth = element("input", {
    type: "range",
    min: -1,
    max: 1,
    step: 0.01,
    "aria-label": "Place of the cut",
    input: () => shown.set({ cutAt: Number(depth.value) }),
  });
  shown.on(["cut", "cutAt"], (values) => {
    depth.hidden = values.cut === "none";
    depth.value = values.cutAt;
    cut.value = values.cut;
  });
  cut.setAttribute("aria-label", "Cut");
  return element("div", { class: "options" }, check("Reference", "showReference"), check("Forces", "showForces"), arm, smoothed, cut, depth);
}

/** Buttons of the directions from which the view looks. */
export function viewChoice(view) {
  const button = (name) => element("button", { type: "button", "aria-label": `View ${name}`, click: () => view.look(name) }, name);
  return element("div", { class: "views", role: "group", "aria-label": "View" }, Object.keys(VIEWS).map(button));
}

/** The arrow of a round force, as long as it is in the middle of the view. */
export function forceScale(shown) {
  const line = drawing("path", { d: "M0 6H0" });
  const words = element("span", {});
  const scale = element("span", { class: "scale" }, drawing("svg", { height: 12, "aria-hidden": "true" }, line), words);
  shown.on(["showForces"], ({ showForces }) => (scale.hidden = !showForces));
  return {
    scale,
    /** For a number of pixels per newton; null without arrows. */
    setPixels(perNewton) {
      scale.classList.toggle("none", perNewton === null);
      if (perNewton === null) return;
      const force = roundAbove(SCALE / perNewton);
      const length = Math.round(perNewton * force);
      line.ownerSVGElement.setAttribute("width", length + 2);
      line.setAttribute("d", `M0 6H${length}M${length - 8} 1.5L${length} 6L${length - 8} 10.5`);
      words.textContent = newtons(force);
    },
  };
}

/** The least of 1, 2, 5, 10 ... that is not below a number. */
function roundAbove(number) {
  const decade = 10 ** Math.floor(Math.log10(number));
  return Number((decade * [1, 2, 5, 10].find((factor) => factor * decade >= number * (1 - 1e-9))).toPrecision(1));
}

/** Space plays, arrows go one time step (s), Home and End to the ends. */
export function followKeys(shown, end, timeStep) {
  document.addEventListener("keydown", (event) => {
    const isOccupied = event.target.closest?.("button, select, input, summary, a, [role=region]");
    if (isOccupied || event.ctrlKey || event.metaKey || event.altKey) return;
    const { time } = shown.values;
    const step = timeStep();
    const goTo = (moment) => shown.set({ time: Math.min(Math.max(moment, 0), end()), playing: false });
    const actions = {
      " ": () => toggle(shown),
      ArrowRight: () => goTo((Math.round(time / step) + 1) * step),
      ArrowLeft: () => goTo((Math.round(time / step) - 1) * step),
      Home: () => goTo(0),
      End: () => goTo(end()),
    };
    if (actions[event.key]) {
      event.preventDefault();
      actions[event.key]();
    }
  });
}
