// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { create } from "@bufbuild/protobuf";
import { ModelCallSchema } from "../gen/flair/v1/model_call_pb";
import { kNothingSpent, plus, spentInWords } from "./spent";

test("calls of a model add up, and those without usage cost nothing", () => {
  const usage = { callCount: 1, inputTokenCount: 1000n, outputTokenCount: 234n, costUsd: 0.005 };
  const calls = [create(ModelCallSchema, { usage }), create(ModelCallSchema, { usage }), create(ModelCallSchema)];
  assert.deepEqual(plus(kNothingSpent, calls), { calls: 2, tokens: 2468, usd: 0.01 });
});

test("what is spent is told with as many decimals as it needs", () => {
  assert.equal(spentInWords({ calls: 1, tokens: 900, usd: 0 }), "1 call, 900 tokens");
  assert.equal(spentInWords({ calls: 14, tokens: 12400, usd: 0.0214 }), "14 calls, 12,400 tokens, $0.021");
});
