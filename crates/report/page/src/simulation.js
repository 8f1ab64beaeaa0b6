// Success rates of a simulation, each beside that of the straight push.
import { card, element, facts, pageHead, table } from "./dom.js";
import { rateCell } from "./rates.js";
import { themeButton } from "./theme.js";
import { degrees, magnitude, short } from "./words.js";

const PUSH = "straight push";

export function simulationPage(root, data) {
  const rollouts = data.groups.reduce((sum, group) => sum + group.rollouts, 0);
  root.append(
    pageHead(data.record?.scene ?? data.title, "", ["simulation", `${rollouts} rollouts with hard contact`], themeButton()),
    element("main", {}, rateMatrix(data)),
  );
}

/** What was simulated, so that it can be repeated. */
function simulated(record) {
  if (record === null) return null;
  const { scene, plans, seed, turn_rad: rotation, position_tolerance_m: position, angle_tolerance_rad: angle } = record;
  return facts([
    ["scene", scene],
    [plans.length === 1 ? "plan" : "plans", plans.join(", ")],
    ["success", `within ${magnitude(position)} and ${degrees(angle)} of the goal`],
    ["rotation errors in the gripper", rotation === 0 ? "none" : `up to ${degrees(rotation)}`],
    ["seed", String(seed)],
    ["simulated by", `assembly-plan ${record.assembly_plan}`],
  ]);
}

/** One row per motion, friction and modelled magnitude, one column per injected magnitude. */
export function rateMatrix({ record, groups }) {
  const magnitudes = [...new Set(groups.map(({ magnitude_m: length }) => Number(length)))].sort((one, other) => one - other);
  const rowKey = ({ motion, friction, delta_m: delta }) => `${motion}|${friction}|${delta}`;
  const keys = [...new Set(groups.map(rowKey))];
  const rows = keys.map((key) => {
    const [motion, friction, delta] = key.split("|");
    const cells = magnitudes.map((length) => {
      const group = groups.find((one) => rowKey(one) === key && Number(one.magnitude_m) === length);
      return group ? rateCell(group) : "";
    });
    return { class: motion === PUSH ? "push" : "", cells: [motion, short(Number(friction)), magnitude(Number(delta)), ...cells] };
  });
  const header = ["motion", "friction", "planned for", ...magnitudes.map((length) => `${magnitude(length)} injected`)];
  return card(
    "Success in rollouts",
    simulated(record),
    element(
      "p",
      {},
      "Share of rollouts with hard contact that end at the goal, its counts and Wilson's interval of 95 %; the colour is that of the lower end of the interval. ",
      "The straight push goes from start to goal without a plan. ",
      pushSuffices(groups) ? "It succeeds as often as the plan." : "",
    ),
    table("Success rates", header, rows),
  );
}

/** Whether the straight push succeeds as often as the plan, everywhere. */
function pushSuffices(groups) {
  const planned = groups.filter(({ motion }) => motion === "plan");
  const isSame = (one, other) => ["friction", "delta_m", "magnitude_m"].every((key) => one[key] === other[key]);
  const pushed = (group) => groups.find((one) => one.motion === PUSH && isSame(one, group));
  const share = (group) => (group ? group.successes / group.rollouts : 0);
  return planned.every((group) => share(pushed(group)) >= share(group));
}
