// SPDX-License-Identifier: GPL-3.0-or-later
// What a language model has cost in the stages of a job that have ended.
import { useEffect, useState } from "preact/hooks";
import type { Clients } from "../api/clients";
import type { JobEvent } from "../gen/flair/v1/job_pb";
import { JobEventKind } from "../gen/flair/v1/job_pb";
import type { ModelCall } from "../gen/flair/v1/model_call_pb";

export interface Spent {
  readonly calls: number;
  readonly tokens: number;
  readonly usd: number;
}

export const kNothingSpent: Spent = { calls: 0, tokens: 0, usd: 0 };

export function plus(sum: Spent, calls: readonly ModelCall[]): Spent {
  return calls.reduce<Spent>(({ calls: count, tokens, usd }, { usage }) => ({
    calls: count + (usage?.callCount ?? 0),
    tokens: tokens + Number((usage?.inputTokenCount ?? 0n) + (usage?.outputTokenCount ?? 0n)),
    usd: usd + (usage?.costUsd ?? 0),
  }), sum);
}

// "14 calls, 12,400 tokens, $0.02".
export function spentInWords({ calls, tokens, usd }: Spent): string {
  const cost = usd > 0 ? `, $${usd.toFixed(usd < 0.1 ? 3 : 2)}` : "";
  return `${calls} ${calls === 1 ? "call" : "calls"}, ${tokens.toLocaleString("en")} tokens${cost}`;
}

// Grows as stages end; of stages that were known before nothing is spent, nor where no model designs.
export function useSpent(clients: Clients, events: readonly JobEvent[]): Spent {
  const [isAsked, setAsked] = useState(false);
  const [byArtifact, setByArtifact] = useState<ReadonlyMap<string, Spent>>(new Map());
  useEffect(() => {
    clients.studio.getModel({}).then(
      ({ model, canChoose }) => setAsked(!canChoose || Boolean(model?.baseUrl)),
      () => {},
    );
  }, []);
  useEffect(() => {
    if (!isAsked) return;
    for (const { kind, artifact } of events) {
      const id = artifact?.id;
      if (kind !== JobEventKind.STAGE_FINISHED || !id || byArtifact.has(id)) continue;
      setByArtifact((known) => new Map(known).set(id, kNothingSpent));
      clients.orchestrator.getArtifact({ artifactId: id }).then(
        ({ artifact: whole }) =>
          setByArtifact((known) => new Map(known).set(id, plus(kNothingSpent, whole?.modelCalls ?? []))),
        () => {},
      );
    }
  }, [events, isAsked]);
  return [...byArtifact.values()].reduce((sum, one) =>
    ({ calls: sum.calls + one.calls, tokens: sum.tokens + one.tokens, usd: sum.usd + one.usd }), kNothingSpent);
}
