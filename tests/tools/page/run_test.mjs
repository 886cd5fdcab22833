// The page of a 3D run as its reader uses it.
import assert from "node:assert/strict";
import { copyFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { Browser, colours_in, comes_to_be_told, numbers_in, numbers_of, parts_of, picture_of, reported, table_of, vesicle } from "./browser.mjs";

const input = `model = "SBEH"
[surface]
shape = "ellipsoid"
reduced_volume = 0.8
triangles = 320
[material]
L = 0.05
[time]
end = 0.003
frames = [0, 0.0003, 0.001, 0.003]
output = [0, 0.0003, 0.001, 0.003]
`;
let run, series, frames, browser, page;

before(async () => {
  run = reported("run", input);
  series = run.table("series.csv");
  frames = run.table("frames.csv");
  browser = await Browser.start();
  page = await browser.open_live(run.file);
});
after(async () => {
  await browser?.close();
  run?.remove();
});

const canvas = ".explore-run .surface canvas";
const slide_to = (index, on = page) => on.locator("input[type=range]").fill(String(index));

test("the surfaces of the frames have the area and volume of the run, the order its range", () => {
  const parts = parts_of(run.read("report.html"));
  const fields = table_of(parts["fields.csv"].toString()), [mesh] = table_of(parts["meshes.csv"].toString());
  const nodes = Number(mesh.nodes), size = fields.length * nodes;
  const numbers = numbers_of(parts["frames/0"], 2), corners = numbers_of(parts["mesh/0"], 4);
  assert.equal(mesh.triangles, "320");
  assert.equal(corners.length, 3 * 9 * 320);
  assert.equal(numbers.length, frames.length * size);
  for (let i = size; i < numbers.length; ++i) numbers[i] = (numbers[i] + numbers[i - size]) % 65536;
  frames.forEach(({ time }, k) => {
    const value = (field, node) => {
      const { low, high } = fields[field];
      return Number(low) + ((Number(high) - Number(low)) * numbers[k * size + field * nodes + node]) / 65534;
    };
    const point = (node) => [0, 1, 2].map((field) => value(field, node));
    let area = 0, volume = 0;
    for (let t = 0; t < corners.length; t += 3) {
      const [a, b, c] = [0, 1, 2].map((corner) => point(corners[t + corner]));
      const cross = (u, v) => [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
      const less = (u, v) => u.map((x, i) => x - v[i]);
      area += 0.5 * Math.hypot(...cross(less(b, a), less(c, a)));
      volume += a.reduce((sum, x, i) => sum + x * cross(b, c)[i], 0) / 6;
    }
    const row = series.find((one) => Number(one.time) === Number(time));
    // 2880 triangles have edges h ≈ 0.1. On curvatures up to 3 they are short by (3h)²/24 = 0.4 % in each direction.
    assert.ok(Math.abs(area / Number(row.area) - 1) < 0.008, `area ${area} at ${time}`);
    assert.ok(Math.abs(volume / Number(row.volume) - 1) < 0.016, `volume ${volume} at ${time}`);
    const orders = Array.from({ length: nodes }, (_, node) => value(3, node));
    const step = (Number(fields[3].high) - Number(fields[3].low)) / 65534;
    const width = Number(row.order_max) - Number(row.order_min);
    assert.ok(Math.abs(Math.min(...orders) - Number(row.order_min)) < step + 0.05 * width); // the table has more than nodes
    assert.ok(Math.abs(Math.max(...orders) - Number(row.order_max)) < step + 0.05 * width);
  });
});

test("the slider shows the surface, the numbers of series.csv and the line in the charts of its time", async () => {
  const pictures = new Set(), charts = new Set();
  for (const [k, frame] of frames.entries()) {
    await slide_to(k);
    assert.equal(await page.locator(".time").textContent(), `t = ${frame.time}`);
    const shown = await numbers_in(page, ".explore-run");
    const row = series.find((one) => one.time === frame.time);
    assert.equal(shown.energy, row.energy);
    for (const [column, text] of Object.entries(shown)) assert.equal(text, row[column]);
    assert.equal(Number(await page.locator("[data-time]").getAttribute("data-time")), Number(frame.time));
    pictures.add(await picture_of(page, canvas));
    charts.add(await page.$eval(".chart canvas", (chart) => chart.toDataURL()));
  }
  assert.equal(pictures.size, frames.length);
  assert.equal(charts.size, frames.length); // the line is elsewhere
});

test("the charts are those of the still page, and have its lines", async () => {
  const still = await page.$$eval(".charts figure svg[role=img]", (charts) => charts.map((chart) => chart.getAttribute("aria-label")));
  const live = await page.$$eval(".chart:not([hidden]) .u-title", (titles) => titles.map((title) => title.textContent));
  assert.ok(still.length > 4);
  assert.deepEqual(live, still);
  assert.equal(await page.locator(".charts").isVisible(), false); // the live ones stand for them
});

test("a click into a chart goes to the frame of that time", async () => {
  await slide_to(0);
  const chart = page.locator(".u-over").first();
  const { width, height } = await chart.boundingBox();
  await chart.click({ position: { x: width - 2, y: height / 2 } });
  assert.equal(await page.locator(".time").textContent(), `t = ${frames.at(-1).time}`);
});

test("the field and its range can be chosen", async () => {
  const bars = new Set();
  for (const field of ["order", "H", "speed"]) {
    await page.locator("select[name=field]").selectOption(field);
    for (const range of ["all", "one"]) {
      await page.locator("select[name=range]").selectOption(range);
      bars.add(await page.locator(".explore-run .colours").textContent());
    }
  }
  assert.ok(bars.size >= 3);
  assert.ok((await colours_in(page, await picture_of(page, canvas))) > 100);
});

test("it is turned by the mouse and by keys, played, and slid by keys", async () => {
  const before_turning = await picture_of(page, canvas);
  const { x, y, width, height } = await page.locator(canvas).boundingBox();
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + width / 2 + 60, y + height / 2 + 50, { steps: 4 });
  await page.mouse.up();
  const turned = await picture_of(page, canvas);
  assert.notEqual(turned, before_turning);
  await page.locator(canvas).focus();
  await page.keyboard.press("+");
  assert.notEqual(await picture_of(page, canvas), turned);
  await page.locator("input[type=range]").focus();
  await page.keyboard.press("Home");
  assert.equal(await page.locator(".time").textContent(), "t = 0");
  await page.keyboard.press("ArrowRight");
  assert.equal(await page.locator(".time").textContent(), `t = ${frames[1].time}`);
  await page.locator("button", { hasText: "Play" }).click();
  await page.waitForFunction((time) => document.querySelector(".time").textContent === time, `t = ${frames.at(-1).time}`);
});

test("in physical units numbers, charts and time are those of the converted table", async () => {
  const { file, table } = run.in_units(vesicle);
  const there = await browser.open_live(file), converted = table("series.csv"), times = table("frames.csv");
  await slide_to(2, there);
  const row = converted.find(({ time_s }) => time_s === times[2].time_s);
  const shown = await numbers_in(there, ".explore-run");
  assert.equal(shown.energy, row.energy_kT);
  assert.equal(shown.speed_max, row.speed_max_um_per_s);
  const told = await there.locator(".explore-run .time").textContent();
  assert.equal(told, `t = ${times[2].time_s} s`);
  assert.equal(shown.time, row.time_s);
  assert.match(await there.locator(".live-charts").textContent(), /t \(s\)/);
  await there.locator("select[name=field]").selectOption("H");
  assert.match(await there.locator(".explore-run .colours").textContent(), /mean curvature H \(1\/µm\)/);
  assert.deepEqual(there.faults, []);
});

test("nothing is asked of a network, and no error is left", () => {
  assert.deepEqual(page.requests.filter((url) => !/^(file|data|blob):/.test(url)), []);
  assert.deepEqual(page.faults, []);
});

test("a phone shows it without scrolling sideways, a browser without WebGL draws it", async () => {
  const plain = await Browser.start("--disable-3d-apis");
  const narrow = await plain.open_live(run.file, 380);
  assert.equal(await narrow.evaluate(() => document.documentElement.scrollWidth), 380);
  assert.equal(await narrow.locator(".surface").getAttribute("data-painter"), "canvas");
  const last = await picture_of(narrow, canvas);
  assert.ok((await colours_in(narrow, last)) > 100);
  await slide_to(0, narrow);
  assert.notEqual(await picture_of(narrow, canvas), last);
  await plain.close();
});

test("a frame on new triangles is shown on these", async () => {
  const coarse = reported("run", input.replace("triangles = 320", "triangles = 80"));
  copyFileSync(`${run.folder}/frames/0003.vtu`, `${coarse.folder}/frames/fine.vtu`);
  coarse.written("frames.csv", `${coarse.read("frames.csv")}4,0.004,frames/fine.vtu\n`);
  coarse.report();
  const parts = parts_of(coarse.read("report.html"));
  assert.deepEqual(table_of(parts["meshes.csv"].toString()).map((mesh) => [mesh.triangles, mesh.frames]), [["80", "4"], ["320", "1"]]);
  const both = await browser.open_live(coarse.file);
  assert.match(await both.locator("#explore").textContent(), /5 frames of 80, 320 curved triangles/);
  const fine = await picture_of(both, canvas);
  await slide_to(3, both);
  const before_it = await picture_of(both, canvas);
  assert.notEqual(before_it, fine);
  await slide_to(4, both);
  assert.equal(await picture_of(both, canvas), fine);
  assert.deepEqual(both.faults, []);
  coarse.remove();
});

test("an axisymmetric evolution is shown turned about its axis", async () => {
  const relax = reported("relax", `model = "SBEH"
[start]
shape = "ellipsoid"
reduced_volume = 0.8
[time]
end = 0.01
output = [0, 0.001, 0.01]
profiles = [0, 0.001, 0.01]
`);
  const other = await browser.open_live(relax.file);
  const rows = relax.table("series.csv"), pictures = new Set();
  for (const [k, profile] of relax.table("profiles.csv").entries()) {
    await slide_to(k, other);
    assert.equal((await numbers_in(other, ".explore-run")).energy, rows.find((row) => row.time === profile.time).energy);
    pictures.add(await picture_of(other, canvas));
  }
  assert.equal(pictures.size, 3);
  assert.deepEqual(await other.$$eval("select[name=field] option", (options) => options.map((option) => option.value)), ["order", "H"]);
  assert.deepEqual(other.faults, []);
  relax.remove();
});

test("a file that was cut off says so", async () => {
  const text = run.read("report.html");
  const cut = await browser.open(run.written("cut.html", text.slice(0, text.indexOf('id="sbeh-data"') + 4000)));
  assert.ok(await comes_to_be_told(cut));
});
