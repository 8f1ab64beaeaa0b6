// Elements of the page.

const SVG = "http://www.w3.org/2000/svg";

/** An element with attributes and children; an attribute that is a function listens to the event of its name. */
export const element = (name, attributes = {}, ...children) => filled(document.createElement(name), attributes, children);

/** Likewise, of a drawing. */
export const drawing = (name, attributes = {}, ...children) => filled(document.createElementNS(SVG, name), attributes, children);

function filled(node, attributes, children) {
  for (const [key, value] of Object.entries(attributes)) {
    if (typeof value === "function") node.addEventListener(key, value);
    else if (value === true) node.setAttribute(key, "");
    else if (value !== false && value !== null && value !== undefined) node.setAttribute(key, value);
  }
  node.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined && child !== false));
  return node;
}

const identifier = (title) => `section-${title.toLowerCase().replaceAll(/[^a-z]+/g, "-")}`;

/** A titled section of the page. */
export function card(title, ...children) {
  const id = identifier(title);
  return element("section", { class: "card", "aria-labelledby": id }, element("h2", { id }, title), children);
}

/** A section that is closed until its title is clicked, with a line that describes its content. */
export function drawer(title, about, ...children) {
  const id = identifier(title);
  const summary = element("summary", {}, element("h2", { id }, title), element("span", { class: "about" }, about));
  return element("section", { class: "card", "aria-labelledby": id }, element("details", {}, summary, children));
}

/** A name of a column or a fact with an explanation: shown where the pointer rests, and listed by `terms`. */
export const explained = (name, explanation) => ({ name, explanation });

/**
 * A table with a header row; the first cell of each row names it. Wide tables scroll within themselves. Columns that need
 * it are explained below.
 */
export function table(caption, header, rows) {
  const columns = header.map((column) => (typeof column === "string" ? { name: column } : column));
  const head = columns.map(({ name, explanation }) => element("th", { scope: "col", title: explanation }, name));
  const body = rows.map(({ cells, ...attributes }) => {
    const [first, ...others] = cells;
    return element("tr", attributes, element("th", { scope: "row" }, first), others.map((cell) => element("td", {}, cell)));
  });
  const content = element(
    "table",
    {},
    element("caption", { class: "hidden" }, caption),
    element("thead", {}, element("tr", {}, head)),
    element("tbody", {}, body),
  );
  const scrolled = element("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": `Table: ${caption}` }, content);
  const unclear = columns.filter(({ explanation }) => explanation);
  return unclear.length === 0 ? scrolled : [scrolled, element("p", { class: "terms" }, terms(unclear))];
}

/** Words and what they mean, one after the other. */
function terms(all) {
  return all.map(({ name, explanation }) => element("span", {}, element("b", {}, name), `: ${explanation}. `));
}

/** A coloured word for a status: `good`, `open` or `bad`. */
export const chip = (text, standing) => element("span", { class: `chip ${standing}` }, text);

/** Names and values. */
export function facts(pairs) {
  const pair = ([name, value]) => element("div", {}, element("dt", {}, name), element("dd", {}, value));
  return element("dl", {}, pairs.map(pair));
}

/** The head of every page. */
export function pageHead(title, status, about, extra) {
  return element(
    "header",
    { class: "head" },
    element("div", {}, element("h1", {}, title, " ", status), element("p", {}, about.join(" · "))),
    extra,
  );
}
