// The page of a batch: its cells as a matrix, with a link into each plan's page.
import { card, chip, element, facts, pageHead, table } from "./dom.js";
import { rateMatrix } from "./simulation.js";
import { themeButton } from "./theme.js";
import { degrees, magnitude, millimetres, percent } from "./words.js";

export function batchPage(root, data) {
  const count = (state) => data.cells.filter((cell) => cell.state === state).length;
  const done = count("done");
  const states = ["done", "planned", "failed", "running", "to do"].filter((state) => count(state) > 0);
  const worst = ["failed", "running", "to do", "planned", "done"].find((state) => count(state) > 0);
  root.append(
    pageHead(
      data.title,
      chip(`${done} of ${data.cells.length} done`, standing(worst)),
      ["batch", ...states.map((state) => `${count(state)} ${state}`)],
      themeButton(),
    ),
    element("main", {}, madeFrom(data.cells), matrices(data.cells), data.simulation ? rateMatrix(data.simulation) : "", list(data.cells)),
  );
}

/** What the cells were made from. */
function madeFrom(cells) {
  const distinct = (of) => [...new Set(cells.map(of).filter((value) => value !== null && value !== undefined))];
  const sorted = (numbers) => numbers.sort((one, other) => one - other);
  const program = ({ versions }) => versions && `assembly-plan ${versions.assembly_plan}, Ipopt ${versions.ipopt}`;
  return card(
    "Made from",
    facts([
      ["scenes", distinct(({ scene }) => scene).join(", ")],
      ["homotopies", distinct(({ homotopy }) => homotopy).join(", ") || "of the scenes"],
      ["starts", distinct(({ start }) => start).join(", ")],
      ["offsets", sorted(distinct(({ delta }) => delta)).map(magnitude).join(", ")],
      ["rotation errors in the gripper", sorted(distinct(({ rotation_error: angle }) => angle)).map(degrees).join(", ")],
      ["written by", distinct(program).join("; ")],
    ]),
  );
}

/** Colours of states. */
const STANDINGS = { done: "good", planned: "open" };
const standing = (state) => STANDINGS[state] ?? "bad";

/** One matrix per scene and homotopy: starts down, magnitudes across. */
function matrices(cells) {
  const groups = Map.groupBy(cells, ({ scene, homotopy }) => (homotopy ? `${scene}, ${homotopy}` : scene));
  return [...groups].map(([name, members]) => {
    const deltas = [...new Set(members.map(({ delta }) => delta))].sort((one, other) => one - other);
    const starts = [...new Set(members.map(({ start }) => start))];
    const rows = starts.map((start) => ({
      cells: [start, ...deltas.map((delta) => square(members.find((cell) => cell.start === start && cell.delta === delta)))],
    }));
    const done = members.filter(({ state }) => state === "done").length;
    return card(
      name,
      element("p", {}, `${done} of ${members.length} cells are done (${percent(done / members.length)}).`),
      table(`Cells of ${name}`, ["start", ...deltas.map((delta) => magnitude(delta))], rows),
    );
  });
}

function square(cell) {
  if (!cell) return "";
  const { state, errors, rate, page } = cell;
  const detail = rate !== null ? `${percent(rate)} succeed` : errors ? `${millimetres(errors[0])} off` : "";
  const content = [element("b", {}, state), element("small", {}, detail)];
  const attributes = { class: `cell ${state.replace(" ", "-")}` };
  return page ? element("a", { ...attributes, href: page }, content) : element("span", attributes, content);
}

function list(cells) {
  const rows = cells.map(({ index, scene, start, delta, homotopy, state, status, page, effort }) => ({
    cells: [
      page ? element("a", { href: page }, `cell ${index}`) : `cell ${index}`,
      homotopy ? `${scene}, ${homotopy}` : scene,
      start,
      magnitude(delta),
      chip(state, standing(state)),
      status,
      effort ? String(effort[0]) : "–",
      effort ? `${effort[1].toFixed(1)} s` : "–",
    ],
  }));
  return card("All cells", table("All cells", ["cell", "scene", "start", "offsets", "state", "status", "iterations", "time"], rows));
}
