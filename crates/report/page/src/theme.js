// Light or dark: as the system says, until the reader chooses.
import { element } from "./dom.js";

const dark = matchMedia("(prefers-color-scheme: dark)");
const listeners = new Set();

const isDark = () => (document.documentElement.dataset.theme ?? (dark.matches ? "dark" : "light")) === "dark";
const notify = () => listeners.forEach((listener) => listener());

/** Tells listeners when the system changes its mind. */
export function followTheme() {
  dark.addEventListener("change", notify);
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
    document.documentElement.dataset.theme = isDark() ? "light" : "dark";
    notify();
  }
  onTheme(() => {
    button.textContent = isDark() ? "Light" : "Dark";
    button.setAttribute("aria-label", `Switch to ${isDark() ? "light" : "dark"} colours`);
  });
  return button;
}

const SCENARIOS = ["#2f7fc1", "#d9691f", "#0f9b77", "#c264a3", "#c79a00", "#7d6be0", "#3aa6b9", "#a3623a"];

/** The colour of a scenario, the same in light and dark. */
export const scenarioColour = (index) => SCENARIOS[index % SCENARIOS.length];
