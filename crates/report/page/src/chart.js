// One plot over time: lines told apart by dashes and by names at their ends, limits, and the values at an instant.
import uPlot from "uplot";
import { drawing, element } from "./dom.js";
import { colour } from "./theme.js";
import { linearRange, linearTicks, logarithmicRange, logarithmicTicks } from "./ticks.js";
import { short } from "./words.js";

const HEIGHT = 176;
const FONT = "11px system-ui, sans-serif";
/** Room for the names at the ends of lines, and between two of them (px). */
const ENDS = 26;
const NAME_HEIGHT = 12;
const DASHES = [[], [7, 3], [2, 3], [10, 3, 2, 3], [4, 2], [14, 4], [10, 3, 2, 3, 2, 3], [1, 2]];

/**
 * A plot in a figure of its own. Its lines have a short name for their end, a longer one for the legend, and a value for each
 * of the times; its limits have a value and a name.
 */
export function chart({ title, quantity, unit, logarithmic, lines, limits, note }, times, seek) {
  const values = lines.map(() => element("output", {}));
  const read = (step) => lines.forEach((line, index) => (values[index].textContent = valueInWords(line.values[step])));
  const key = lines.map((line, index) => element("span", { class: "key" }, sample(line, index), line.name, values[index]));
  const frame = element("div", { class: "frame" });
  const caption = element("figcaption", {}, element("b", {}, title), element("span", { class: "legend" }, key));
  const axes = [
    element("span", { class: "y-name" }, `${quantity} (${unit})${logarithmic ? ", log" : ""}`),
    element("span", { class: "x-name" }, "time (s)"),
  ];
  const figure = element("figure", { class: "plot" }, caption, element("div", { class: "axes" }, axes, frame));
  const now = element("div", { class: "now" });
  let [plot, shown] = [null, 0];

  function draw() {
    const lists = lines.map((line) => line.values);
    const levels = limits.map(({ value }) => value);
    const range = logarithmic ? logarithmicRange(lists, levels) : linearRange(lists.flat(), levels);
    // A logarithm has no zero.
    const column = (list) => list.map((value) => (value === null || !logarithmic ? value : Math.max(value, range[0])));
    plot = new uPlot(options(frame, lines, limits, range, logarithmic, hover), [times, ...lists.map(column)], frame);
    plot.over.append(now);
    plot.over.setAttribute("role", "img");
    plot.over.setAttribute("aria-label", described(title, unit, lines, limits, note));
    plot.over.addEventListener("pointerdown", (event) => {
      plot.over.setPointerCapture(event.pointerId);
      seek(timeAt(event));
    });
    plot.over.addEventListener("pointermove", (event) => event.buttons === 1 && seek(timeAt(event)));
  }

  function timeAt({ clientX }) {
    const time = plot.posToVal(clientX - plot.over.getBoundingClientRect().left, "x");
    return Math.min(Math.max(time, 0), times.at(-1));
  }

  /** Under the pointer, the values are those there. */
  const hover = ({ cursor: { idx } }) => read(idx ?? nearest(times, shown));

  return {
    figure,
    draw,
    moveTo(time) {
      shown = time;
      now.style.transform = `translateX(${plot.valToPos(time, "x")}px)`;
      read(nearest(times, time));
    },
    resize() {
      if (frame.clientWidth > 0 && frame.clientWidth !== plot.width) {
        plot.setSize({ width: frame.clientWidth, height: HEIGHT });
        this.moveTo(shown);
      }
    },
    destroy: () => plot.destroy(),
  };
}

const nearest = (times, time) => Math.min(Math.round((time / times.at(-1)) * (times.length - 1)), times.length - 1);

/** A value; a motion that ended early has none at the end. */
const valueInWords = (value) => (value === null ? "–" : short(value));

/** A piece of a line for the legend. */
function sample({ colour: stroke, width }, index) {
  const dashes = DASHES[index % DASHES.length].join(" ");
  const line = drawing("line", { x1: 0, x2: 24, y1: 4, y2: 4, stroke, "stroke-width": width, "stroke-dasharray": dashes });
  return drawing("svg", { width: 24, height: 8, "aria-hidden": "true" }, line);
}

/** The plot for who does not see it. */
function described(title, unit, lines, limits, note) {
  const ends = lines.map(({ name, values }) => `${name} ${valueInWords(values.findLast((value) => value !== null) ?? null)}`);
  const levels = limits.map(({ name }) => `; ${name}`).join("");
  return `${title} (${unit}) over time${note ? `, ${note}` : ""}; at the end ${ends.join(", ")}${levels}`;
}

