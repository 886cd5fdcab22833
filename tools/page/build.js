// Bundles src/main.js with its libraries and their licences into one script.  Usage: node build.js FILE
import { build } from "esbuild";
import { mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { dirname } from "node:path";

const file = process.argv[2];
if (!file) throw new Error("usage: node build.js FILE");

const { metafile, outputFiles } = await build({
  entryPoints: ["src/main.js"],
  bundle: true,
  minify: true,
  write: false,
  metafile: true,
  format: "iife",
  charset: "utf8",
  target: "es2022",
  loader: { ".css": "text" },
  legalComments: "none", // the whole texts are put in front
});

const packages = new Set(
  Object.keys(metafile.inputs).flatMap((path) => path.match(/node_modules\/((?:@[^/]+\/)?[^/]+)/)?.[1] ?? []),
);
const licence_of = (name) => {
  const folder = `node_modules/${name}`;
  const { version } = JSON.parse(readFileSync(`${folder}/package.json`, "utf8"));
  const text = readdirSync(folder).find((entry) => /^licen[cs]e/i.test(entry));
  if (!text) throw new Error(`${name} has no licence beside it`);
  return `${name} ${version}\n\n${readFileSync(`${folder}/${text}`, "utf8").trim()}\n`;
};
const licences = [...packages].sort().map(licence_of).join("\n----\n\n").replaceAll("*/", "* /");

mkdirSync(dirname(file), { recursive: true });
writeFileSync(file, `/*! What this page is made with:\n\n${licences}*/\n${outputFiles[0].text}`);
