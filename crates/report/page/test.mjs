// Drives report pages in Chromium, as a reader would, and lets axe look for what some readers could not use. Arguments: a
// folder with the pages of plans (plan, robust, lossy, arm, executed), of two of them, a batch, a simulation and tolerances, and
// animations; with a second one, pictures of the
// pages are written there.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { DESKTOP, PHONE, browser, changesPicture, clock, cursor, drag, folder, open, pictures, scrub, settle } from "./driver.mjs";
import { linearRange, linearTicks, logarithmicRange, logarithmicTicks } from "./src/ticks.js";
import { testAnimation } from "./test-animation.mjs";
import { testBeside } from "./test-beside.mjs";
import { testShare } from "./test-share.mjs";

/** Widths beside those at which the layout changes. */
const WIDTHS = [390, 900, 901, 1280, 1699, 1700];

const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const TAGS = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"];

/** Opens a page with all that it folds away, in colours and on a screen, for axe to find nothing. */
async function checkAccess(name, viewport, colorScheme) {
  const page = await open(name, viewport, colorScheme);
  await page.$$eval("details", (nodes) => nodes.forEach((node) => (node.open = true)));
  await page.evaluate(AXE);
  const { violations } = await page.evaluate((values) => axe.run(document, { runOnly: { type: "tag", values } }), TAGS);
  const found = violations.flatMap(({ id, help, nodes }) => nodes.map(({ html, any }) => `${id}: ${help}: ${html} ${any[0]?.message ?? ""}`));
  assert.deepEqual(found, [], `${name}, ${colorScheme}, ${viewport.width} wide`);
  await page.close();
}

/** Axes have three labels or more, and show limits and where values end. */
function testTicks() {
  const ranges = [[0, 1], [-0.013, 0.0071], [0, 963], [-40, -1e-3], [0.0099, 0.0101]];
  for (const range of ranges) {
    const ticks = linearTicks(range, 4);
    assert.ok(ticks.length >= 3 && ticks.every((tick) => tick >= range[0] - 1e-9 && tick <= range[1] + 1e-9), `${range}: ${ticks}`);
  }
  assert.deepEqual(linearTicks([-1, 1], 4), [-1, -0.5, 0, 0.5, 1]);
  assert.deepEqual(linearRange([0, 0, null], []), [0, 1], "a force that is always zero has an axis");
  assert.ok(linearRange([0, 19], [20])[1] >= 20, "a limit that is near is drawn");
  assert.ok(linearRange([0, 1], [20])[1] < 2, "one that is far does not flatten the lines");
  for (const [lists, limits] of [[[[90, 30, 0.04]], [3, 20]], [[[1e-3, 1e-3]], [5.7]], [[[0, 0]], [3]], [[[90, 80, 70]], [3]]]) {
    const range = logarithmicRange(lists, limits);
    const ends = [...lists.flat().slice(-1), ...limits].filter((value) => value > 0);
    assert.ok(ends.every((value) => value > range[0] || value < 1e-4 * range[1]) && limits.every((value) => value < range[1]), `${range}`);
    assert.ok(logarithmicTicks(range).length >= 3, `${range}: ${logarithmicTicks(range)}`);
  }
}

/** No table and no text lies below the 3D view, however wide the window and however far it is scrolled. */
async function testLayout(name) {
  for (const width of WIDTHS) {
    const page = await open(name, { width, height: 900 });
    await page.$$eval("details", (nodes) => nodes.forEach((node) => (node.open = true)));
    const covered = await page.evaluate(() => {
      const found = [];
      const end = document.documentElement.scrollHeight - innerHeight;
      for (let step = 0; step <= 20; step += 1) {
        scrollTo({ top: (end * step) / 20, behavior: "instant" });
        const stage = document.querySelector(".stage").getBoundingClientRect();
        for (const node of document.querySelectorAll(".card, .verdict, .plot, table")) {
          const box = node.getBoundingClientRect();
          const [across, down] = [Math.min(box.right, stage.right) - Math.max(box.left, stage.left), Math.min(box.bottom, stage.bottom) - Math.max(box.top, stage.top)];
          if (across > 0.5 && down > 0.5) found.push(`${node.className || node.tagName} at ${scrollY}`);
        }
      }
      return found;
    });
    assert.deepEqual(covered, [], `${name}, ${width} wide: covered by the 3D view`);
    await page.close();
  }
}

