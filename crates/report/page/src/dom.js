// Elements of the page.

/** An element with attributes and children; an attribute that is a function listens to the event of its name. */
export function element(name, attributes = {}, ...children) {
  const node = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (typeof value === "function") node.addEventListener(key, value);
    else if (value === true) node.setAttribute(key, "");
    else if (value !== false && value !== null && value !== undefined) node.setAttribute(key, value);
  }
  node.append(...children.flat().filter((child) => child !== null && child !== undefined && child !== false));
  return node;
}

/** A titled section of the page. */
export function card(title, ...children) {
  const id = `section-${title.toLowerCase().replaceAll(/[^a-z]+/g, "-")}`;
  return element("section", { class: "card", "aria-labelledby": id }, element("h2", { id }, title), children);
}

/** A table with a header row; the first cell of each row names it. Wide tables scroll within themselves. */
export function table(caption, header, rows) {
  const head = header.map((name) => element("th", { scope: "col" }, name));
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
  return element("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": `Table: ${caption}` }, content);
}

/** A coloured word that says what has become of something. */
export function chip(text, good) {
  return element("span", { class: `chip ${good ? "good" : "bad"}` }, text);
}

/** The head of every page. */
export function pageHead(title, status, facts, extra) {
  return element(
    "header",
    { class: "head" },
    element("div", {}, element("h1", {}, title, " ", status), element("p", {}, facts.join(" · "))),
    extra,
  );
}
