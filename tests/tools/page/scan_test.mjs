// The page of a scan as its reader uses it.
import assert from "node:assert/strict";
import { renameSync, rmSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Browser, colours_in, comes_to_be_told, numbers_in, picture_of, reported, resized, table_of, vesicle } from "./browser.mjs";

const input = `[scan]
reduced_volume = [0.6, 0.7, 0.8]
L = [0.03, 0.06, 0.09]
branches = ["oblate", "prolate"]
modes = 2
`;
let scan, rows, browser, page;

before(async () => {
  scan = reported("scan", input);
  rows = scan.table("scan.csv");
  browser = await Browser.start();
  page = await browser.open_live(scan.file);
});
after(async () => {
  await browser?.close();
  scan?.remove();
});

const row_of = (model, branch, V, L) =>
  rows.findIndex((row) => row.model === model && row.branch === branch && row.reduced_volume === V && row.L === L);
const click = (row, on = page) => on.locator(`.cells rect[data-row="${row}"]`).click({ force: true });
const heading = (on = page) => on.locator(".point h3").textContent();
const choose = (name, value) => page.locator(`select[name=${name}]`).selectOption(value);
const expected_heading = ({ model, branch, reduced_volume, L }) => `${model} ${branch}, V_r = ${reduced_volume}, L = ${L}`;

test("the numbers of every point are those of scan.csv, digit by digit", async () => {
  let seen = 0;
  for (const model of ["SBEH", "SSH"])
    for (const branch of ["oblate", "prolate"]) {
      await choose("model", model);
      await choose("branch", branch);
      for (const [index, row] of rows.entries()) {
        if (row.model !== model || row.branch !== branch) continue;
        await click(index);
        assert.equal(await heading(), expected_heading(row));
        assert.deepEqual(await numbers_in(page, ".numbers-of"), row);
        ++seen;
      }
    }
  assert.equal(seen, rows.length);
});

test("a click shows the shape of the point, as its profile has it", async () => {
  await choose("model", "SBEH");
  await choose("branch", "oblate");
  const pictures = [];
  for (const V of ["0.6", "0.8"]) {
    await click(row_of("SBEH", "oblate", V, "0.03"));
    pictures.push(await picture_of(page, ".point canvas"));
    const nodes = table_of(scan.read(`points/SBEH_oblate_v${V}_L0.03.csv`));
    const r = nodes.map((node) => Number(node.r)), z = nodes.map((node) => Number(node.z));
    const drawn = await page.$$eval(".profile path[stroke]", (paths) => paths.map((path) => path.getAttribute("d").match(/-?[\d.e-]+/g).map(Number)));
    const across = drawn.flatMap(([x0, , x1]) => [x0, x1]), up = drawn.flatMap(([, y0, , y1]) => [y0, y1]);
    const step = 2 / 65534; // of 16 bits, of lengths below 2
    assert.ok(Math.abs(Math.max(...across) - Math.max(...r)) < step + 1e-3 * Math.max(...r)); // every second node or so
    assert.ok(Math.abs(Math.max(...up) - Math.min(...up) - (Math.max(...z) - Math.min(...z))) < step + 1e-3 * Math.max(...r));
  }
  assert.notEqual(pictures[0], pictures[1]);
  for (const picture of pictures) assert.ok((await colours_in(page, picture)) > 100);
});

