// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the page: node scripts/build.mjs [--out DIR] [--dev]
// --dev takes src/dev/main.tsx, a page whose server is in its memory, and does not compress.
import { build } from "esbuild";
import { mkdirSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { basename, dirname, join, relative, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { generate } from "./generate.mjs";
import { bundledPackages, notices } from "./notices.mjs";

const root = resolve(dirname(fileURLToPath(import.meta.url)), "..");

function option(name) {
  const at = process.argv.indexOf(name);
  return at > 0 ? process.argv[at + 1] : undefined;
}

function writePage(out, metafile, entry) {
  const [script, { cssBundle, imports }] = Object.entries(metafile.outputs)
    .find(([, output]) => output.entryPoint === entry);
  // Chunks that the first script imports at once are fetched beside it.
  const preloads = imports.filter((one) => one.kind === "import-statement")
    .map((one) => `<link rel="modulepreload" href="/assets/${basename(one.path)}">`).join("\n    ");
  const page = readFileSync(join(root, "src/index.html"), "utf8")
    .replace("%SCRIPT%", `/assets/${basename(script)}`)
    .replace("%STYLE%", `/assets/${basename(cssBundle)}`)
    .replace("%PRELOADS%", preloads);
  writeFileSync(join(out, "index.html"), page);
}

function compress(folder) {
  for (const name of readdirSync(folder)) {
    const path = join(folder, name);
    if (statSync(path).isDirectory()) compress(path);
    else if (!name.endsWith(".gz")) writeFileSync(`${path}.gz`, gzipSync(readFileSync(path), { level: 9 }));
  }
}

function report(metafile, out) {
  let total = 0;
  for (const path of Object.keys(metafile.outputs).filter((one) => !one.endsWith(".map"))) {
    const size = gzipSync(readFileSync(resolve(root, path)), { level: 9 }).length;
    total += size;
    console.log(`${relative(out, resolve(root, path)).padEnd(44)} ${(size / 1000).toFixed(1).padStart(7)} kB gzipped`);
  }
  console.log(`${"all".padEnd(44)} ${(total / 1000).toFixed(1).padStart(7)} kB gzipped`);
}

const dev = process.argv.includes("--dev");
const out = resolve(root, option("--out") ?? "../../build/release/studio_web");
const entry = dev ? "src/dev/main.tsx" : "src/main.tsx";

generate();
rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });
const { metafile } = await build({
  absWorkingDir: root,
  entryPoints: [entry],
  bundle: true,
  format: "esm",
  splitting: true,
  minify: !dev,
  sourcemap: dev ? "linked" : false,
  target: ["es2022"],
  jsx: "automatic",
  jsxImportSource: "preact",
  outdir: join(out, "assets"),
  entryNames: "[name]-[hash]",
  chunkNames: "[name]-[hash]",
  assetNames: "[name]-[hash]",
  loader: { ".svg": "file", ".glb": "file", ".txt": "text" },
  legalComments: "none",
  metafile: true,
  logLevel: "warning",
});
writePage(out, metafile, entry);
writeFileSync(join(out, "THIRD_PARTY_NOTICES"), notices(root, bundledPackages(metafile)));
writeFileSync(join(out, "favicon.svg"), readFileSync(join(root, "src/favicon.svg")));
if (!dev) compress(out);
report(metafile, out);
