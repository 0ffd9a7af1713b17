// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { Judging, type Placements } from "./judging";

function judgeByHand() {
  const asked: Placements[] = [];
  const answers: Array<() => void> = [];
  const judging = new Judging((placements) => {
    asked.push(placements);
    return new Promise((done) => answers.push(() => done({ edgeOutcomes: [], findings: [] })));
  });
  const answer = async () => {
    answers.shift()!();
    await new Promise((done) => setImmediate(done));
  };
  return { judging, asked, answer };
}

const at = (x: number): Placements => [{ objectId: "desk", xM: x }];

test("while one question is on its way the newest poses wait", async () => {
  const { judging, asked, answer } = judgeByHand();
  judging.ask(at(1));
  judging.ask(at(2));
  judging.ask(at(3));
  assert.equal(asked.length, 1);
  await answer();
  assert.deepEqual(asked.map((one) => one[0]!.xM), [1, 3]);
  assert.ok(judging.verdict.value?.poses.has("desk"));
});

test("an answer that comes after the gesture says nothing", async () => {
  const { judging, answer } = judgeByHand();
  judging.ask(at(1));
  judging.end();
  await answer();
  assert.equal(judging.verdict.value, undefined);
});

test("the next gesture is asked about although the last answer is missing", async () => {
  const { judging, asked, answer } = judgeByHand();
  judging.ask(at(1));
  judging.end();
  judging.ask(at(2));
  await answer();
  assert.equal(asked.length, 2);
  await answer();
  assert.ok(judging.verdict.value);
});
