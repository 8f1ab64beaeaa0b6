// Drives report pages in Chromium, as a reader would, and lets axe look for what some readers could not use. Arguments: a
// folder with the pages of plans (plan, robust, lossy, arm, executed), a batch and a simulation; with a second one, pictures of the
// pages are written there.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const [folder, pictures] = process.argv.slice(2);
const DESKTOP = { width: 1280, height: 860 };
const PHONE = { width: 390, height: 844 };
const FLAGS = ["--headless=new", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-sandbox"];

const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const TAGS = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"];

const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: FLAGS });

/** Opens a page, which must neither complain nor ask for anything but files. */
async function open(name, viewport = DESKTOP, colorScheme = "light") {
  const page = await browser.newPage({ viewport, colorScheme, reducedMotion: "reduce" });
  page.on("console", (message) => assert.fail(`${name}: ${message.type()}: ${message.text()}`));
  page.on("pageerror", (error) => assert.fail(`${name}: ${error.stack}`));
  page.on("request", (request) => assert.match(request.url(), /^(file|data):/, `${name} asks for ${request.url()}`));
  await page.goto(pathToFileURL(resolve(folder, name)).href);
  await page.waitForSelector("main");
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert.ok(overflow <= 0, `${name}: wider than ${viewport.width} by ${overflow}`);
  return page;
}

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

/** Two frames later everything is drawn. */
const settle = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 150)))));
const picture = async (page) => {
  await settle(page);
  return (await page.locator("canvas").first().screenshot()).toString("base64");
};
const clock = (page) => page.locator(".clock").textContent().then(Number.parseFloat);
const scrub = (page, share) =>
  page.getByLabel("Time", { exact: true }).evaluate((range, part) => {
    range.value = part * range.max;
    range.dispatchEvent(new Event("input"));
  }, share);
const cursor = (page) => page.locator(".now").first().evaluate((line) => line.getBoundingClientRect().left);

/** Does something that must change the picture. */
async function changesPicture(page, what, action) {
  const before = await picture(page);
  await action();
  assert.notEqual(await picture(page), before, `${what} changes nothing that is seen`);
}

async function testPlan(name) {
  const page = await open(name);
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
  await changesPicture(page, "hiding a scenario", () => page.getByRole("button", { name: /^Show Scenario 1/ }).click());
  await changesPicture(page, "the cut", () => page.getByLabel("Cut", { exact: true }).selectOption("x"));
  await changesPicture(page, "the place of the cut", () => page.getByLabel("Place of the cut").fill("0.4"));
  await page.getByLabel("Cut", { exact: true }).selectOption("none");
  await changesPicture(page, "the homotopy", async () => {
    await page.getByRole("button", { name: "Homotopy", exact: true }).click();
    await page.getByRole("slider", { name: "Homotopy iteration" }).fill("1");
  });
  await changesPicture(page, "smoothed shapes", () => page.getByLabel("Smoothed shapes").uncheck());
  await changesPicture(page, "a rollout", () => page.getByRole("button", { name: /^Hard contact, friction 0\.1/ }).click());
  await changesPicture(page, "orbiting", () => page.mouse.move(300, 300).then(() => page.mouse.down()).then(() => page.mouse.move(380, 330)).then(() => page.mouse.up()));
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
  await changesPicture(page, "the arm", () => page.getByLabel("Arm").uncheck());
  await page.getByRole("button", { name: /^Hard contact/ }).first().click();
  assert.ok(await page.getByLabel("Arm").isHidden(), "joints are known along the plan");
  await page.close();
}

/** What a robot did, beside a rollout. */
async function testExecuted(name) {
  const page = await open(name);
  const button = (words) => page.getByRole("button", { name: words });
  assert.equal(await button("Executed: executed.csv").getAttribute("aria-pressed"), "true", "the page opens with the first log");
  assert.match(await page.locator("main").textContent(), /If the part ended at its goal.*was stopped.*force of 41 N/s);
  const plot = (title) => page.getByText(title, { exact: true }).count();
  assert.equal(await plot("Distance between robot and rollout"), 1);
  assert.equal(await plot("Measured force at the tool, robot"), 1);
  await scrub(page, 0.5);
  await changesPicture(page, "the rollout", () => button(/^Rollout/).click());
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
  assert.match(await page.locator("main").textContent(), /straight push/);
  await page.close();
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

try {
  await testPlan("plan/report.html");
  await testPlan("robust/report.html");
  await testBatch("batch/report.html");
  await testSimulation("simulation/report.html");
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
    await takePicture("plan/report.html", "report.png", { width: 1200, height: 780 }, "light", 0.62);
    await takePicture("clamp/report.html", "report-dark.png", { width: 1200, height: 780 }, "dark", 0.8);
  }
} finally {
  await browser.close();
}
console.log("report pages work");
