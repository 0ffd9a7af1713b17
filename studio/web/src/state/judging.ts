// SPDX-License-Identifier: GPL-3.0-or-later
// Verdicts while something is dragged: at most one question is on its way, and the next asks for the newest poses.
import { signal } from "@preact/signals";
import type { MessageInitShape } from "@bufbuild/protobuf";
import type { Finding } from "../gen/flair/v1/layout_metrics_pb";
import type { PlacementSchema } from "../gen/flair/v1/placement_pb";
import type { EdgeOutcome } from "../gen/flair/v1/solved_layout_pb";
import type { Poses } from "./pieces";

export type Placements = Array<MessageInitShape<typeof PlacementSchema>>;

export interface Verdict {
  readonly outcomes: ReadonlyMap<string, EdgeOutcome>;
  readonly findings: readonly Finding[];
  // The objects that were asked about, and where they would stand.
  readonly poses: Poses;
}

interface Answer {
  readonly edgeOutcomes: readonly EdgeOutcome[];
  readonly findings: readonly Finding[];
}

export class Judging {
  readonly verdict = signal<Verdict | undefined>(undefined);
  private waiting: Placements | undefined;
  private asking = false;
  // Counts gestures, so that an answer to the last one says nothing about the next.
  private gesture = 0;

  constructor(private readonly call: (placements: Placements) => Promise<Answer>) {}

  ask(placements: Placements): void {
    this.waiting = placements;
    if (!this.asking) void this.run();
  }

  end(): void {
    this.gesture += 1;
    this.waiting = undefined;
    this.verdict.value = undefined;
  }

  private async run(): Promise<void> {
    this.asking = true;
    while (this.waiting) {
      const placements = this.waiting, gesture = this.gesture;
      this.waiting = undefined;
      try {
        const { edgeOutcomes, findings } = await this.call(placements);
        if (gesture !== this.gesture) continue;
        this.verdict.value = {
          outcomes: new Map(edgeOutcomes.map((one) => [one.edgeId, one])),
          findings, poses: new Map(placements.map(({ objectId = "", xM = 0, yM = 0, thetaRad = 0 }) =>
            [objectId, { x: xM, y: yM, theta: thetaRad }])),
        };
      } catch {
        // A verdict that does not come is none; the act that follows will say what is the matter.
      }
    }
    this.asking = false;
  }
}
