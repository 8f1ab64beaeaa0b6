// Light or dark: the system's choice, until the reader chooses.
import { element } from "./dom.js";

const dark = matchMedia("(prefers-color-scheme: dark)");
const listeners = new Set();
let chosen = null;

const theme = () => chosen ?? (dark.matches ? "dark" : "light");

function apply() {
  document.documentElement.dataset.theme = theme();
  listeners.forEach((listener) => listener());
}

/** Follows the system's colours, also when they change. */
export function followTheme() {
  dark.addEventListener("change", apply);
  apply();
}

/** Calls back at once and whenever colours change. */
export function onTheme(listener) {
  listeners.add(listener);
  listener();
}

/** A colour of the style sheet. */
export const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();

/** The button that switches between light and dark. */
export function themeButton() {
  const button = element("button", { class: "plain theme", type: "button", click: flip });
  function flip() {
    chosen = theme() === "dark" ? "light" : "dark";
    apply();
  }
  onTheme(() => {
    const other = theme() === "dark" ? "light" : "dark";
    button.textContent = other === "dark" ? "Dark" : "Light";
    button.setAttribute("aria-label", `Switch to ${other} colours`);
  });
  return button;
}

const SCENARIOS = ["#2f7fc1", "#d9691f", "#0f9b77", "#c264a3", "#c79a00", "#7d6be0", "#3aa6b9", "#a3623a"];

/** The colour of a scenario, the same in light and dark. */
export const scenarioColour = (index) => SCENARIOS[index % SCENARIOS.length];
