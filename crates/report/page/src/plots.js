// Plots over time, linked by the shown instant.
import { chart } from "./chart.js";
import { element } from "./dom.js";
import { angularVelocities, knots, orientationErrors, positionErrors, velocities } from "./motion.js";
import { onTheme, scenarioColour } from "./theme.js";
import { degrees, magnitude, newtons, scenarioName, short } from "./words.js";

const AXIS_COLOURS = ["#d8453e", "#2f9e44", "#3b7ddd"];
const DEGREES = 180 / Math.PI;

/** What is so during each step, from the start on: the value at a knot is that of the step which ends there. */
const duringSteps = (values) => (values.length === 0 ? [] : [values[0], ...values]);
const component = (values, axis) => duringSteps(values.filter((_, index) => index % 6 === axis));
const scaled = (values, factor) => values.map((value) => (value === null ? null : factor * value));

/** All plots of the shown motion. */
export function plots(data, shown) {
  const root = element("div", { class: "plots" });
  const charts = [];
  const rebuild = () => {
    charts.splice(0).forEach((one) => one.destroy());
    root.replaceChildren();
    const motion = data.motions[shown.values.motion];
    const times = Array.from({ length: knots(motion.reference) }, (_, step) => step * motion.time_step);
    for (const plot of series(data, shown.values, motion, times.length)) {
      const one = chart(plot, times, (time) => shown.set({ time, playing: false }));
      root.append(one.figure);
      one.draw();
      charts.push(one);
    }
    follow();
  };
  const follow = () => charts.forEach((one) => one.moveTo(shown.values.time));
  shown.on(["motion", "selected", "hidden"], rebuild);
  shown.on(["time"], follow);
  new ResizeObserver(() => charts.forEach((one) => one.resize())).observe(root);
  onTheme(rebuild);
  return root;
}

/** All plots with data. Each line has a value for each knot. */
function series(data, shown, motion, count) {
  const all = [
    ...distanceFromRollout(motion),
    ...ofScenarios(data, shown, motion),
    ...ofSelected(data, shown, motion),
    ...ofJoints(data, shown, motion),
  ];
  const filled = (line) => ({ ...line, values: Array.from({ length: count }, (_, step) => line.values[step] ?? null) });
  const known = all.map((plot) => ({ limits: [], ...plot, lines: plot.lines.map(filled).filter(({ values }) => values.some((value) => value !== null)) }));
  return known.filter(({ lines }) => lines.length > 0);
}

/** Errors, contact forces and distances of all scenarios. */
function ofScenarios({ goal, tolerance, result: { limits, delta_m: offset } }, { selected, hidden }, motion) {
  const lines = (values) =>
    motion.scenarios.flatMap((scenario, index) =>
      hidden.has(index)
        ? []
        : {
            end: String(index + 1),
            name: scenarioName(motion, index).replace("scenario ", ""),
            colour: scenarioColour(index),
            width: index === selected ? 2.4 : 1.2,
            values: values(scenario),
          },
    );
  return [
    {
      title: "Position error",
      quantity: "error",
      unit: "mm",
      logarithmic: true,
      limits: [limit("tolerance", tolerance[0], 1e3, magnitude), limit("offset", offset, 1e3, magnitude)].flat(),
      lines: lines(({ poses }) => scaled(positionErrors(poses, goal), 1e3)),
    },
    {
      title: "Orientation error",
      quantity: "error",
      unit: "°",
      logarithmic: true,
      limits: limit("tolerance", tolerance[1], DEGREES, degrees),
      lines: lines(({ poses }) => scaled(orientationErrors(poses, goal), DEGREES)),
    },
    {
      title: "Contact force of the pair that pushes most",
      quantity: "force",
      unit: "N",
      limits: limit("limit", limits.contact_force_n, 1, newtons),
      note: "mean over each step",
      lines: lines(({ forces }) => duringSteps(forces)),
    },
    {
      title: "Smallest distance of all pairs",
      quantity: "distance",
      unit: "mm",
      lines: lines(({ distances }) => scaled(distances, 1e3)),
    },
  ];
}

