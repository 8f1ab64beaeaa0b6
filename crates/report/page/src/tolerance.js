// Which errors a plan tolerates: its boundaries, and a map of one quantity by another one.
import { card, drawing, element, explained, facts, pageHead, table } from "./dom.js";
import { rateMatrix } from "./simulation.js";
import { themeButton } from "./theme.js";
import { linearRange, linearTicks } from "./ticks.js";
import { degrees, listed, magnitude, percent, short } from "./words.js";

/** Units in which people read quantities, how many of these are one SI unit, and decimals. */
const LENGTH = { unit: "mm", scale: 1e3, decimals: 2 };
const UNITS = {
  offset: LENGTH,
  rotation: { unit: "mrad", scale: 1e3, decimals: 2 },
  hole: LENGTH,
  friction: { unit: "", scale: 1, decimals: 2 },
  clearance: { ...LENGTH, decimals: 3 },
  chamfer: LENGTH,
};
const MEANINGS = {
  offset: "of the part in the gripper",
  rotation: "of the part in the gripper",
  hole: "position error of the environment across the insertion",
  friction: "the same in all rollouts",
  clearance: "from side to side where it is tightest",
  chamfer: "of 45° at the mouth of the hole",
};
/** Smaller values of these are harder. */
const HARD_WHEN_SMALL = ["clearance", "chamfer"];

/** Size of the map and its margins (units of its drawing). */
const WIDTH = 420;
const HEIGHT = 260;
const LEFT = 56;
const BELOW = 46;
const EDGE = 14;
/** Half of the width of the ends of intervals. */
const CAP = 5;

export function tolerancePage(root, data) {
  const { record, simulation } = data;
  root.append(
    pageHead(record.scene, "", ["tolerances", `${percent(record.rate)} of the rollouts succeed`], themeButton()),
    element("main", {}, tolerance(record), simulation ? rateMatrix(simulation) : null),
  );
}

/** The section of a plan's tolerances. */
export function tolerance(record) {
  const { map, need, boundaries } = record;
  return card(
    "Tolerances",
    map?.sensitivity ? element("p", { class: "lead" }, `${map.sensitivity.sentence}.`) : null,
    need ? element("p", {}, needInWords(need)) : null,
    measured(record),
    boundaries.length > 0 ? boundaryTable(record) : null,
    map ? mapped(map) : null,
  );
}

function measured({ scene, plans, rate, frictions, seed, position_tolerance_m: position, angle_tolerance_rad: angle, assembly_plan: version }) {
  return facts([
    ["scene", scene],
    [plans.length === 1 ? "plan" : "plans", plans.join(", ")],
    ["success", `within ${magnitude(position)} and ${degrees(angle)} of the goal`],
    ["target", `${percent(rate)} of the rollouts`],
    ["frictions", listed(frictions.map(short))],
    ["seed", String(seed)],
    ["measured by", `assembly-plan ${version}`],
  ]);
}

const number = (name, value) => (UNITS[name].scale * value).toFixed(UNITS[name].decimals);
const withUnit = (name, value) => `${number(name, value)} ${UNITS[name].unit}`.trimEnd();

/** The value of a boundary in words. */
function valueInWords({ quantity, value, is_open: isOpen }) {
  if (value === null) return "no tested value";
  const bound = HARD_WHEN_SMALL.includes(quantity) ? "down to" : "up to";
  return `${bound} ${withUnit(quantity, value)}${isOpen ? ", no harder value was tried" : ""}`;
}

/** Its interval, by ascending values; an end beyond the tested values has a word. */
function intervalInWords({ quantity, interval }) {
  const [one, other] = HARD_WHEN_SMALL.includes(quantity) ? interval.toReversed() : interval;
  const end = (value, word) => (value === null ? word : withUnit(quantity, value));
  return `${end(one, "unknown")} to ${end(other, "unknown")}`;
}

const successesInWords = ({ successes, rollouts }) => `${successes} of ${rollouts}`;

const RESULTS = [
  explained("tolerated", "the hardest value at which enough rollouts succeed"),
  explained("95 % confidence", "of that value; unknown where no tested value decides it"),
  explained("succeed there", "rollouts at that value"),
];
const results = (boundary) => [valueInWords(boundary), intervalInWords(boundary), successesInWords(boundary)];

