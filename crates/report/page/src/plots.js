// Plots over time, linked by the shown instant.
import uPlot from "uplot";
import { element } from "./dom.js";
import { knots, orientationErrors, positionErrors } from "./motion.js";
import { colour, onTheme, scenarioColour } from "./theme.js";
import { scenarioName } from "./words.js";

const HEIGHT = 108;
const AXIS_COLOURS = ["#d8453e", "#2f9e44", "#3b7ddd"];
const DEGREES = 180 / Math.PI;

/** One value per knot: what is known from the first step on has none at the start. */
const fromFirstStep = (values) => [null, ...values];
const component = (values, axis) => fromFirstStep(values.filter((_, index) => index % 6 === axis));

/** Plots of every scenario. `of` are the values of one of them. */
const BY_SCENARIO = [
  { title: "Position error", unit: "mm", of: ({ poses }, goal) => positionErrors(poses, goal).map((error) => 1e3 * error) },
  { title: "Orientation error", unit: "°", of: ({ poses }, goal) => orientationErrors(poses, goal).map((error) => DEGREES * error) },
  { title: "Contact force, all pairs", unit: "N", of: ({ forces }) => fromFirstStep(forces) },
  {
    title: "Smallest distance",
    unit: "mm",
    of: ({ distances }) => fromFirstStep(distances.map((distance) => (distance === null ? null : 1e3 * distance))),
  },
];
/** Plots of the selected scenario: three components of its wrenches from the first one on. */
const OF_SELECTED = [
  { title: "Controller force", unit: "N", of: ({ wrenches }) => wrenches, first: 0 },
  { title: "Controller torque", unit: "Nm", of: ({ wrenches }) => wrenches, first: 3 },
  { title: "Measured force at the tool", unit: "N", of: ({ measured }) => measured, first: 0 },
  { title: "Measured torque at the tool", unit: "Nm", of: ({ measured }) => measured, first: 3 },
];

/** All plots of the shown motion. */
export function plots(data, shown) {
  const root = element("div", { class: "plots" });
  const charts = [];
  const rebuild = () => {
    charts.splice(0).forEach((chart) => chart.destroy());
    root.replaceChildren();
    const motion = data.motions[shown.values.motion];
    for (const plot of series(data, shown.values, motion)) charts.push(chart(root, plot, shown, motion));
    follow();
  };
  const follow = () => charts.forEach((chart) => chart.moveTo(shown.values.time));
  shown.on(["motion", "selected", "hidden"], rebuild);
  shown.on(["time"], follow);
  new ResizeObserver(() => charts.forEach((chart) => chart.resize())).observe(root);
  onTheme(rebuild);
  return root;
}

/** Title, unit and lines of every plot. */
function series(data, { selected, hidden }, motion) {
  const visible = motion.scenarios.map((_, index) => index).filter((index) => !hidden.has(index));
  const byScenario = BY_SCENARIO.map(({ title, unit, of }) => ({
    title,
    unit,
    lines: visible.map((index) => ({
      name: scenarioName(motion, index),
      colour: scenarioColour(index),
      width: index === selected ? 2.2 : 1.1,
      leads: index === selected,
      values: of(motion.scenarios[index], data.goal),
    })),
  }));
  const ofSelected = OF_SELECTED.map(({ title, unit, of, first }) => ({
    title: `${title}, ${scenarioName(motion, selected)}`,
    unit,
    lines: [0, 1, 2].map((axis) => ({
      name: "xyz"[axis],
      colour: AXIS_COLOURS[axis],
      width: 1.5,
      values: component(of(motion.scenarios[selected]), first + axis),
    })),
  }));
  const joints = motion.source === "plan" && data.arm ? jointPlots(data.arm, selected) : [];
  const all = [...distanceFromRollout(motion), ...byScenario, ...ofSelected, ...joints];
  const known = all.map((plot) => ({ ...plot, lines: plot.lines.filter(({ values }) => values.some((value) => value !== null)) }));
  return known.filter(({ lines }) => lines.length > 0);
}

/** How far the robot was from the rollout with the same grasp error. */
function distanceFromRollout({ execution }) {
  if (!execution) return [];
  const values = execution.distances.map((distance) => (distance === null ? null : 1e3 * distance));
  return [{ title: "Distance between robot and rollout", unit: "mm", lines: [{ name: "distance", colour: scenarioColour(0), width: 2.2, leads: true, values }] }];
}

