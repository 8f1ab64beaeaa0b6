// Pictures, the full screen and links to a moment.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { DESKTOP, PHONE, clock, drag, open, picture, scrub, settle } from "./driver.mjs";

/** Share of the pixels up to which two pictures show the same. */
const SAME = 1e-3;
const LINK = /#motion=\d+&t=[\d.]+&scenario=\d+&/;

const button = (page, name) => page.getByRole("button", { name, exact: true });
const selected = (page) => page.locator(".scenarios [aria-pressed=true]:not(.eye)").textContent();

/** What a reader takes away from a page. */
export async function testShare(name) {
  await testPicture(name);
  await testFullScreen(name);
  await testLink(name);
  await testWrongLinks(name);
}

/** The saved file is the view, as sharp as a print needs it. */
async function testPicture(name) {
  const page = await open(name);
  await scrub(page, 0.5);
  await settle(page);
  const begun = page.waitForEvent("download");
  await button(page, "Picture").focus();
  await page.keyboard.press("Enter");
  const download = await begun;
  assert.match(download.suggestedFilename(), /^peg1-\d+\.\d\ds\.png$/);
  const file = readFileSync(await download.path());
  assert.equal(file.toString("latin1", 1, 4), "PNG");
  const [width, height] = [file.readUInt32BE(16), file.readUInt32BE(20)];
  const canvas = await page.locator("canvas").first().evaluate(({ clientWidth, clientHeight }) => [clientWidth, clientHeight]);
  assert.deepEqual([width, height], canvas.map((pixels) => 2 * pixels));
  const saved = file.toString("base64");
  const difference = await unlike(page, saved, await picture(page));
  assert.ok(difference < 0.03, `${difference} of the saved picture is not what the page shows`);
  assert.ok((await coloursOf(page, saved)) > 10, "the picture shows parts");
  await page.close();
}

/** Share of the pixels that differ visibly between two pictures (base64), both made small. */
const unlike = (page, ...files) =>
  page.evaluate(async (all) => {
    const read = async (data) => {
      const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
      const context = new OffscreenCanvas(200, 120).getContext("2d");
      context.imageSmoothingQuality = "high";
      context.drawImage(image, 0, 0, 200, 120);
      return context.getImageData(2, 2, 196, 116).data;
    };
    const [one, other] = await Promise.all(all.map(read));
    return one.filter((value, index) => Math.abs(value - other[index]) > 40).length / one.length;
  }, files);

/** Number of colours of a picture. */
const coloursOf = (page, file) =>
  page.evaluate(async (data) => {
    const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
    const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
    context.drawImage(image, 0, 0);
    return new Set(new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer)).size;
  }, file);

/** On the full screen, the view is most of it and the motion still plays. */
async function testFullScreen(name) {
  const page = await open(name);
  const share = () => page.locator(".viewport").evaluate((node) => (node.clientWidth * node.clientHeight) / (innerWidth * innerHeight));
  const before = await share();
  await button(page, "Full screen").focus();
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.fullscreenElement?.matches(".stage"));
  await settle(page);
  const full = await share();
  assert.ok(full > 0.55 && full > 1.5 * before, `the view fills ${full} of the screen, ${before} before`);
  assert.ok(await page.getByRole("button", { name: "Play" }).isVisible(), "the motion can be played");
  await button(page, "Leave full screen").click();
  await page.waitForFunction(() => document.fullscreenElement === null);
  await settle(page);
  assert.ok(Math.abs((await share()) - before) < 0.01, "the view is as large as before");
  assert.ok(await button(page, "Full screen").isVisible());
  await page.close();
}

/** A copied link leads to the picture that it was copied from, in another window and in an open one. */
async function testLink(name) {
  const page = await open(name);
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.getByRole("button", { name: /^Hard contact, friction 0\.1/ }).click();
  await page.locator(".scenarios button:not(.eye)").nth(2).click();
  await page.getByRole("button", { name: /^Show scenario 2/ }).click();
  await page.getByLabel("Cut", { exact: true }).selectOption("y");
  await page.getByLabel("Place of the cut").fill("0.1");
  await scrub(page, 0.6);
  await drag(page);
  const [time, scenario, shown] = [await clock(page), await selected(page), await picture(page)];
  await button(page, "Link").focus();
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.querySelector(".said").textContent === "Link copied");
  const link = await page.evaluate(() => navigator.clipboard.readText());
  assert.match(link, LINK);
  assert.equal(link, page.url(), "the address is the link, too");

  const fragment = link.slice(link.indexOf("#") + 1);
  const other = await open(`${name}#${fragment}`);
  assert.deepEqual([await clock(other), await selected(other)], [time, scenario]);
  const { top, bottom } = await other.locator("canvas").first().evaluate((node) => node.getBoundingClientRect());
  assert.ok(top >= 0 && bottom <= DESKTOP.height, `the window shows the view, from ${top} to ${bottom}`);
  const difference = await unlike(other, await picture(other), shown);
  assert.ok(difference < SAME, `${difference} of the picture is not what the link was copied from`);
  await other.evaluate(() => (location.hash = "#motion=1&t=0&scenario=1&view=X"));
  assert.ok((await unlike(other, await picture(other), shown)) > 10 * SAME, "an address that changes is followed");
  assert.equal(await clock(other), 0);
  assert.ok(await other.getByLabel("Place of the cut").isHidden(), "a link without a cut has none");
  // A named view shows everything, whatever the window.
  const phone = await open(`${name}#t=0&view=X`, PHONE);
  assert.equal(await clock(phone), 0);
  await Promise.all([page, other, phone].map((one) => one.close()));

  const refused = await open(name, DESKTOP, "light", () => {
    navigator.clipboard.writeText = () => Promise.reject(new Error("refused"));
  });
  await button(refused, "Link").click();
  await refused.waitForFunction(() => /address of this window/.test(document.querySelector(".said").textContent));
  assert.match(refused.url(), LINK, "without a clipboard, the address is the link");
  await refused.close();
}

/** What an address names and the page does not have changes nothing. */
async function testWrongLinks(name) {
  const page = await open(name);
  const [time, scenario, shown] = [await clock(page), await selected(page), await picture(page)];
  const wrong = ["motion=99&scenario=0&t=NaN", "t=&scenario=-1&view=1,2,3", "view=0,0,0,0,0,0", "view=toString&cut=w,1", "section-made-from", "hidden=77,x&cut=x2"];
  for (const fragment of wrong) {
    await page.evaluate((hash) => (location.hash = hash), fragment);
    await settle(page);
    assert.deepEqual([await clock(page), await selected(page)], [time, scenario], fragment);
    assert.ok((await unlike(page, await picture(page), shown)) < SAME, fragment);
  }
  const late = await open(`${name}#t=1e9`);
  assert.equal(await clock(late), Number((await late.locator(".clock").textContent()).match(/\/ ([\d.]+) s/)[1]), "times end with the motion");
  await Promise.all([page, late].map((one) => one.close()));
}
