// Links to a moment: the fragment of the page's address names motion, time, scenario, cut and viewpoint, counted from 1.
import { VIEWS } from "./scene.js";
import { duration } from "./state.js";

const KEYS = ["motion", "t", "scenario", "hidden", "cut", "view"];
const AXES = ["x", "y", "z"];
/** Shortest distance (m) of a camera from what it looks at. */
const NEAREST = 1e-6;

/** The fragment that leads to what is shown. */
export function fragmentOf({ motion, time, selected, hidden, cut, cutAt }, viewpoint) {
  const parts = {
    motion: motion + 1,
    t: Number(time.toFixed(3)),
    scenario: selected + 1,
    hidden: [...hidden].map((index) => index + 1).join(","),
    cut: cut === "none" ? "" : `${cut},${cutAt}`,
    view: typeof viewpoint === "string" ? viewpoint : viewpoint.map((place) => Number(place.toPrecision(6))).join(","),
  };
  return `#${KEYS.filter((key) => parts[key] !== "").map((key) => `${key}=${parts[key]}`).join("&")}`;
}

/**
 * The values to show and the viewpoint that a fragment names; null if it is no link to a moment. What it does not name, or
 * what the page does not have, is as in `present`; nothing is hidden and cut unless it says so.
 */
export function momentOf(fragment, motions, present) {
  const read = new URLSearchParams(fragment.slice(1));
  if (!KEYS.some((key) => read.has(key))) return null;
  const motion = indexOf(read.get("motion"), motions.length) ?? present.motion;
  const count = motions[motion].scenarios.length;
  const [time] = numbersOf(read.get("t"), 1) ?? [present.time];
  const [axis, place] = (read.get("cut") ?? "").split(",");
  const [cutAt] = numbersOf(place, 1) ?? [0];
  return {
    values: {
      motion,
      time: within(time, 0, duration(motions[motion])),
      playing: false,
      selected: indexOf(read.get("scenario"), count) ?? (motion === present.motion ? present.selected : 0),
      hidden: new Set((read.get("hidden") ?? "").split(",").map((number) => indexOf(number, count)).filter((index) => index !== null)),
      cut: AXES.includes(axis) ? axis : "none",
      cutAt: within(cutAt, -1, 1),
    },
    viewpoint: viewpointOf(read.get("view")),
  };
}

function viewpointOf(text) {
  if (Object.hasOwn(VIEWS, text ?? "")) return text;
  const places = numbersOf(text, 6);
  const distance = places && Math.hypot(...[0, 1, 2].map((axis) => places[axis] - places[axis + 3]));
  return distance > NEAREST ? places : null;
}

const within = (value, low, high) => Math.min(Math.max(value, low), high);

/** An index from a number that counts from 1; null if there is no such thing. */
function indexOf(text, count) {
  const index = /^\d+$/.test(text ?? "") ? Number(text) - 1 : -1;
  return index >= 0 && index < count ? index : null;
}

/** Finite numbers between commas; null if they are not as many. */
function numbersOf(text, count) {
  const words = (text ?? "").split(",");
  const numbers = words.map((word) => (word.trim() === "" ? NaN : Number(word)));
  return numbers.length === count && numbers.every(Number.isFinite) ? numbers : null;
}