test("the command for the modes of a point, as it is told, brings their shapes into the page", async () => {
  const index = row_of("SBEH", "oblate", "0.7", "0.03"), row = rows[index], report = scan.read("report.html");
  await click(index);
  const [, ...words] = (await page.locator(".modes code").textContent()).split(" ");
  scan.made([...words, "--no-pictures"]);
  const name = "modes/SBEH_oblate_v0.7_L0.03", modes = scan.table(`${name}/modes.csv`);
  const of_m2 = modes.filter(({ m }) => m === "2").map(({ eigenvalue }) => Number(eigenvalue));
  // Computed from the profile, the same state to rounding: 1e-6 is far below what tells modes apart.
  assert.ok(Math.abs(Math.min(...of_m2) - Number(row.eigenvalue_m2)) < 1e-6);
  scan.report();
  const there = await browser.open_live(scan.file);
  await click(index, there);
  const shown = await there.$$eval(".modes tr[data-mode]", (lines) => lines.slice(1).map((line) => [...line.querySelectorAll("td")].slice(1).map((cell) => cell.textContent)));
  assert.deepEqual(shown, modes.map((mode) => Object.values(mode)));
  const section = () => there.$$eval(".profile path[stroke]", (paths) => paths.map((path) => path.getAttribute("d").match(/-?[\d.e-]+/g).map(Number)));
  const before_it = await section(), at_rest = await picture_of(there, ".point canvas"), pictures = new Set([at_rest]);
  for (const { m, parity, number } of modes) {
    await there.locator(`tr[data-mode=m${m}_${parity}_${number}]`).click();
    await there.locator("input[type=range]").fill("0");
    const rest = await section();
    await there.locator("input[type=range]").fill("0.2");
    pictures.add(await picture_of(there, ".point canvas"));
    const far = (await section()).map(([x, y], k) => Math.hypot(x - rest[k][0], y - rest[k][1]));
    const u = scan.table(`${name}/modes/m${m}_${parity}_${number}.csv`).map((node) => Math.abs(node.displacement));
    // Every second node or so is drawn, at whose neighbours u is less by a fiftieth at most; the last one of a half has no piece.
    assert.ok(Math.abs(Math.max(...far) - 0.2 * Math.max(...u)) < 0.02 * 0.2, `m = ${m}, ${parity}, ${number}`);
  }
  assert.equal(pictures.size, 1 + modes.length);
  await there.locator("tr[data-mode=rest]").click();
  assert.equal(await picture_of(there, ".point canvas"), at_rest);
  assert.deepEqual(await section(), before_it);
  await click(row_of("SBEH", "oblate", "0.8", "0.03"), there);
  assert.equal(await there.locator("tr[data-mode]").count(), 0);
  await resized(there, 380);
  await click(index, there);
  assert.equal(await there.evaluate(() => document.documentElement.scrollWidth), 380);
  assert.deepEqual(there.faults, []);
  await there.close();
  renameSync(join(scan.folder, name), join(scan.folder, "modes/SBEH_oblate_v0.8_L0.03"));
  assert.throws(() => scan.report(), /SBEH_oblate_v0\.8_L0\.03: holds the modes of SBEH oblate, V_r = 0\.7, L = 0\.03, not of SBEH oblate, V_r = 0\.8, L = 0\.03/);
  rmSync(join(scan.folder, "modes"), { recursive: true });
  scan.written("report.html", report);
});

test("the pointer over a point tells its numbers", async () => {
  const row = row_of("SBEH", "oblate", "0.7", "0.06");
  await page.locator(`.cells rect[data-row="${row}"]`).hover({ force: true });
  const told = await page.locator(".tip").textContent();
  for (const text of ["V_r = 0.7, L = 0.06", `energy = ${rows[row].energy}`, `order_min = ${rows[row].order_min}`])
    assert.ok(told.includes(text), told);
  await page.mouse.move(2, 2);
  assert.equal(await page.locator(".tip").isVisible(), false);
});

test("colours go from the least to the largest energy at rest, and the unresolved have none", async () => {
  const fills = await page.$$eval(".cells rect", (cells) => cells.map((cell) => [Number(cell.dataset.row), cell.getAttribute("fill")]));
  const resting = fills.filter(([row]) => rows[row].status === "stationary");
  const others = fills.filter(([row]) => rows[row].status !== "stationary");
  assert.ok(others.length > 0 && resting.length > 0);
  for (const [, fill] of others) assert.equal(fill, "url(#hatching)");
  const by_energy = [...resting].sort(([a], [b]) => rows[a].energy - rows[b].energy);
  assert.equal(by_energy[0][1], "#440154"); // the ends of viridis
  assert.equal(by_energy.at(-1)[1], "#fde725");
});