/** Colours of the pixels along the edges of the 3D view. */
async function edgeColours(page) {
  await settle(page);
  const shot = (await page.locator("canvas").first().screenshot()).toString("base64");
  return page.evaluate(async (data) => {
    const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
    const context = new OffscreenCanvas(image.width, image.height).getContext("2d", { willReadFrequently: true });
    context.drawImage(image, 0, 0);
    const { width, height } = image;
    // What is fixed at the page's edges may lie upon the outermost pixels.
    const sides = [[2, 2, width - 4, 1], [2, height - 3, width - 4, 1], [2, 2, 1, height - 4], [width - 3, 2, 1, height - 4]];
    const pixels = sides.flatMap((side) => Array.from(new Uint32Array(context.getImageData(...side).data.buffer)));
    return new Set(pixels).size;
  }, shot);
}

/** All parts are in the first view, at any time of the motion: nothing reaches its edges. */
async function testView(name) {
  for (const viewport of [DESKTOP, PHONE, { width: 901, height: 700 }, { width: 1700, height: 900 }]) {
    const page = await open(name, viewport);
    await page.getByLabel("Forces").uncheck();
    for (const share of [0, 0.5, 1]) {
      await scrub(page, share);
      assert.equal(await edgeColours(page), 1, `${name}, ${viewport.width} wide: a part is cut off at ${share} of the motion`);
    }
    await page.getByRole("button", { name: "View X" }).click();
    assert.equal(await edgeColours(page), 1, `${name}, ${viewport.width} wide: a part is cut off along x`);
    await page.close();
  }
}

/** Plots have names, units and values everywhere, and lines that differ without colours. */
async function testPlots(name, limits) {
  const page = await open(name);
  const plots = await page.$$eval(".plot", (figures) =>
    figures.map((figure) => ({
      title: figure.querySelector("b").textContent,
      axes: [...figure.querySelectorAll(".axes > span")].map((node) => node.textContent),
      dashes: [...figure.querySelectorAll(".key line")].map((line) => line.getAttribute("stroke-dasharray")),
      values: [...figure.querySelectorAll(".key output")].map((node) => node.textContent),
      words: figure.querySelector(".u-over").getAttribute("aria-label"),
      height: figure.querySelector(".u-over").clientHeight,
    })),
  );
  assert.ok(plots.length >= 8, `${name}: ${plots.length} plots`);
  for (const { title, axes, dashes, values, words, height } of plots) {
    assert.match(axes[0], /^[a-z ]+ \(\S+\)(, log)?$/, title);
    assert.equal(axes[1], "time (s)", title);
    assert.equal(new Set(dashes).size, Math.min(dashes.length, 8), `${title}: lines have the same dashes`);
    assert.ok(values.length === dashes.length && values.every((value) => /\d/.test(value)), `${title} at the start: ${values}`);
    assert.match(words, /over time.*at the end .*\d/, title);
    assert.ok(height >= 120, `${title} is ${height} px high`);
  }
  for (const [title, words] of limits) {
    assert.ok(plots.some((plot) => plot.title.startsWith(title) && plot.words.includes(words)), `${title}: ${words} is drawn`);
  }
  // Under the pointer, values are those there.
  const value = () => page.locator(".plot output").first().textContent();
  const before = await value();
  const box = await page.locator(".u-over").first().boundingBox();
  await page.mouse.move(box.x + 0.9 * box.width, box.y + 0.5 * box.height);
  assert.notEqual(await value(), before, "values follow the pointer");
  await page.mouse.move(2, 2);
  assert.equal(await value(), before, "and return to the shown instant");
  await page.close();
}

/** The page begins with what is to be thought of the plan. */
async function testVerdict(name, standing, words) {
  const page = await open(name);
  assert.equal(await page.locator("main > :first-child").getAttribute("class"), `verdict ${standing}`, name);
  const said = await page.locator(".verdict").textContent();
  const must = [words, /end within [\d.]+ mm and [\d.]+°/, /largest contact force[\d.]+ N, /, /duration[\d.]+ s/, /stiffness/, /Tested with/, /Not tested with/];
  must.forEach((part) => assert.match(said, part, name));
  assert.equal(await page.locator("h1 .chip").getAttribute("class"), `chip ${standing}`, "the status has the colour of the verdict");
  await page.close();
}

