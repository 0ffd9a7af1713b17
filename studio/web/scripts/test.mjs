// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: every src/**/*.test.ts, bundled and run by node's own test runner.
import { build } from "esbuild";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { generate } from "./generate.mjs";

const root = resolve(dirname(fileURLToPath(import.meta.url)), "..");

function filesBelow(folder, ending) {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const path = join(folder, entry.name);
    if (entry.isDirectory()) return filesBelow(path, ending);
    return entry.name.endsWith(ending) ? [path] : [];
  });
}

generate();
const out = mkdtempSync(join(tmpdir(), "flair-studio-test-"));
try {
  await build({
    absWorkingDir: root,
    entryPoints: filesBelow(join(root, "src"), ".test.ts"),
    bundle: true,
    format: "esm",
    platform: "node",
    outdir: out,
    outExtension: { ".js": ".mjs" },
    entryNames: "[dir]/[name]",
    jsx: "automatic",
    jsxImportSource: "preact",
    logLevel: "warning",
    sourcemap: "inline",
  });
  const run = spawnSync(process.execPath, ["--enable-source-maps", "--test", ...filesBelow(out, ".mjs")],
    { stdio: "inherit" });
  process.exitCode = run.status ?? 1;
} finally {
  rmSync(out, { recursive: true, force: true });
}