function options(frame, lines, limits, range, logarithmic, hover) {
  const axis = {
    stroke: colour("faint"),
    font: FONT,
    grid: { stroke: colour("line"), width: 1 },
    ticks: { show: false },
  };
  const ticks = logarithmic ? logarithmicTicks(range) : linearTicks(range, 4);
  return {
    width: Math.max(frame.clientWidth, 120),
    height: HEIGHT,
    legend: { show: false },
    cursor: { y: false, points: { show: false }, drag: { x: false, y: false } },
    padding: [8, ENDS, 0, 0],
    scales: { x: { time: false }, y: { range: () => range, distr: logarithmic ? 3 : 1 } },
    axes: [
      { ...axis, size: 22, gap: 3, space: 50 },
      { ...axis, size: 46, gap: 4, splits: () => ticks, filter: (_, splits) => splits, values: (_, splits) => splits.map(short) },
    ],
    series: [
      {},
      ...lines.map(({ colour: stroke, width }, index) => ({
        stroke,
        width,
        dash: DASHES[index % DASHES.length],
        points: { show: false },
      })),
    ],
    hooks: {
      setCursor: [hover],
      draw: [(plot) => drawLimits(plot, limits, range), (plot) => drawNames(plot, lines)],
    },
  };
}

/** Limits as dashed lines; one that the range does not reach is named at the edge. */
function drawLimits(plot, limits, [low, high]) {
  const { ctx: context, bbox } = plot;
  const ratio = devicePixelRatio;
  context.save();
  Object.assign(context, { fillStyle: colour("bad"), lineJoin: "round" });
  context.font = FONT.replace("11px", `${11 * ratio}px`);
  for (const { value, name } of limits) {
    Object.assign(context, { strokeStyle: colour("bad"), lineWidth: ratio });
    context.setLineDash([6 * ratio, 4 * ratio]);
    const beyond = value > high ? "↑ " : value < low ? "↓ " : "";
    const y = plot.valToPos(Math.min(Math.max(value, low), high), "y", true);
    if (beyond === "") {
      context.beginPath();
      context.moveTo(bbox.left, y);
      context.lineTo(bbox.left + bbox.width, y);
      context.stroke();
    }
    if (name === "") continue;
    // Below a line that is near the upper edge, above others.
    const isHigh = y < bbox.top + 14 * ratio;
    context.textBaseline = isHigh ? "top" : "bottom";
    context.textAlign = "right";
    // Upon a halo, so that lines behind it do not cross it.
    const place = [beyond + name, bbox.left + bbox.width - 4 * ratio, y + (isHigh ? 3 : -3) * ratio];
    context.setLineDash([]);
    Object.assign(context, { strokeStyle: colour("surface"), lineWidth: 4 * ratio });
    context.strokeText(...place);
    context.fillText(...place);
  }
  context.restore();
}

/** The names of lines beside their ends, apart from each other where there is room for all. */
function drawNames(plot, lines) {
  const { ctx: context, bbox } = plot;
  const [ratio, [times, ...columns]] = [devicePixelRatio, plot.data];
  const height = NAME_HEIGHT * ratio;
  if (lines.length * height > bbox.height) return;
  const ends = lines.map(({ end, colour: ink }, index) => {
    const last = columns[index].findLastIndex((value) => value !== null);
    const [x, y] = [plot.valToPos(times[last], "x", true), plot.valToPos(columns[index][last], "y", true)];
    return { end, ink, x, y, at: y };
  });
  ends.sort((one, other) => one.y - other.y);
  ends.forEach((one, index) => (one.at = Math.max(one.y, index === 0 ? bbox.top : ends[index - 1].at + height)));
  const bottom = bbox.top + bbox.height;
  ends.reduceRight((limit, one) => (one.at = Math.min(one.at, limit)) - height, bottom);
  context.save();
  Object.assign(context, { textBaseline: "middle", textAlign: "left", lineWidth: ratio });
  context.setLineDash([]);
  context.font = `600 ${FONT.replace("11px", `${11 * ratio}px`)}`;
  const right = bbox.left + bbox.width;
  for (const { end, ink, x, y, at } of ends) {
    Object.assign(context, { strokeStyle: ink, fillStyle: colour("text") });
    context.globalAlpha = 0.6;
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(right + 8 * ratio, at);
    context.stroke();
    context.globalAlpha = 1;
    context.fillText(end, right + 11 * ratio, at);
  }
  context.restore();
}
