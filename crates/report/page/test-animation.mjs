// Animations, as a browser plays them.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { browser, folder } from "./driver.mjs";

/** Instants at which pictures are counted. */
const INSTANTS = 400;

/** The parts move, in a browser and as an image of another page. */
export async function testAnimation(name) {
  const address = pathToFileURL(resolve(folder, name)).href;
  if (name.endsWith(".svg")) await testPictures(address);
  const around = resolve(folder, `${name}.html`);
  writeFileSync(around, `<img src="${name}">`);
  const page = await browser.newPage();
  await page.goto(pathToFileURL(around).href);
  await page.waitForFunction(() => document.images[0].naturalWidth > 0);
  const shown = () => page.locator("img").screenshot();
  const first = await shown();
  for (let tries = 0; first.equals(await shown()); tries += 1) assert.ok(tries < 200, `${name} does not move`);
  await page.close();
}

/** At any instant a browser shows one picture, and to readers who have asked for less motion the last one. */
async function testPictures(address) {
  const page = await browser.newPage({ reducedMotion: "no-preference" });
  await page.goto(address);
  const seen = await page.evaluate((instants) => {
    const [groups, animations] = [[...document.querySelectorAll(".picture")], document.getAnimations()];
    animations.forEach((animation) => animation.pause());
    const total = animations[0].effect.getComputedTiming().duration;
    return Array.from({ length: instants }, (_, instant) => {
      animations.forEach((animation) => (animation.currentTime = ((instant + 0.5) / instants) * total));
      return groups.flatMap((group, index) => (getComputedStyle(group).visibility === "visible" ? [index] : []));
    });
  }, INSTANTS);
  assert.ok(seen.every((pictures) => pictures.length === 1 || pictures.length === 2), "one picture is shown, or two while they change");
  const upper = seen.map((pictures) => pictures.at(-1));
  const count = await page.locator(".picture").count();
  assert.deepEqual([...new Set(upper)], Array.from({ length: count }, (_, index) => index), "all pictures are shown, one after the other");
  await page.emulateMedia({ reducedMotion: "reduce" });
  const still = await page.$$eval(".picture", (groups) => groups.map((group) => getComputedStyle(group).visibility));
  assert.deepEqual(still, [...Array(count - 1).fill("hidden"), "visible"]);
  await page.close();
}
