// Builds the page that the embedded data asks for.
import "uplot/dist/uPlot.min.css";
import "./style.css";
import { batchPage } from "./batch.js";
import { besidePage } from "./beside.js";
import { element } from "./dom.js";
import { planPage } from "./plan.js";
import { simulationPage } from "./simulation.js";
import { followTheme } from "./theme.js";
import { tolerancePage } from "./tolerance.js";

const pages = {
  plan: planPage,
  beside: besidePage,
  batch: batchPage,
  simulation: simulationPage,
  tolerance: tolerancePage,
};
const data = JSON.parse(document.getElementById("data").textContent);
const root = document.getElementById("page");

followTheme();
try {
  pages[data.kind](root, data);
} catch (error) {
  root.append(element("p", { class: "notice" }, `This page cannot be shown: ${error.message}`));
  throw error;
}
