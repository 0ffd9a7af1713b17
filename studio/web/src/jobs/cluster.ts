// SPDX-License-Identifier: GPL-3.0-or-later
// Workers as all orchestrators see them: the worst that one says of it, the sum of their calls and of the time.
import { WorkerState, type GetClusterResponse } from "../gen/flair/v1/orchestrator_service_pb";
import { seconds } from "./words";

export interface SeenWorker {
  readonly stage: string;
  readonly address: string;
  readonly state: WorkerState;
  readonly busy: number;
  readonly calls: number;
  readonly failures: number;
  // Mean of a call, seconds.
  readonly latency: number;
}

const order = ["language", "translator", "optimizer", "renderer"];
const trouble = [WorkerState.UNSPECIFIED, WorkerState.READY, WorkerState.GONE, WorkerState.BROKEN];
const worst = (a: WorkerState, b: WorkerState) => (trouble.indexOf(a) >= trouble.indexOf(b) ? a : b);

export function workersOf({ orchestrators }: GetClusterResponse): SeenWorker[] {
  const seen = new Map<string, SeenWorker>();
  for (const one of orchestrators.flatMap(({ workers }) => workers)) {
    const key = `${one.stage} ${one.address}`,
      calls = Number(one.callCount),
      before = seen.get(key);
    const total = (before?.calls ?? 0) + calls;
    const time = (before ? before.latency * before.calls : 0) + seconds(one.callDuration) * calls;
    seen.set(key, {
      stage: one.stage,
      address: one.address,
      state: worst(one.state, before?.state ?? WorkerState.UNSPECIFIED),
      busy: (before?.busy ?? 0) + one.inFlightCount,
      calls: total,
      failures: (before?.failures ?? 0) + Number(one.failureCount),
      latency: total > 0 ? time / total : 0,
    });
  }
  const rank = ({ stage, state }: SeenWorker) =>
    [order.indexOf(stage) < 0 ? order.length : order.indexOf(stage), -trouble.indexOf(state)] as const;
  return [...seen.values()].sort((a, b) => rank(a)[0] - rank(b)[0] || rank(a)[1] - rank(b)[1]);
}
