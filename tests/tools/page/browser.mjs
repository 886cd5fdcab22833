// What the tests of the pages share: results made by the program, and a browser that looks at their report.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { inflateSync } from "node:zlib";

const { chromium } = createRequire(`${process.env.SBEH_PAGE_FOLDER}/`)("playwright-core");

// A folder with the results of one input and their report.
export function reported(command, input) {
  const folder = mkdtempSync(join(tmpdir(), "sbeh-page-"));
  const results = join(folder, "out");
  writeFileSync(join(folder, "in.toml"), input);
  const sbeh = (...words) => execFileSync(process.env.SBEH_PROGRAM, words, { encoding: "utf8" });
  sbeh(command, join(folder, "in.toml"), "-o", results, "--no-pictures");
  const report = () => sbeh("report", results, "--no-pictures");
  report();
  return {
    report,
    // The page of what other words of the program leave in the folder after "-o".
    made(words) {
      sbeh(...words);
      const other = words[words.indexOf("-o") + 1];
      sbeh("report", other, "--no-pictures");
      return join(other, "report.html");
    },
    // The page of the same results in other units, left beside the first, and a table in these.
    in_units(text) {
      const units = join(folder, "units.toml"), physical = join(folder, "physical");
      writeFileSync(units, text);
      const before = readFileSync(join(results, "report.html"), "utf8");
      sbeh("report", results, "--no-pictures", "--units-from", units);
      const file = join(results, "in_units.html");
      writeFileSync(file, readFileSync(join(results, "report.html")));
      writeFileSync(join(results, "report.html"), before);
      sbeh("units", results, "--units-from", units, "-o", physical);
      return { file, table: (name) => table_of(readFileSync(join(physical, name), "utf8")) };
    },
    folder: results,
    file: join(results, "report.html"),
    read: (name) => readFileSync(join(results, name), "utf8"),
    table: (name) => table_of(readFileSync(join(results, name), "utf8")),
    // Another page, made of this one.
    written(name, text) {
      writeFileSync(join(results, name), text);
      return join(results, name);
    },
    remove: () => rmSync(folder, { recursive: true }),
  };
}

export const vesicle = "[units]\nradius_um = 10\nbending_rigidity_kT = 20\nsurface_viscosity = 5e-10\n";

// Rows of comma separated values by their columns; fields in quotes have no quotes in them.
export function table_of(text) {
  const fields = (line) => [...line.matchAll(/("([^"]*)"|[^,]*)(,|$)/g)].map((m) => m[2] ?? m[1]);
  const [header, ...lines] = text.trimEnd().split("\n");
  const columns = header.split(",");
  return lines.map((line) => Object.fromEntries(columns.map((name, k) => [name, fields(line)[k]])));
}

// The parts of the data, read without the code of the page.
export function parts_of(text) {
  const [, packed] = text.match(/id="sbeh-data">([^<]*)</);
  const bytes = inflateSync(Buffer.from(packed, "base64"));
  const end = bytes.indexOf("\n\n");
  let from = end + 2;
  const parts = {};
  for (const { name, bytes: size } of table_of(bytes.subarray(0, end).toString())) {
    parts[name] = bytes.subarray(from, from + Number(size));
    from += Number(size);
  }
  return parts;
}
export const numbers_of = (bytes, places) => {
  const count = bytes.length / places;
  return Array.from({ length: count }, (_, i) => Array.from({ length: places }, (__, p) => bytes[p * count + i] * 256 ** p).reduce((a, b) => a + b));
};

export class Browser {
  static async start(...more) {
    const browser = new Browser();
    browser.chromium = await chromium.launch({
      executablePath: process.env.SBEH_CHROMIUM,
      args: [
        "--no-sandbox",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-sync",
        "--use-angle=swiftshader",
        "--enable-unsafe-swiftshader",
        ...more,
      ],
    });
    return browser;
  }
  // The page, once it is live or has failed; `page.faults` and `page.requests` grow.
  async open(file, width = 1200) {
    const page = await this.chromium.newPage({ viewport: { width, height: 900 } });
    page.faults = [];
    page.requests = [];
    page.on("pageerror", (error) => page.faults.push(error.message));
    page.on("request", (request) => page.requests.push(request.url()));
    await page.goto(`file://${file}`);
    return page;
  }
  async open_live(file, width) {
    const page = await this.open(file, width);
    await page.waitForSelector("#explore[data-state=live]");
    await drawn(page);
    return page;
  }
  close() {
    return this.chromium.close();
  }
}

// Two frames on, what is drawn when its size is known (at the start, after a resize) has been: before that, what a
// locator finds may be replaced before it is clicked.
export function drawn(page) {
  return page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}
export async function resized(page, width) {
  await page.setViewportSize({ width, height: 900 });
  await drawn(page);
}

// What a canvas shows, as a picture, after it was drawn.
export async function picture_of(page, selector) {
  await drawn(page);
  return (await page.locator(selector).screenshot()).toString("base64");
}

// How many colours there are in a picture of the page.
export function colours_in(page, picture) {
  return page.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [image.width, image.height];
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    const pixels = new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer);
    return new Set(pixels).size;
  }, picture);
}

// The numbers of a table of the page, by their columns.
export function numbers_in(page, selector) {
  return page.$$eval(`${selector} tr[data-column]`, (rows) =>
    Object.fromEntries(rows.map((row) => [row.dataset.column, row.querySelector("td").textContent])),
  );
}

// Whether a page says that it was cut off. It waits two seconds before, for it may be loading.
export async function comes_to_be_told(page) {
  await page.bringToFront(); // time stands still in a page that is not seen
  const told = page.locator(".cut");
  if ((await told.evaluate((place) => getComputedStyle(place).display)) === "none") return false;
  await told.waitFor({ state: "visible" });
  return true;
}
