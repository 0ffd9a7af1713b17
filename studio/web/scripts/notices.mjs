// SPDX-License-Identifier: GPL-3.0-or-later
// THIRD_PARTY_NOTICES: the licences of the packages of which a line is in the bundle.
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";

// The packages that esbuild's metafile names, such as "preact" or "@bufbuild/protobuf".
export function bundledPackages(metafile) {
  const names = new Set();
  for (const output of Object.values(metafile.outputs)) {
    for (const [input, { bytesInOutput }] of Object.entries(output.inputs)) {
      const match = /node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(input);
      if (match && bytesInOutput > 0) names.add(match[1]);
    }
  }
  return [...names].sort();
}

function licenceText(folder) {
  const file = readdirSync(folder).find((name) => /^(licen[cs]e|copying)/i.test(name));
  return file ? readFileSync(join(folder, file), "utf8").trim() : "";
}

// Apache's and MIT's words for packages that name their licence without shipping it.
function fallbackText(root, licence) {
  const standIn = { "Apache-2.0": "@bufbuild/buf", "MIT": "preact" }[licence];
  const folder = standIn && join(root, "node_modules", standIn);
  return folder && existsSync(folder) ? licenceText(folder) : "";
}

export function notices(root, names) {
  const blocks = names.map((name) => {
    const folder = join(root, "node_modules", name);
    const about = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
    const text = licenceText(folder) || fallbackText(root, about.license);
    return `${name} ${about.version}: ${about.license}\n\n${text || `Licence: ${about.license}`}\n`;
  });
  return `The studio's page holds code of these packages.\n\n${blocks.join(`\n${"-".repeat(78)}\n\n`)}`;
}
