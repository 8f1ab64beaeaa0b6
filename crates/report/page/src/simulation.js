// Success rates of a simulation, each beside that of the straight push.
import { card, element, pageHead, table } from "./dom.js";
import { rateCell } from "./robustness.js";
import { themeButton } from "./theme.js";
import { magnitude, short } from "./words.js";

const PUSH = "straight push";

export function simulationPage(root, data) {
  const rollouts = data.groups.reduce((sum, group) => sum + group.rollouts, 0);
  root.append(
    pageHead(data.title, "", ["simulation", `${rollouts} rollouts with hard contact`], themeButton()),
    element("main", { class: "single" }, rateMatrix(data)),
  );
}

/** One row per motion, friction and modelled magnitude, one column per injected magnitude. */
export function rateMatrix({ groups }) {
  const magnitudes = [...new Set(groups.map(({ magnitude_m: length }) => Number(length)))].sort((one, other) => one - other);
  const rowKey = ({ motion, friction, delta_m: delta }) => `${motion}|${friction}|${delta}`;
  const keys = [...new Set(groups.map(rowKey))];
  const rows = keys.map((key) => {
    const [motion, friction, delta] = key.split("|");
    const cells = magnitudes.map((length) => {
      const group = groups.find((one) => rowKey(one) === key && Number(one.magnitude_m) === length);
      return group ? cell(group) : "";
    });
    return { class: motion === PUSH ? "push" : "", cells: [motion, short(Number(friction)), magnitude(Number(delta)), ...cells] };
  });
  const header = ["motion", "friction", "planned for", ...magnitudes.map((length) => `${magnitude(length)} injected`)];
  return card(
    "Success in rollouts",
    element("p", {}, "Share of rollouts with hard contact that end at the goal, with Wilson's interval of 95 %. The straight push is unplanned."),
    table("Success rates", header, rows),
  );
}

function cell({ successes, rollouts, rate_low: low, rate_high: high }) {
  const interval = `${(100 * Number(low)).toFixed(0)}–${(100 * Number(high)).toFixed(0)} %`;
  return rateCell(successes, rollouts, interval);
}
