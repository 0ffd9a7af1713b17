// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import { test } from "node:test";
import { create } from "@bufbuild/protobuf";
import { GetClusterResponseSchema, WorkerState } from "../gen/flair/v1/orchestrator_service_pb";
import { ReportSchema } from "../gen/flair/v1/report_pb";
import { workersOf } from "./cluster";
import { anyMeasures, measuresOf, passes } from "./measures";
import { Rates } from "./rates";
import { lastingText } from "./words";

test("shares of what was asked come from the report", () => {
  const report = create(ReportSchema, {
    metrics: { reachableFloorShare: 0.9, useCount: 4, metUseCount: 3 },
    constraints: { satisfiedCount: 8, violatedCount: 2 },
  });
  assert.deepEqual(measuresOf(report), { held: 0.8, uses: 0.75, floor: 0.9 });
  assert.ok(passes(measuresOf(report), { ...anyMeasures, held: 0.8 }));
  assert.ok(!passes(measuresOf(report), { ...anyMeasures, uses: 0.8 }));
  assert.ok(passes(undefined, anyMeasures));
  assert.ok(!passes({}, { ...anyMeasures, floor: 0.5 }), "what is not measured does not pass");
});

test("a worker is as bad as the worst that an orchestrator says of it", () => {
  const worker = (state: WorkerState, callCount: bigint, nanos: number) => ({
    stage: "optimizer",
    address: "a:1",
    state,
    callCount,
    callDuration: { seconds: 0n, nanos },
  });
  const cluster = create(GetClusterResponseSchema, {
    orchestrators: [
      { id: "1", workers: [worker(WorkerState.READY, 1n, 100_000_000), { stage: "language", address: "b:1" }] },
      { id: "2", workers: [worker(WorkerState.BROKEN, 3n, 500_000_000)] },
    ],
  });
  const [language, optimizer] = workersOf(cluster);
  assert.equal(language!.stage, "language");
  assert.equal(optimizer!.state, WorkerState.BROKEN);
  assert.equal(optimizer!.calls, 4);
  assert.ok(Math.abs(optimizer!.latency - 0.4) < 1e-9);
});

test("rates need two looks, and forget a counter that was set back", () => {
  const rates = new Rates();
  assert.equal(rates.see("a", 0, 10), undefined);
  assert.equal(rates.see("a", 2000, 14), 2);
  assert.equal(rates.see("a", 4000, 1), undefined);
});

test("durations read as people say them", () => {
  assert.deepEqual([0.042, 3.21, 65, 7400].map(lastingText), ["42 ms", "3.2 s", "1 m 05 s", "2 h 03 m"]);
});
