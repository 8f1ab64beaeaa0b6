// Chromium and what a reader does in it, for the tests of report pages. Arguments of the program: a folder with pages, and
// a folder for pictures.
import assert from "node:assert/strict";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

export const [folder, pictures] = process.argv.slice(2);
export const DESKTOP = { width: 1280, height: 860 };
export const PHONE = { width: 390, height: 844 };
const FLAGS = ["--headless=new", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-sandbox"];

export const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: FLAGS });

/**
 * Opens a page, perhaps at a fragment. It must neither complain nor ask for anything but files and what it made itself; `prepare` may change the browser
 * before.
 */
export async function open(name, viewport = DESKTOP, colorScheme = "light", prepare = null) {
  const page = await browser.newPage({ viewport, colorScheme, reducedMotion: "reduce" });
  if (prepare) await page.addInitScript(prepare);
  page.on("console", (message) => assert.fail(`${name}: ${message.type()}: ${message.text()}`));
  page.on("pageerror", (error) => assert.fail(`${name}: ${error.stack}`));
  page.on("request", (request) => assert.match(request.url(), /^(file|data|blob):/, `${name} asks for ${request.url()}`));
  const [file, fragment] = name.split("#");
  const address = pathToFileURL(resolve(folder, file));
  if (fragment) address.hash = fragment;
  await page.goto(address.href);
  await page.waitForSelector("main");
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert.ok(overflow <= 0, `${name}: wider than ${viewport.width} by ${overflow}`);
  return page;
}

/** Two frames later everything is drawn. */
export const settle = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 150)))));
export const picture = async (page) => {
  await settle(page);
  return (await page.locator("canvas").first().screenshot()).toString("base64");
};
export const clock = (page) => page.locator(".clock").textContent().then(Number.parseFloat);
export const scrub = (page, share) =>
  page.getByLabel("Time", { exact: true }).evaluate((range, part) => {
    range.value = part * range.max;
    range.dispatchEvent(new Event("input"));
  }, share);
export const cursor = (page) => page.locator(".now").first().evaluate((line) => line.getBoundingClientRect().left);

/** Turns the 3D view. */
export async function drag(page) {
  const { x, y, width, height } = await page.locator("canvas").first().boundingBox();
  await page.mouse.move(x + 0.5 * width, y + 0.5 * height);
  await page.mouse.down();
  await page.mouse.move(x + 0.6 * width, y + 0.55 * height);
  await page.mouse.up();
}

/** Does something that must change the picture. */
export async function changesPicture(page, what, action) {
  const before = await picture(page);
  await action();
  assert.notEqual(await picture(page), before, `${what} changes nothing that is seen`);
}
