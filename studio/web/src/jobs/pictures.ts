// SPDX-License-Identifier: GPL-3.0-or-later
// Plans and measures of jobs, fetched when they come into view, a few at a time; the newest are kept.
import { signal, type Signal } from "@preact/signals";
import type { Clients } from "../api/clients";
import { ArtifactKind } from "../gen/flair/v1/artifact_pb";
import type { Job } from "../gen/flair/v1/job_pb";
import { PreviewFormat, PreviewView } from "../gen/flair/v1/preview_pb";
import { factsOf, type Facts } from "./facts";
import { measuresOf, type Measures } from "./measures";

const kMediaTypes: Partial<Record<PreviewFormat, string>> = {
  [PreviewFormat.PNG]: "image/png",
  [PreviewFormat.JPEG]: "image/jpeg",
  [PreviewFormat.SVG]: "image/svg+xml",
};
const kAtOnce = 2;
const kKept = 300;

export class JobPictures {
  private readonly plans = new Map<string, Signal<string | undefined>>();
  private readonly measured = new Map<string, Signal<Measures | undefined>>();
  private readonly facts = new Map<string, Signal<Facts | undefined>>();
  private readonly waiting: Array<() => Promise<void>> = [];
  private running = 0;

  constructor(private readonly clients: Clients) {}

  // The address of the job's plan; empty when there is none that a browser shows, undefined until it is known.
  planOf(job: Job): Signal<string | undefined> {
    return this.once(this.plans, job, ArtifactKind.PREVIEW, "", async (id) => {
      const { artifact } = await this.clients.orchestrator.getArtifact({ artifactId: id });
      const content = artifact?.content;
      if (content?.case !== "preview" || content.value.view !== PreviewView.PLAN) return "";
      const type = kMediaTypes[content.value.format];
      return type ? URL.createObjectURL(new Blob([content.value.image as BlobPart], { type })) : "";
    });
  }

  measuresOf(job: Job): Signal<Measures | undefined> {
    return this.once(this.measured, job, ArtifactKind.REPORT, {}, async (id) => {
      const { artifact } = await this.clients.orchestrator.getArtifact({ artifactId: id });
      return artifact?.content.case === "report" ? measuresOf(artifact.content.value) : {};
    });
  }

  // What came of it; undefined until it is known, and when its layout is not there any more.
  factsOf(job: Job): Signal<Facts | undefined> {
    return this.once(this.facts, job, ArtifactKind.SOLVED_LAYOUT, undefined, async (id) => {
      const { artifact } = await this.clients.orchestrator.getArtifact({ artifactId: id });
      return artifact?.content.case === "solvedLayout" ? factsOf(artifact.content.value) : undefined;
    });
  }

  forgetAll(): void {
    this.waiting.length = 0;
    for (const plan of this.plans.values()) if (plan.peek()) URL.revokeObjectURL(plan.peek()!);
    this.plans.clear();
  }

  private once<T>(
    known: Map<string, Signal<T | undefined>>,
    job: Job,
    kind: ArtifactKind,
    none: T | undefined,
    get: (id: string) => Promise<T | undefined>,
  ) {
    const before = known.get(job.id);
    if (before) return before;
    const ref = job.artifacts.find((one) => one.kind === kind);
    const value = signal<T | undefined>(ref ? undefined : none);
    if (!ref) return value;
    known.set(job.id, value);
    this.waiting.push(async () => {
      try {
        value.value = await get(ref.id);
      } catch {
        value.value = none;
      }
    });
    this.prune();
    void this.run();
    return value;
  }

  private prune(): void {
    for (const [id, plan] of this.plans) {
      if (this.plans.size <= kKept) return;
      if (plan.peek()) URL.revokeObjectURL(plan.peek()!);
      this.plans.delete(id);
    }
  }

  private async run(): Promise<void> {
    if (this.running >= kAtOnce) return;
    this.running += 1;
    for (let next = this.waiting.shift(); next; next = this.waiting.shift()) await next();
    this.running -= 1;
  }
}
