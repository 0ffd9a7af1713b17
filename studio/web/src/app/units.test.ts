// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { lengthText, parseLength } from "./units";

const cases: Array<[string, "m" | "ft", number | undefined]> = [
  ["0.9", "m", 0.9],
  [".9", "m", 0.9],
  ["0,9", "m", 0.9],
  ["90 cm", "m", 0.9],
  ["900mm", "ft", 0.9],
  ["1 m 20 cm", "m", 1.2],
  ["3", "ft", 0.9144],
  ["3'", "m", 0.9144],
  ["3' 2\"", "m", 0.9652],
  ["3′ 2″", "ft", 0.9652],
  ["3'2", "ft", 0.9652],
  ["3 ft 2 in", "m", 0.9652],
  ["2″", "m", 0.0508],
  ["-0.1", "m", -0.1],
  ["", "m", undefined],
  ["wide", "m", undefined],
  ["3 ells", "m", undefined],
  ["1 2", "m", undefined],
];

for (const [text, units, metres] of cases) {
  test(`"${text}" in ${units} is ${metres}`, () => {
    const parsed = parseLength(text, units);
    if (metres === undefined) assert.equal(parsed, undefined);
    else assert.ok(parsed !== undefined && Math.abs(parsed - metres) < 1e-9, String(parsed));
  });
}

test("lengths are written in either unit", () => {
  assert.equal(lengthText(1.5, "m"), "1.50 m");
  assert.equal(lengthText(0.9652, "ft"), "3′ 2″");
  assert.equal(lengthText(0.9144, "ft"), "3′");
  assert.equal(lengthText(0.6, "ft"), "2′");
});
