// The page of rest states in 3D as its reader uses it.
import assert from "node:assert/strict";
import { readFileSync, rmSync, writeFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { normals_of } from "../../../tools/page/src/surface/normals.js";
import { Browser, colours_in, comes_to_be_told, numbers_in, numbers_of, parts_of, picture_of, reported, table_of, vesicle } from "./browser.mjs";

const input = `[states]
model = "SSH"
branch = "oblate"
reduced_volume = 0.755
L = 0.05
triangles = 180
eigenpairs = 2
[follow]
parameter = "reduced_volume"
to = 0.74
`;
let states, rows, browser, page;

before(async () => {
  states = reported("states", input);
  rows = states.table("states.csv");
  browser = await Browser.start();
  page = await browser.open_live(states.file);
});
after(async () => {
  await browser?.close();
  states?.remove();
});

const canvas = ".point canvas";
const click = ({ number }, on = page) => on.locator(`.curve .mark[data-number="${number}"]`).click({ force: true });
const chosen = async (on = page) => (await on.locator(".point h3").textContent()).match(/^state (\d+):/)[1];
const select = (name, value, on = page) => on.locator(`select[name=${name}]`).selectOption(value);
const choose_mode = (name, on = page) => on.locator(`.modes tr[data-mode="${name}"]`).click();
const path = (name) => rows.filter((row) => row.path === name);
const eigenvalues = (row) => [row.eigenvalue_1, row.eigenvalue_2];

test("there are two paths, the second of which leaves the first", () => {
  assert.deepEqual([...new Set(rows.map((row) => row.path))], ["1", "2"]);
  assert.equal(rows.find((row) => row.number === path("2")[0].from).point, "branching");
});

// States lie close together: what is next to the pointer is what is meant.
test("the numbers of every state are those of states.csv, digit by digit", async () => {
  await select("parameter", "number");
  for (const row of rows) {
    await click(row);
    assert.equal(await page.locator(".point h3").textContent(), `state ${row.number}: ${row.model} ${row.branch}, V_r = ${row.reduced_volume}, L = ${row.L}`);
    assert.deepEqual(await numbers_in(page, ".numbers-of"), row);
    for (const [column, text] of Object.entries(await numbers_in(page, ".point"))) assert.equal(text, row[column]);
    const shown = await page.$$eval(".modes tr[data-mode]", (lines) => lines.slice(1).map((line) => line.lastElementChild.textContent));
    assert.deepEqual(shown, eigenvalues(row));
  }
  await select("parameter", "reduced_volume");
});

test("a state lies in the diagram where its numbers say, for every quantity", async () => {
  for (const quantity of ["energy", "length_1", "pressure"]) {
    await select("quantity", quantity);
    const drawn = await page.$$eval(".curve .mark", (marks) => marks.map((mark) => [mark.dataset.number, ...mark.getAttribute("transform").match(/-?[\d.]+/g).map(Number)]));
    assert.equal(drawn.length, rows.length);
    const of = (number) => rows.find((row) => row.number === number);
    // Both are linear in the numbers: two states give the line on which the others are.
    const [a, b] = [drawn[0], drawn.at(-1)];
    for (const [number, x, y] of drawn)
      for (const [place, from, to, column] of [[x, a[1], b[1], "reduced_volume"], [y, a[2], b[2], quantity]]) {
        const [first, last, value] = [of(a[0]), of(b[0]), of(number)].map((row) => Number(row[column]));
        assert.ok(Math.abs(place - (from + ((to - from) * (value - first)) / (last - first))) < 1e-6, `${column} of ${number}`);
      }
  }
  await select("quantity", "energy");
});

test("minima have solid lines and full marks, saddles have others, and a branching its own", async () => {
  const fills = Object.fromEntries(await page.$$eval(".curve .mark", (marks) => marks.map((mark) => [mark.dataset.number, getComputedStyle(mark).fill])));
  for (const row of rows)
    if (row.point !== "branching") assert.equal(fills[row.number] === "rgb(255, 255, 255)", row.negative_directions !== "0", row.number);
  const falls = rows.filter((row) => row.negative_directions !== "0").length;
  assert.ok(falls > 2 && falls < rows.length - 1);
  const lines = await page.$$eval(".curve path:not(.mark)", (pieces) => pieces.map((piece) => piece.getAttribute("class")));
  assert.equal(lines.length, rows.length - 1); // every state ends one but the first, that of path 2 begins on path 1
  // A branching is of neither side: the line that ends there is of the state before it.
  const minima_of_path_1 = path("1").filter((row) => row.point !== "branching" && row.negative_directions === "0").length;
  assert.equal(lines.filter((name) => name === "minima").length, minima_of_path_1);
  assert.match(await page.locator(".explore-states .classes").allTextContents().then((texts) => texts.join(" ")), /minima.*saddles.*others leave/);
});

// The states as the data of the page have them: points of the nodes, corners of the plain triangles, and their areas, each at its nodes.
function surfaces_of(parts) {
  const fields = table_of(parts["fields.csv"].toString()), [mesh] = table_of(parts["meshes.csv"].toString());
  const nodes = Number(mesh.nodes), size = fields.length * nodes;
  const numbers = numbers_of(parts["frames/0"], 2), corners = numbers_of(parts["mesh/0"], 4);
  assert.equal(numbers.length, rows.length * size);
  for (let i = size; i < numbers.length; ++i) numbers[i] = (numbers[i] + numbers[i - size]) % 65536;
  return rows.map((_, k) => {
    const points = Array.from({ length: nodes }, (__, node) =>
      [0, 1, 2].map((f) => Number(fields[f].low) + ((fields[f].high - fields[f].low) * numbers[k * size + f * nodes + node]) / 65534),
    );
    const areas = new Float64Array(nodes);
    let volume = 0;
    for (let t = 0; t < corners.length; t += 3) {
      const triangle = corners.slice(t, t + 3), [a, b, c] = triangle.map((corner) => points[corner]);
      const cross = (u, v) => [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
      const less = (u, v) => u.map((x, i) => x - v[i]);
      for (const corner of triangle) areas[corner] += Math.hypot(...cross(less(b, a), less(c, a))) / 6;
      volume += a.reduce((sum, x, i) => sum + x * cross(b, c)[i], 0) / 6;
    }
    return { areas, volume };
  });
}
// 1620 triangles have edges h ≈ 0.13; on curvatures up to 3 they are short by (3h)²/24 = 0.7 % in each direction.
const shortness = 0.007;

test("a click shows the shape of the state, which has its area and volume", async () => {
  const parts = parts_of(states.read("report.html"));
  assert.deepEqual(table_of(parts["shown.csv"].toString()).map(({ number }) => number), rows.map(({ number }) => number));
  surfaces_of(parts).forEach(({ areas, volume }, k) => {
    assert.ok(Math.abs(areas.reduce((a, b) => a + b) / rows[k].area - 1) < 2 * shortness);
    assert.ok(Math.abs(volume / rows[k].volume - 1) < 4 * shortness);
  });
  const pictures = new Set();
  for (const row of [path("1")[0], path("1").at(-1), path("2").at(-1)]) {
    await click(row);
    assert.equal(await chosen(), row.number);
    pictures.add(await picture_of(page, canvas));
  }
  assert.equal(pictures.size, 3);
  for (const picture of pictures) assert.ok((await colours_in(page, picture)) > 100);
});

test("every eigenpair has its shape, which keeps the volume and is orthogonal to the other", () => {
  const parts = parts_of(states.read("report.html")), surfaces = surfaces_of(parts);
  const shapes = table_of(parts["mode_shapes.csv"].toString()), numbers = numbers_of(parts.mode_shapes, 2);
  assert.deepEqual(shapes.map(({ key }) => key), rows.flatMap(({ number }) => [`${number}/1`, `${number}/2`]));
  for (let i = 1; i < numbers.length; ++i) numbers[i] = (numbers[i] + numbers[i - 1]) % 65536;
  let from = 0;
  const displacements = shapes.map(({ nodes, u_low, u_high }) => {
    const u = numbers.slice(from, from + Number(nodes)).map((n) => Number(u_low) + ((u_high - u_low) * n) / 65534);
    from += 2 * nodes; // the order changes, too
    return u;
  });
  surfaces.forEach(({ areas }, k) => {
    const [one, other] = displacements.slice(2 * k, 2 * k + 2);
    const integral = (of) => areas.reduce((sum, area, i) => sum + area * of(i), 0);
    for (const u of [one, other]) {
      assert.ok(Math.abs(Math.max(...u.map(Math.abs)) - 1) < 1e-4); // so it is scaled
      assert.ok(Math.abs(integral((i) => u[i])) < 2 * shortness * integral((i) => Math.abs(u[i])), `volume of ${k}`);
    }
    assert.ok(Math.abs(integral((i) => one[i] * other[i])) < 2 * shortness * integral((i) => Math.abs(one[i] * other[i])), `product of ${k}`);
  });
});

test("normals of a sphere of plain triangles point outwards", () => {
  const positions = Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1, -1, 0, 0, 0, -1, 0, 0, 0, -1);
  const triangles = Uint32Array.of(0, 1, 2, 1, 3, 2, 3, 4, 2, 4, 0, 2, 1, 0, 5, 3, 1, 5, 4, 3, 5, 0, 4, 5);
  assert.deepEqual([...normals_of({ positions, triangles })].map((x) => Math.round(1e6 * x) / 1e6 + 0), [...positions]);
});

test("an eigenpair displaces the surface by as much as is said, and it swings", async () => {
  await click(path("2").at(-1));
  await choose_mode("1"); // and back: so the shape is seen from where it is below
  await choose_mode("rest");
  const at_rest = await picture_of(page, canvas);
  assert.equal(await page.locator("input[type=range]").isVisible(), false);
  const pictures = new Set();
  for (const mode of ["1", "2"]) {
    await choose_mode(mode);
    for (const amplitude of ["0.2", "-0.2"]) {
      await page.locator("input[type=range]").fill(amplitude);
      pictures.add(await picture_of(page, canvas));
    }
  }
  assert.equal(pictures.size, 4);
  assert.match(await page.locator(".point .colours").textContent(), /displacement/);
  await select("field", "order");
  assert.match(await page.locator(".point .colours").textContent(), /order β/);
  await page.locator("button", { hasText: "Swing" }).click();
  const first = await page.locator(".time").textContent();
  await page.waitForFunction((text) => document.querySelector(".time").textContent !== text, first);
  await page.locator("button", { hasText: "Stop" }).click();
  assert.equal(await page.locator(".time").textContent(), "amplitude -0.20");
  await click(path("2").at(-2)); // along the path the same eigenpair is shown
  assert.ok(await page.locator('tr[data-mode="2"] input').isChecked());
  await click(path("2").at(-1));
  await choose_mode("rest");
  assert.equal(await page.locator("select[name=field]").inputValue(), "H"); // as before: the order is uniform
  assert.equal(await picture_of(page, canvas), at_rest);
});

test("the pointer over a state tells its numbers", async () => {
  const row = path("2").at(-1);
  await page.locator(`.mark[data-number="${row.number}"]`).hover({ force: true });
  const told = await page.locator(".tip").textContent();
  for (const text of [`V_r = ${row.reduced_volume}`, `energy = ${row.energy}`, `class = ${row.class}`, "negative_directions = 1"])
    assert.ok(told.includes(text), told);
  await page.mouse.move(2, 2);
  assert.equal(await page.locator(".tip").isVisible(), false);
});

test("all can be done by keys and by buttons", async () => {
  const [first, second] = path("1"), branching = rows.find((row) => row.point === "branching");
  await click(first);
  await page.locator("select[name=parameter]").focus();
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement.getAttribute("aria-roledescription")), "diagram");
  await page.keyboard.press("ArrowLeft"); // the path goes down in V_r
  assert.equal(await chosen(), second.number);
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight"); // there is none beyond
  assert.equal(await chosen(), first.number);
  await page.keyboard.press("ArrowUp");
  assert.equal(rows.find((row) => row.number === "1").path, "1");
  assert.equal(await chosen(), path("2")[0].number); // what lies next on the other path
  await page.keyboard.press("ArrowDown");
  assert.equal(rows[(await chosen()) - 1].path, "1");
  await page.keyboard.press("Enter");
  assert.equal(await page.evaluate(() => document.activeElement.tagName), "CANVAS");
  const before_turning = await picture_of(page, canvas);
  await page.keyboard.press("ArrowUp");
  assert.notEqual(await picture_of(page, canvas), before_turning);
  await page.keyboard.press("Home");
  assert.equal(await picture_of(page, canvas), before_turning);
  await click(path("2").at(-1));
  await page.locator(".near button", { hasText: "where it leaves" }).click();
  assert.equal(await chosen(), branching.number);
  await page.locator(".near button", { hasText: "path 2 leaves" }).click();
  assert.equal(await chosen(), path("2")[0].number);
  await page.locator(".near button", { hasText: "next" }).click();
  assert.equal(await chosen(), path("2")[1].number);
});