function jointPlots({ joints, scenarios }, selected) {
  const unit = joints.every(({ unit }) => unit === joints[0].unit) ? joints[0].unit : "rad or m";
  const lines = (values) =>
    joints.map(({ name }, joint) => ({ name, colour: scenarioColour(joint), width: 1.5, values: values[joint] }));
  const { positions, speeds, torques } = scenarios[selected];
  return [
    { title: `Joint positions, scenario ${selected + 1}`, unit, lines: lines(positions) },
    { title: `Joint speeds, scenario ${selected + 1}`, unit: `${unit}/s`, lines: lines(speeds) },
    { title: `Joint torques, scenario ${selected + 1}`, unit: unit === "m" ? "N" : "Nm", lines: lines(torques) },
  ];
}

/** One plot in a figure of its own. */
function chart(root, { title, unit, lines }, shown, { reference, time_step: timeStep }) {
  const value = element("output", { class: "value" });
  const frame = element("div", { class: "frame" });
  const leading = lines.findIndex(({ leads }) => leads);
  const key = lines.map(({ name, colour }) => element("span", { class: "key", style: `--mark:${colour}` }, name));
  const isLong = lines.length > 3;
  const caption = element(
    "figcaption",
    {},
    element("span", {}, title),
    leading < 0 ? element("span", { class: isLong ? "legend" : "axes" }, key) : null,
    value,
  );
  root.append(element("figure", { class: "plot" }, caption, frame));
  const length = knots(reference);
  const times = Array.from({ length }, (_, step) => step * timeStep);
  // A motion that ended early has nothing at the end.
  const columns = lines.map(({ values }) => times.map((_, step) => values[step] ?? null));
  const plot = new uPlot(options(frame, lines), [times, ...columns], frame);
  const now = element("div", { class: "now" });
  plot.over.append(now);
  plot.over.setAttribute("role", "img");
  plot.over.setAttribute("aria-label", `${title} (${unit}) over time`);
  const seek = (event) => {
    const { left } = plot.over.getBoundingClientRect();
    shown.set({ time: Math.min(Math.max(plot.posToVal(event.clientX - left, "x"), 0), times[length - 1]), playing: false });
  };
  plot.over.addEventListener("pointerdown", (event) => {
    plot.over.setPointerCapture(event.pointerId);
    seek(event);
  });
  plot.over.addEventListener("pointermove", (event) => event.buttons === 1 && seek(event));
  let moment = 0;
  return {
    moveTo(time) {
      moment = time;
      now.style.transform = `translateX(${plot.valToPos(time, "x")}px)`;
      const step = Math.min(Math.round(time / timeStep), length - 1);
      const read = (column) => (column[step] === null ? "–" : column[step].toFixed(2));
      const values = leading < 0 ? columns : [columns[leading]];
      value.textContent = isLong && leading < 0 ? unit : `${values.map(read).join(", ")} ${unit}`;
    },
    resize() {
      if (frame.clientWidth > 0 && frame.clientWidth !== plot.width) {
        plot.setSize({ width: frame.clientWidth, height: HEIGHT });
        this.moveTo(moment);
      }
    },
    destroy: () => plot.destroy(),
  };
}

function options(frame, lines) {
  const axis = {
    stroke: colour("faint"),
    font: "11px system-ui, sans-serif",
    grid: { stroke: colour("line"), width: 1 },
    ticks: { show: false },
  };
  return {
    width: Math.max(frame.clientWidth, 120),
    height: HEIGHT,
    legend: { show: false },
    cursor: { show: false },
    padding: [6, 8, 0, 0],
    scales: { x: { time: false }, y: { range: (_, low, high) => padded(low, high) } },
    axes: [
      { ...axis, size: 24, gap: 3, space: 50 },
      { ...axis, size: 46, gap: 4, space: 26 },
    ],
    series: [{}, ...lines.map(({ colour: stroke, width }) => ({ stroke, width, points: { show: false } }))],
  };
}

/** A range with some room, which includes zero where it is near. */
function padded(low, high) {
  if (low === null || low === undefined) return [0, 1];
  const bottom = low > 0 && low < 0.5 * high ? 0 : low;
  const room = Math.max(0.06 * (high - bottom), 1e-6);
  return [bottom === 0 ? 0 : bottom - room, high + room];
}