/** A rate of few rollouts is not as green as one of many. */
async function testRates(name) {
  const page = await open(name);
  const cells = await page.$$eval(".rate", (nodes) => nodes.map((node) => [Number(node.style.getPropertyValue("--rate")), node.textContent]));
  assert.ok(cells.length > 0, `${name} has rates`);
  for (const [rate, words] of cells) {
    const [, successes, rollouts, low] = words.match(/%(\d+)\/(\d+), (\d+)/).map(Number);
    assert.ok(Math.abs(100 * rate - low) <= 0.5 && rate < successes / rollouts + 1e-9 && rate < 1, words);
  }
  await page.close();
}

/** Without WebGL the page says so, where nothing hides it. */
async function testWithoutGraphics(name) {
  const page = await open(name, DESKTOP, "light", () => {
    const context = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...others) {
      return kind.startsWith("webgl") ? null : context.call(this, kind, ...others);
    };
    console.error = () => {};
  });
  const notice = page.locator(".notice");
  assert.match(await notice.textContent(), /cannot draw in 3D.*plots work/s);
  await notice.scrollIntoViewIfNeeded();
  const isSeen = await notice.evaluate((node) => {
    const { left, top, width, height } = node.getBoundingClientRect();
    return document.elementFromPoint(left + 0.5 * width, top + 0.5 * height) === node;
  });
  assert.ok(isSeen, "nothing hides the notice");
  assert.ok((await page.locator(".plot").count()) > 0);
  await page.close();
}

async function testPlan(name) {
  const page = await open(name);
  assert.equal(await page.getByRole("button", { name: /^Hard contact/ }).first().getAttribute("aria-pressed"), "true", "hard contact is shown first");
  assert.ok(await page.getByRole("button", { name: "Homotopy", exact: true }).isHidden(), "the homotopy is in a drawer");
  assert.match(await page.locator(".scale").textContent(), /^[125]0* N$|^0\.0*[125] N$/, "arrows have a scale");
  const [start, left] = [await clock(page), await cursor(page)];
  await changesPicture(page, "scrubbing", () => scrub(page, 0.6));
  assert.ok((await clock(page)) > start, "the clock follows");
  assert.ok((await cursor(page)) > left + 20, "the cursor of the plots follows");

  await page.locator("h1").click();
  await page.keyboard.press("Home");
  assert.equal(await clock(page), 0, "Home goes to the start");
  await page.keyboard.press("ArrowRight");
  const step = await clock(page);
  assert.ok(step > 0, "an arrow goes one step");
  await page.keyboard.press(" ");
  await page.waitForFunction(() => Number.parseFloat(document.querySelector(".clock").textContent) > 0.5);
  await page.keyboard.press(" ");
  const stopped = await clock(page);
  await page.waitForTimeout(300);
  assert.equal(await clock(page), stopped, "space stops what it has begun");

  await scrub(page, 0.7);
  for (const view of ["X", "Y", "Z", "Free"]) {
    await changesPicture(page, `view ${view}`, () => page.getByRole("button", { name: `View ${view}` }).click());
  }
  await changesPicture(page, "the reference", () => page.getByLabel("Reference").uncheck());
  await changesPicture(page, "forces", () => page.getByLabel("Forces").uncheck());
  await changesPicture(page, "hiding a scenario", () => page.getByRole("button", { name: /^Show scenario 1/ }).click());
  await changesPicture(page, "the cut", () => page.getByLabel("Cut", { exact: true }).selectOption("x"));
  await changesPicture(page, "the place of the cut", () => page.getByLabel("Place of the cut").fill("0.4"));
  await page.getByLabel("Cut", { exact: true }).selectOption("none");
  await changesPicture(page, "the homotopy", async () => {
    await page.getByText("How the plan was found").click();
    await page.getByRole("button", { name: "Homotopy", exact: true }).click();
    await page.getByRole("slider", { name: "Homotopy step" }).fill("1");
  });
  await changesPicture(page, "smoothed shapes", () => page.getByLabel("Smoothed shapes").uncheck());
  await changesPicture(page, "a rollout", () => page.getByRole("button", { name: /^Hard contact, friction 0\.1/ }).click());
  await changesPicture(page, "orbiting", () => drag(page));
  await changesPicture(page, "dark colours", () => page.getByRole("button", { name: /Switch to dark/ }).click());
  await page.close();
}

