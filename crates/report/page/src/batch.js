// The page of a batch: its cells as a matrix, with a link into each plan's page.
import { card, chip, element, pageHead, table } from "./dom.js";
import { rateMatrix } from "./simulation.js";
import { themeButton } from "./theme.js";
import { magnitude, millimetres, percent } from "./words.js";

export function batchPage(root, data) {
  const count = (state) => data.cells.filter((cell) => cell.state === state).length;
  const done = count("done");
  const states = ["done", "failed", "running", "to do"].filter((state) => count(state) > 0);
  root.append(
    pageHead(
      data.title,
      chip(`${done} of ${data.cells.length} done`, done === data.cells.length),
      ["batch", ...states.map((state) => `${count(state)} ${state}`)],
      themeButton(),
    ),
    element("main", { class: "single" }, matrices(data.cells), data.simulation ? rateMatrix(data.simulation) : "", list(data.cells)),
  );
}

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
      chip(state, state === "done"),
      status,
      effort ? String(effort[0]) : "–",
      effort ? `${effort[1].toFixed(1)} s` : "–",
    ],
  }));
  return card("All cells", table("All cells", ["cell", "scene", "start", "offsets", "state", "status", "iterations", "time"], rows));
}
