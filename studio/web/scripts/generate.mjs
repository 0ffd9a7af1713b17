// SPDX-License-Identifier: GPL-3.0-or-later
// Makes src/gen, the typed clients, from protos/flair/v1. Does nothing when they are newer than the protocol.
import { spawnSync } from "node:child_process";
import { existsSync, readdirSync, rmSync, statSync } from "node:fs";
import { delimiter, dirname, join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const root = resolve(dirname(fileURLToPath(import.meta.url)), "..");
const protos = resolve(root, "../../protos");
const generated = join(root, "src/gen/flair/v1");

function newest(folder) {
  return Math.max(...readdirSync(folder).map((name) => statSync(join(folder, name)).mtimeMs));
}

function isFresh() {
  if (!existsSync(generated)) return false;
  const inputs = Math.max(newest(join(protos, "flair/v1")), statSync(join(root, "package-lock.json")).mtimeMs);
  return readdirSync(generated).length > 0 && Math.min(...readdirSync(generated).map(
    (name) => statSync(join(generated, name)).mtimeMs)) > inputs;
}

export function generate() {
  if (isFresh()) return;
  rmSync(join(root, "src/gen"), { recursive: true, force: true });
  const bin = join(root, "node_modules/.bin");
  const run = spawnSync(join(bin, "buf"),
    ["generate", protos, "--template", "buf.gen.yaml", "--path", join(protos, "flair/v1")],
    { cwd: root, stdio: "inherit", env: { ...process.env, PATH: bin + delimiter + process.env.PATH } });
  if (run.status !== 0) throw new Error("buf generate failed");
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) generate();
