// Two plans on one page.
import assert from "node:assert/strict";
import { clock, drag, open, scrub, settle } from "./driver.mjs";

export async function testBeside(name) {
  const page = await open(name);
  const views = page.locator(".pair canvas");
  assert.equal(await views.count(), 2);
  const pictures = async () => {
    await settle(page);
    return Promise.all([0, 1].map(async (index) => (await views.nth(index).screenshot()).toString("base64")));
  };
  const bothChange = async (what, action) => {
    const before = await pictures();
    await action();
    const after = await pictures();
    before.forEach((picture, index) => assert.ok(picture !== after[index], `${what} changes nothing in view ${index + 1}`));
  };
  await bothChange("time", () => scrub(page, 0.6));
  await bothChange("orbiting one view", () => drag(page));
  await bothChange("a view", () => page.getByRole("button", { name: "View X" }).nth(1).click());
  await page.locator("h1").click();
  await bothChange("a key", () => page.keyboard.press("Home"));
  await bothChange("the end", () => page.keyboard.press("End"));
  await page.keyboard.press("Home");
  await page.keyboard.press(" ");
  await page.waitForFunction(() => Number.parseFloat(document.querySelector(".clock").textContent) > 0.3);
  await page.keyboard.press(" ");
  // Another motion of one plan leaves both at one time.
  await scrub(page, 0.5);
  const time = await clock(page);
  await page.locator(".pair .stage").nth(1).getByRole("button", { name: /^Hard contact/ }).nth(0).click();
  assert.equal(await clock(page), time);

  const rows = await page.$$eval(".card tbody tr", (all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));
  assert.ok(rows.every((row) => row.length === 3), "every number is there for both");
  const row = (start) => rows.find(([title]) => title.startsWith(start));
  for (const start of ["success, friction", "planned offsets at the goal", "end at most", "largest force", "largest contact force", "duration"]) {
    assert.ok(row(start).slice(1).some((cell) => /\d/.test(cell)), `${start}: ${row(start)}`);
  }
  assert.notEqual(row("status")[1], row("status")[2], "one of the plans is robust");
  await page.close();
}
