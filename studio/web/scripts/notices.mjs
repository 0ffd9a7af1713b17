// SPDX-License-Identifier: GPL-3.0-or-later
// THIRD_PARTY_NOTICES: the licences of the packages of which a line is in the bundle.
import { readFileSync, readdirSync } from "node:fs";
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

// For packages that name their licence without shipping its words: a package here that ships them.
const bearers = { "Apache-2.0": "typescript", "MIT": "preact" };

// Licences of single files that a package has from others, in their first comments.
const filesOfOthers = { "@bufbuild/protobuf": ["dist/esm/wire/varint.js"] };

function wordsOf(root, name, licence) {
  const folder = join(root, "node_modules", name);
  const own = licenceText(folder);
  const known = Object.keys(bearers).filter((one) => licence.includes(one));
  if (!own && known.length === 0) throw new Error(`${name}: the words of its licence, ${licence}, are nowhere`);
  const texts = own ? [own] : known.map((one) => licenceText(join(root, "node_modules", bearers[one])));
  const heads = (filesOfOthers[name] ?? []).map((file) => {
    const lines = readFileSync(join(folder, file), "utf8").split("\n").filter((line) => line.startsWith("//"));
    return `${file}:\n\n${lines.map((line) => line.replace(/^\/\/ ?/, "")).join("\n")}`;
  });
  return [...texts, ...heads].join("\n\n");
}

export function notices(root, names) {
  const blocks = names.map((name) => {
    const { version, license } = JSON.parse(readFileSync(join(root, "node_modules", name, "package.json"), "utf8"));
    return `${name} ${version}: ${license}\n\n${wordsOf(root, name, license)}\n`;
  });
  return `The studio's page holds code of these packages.\n\n${blocks.join(`\n${"-".repeat(78)}\n\n`)}`;
}