test("in physical units its numbers are those of the converted table", async () => {
  const { file, table } = states.in_units(vesicle);
  const there = await browser.open_live(file), row = table("states.csv")[path("2").at(-1).number - 1];
  await click(row, there);
  const shown = await numbers_in(there, ".numbers-of");
  assert.deepEqual(Object.values(shown), Object.values(row).slice(0, Object.keys(rows[0]).length));
  assert.match(await there.locator(".said").textContent(), new RegExp(`energy = ${row.energy_kT} kT`));
  assert.match(await there.locator(".modes th").last().textContent(), /eigenvalue \(kT\)/);
  assert.equal(await there.locator(".modes tr[data-mode='1'] td").last().textContent(), row.eigenvalue_1_kT);
  assert.match(await there.locator(".point .colours").textContent(), /mean curvature H \(1\/µm\)/);
  assert.deepEqual(there.faults, []);
});

test("a phone shows it without scrolling sideways, a browser without WebGL draws it", async () => {
  const plain = await Browser.start("--disable-3d-apis");
  const narrow = await plain.open_live(states.file, 380);
  assert.equal(await narrow.evaluate(() => document.documentElement.scrollWidth), 380);
  assert.equal(await narrow.locator(".surface").getAttribute("data-painter"), "canvas");
  const first = await picture_of(narrow, canvas);
  assert.ok((await colours_in(narrow, first)) > 100);
  await click(path("2").at(-1), narrow);
  assert.notEqual(await picture_of(narrow, canvas), first);
  assert.equal(await narrow.evaluate(() => document.documentElement.scrollWidth), 380);
  await plain.close();
});

