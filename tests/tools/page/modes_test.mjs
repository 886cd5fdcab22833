// The page of the modes of a state as its reader uses it.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { revolved } from "../../../tools/page/src/surface/revolved.js";
import { Browser, colours_in, picture_of, reported } from "./browser.mjs";

const input = `[modes]
model = "SBEH"
branch = "oblate"
reduced_volume = 0.6
L = 0.07
largest_m = 2
`;
let modes, rows, browser, page;

before(async () => {
  modes = reported("modes", input);
  rows = modes.table("modes.csv");
  browser = await Browser.start();
  page = await browser.open_live(modes.file);
});
after(async () => {
  await browser?.close();
  modes?.remove();
});

const canvas = ".explore-run .surface canvas";
const name_of = ({ m, parity, number }) => `m${m}_${parity}_${number}`;
const choose = (row) => page.locator(`tr[data-mode=${name_of(row)}]`).click();
const set_amplitude = (value) => page.locator("input[type=range]").fill(String(value));

test("the numbers of the modes are those of modes.csv, digit by digit", async () => {
  const shown = await page.$$eval("tr[data-mode]", (lines) => lines.map((line) => [...line.querySelectorAll("td")].slice(1).map((cell) => cell.textContent)));
  assert.deepEqual(shown, rows.map((row) => Object.values(row)));
  assert.ok(rows.length >= 6);
});

test("it begins with the mode of the least eigenvalue", async () => {
  const least = rows.reduce((a, b) => (Number(b.eigenvalue) < Number(a.eigenvalue) ? b : a));
  assert.ok((await page.locator(".said").textContent()).includes(`λ = ${least.eigenvalue}`));
});

test("a click on a mode displaces the surface by it, to either side and as far as is said", async () => {
  const at_rest = new Set(), displaced = new Set();
  for (const row of rows) {
    await choose(row);
    assert.ok((await page.locator(".said").textContent()).includes(`λ = ${row.eigenvalue}`));
    await set_amplitude(0);
    at_rest.add(await picture_of(page, canvas));
    for (const amplitude of [0.2, -0.2]) {
      await set_amplitude(amplitude);
      displaced.add(await picture_of(page, canvas));
    }
  }
  assert.equal(at_rest.size, 1); // the state
  assert.equal(displaced.size, 2 * rows.length);
  for (const picture of at_rest) assert.ok(!displaced.has(picture));
});

test("a sphere displaced by a is one of radius 1 + a", () => {
  const angles = Array.from({ length: 61 }, (_, i) => (Math.PI * i) / 60);
  const normals = angles.map((angle) => [Math.sin(angle), Math.cos(angle)]);
  const sphere = { r: normals.map(([r]) => r), z: normals.map(([, z]) => z) };
  const { positions } = revolved(sphere, { displaced: (i) => normals[i].map((n) => 0.25 * n) });
  for (let k = 0; k < positions.length; k += 3)
    assert.ok(Math.abs(Math.hypot(...positions.subarray(k, k + 3)) - 1.25) < 1e-6); // of single precision
});

test("modes can be chosen by keys, the order shown, and the state swings", async () => {
  await page.locator(`tr[data-mode=${name_of(rows[0])}] input`).focus();
  await page.keyboard.press("ArrowDown");
  assert.ok((await page.locator(".said").textContent()).includes(`λ = ${rows[1].eigenvalue}`));
  await page.locator("label", { hasText: "colour by" }).locator("select").selectOption("order");
  assert.match(await page.locator(".explore-run .colours").textContent(), /order β/);
  assert.ok((await colours_in(page, await picture_of(page, canvas))) > 100);
  await page.locator("button", { hasText: "Swing" }).click();
  const first = await page.locator(".time").textContent();
  await page.waitForFunction((text) => document.querySelector(".time").textContent !== text, first);
  await page.locator("button", { hasText: "Stop" }).click();
  assert.equal(await page.locator(".time").textContent(), "amplitude -0.20");
});

test("a phone shows it without scrolling sideways, and nothing is asked of a network", async () => {
  const narrow = await browser.open_live(modes.file, 380);
  assert.equal(await narrow.evaluate(() => document.documentElement.scrollWidth), 380);
  assert.deepEqual(narrow.requests.filter((url) => !/^(file|data|blob):/.test(url)), []);
  assert.deepEqual([...narrow.faults, ...page.faults], []);
});