test("the lines are those of the tables", async () => {
  const inside = (row) => Number(row.L) > 0.015 && Number(row.L) < 0.105 && Number(row.reduced_volume) > 0.55 && Number(row.reduced_volume) < 0.85;
  const dots = (style) => page.locator(`.lines circle.${style}`).count();
  const count = (name, holds) => scan.table(name).filter((row) => inside(row) && holds(row)).length;
  assert.equal(await dots("fold"), count("folds.csv", (row) => row.branch === "oblate"));
  assert.equal(await dots("equal"), count("equal_energy.csv", () => true));
  const of_oblates = (row) => row.model === "SBEH" && row.branch === "oblate" && row.reduced_volume !== "" && row.L !== "";
  assert.equal(await dots("stability"), count("stability_lines.csv", of_oblates));
  assert.ok((await dots("fold")) > 0 && (await dots("stability")) > 0);
});

test("another quantity, classes among them, and the lowest branch can be chosen", async () => {
  await choose("quantity", "class");
  assert.match(await page.locator(".colours").first().textContent(), /class.*oblate/);
  await choose("quantity", "order_min");
  await choose("branch", "lowest");
  for (const { model, L, reduced_volume, branch } of scan.table("lowest.csv")) {
    if (model !== "SBEH" || row_of(model, branch, reduced_volume, L) < 0) continue;
    await click(row_of(model, branch, reduced_volume, L));
    assert.equal(await heading(), `${model} ${branch}, V_r = ${reduced_volume}, L = ${L}`);
  }
  await choose("branch", "oblate");
  await choose("quantity", "energy");
});

test("all can be done by keys", async () => {
  await click(row_of("SBEH", "oblate", "0.6", "0.03"));
  await page.locator("select[name=colours]").focus();
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement.getAttribute("aria-roledescription")), "diagram");
  await page.keyboard.press("ArrowRight");
  assert.equal(await heading(), "SBEH oblate, V_r = 0.7, L = 0.03");
  await page.keyboard.press("ArrowUp");
  assert.equal(await heading(), "SBEH oblate, V_r = 0.7, L = 0.06");
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("ArrowLeft"); // there is no point beyond
  assert.equal(await heading(), "SBEH oblate, V_r = 0.6, L = 0.06");
  await page.keyboard.press("Enter");
  assert.equal(await page.evaluate(() => document.activeElement.tagName), "CANVAS");
  const before_turning = await picture_of(page, ".point canvas");
  await page.keyboard.press("ArrowUp");
  assert.notEqual(await picture_of(page, ".point canvas"), before_turning);
  await page.keyboard.press("Home");
  assert.equal(await picture_of(page, ".point canvas"), before_turning);
});

test("neighbours, models and branches are a click away", async () => {
  await click(row_of("SBEH", "oblate", "0.7", "0.03"));
  for (const [button, expected] of [
    ["V_r +", "SBEH oblate, V_r = 0.8, L = 0.03"],
    ["L +", "SBEH oblate, V_r = 0.8, L = 0.06"],
    ["SSH", "SSH oblate, V_r = 0.8, L = 0.06"],
    ["prolate", "SSH prolate, V_r = 0.8, L = 0.06"],
  ]) {
    await page.locator(".near button", { hasText: button }).click();
    assert.equal(await heading(), expected);
  }
  const beyond = page.locator(".near button", { hasText: "V_r +" });
  assert.equal(await beyond.isDisabled(), true);
  assert.equal(await beyond.getAttribute("title"), "There is no point.");
  await choose("model", "SBEH");
  await choose("branch", "oblate");
});

test("a scan over one parameter is drawn as curves", async () => {
  const one = reported("scan", "[scan]\nreduced_volume = [0.6, 0.7, 0.8]\nL = 0.05\nbranches = [\"oblate\", \"prolate\"]\nmodels = [\"SSH\"]\nmodes = 0\n");
  const all = one.table("scan.csv"), curves = await browser.open_live(one.file);
  const dots = await curves.$$eval(".curve circle", (circles) => circles.map((dot) => [Number(dot.dataset.row), Number(dot.getAttribute("cy"))]));
  assert.equal(dots.length, all.length);
  // Heights go linearly with the energy: by the first two, all others.
  const [[first, y0], [second, y1]] = dots;
  const slope = (y1 - y0) / (all[second].energy - all[first].energy);
  for (const [row, y] of dots) assert.ok(Math.abs(y - y0 - slope * (all[row].energy - all[first].energy)) < 1e-6);
  const crossings = await curves.locator(".lines path.equal").count();
  assert.equal(crossings, one.table("equal_energy.csv").length);
  for (const [index, row] of all.entries()) {
    await curves.locator(`.curve circle[data-row="${index}"]`).click({ force: true });
    assert.equal(await heading(curves), expected_heading(row));
    assert.deepEqual(await numbers_in(curves, ".numbers-of"), row);
  }
  await curves.locator(".diagram svg").focus();
  await curves.keyboard.press("ArrowLeft");
  assert.deepEqual(curves.faults, []);
  one.remove();
});