test("what lacks its frame has its numbers, and a mode that lacks its file cannot be chosen", async () => {
  const [some, other] = path("1");
  const frame = `${states.folder}/frames/state_${some.number.padStart(4, "0")}.vtu`, mode = `${states.folder}/modes/state_${other.number.padStart(4, "0")}_mode_2.vtu`;
  const kept = [frame, mode].map((file) => [file, readFileSync(file)]), whole = states.read("report.html");
  rmSync(frame);
  rmSync(mode);
  states.report();
  const lacking = await browser.open_live(states.file);
  await click(some, lacking);
  assert.match(await lacking.locator(".point .note").textContent(), /its shape is not in this page/);
  assert.equal(await lacking.locator(canvas).isVisible(), false);
  assert.deepEqual(await numbers_in(lacking, ".numbers-of"), some);
  await click(other, lacking);
  assert.equal(await lacking.locator(canvas).isVisible(), true);
  assert.ok(await lacking.locator('tr[data-mode="2"] input').isDisabled());
  assert.deepEqual(lacking.faults, []);
  await lacking.close();
  for (const [file, bytes] of kept) writeFileSync(file, bytes);
  states.written("report.html", whole);
});

test("a frame that is cut short is told with its name, and so is one that is none", () => {
  const file = `${states.folder}/frames/state_0001.vtu`, whole = readFileSync(file), report = states.read("report.html");
  writeFileSync(file, whole.subarray(0, whole.length / 2));
  assert.throws(() => states.report(), /state_0001\.vtu/);
  writeFileSync(file, readFileSync(`${states.folder}/modes/state_0001_mode_1.vtu`));
  assert.throws(() => states.report(), /state_0001\.vtu: is no frame of a state/);
  writeFileSync(file, whole);
  assert.equal(states.read("report.html"), report);
});

