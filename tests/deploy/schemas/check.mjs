// SPDX-License-Identifier: GPL-3.0-or-later
// Holds Kubernetes objects against the schemas of their kinds. Usage: node check.mjs FILE.yaml CHECKED.ts
// Ends with 1 when values are wrong; CHECKED.ts holds the objects typed, whose compilation finds fields that no kind has.
import { readFileSync, writeFileSync } from 'node:fs';
import { loadAll } from 'js-yaml';

const [input, output] = process.argv.slice(2);
const others = { 'keda.sh': '@kubernetes-models/keda/', 'monitoring.coreos.com': '@kubernetes-models/prometheus-operator/' };

function moduleOf(apiVersion) {
  const group = apiVersion.includes('/') ? apiVersion.split('/')[0] : '';
  return (others[group] ?? 'kubernetes-models/') + apiVersion;
}

const objects = loadAll(readFileSync(input, 'utf8'));
let typed = '';
let faults = 0;
for (const [index, object] of objects.entries()) {
  const name = `${object.kind} ${object.metadata?.name}`;
  const Kind = (await import(moduleOf(object.apiVersion)))[object.kind];
  try {
    new Kind(object).validate();
  } catch (error) {
    ++faults;
    console.log(`${name}: ${error.message}`);
  }
  typed += `import type { I${object.kind} as T${index} } from '${moduleOf(object.apiVersion)}';\n`;
  typed += `export const o${index}: T${index} = ${JSON.stringify(object, null, 1)};\n`;
}
writeFileSync(output, typed);
console.log(`${objects.length} objects, ${faults} wrong`);
process.exitCode = faults > 0 ? 1 : 0;