/** Velocities and wrenches of the selected scenario. */
function ofSelected({ result: { limits } }, { selected }, motion) {
  const scenario = motion.scenarios[selected];
  const of = (title, quantity, unit, largest, values) => ({
    title: `${title}, ${scenarioName(motion, selected)}`,
    quantity,
    unit,
    limits: bothSides(largest, unit),
    lines: [0, 1, 2].map((axis) => ({
      end: "xyz"[axis],
      name: "xyz"[axis],
      colour: AXIS_COLOURS[axis],
      width: 1.6,
      values: values(axis),
    })),
  });
  const speed = limits.translational_velocity_m_s;
  const wrench = (values, first) => (axis) => component(values, first + axis);
  const steps = velocities(scenario.poses, motion.time_step);
  const turns = angularVelocities(scenario.poses, motion.time_step);
  return [
    of("Velocity", "velocity", "mm/s", speed === null ? null : 1e3 * speed, (axis) =>
      duringSteps(steps.map((step) => 1e3 * step[axis])),
    ),
    of("Angular velocity", "velocity", "rad/s", limits.rotational_velocity_rad_s, (axis) => duringSteps(turns.map((step) => step[axis]))),
    of("Controller force", "force", "N", limits.force_n, wrench(scenario.wrenches, 0)),
    of("Controller torque", "torque", "Nm", limits.torque_nm, wrench(scenario.wrenches, 3)),
    of("Measured force at the tool", "force", "N", null, wrench(scenario.measured, 0)),
    of("Measured torque at the tool", "torque", "Nm", null, wrench(scenario.measured, 3)),
  ];
}

/** How far the robot was from the rollout with the same grasp error. */
function distanceFromRollout({ execution }) {
  if (!execution) return [];
  const line = { end: "", name: "distance", colour: scenarioColour(0), width: 2.2, values: scaled(execution.distances, 1e3) };
  return [{ title: "Distance between robot and rollout", quantity: "distance", unit: "mm", lines: [line] }];
}

/** Positions, speeds and torques of the joints, each beside its limits in the legend. */
function ofJoints({ joints }, { selected }, { courses }) {
  if (courses.length === 0) return [];
  const same = joints.every(({ unit }) => unit === joints[0].unit);
  const unit = same ? joints[0].unit : "rad or m";
  const plot = (title, quantity, unitOf, values, range) => ({
    title: `Joint ${title}, scenario ${selected + 1}`,
    quantity,
    unit: unitOf,
    limits: joints.flatMap((joint, index) => range(joint).filter((value) => value !== null).map((value) => ({ value, name: String(index + 1) }))),
    lines: joints.map((joint, index) => ({
      end: String(index + 1),
      name: `${index + 1} ${joint.name}${within(range(joint))}`,
      colour: scenarioColour(index),
      width: 1.6,
      values: values[index],
    })),
  });
  const { positions, speeds, torques } = courses[selected];
  const around = (value) => (value === null ? [] : [-value, value]);
  return [
    plot("positions", "position", unit, positions, ({ range }) => range),
    plot("speeds", "speed", `${unit}/s`, speeds, ({ speed }) => around(speed)),
    plot("torques", "torque", same && unit === "m" ? "N" : "Nm", torques, ({ torque }) => around(torque)),
  ];
}

function within([low, high]) {
  if ((low ?? null) === null && (high ?? null) === null) return "";
  return low === -high ? ` (±${short(high)})` : ` (${short(low)} to ${short(high)})`;
}

/** A limit with its name and value, if there is one. */
function limit(name, value, factor, inWords) {
  return value === null || value === 0 ? [] : [{ value: factor * value, name: `${name} ${inWords(value)}` }];
}

/** A limit of the absolute value, if there is one. */
function bothSides(value, unit) {
  return value === null ? [] : [{ value, name: `limit ±${short(value)} ${unit}` }, { value: -value, name: "" }];
}