test("states that are not followed are points without lines", async () => {
  const grid = reported("states", `[states]
model = "SSH"
branch = "oblate"
reduced_volume = [0.75, 0.8]
L = 0.05
triangles = 180
eigenpairs = 0
`);
  const points = await browser.open_live(grid.file);
  assert.equal(await points.locator(".curve .mark").count(), 2);
  assert.equal(await points.locator(".curve path:not(.mark)").count(), 0);
  const [, last] = grid.table("states.csv");
  await click(last, points);
  assert.deepEqual(await numbers_in(points, ".numbers-of"), last);
  assert.ok((await colours_in(points, await picture_of(points, canvas))) > 100);
  assert.deepEqual(points.faults, []);
  grid.remove();
});

test("a branch in a number of the material is drawn over that", async () => {
  const follow = reported("states", `[states]
model = "SSH"
branch = "oblate"
reduced_volume = 0.8
L = 0.05
triangles = 180
eigenpairs = 0
[follow]
parameter = "H0"
to = -0.2
switch = false
`);
  const { file, table } = follow.in_units(vesicle), [first, second] = table("states.csv");
  const physical = await browser.open_live(file);
  assert.equal(await physical.locator("select[name=parameter]").inputValue(), "H0");
  assert.match(await physical.locator(".branches text.title").first().textContent(), /spontaneous curvature H0 \(1\/µm\)/);
  await click(second, physical);
  assert.match(await physical.locator(".point h3").textContent(), new RegExp(`L = 0.05, H0 = ${second.H0_per_um} 1/µm$`));
  const [a, b] = await Promise.all([first, second].map(({ number }) => physical.locator(`.mark[data-number="${number}"]`).getAttribute("transform")));
  assert.ok(Number(b.match(/-?[\d.]+/)[0]) < Number(a.match(/-?[\d.]+/)[0])); // it goes to lower values
  assert.deepEqual(physical.faults, []);
  follow.remove();
});

test("a file that was cut off or damaged says so; nothing is asked of a network, and no error is left", async () => {
  const text = states.read("report.html"), at = text.indexOf('id="sbeh-data"') + 3000;
  const cut = await browser.open(states.written("cut.html", text.slice(0, at)));
  assert.ok(await comes_to_be_told(cut));
  const damaged = await browser.open(states.written("damaged.html", text.slice(0, at) + (text[at] === "A" ? "B" : "A") + text.slice(at + 1)));
  await damaged.waitForSelector("#explore[data-state=failed]");
  assert.match(await damaged.locator("#explore [role=alert]").textContent(), /cannot be explored here/);
  assert.deepEqual(page.requests.filter((url) => !/^(file|data|blob):/.test(url)), []);
  assert.deepEqual(page.faults, []);
});