function boundaryTable({ boundaries, planned_offset_m: offset, clearance_m: clearance }) {
  const own = { offset: `planned for ${magnitude(offset)}`, clearance: clearance === null ? "" : `the scene's is ${withUnit("clearance", clearance)}` };
  const rows = boundaries.map((boundary) => ({
    class: boundary.value === null ? "missing" : "",
    cells: [boundary.quantity, MEANINGS[boundary.quantity], ...results(boundary), own[boundary.quantity] ?? ""],
  }));
  return [
    element("p", {}, "Each quantity is varied while the others are as planned."),
    table("Boundaries", ["quantity", "meaning", ...RESULTS, "for comparison"], rows),
  ];
}

function needInWords({ quantity, value, boundary }) {
  const needed = `${withUnit(quantity, value)} of ${quantity} is tolerated at a ${boundary.quantity}`;
  return boundary.value === null ? `${needed} of no tested value.` : `${needed} ${valueInWords(boundary)} (95 % confidence: ${intervalInWords(boundary)}).`;
}

function mapped(map) {
  const { quantity, over, rows } = map;
  const title = `${HARD_WHEN_SMALL.includes(quantity) ? "Smallest" : "Largest"} ${quantity} by ${over}`;
  const cells = rows.map(({ at, boundary }) => ({ cells: [withUnit(over, at), ...results(boundary)] }));
  return [
    element("h3", {}, title),
    drawn(map),
    element("details", {}, element("summary", {}, "Numbers of the map"), table("Numbers of the map", [over, ...RESULTS], cells)),
  ];
}

const axisName = (name) => (UNITS[name].unit ? `${name} (${UNITS[name].unit})` : name);

/** The map: values with their intervals, open where they end beyond the tested values. */
function drawn({ quantity, over, rows }) {
  const [xs, ys] = [UNITS[over].scale, UNITS[quantity].scale];
  const ends = rows.flatMap(({ boundary }) => [boundary.value, ...boundary.interval]).filter((value) => value !== null);
  const xRange = linearRange(rows.map(({ at }) => xs * at), []);
  const yRange = linearRange(ends.length > 0 ? ends.map((value) => ys * value) : [0], []);
  const place = (value, [low, high], from, to) => from + ((to - from) * (value - low)) / (high - low);
  const x = (value) => place(xs * value, xRange, LEFT, WIDTH - EDGE);
  const y = (value) => place(ys * value, yRange, HEIGHT - BELOW, EDGE);
  const label = (attributes, text) => drawing("text", attributes, String(text));
  const bottom = HEIGHT - BELOW;
  const grid = [
    ...linearTicks(xRange, 4).map((tick) => label({ x: x(tick / xs), y: bottom + 18, "text-anchor": "middle" }, tick)),
    ...linearTicks(yRange, 3).map((tick) => {
      const height = y(tick / ys);
      return [
        drawing("line", { class: "grid", x1: LEFT, x2: WIDTH - EDGE, y1: height, y2: height }),
        label({ x: LEFT - 8, y: height + 4, "text-anchor": "end" }, tick),
      ];
    }),
    label({ x: 0.5 * (LEFT + WIDTH - EDGE), y: HEIGHT - 6, "text-anchor": "middle" }, axisName(over)),
    label({ transform: `translate(13 ${0.5 * (EDGE + bottom)}) rotate(-90)`, "text-anchor": "middle" }, axisName(quantity)),
  ];
  const known = rows.filter(({ boundary }) => boundary.value !== null);
  const line = known.map(({ at, boundary }) => `${x(at)},${y(boundary.value)}`).join(" ");
  const marks = known.map(({ at, boundary }) => interval(x(at), y, boundary, bottom));
  const words = known.map(({ at, boundary }) => `${withUnit(quantity, boundary.value)} at ${withUnit(over, at)}`);
  return drawing(
    "svg",
    { class: "map", viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img", "aria-label": `${quantity} by ${over}: ${words.join(", ")}` },
    grid,
    drawing("path", { class: "axis", d: `M${LEFT} ${EDGE}V${bottom}H${WIDTH - EDGE}` }),
    drawing("polyline", { class: "line", points: line }),
    marks,
  );
}

/** A value with its interval; an end that is not known reaches the edge and has no cap. */
function interval(at, y, { quantity, value, interval: ends }, bottom) {
  const [low, high] = HARD_WHEN_SMALL.includes(quantity) ? ends.toReversed() : ends;
  const cap = (end) => (end === null ? null : drawing("line", { class: "interval", x1: at - CAP, x2: at + CAP, y1: y(end), y2: y(end) }));
  return [
    drawing("line", { class: "interval", x1: at, x2: at, y1: low === null ? bottom : y(low), y2: high === null ? EDGE : y(high) }),
    cap(low),
    cap(high),
    drawing("circle", { class: "value", cx: at, cy: y(value), r: 4 }),
  ];
}