/** What a plan that is not robust loses, and how its rollouts miss the goal. */
async function testLossy(name) {
  const page = await open(name);
  const weakest = await page.locator(".weakest").textContent();
  assert.match(weakest, /most is lost at friction .*95 % confidence: \d+ to \d+ %.*of inertia.*of stiffness.*the body/is);
  await page.getByRole("button", { name: /^Hard contact.*fail/ }).first().click();
  const lost = page.getByRole("button", { name: /of inertia.*of stiffness.*misses the goal/ });
  assert.ok((await lost.count()) > 0, "the rollout that is lost most can be played");
  await page.close();
}

/** Joints and outline of an arm. */
async function testArm(name) {
  const page = await open(name);
  for (const plot of ["Joint positions", "Joint speeds", "Joint torques"]) {
    assert.equal(await page.getByText(`${plot}, scenario 1`).count(), 1, plot);
  }
  assert.match(await page.locator(".plot", { hasText: "Joint speeds" }).locator(".legend").textContent(), /\(±[\d.]+\)/, "limits of joints");
  await changesPicture(page, "the arm", () => page.getByLabel("Arm").uncheck());
  await page.getByText("How the plan was found").click();
  await page.getByRole("button", { name: "Homotopy", exact: true }).click();
  assert.ok(await page.getByLabel("Arm").isHidden(), "nobody computes joints of homotopy steps");
  await page.close();
}

/** What a robot did, beside a rollout. */
async function testExecuted(name) {
  const page = await open(name);
  const button = (words) => page.getByRole("button", { name: words });
  assert.equal(await button("Executed: executed.csv").getAttribute("aria-pressed"), "true", "the page opens with the first log");
  assert.match(await page.locator("main").textContent(), /if the part ended at its goal.*was stopped.*force of 41 N/s);
  const plot = (title) => page.getByText(title, { exact: true }).count();
  assert.equal(await plot("Distance between robot and rollout"), 1);
  assert.equal(await plot("Measured force at the tool, robot"), 1);
  await scrub(page, 0.5);
  await changesPicture(page, "the rollout", () => button(/^rollout/).click());
  assert.equal(await page.getByText(/^Measured/).count(), 0, "a rollout measures nothing");
  await button("Executed: stopped.csv").click();
  assert.equal(await page.getByText(/^stopped after/).count(), 1, "the robot says when it was stopped");
  await page.close();
}

async function testBatch(name) {
  const page = await open(name);
  const links = page.locator("a.cell");
  assert.ok((await links.count()) > 1, "cells lead to their plans");
  await links.first().click();
  await page.waitForSelector("canvas");
  await page.close();
}

async function testSimulation(name) {
  const page = await open(name);
  const words = await page.locator("main").textContent();
  assert.match(words, /straight push/);
  assert.match(words, /scene\s*peg1.*plan\S*\/plan.*within [\d.]+ mm.*seed\s*1.*assembly-plan \d/s, "it can be repeated");
  await page.close();
}

/** Boundaries and a map, whose marks are where its numbers are; `hasUnknown` of which one row has no value. */
async function testTolerance(name, hasUnknown) {
  const page = await open(name);
  const data = await page.evaluate(() => JSON.parse(document.getElementById("data").textContent));
  const { map, boundaries } = data.record ?? data.tolerated;
  const section = page.getByRole("region", { name: "Tolerances" });
  const said = await section.textContent();
  for (const { quantity, successes, rollouts } of boundaries) {
    assert.match(said, new RegExp(`${quantity}.*up to [\\d.]+.*${successes} of ${rollouts}`, "s"));
  }
  const sentence = map.sensitivity?.sentence;
  assert.ok(sentence === undefined || said.includes(`${sentence}.`), `what a change buys: ${sentence}`);
  const known = map.rows.filter(({ boundary }) => boundary.value !== null);
  assert.equal(known.length < map.rows.length, hasUnknown, "a row without a value");
  const marks = await section.locator(".map .value").evaluateAll((circles) =>
    circles.map((circle) => ["cx", "cy"].map((key) => Number(circle.getAttribute(key)))),
  );
  assert.equal(marks.length, known.length, "a mark for each known row");
  const numbers = known.map(({ at, boundary }) => [at, boundary.value]);
  // Marks are where a line through the first and the last one has them.
  for (const axis of [0, 1]) {
    const [first, last] = [0, known.length - 1];
    const [from, to] = [numbers[first][axis], numbers[last][axis]];
    if (from === to) continue;
    numbers.forEach((number, index) => {
      const share = (number[axis] - from) / (to - from);
      const expected = marks[first][axis] + share * (marks[last][axis] - marks[first][axis]);
      assert.ok(Math.abs(marks[index][axis] - expected) < 0.1, `mark ${index} of ${name}: ${marks}`);
    });
  }
  const ends = known.flatMap(({ boundary }) => boundary.interval).filter((end) => end !== null).length;
  const bars = await section.locator(".map .interval").count();
  assert.equal(bars, known.length + ends, "intervals have caps where they are known");
  await section.locator("summary").click();
  assert.equal(await section.getByRole("row").count(), 2 + boundaries.length + map.rows.length, "tables have all rows");
  await page.close();
  return sentence !== undefined;
}