test("in physical units all numbers are those of the converted table, with their units", async () => {
  const { file, table } = scan.in_units(vesicle);
  const there = await browser.open_live(file), converted = table("scan.csv");
  const names = Object.keys(converted[0]).slice(0, Object.keys(rows[0]).length);
  const row = row_of("SBEH", "oblate", "0.7", "0.03");
  await click(row, there);
  const shown = await numbers_in(there, ".numbers-of");
  assert.deepEqual(Object.values(shown), names.map((name) => converted[row][name]));
  assert.match(await there.locator('.numbers-of tr[data-column="H_pole"] th').textContent(), /\(1\/µm\)/);
  assert.match(await there.locator(".said").first().textContent(), new RegExp(`energy = ${converted[row].energy_kT} kT`));
  assert.match(await there.locator(".two .colours").first().textContent(), /^energy \(kT\)/);
  await there.locator(".point select").selectOption("H");
  assert.match(await there.locator(".point .colours").textContent(), /mean curvature H \(1\/µm\)/);
  assert.deepEqual(there.faults, []);
});

test("nothing is asked of a network, and no error is left", () => {
  assert.deepEqual(page.requests.filter((url) => !/^(file|data|blob):/.test(url)), []);
  assert.deepEqual(page.faults, []);
});

test("a phone shows it without scrolling sideways", async () => {
  const narrow = await browser.open_live(scan.file, 380);
  assert.equal(await narrow.evaluate(() => document.documentElement.scrollWidth), 380);
  await click(row_of("SBEH", "oblate", "0.8", "0.06"), narrow);
  assert.equal(await heading(narrow), "SBEH oblate, V_r = 0.8, L = 0.06");
  await narrow.close();
});

test("a browser without WebGL draws the shape too", async () => {
  const plain = await Browser.start("--disable-3d-apis");
  const without = await plain.open_live(scan.file);
  assert.equal(await without.locator(".surface").getAttribute("data-painter"), "canvas");
  assert.ok((await colours_in(without, await picture_of(without, ".point canvas"))) > 100);
  const before_click = await picture_of(without, ".point canvas");
  await click(row_of("SBEH", "oblate", "0.8", "0.03"), without);
  assert.notEqual(await picture_of(without, ".point canvas"), before_click);
  await plain.close();
});

test("a file that was cut off says so, wherever that was; a whole one does not", async () => {
  const text = scan.read("report.html");
  const body = text.indexOf("<main>"), data = text.indexOf('id="sbeh-data"'), script = text.indexOf("</script>", data);
  const lengths = [body + 100, data - 2000, data + 5000, script + 30, script + 5000, text.length - 20_000, text.length - 30];
  const pages = await Promise.all(lengths.map((length) => browser.open(scan.written(`cut${length}.html`, text.slice(0, length)))));
  for (const [k, cut] of pages.entries()) {
    assert.ok(await comes_to_be_told(cut), `cut off after ${lengths[k]} of ${text.length}`);
    await cut.close();
  }
  await page.bringToFront();
  assert.equal(await comes_to_be_told(page), false);
});

test("data that are damaged are told, not shown", async () => {
  const text = scan.read("report.html"), at = text.indexOf('id="sbeh-data"') + 3000;
  const other = text[at] === "A" ? "B" : "A";
  for (const damaged of [text.slice(0, at) + other + text.slice(at + 1), text.slice(0, at) + text.slice(at + 400)]) {
    const broken = await browser.open(scan.written("damaged.html", damaged));
    await broken.waitForSelector("#explore[data-state=failed]");
    assert.match(await broken.locator("#explore [role=alert]").textContent(), /cannot be explored here/);
    await broken.close();
  }
});
