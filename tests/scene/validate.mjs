// SPDX-License-Identifier: GPL-3.0-or-later
// What the Khronos glTF validator says of GLB files, all of it: one line an issue, one line a file. Ends with 1 unless
// every file is free of errors and warnings. Usage, where gltf-validator is installed: node validate.mjs FILE.glb...
import fs from 'node:fs';
import validator from 'gltf-validator';

const severities = ['error', 'warning', 'info', 'hint'];
const sum = {error: 0, warning: 0, info: 0, hint: 0};
for (const file of process.argv.slice(2)) {
  const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {maxIssues: 0});
  for (const issue of report.issues.messages) {
    const severity = severities[issue.severity];
    ++sum[severity];
    console.log(`${file}: ${severity}: ${issue.code} ${issue.pointer ?? ''}: ${issue.message}`);
  }
  console.log(`${file}: ${report.info.totalTriangleCount} triangles, ${report.info.drawCallCount} draw calls`);
}
console.log(`${sum.error} errors, ${sum.warning} warnings, ${sum.info} infos, ${sum.hint} hints`);
process.exitCode = sum.error + sum.warning === 0 && process.argv.length > 2 ? 0 : 1;