/** Frames per second while a page plays, and the pixels that it has left out for that. */
async function framesPerSecond(name) {
  const page = await open(name);
  await page.getByRole("button", { name: "Play" }).click();
  await page.waitForTimeout(1500);
  const frames = await page.evaluate(() => new Promise((done) => {
    const begin = performance.now();
    let count = 0;
    const next = (now) => (now - begin > 3000 ? done((1e3 * count) / (now - begin)) : ((count += 1), requestAnimationFrame(next)));
    requestAnimationFrame(next);
  }));
  const canvas = await page.locator("canvas").first().evaluate(({ width, clientWidth }) => width / clientWidth);
  await page.close();
  return `${frames.toFixed(0)} frames per second at ${canvas.toFixed(2)} pixels per pixel`;
}

async function takePicture(name, file, viewport, colours, share) {
  const page = await open(name, viewport, colours);
  await scrub(page, share);
  await settle(page);
  await page.screenshot({ path: join(pictures, file) });
  await page.close();
}

testTicks();
try {
  await testVerdict("plan/report.html", "open", /smoothed model only.* of 9 rollouts/s);
  await testVerdict("robust/report.html", "good", /reaches the goal: .*hard contact, friction 0\.3/s);
  await testVerdict("lossy/report.html", "bad", /does not do what was asked for/);
  for (const name of ["plan", "robust"]) await testLayout(`${name}/report.html`);
  for (const name of ["plan", "robust"]) await testView(`${name}/report.html`);
  await testPlots("plan/report.html", [["Position error", "tolerance 3 mm"], ["Position error", "offset 20 mm"], ["Orientation error", "tolerance"]]);
  for (const name of ["robust", "lossy", "simulation"]) await testRates(`${name}/report.html`);
  await testWithoutGraphics("plan/report.html");
  await testPlan("plan/report.html");
  await testPlan("robust/report.html");
  await testShare("plan/report.html");
  await testBeside("beside/report.html");
  for (const kind of ["svg", "gif"]) await testAnimation(`plan.${kind}`);
  await testBatch("batch/report.html");
  await testSimulation("simulation/report.html");
  const areDecided = [await testTolerance("robust/report.html", false), await testTolerance("tolerance/report.html", true)];
  assert.ok(areDecided.includes(true), "a map says what a change buys");
  await testLossy("lossy/report.html");
  await testArm("arm/report.html");
  await testExecuted("executed/report.html");
  const pages = readdirSync(folder, { withFileTypes: true }).filter((entry) => entry.isDirectory()).map(({ name }) => name);
  for (const name of pages) {
    // Colours do not depend on the width.
    await checkAccess(join(name, "report.html"), DESKTOP, "light");
    await checkAccess(join(name, "report.html"), PHONE, "dark");
  }
  for (const name of ["plan", "robust", "arm"]) {
    console.log(`${name}: ${await framesPerSecond(join(name, "report.html"))}`);
  }
  if (pictures) {
    await takePicture("plan/report.html", "report.png", { width: 1200, height: 1080 }, "light", 0.62);
    await takePicture("clamp/report.html", "report-dark.png", { width: 1200, height: 1080 }, "dark", 0.8);
  }
} finally {
  await browser.close();
}
console.log("report pages work");
