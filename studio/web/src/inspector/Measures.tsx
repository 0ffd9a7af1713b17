// SPDX-License-Identifier: GPL-3.0-or-later
import type { LayoutMetrics } from "../gen/flair/v1/layout_metrics_pb";
import type { Note } from "./note";

interface Measure {
  readonly label: string;
  readonly value: string;
  readonly share: number;
}

const percent = (share: number) => `${Math.round(share * 100)} %`;

function measuresOf(note: Note, metrics: LayoutMetrics | undefined): Measure[] {
  const count = note.demand_count;
  const asked = count ? (count.holds ?? 0) + (count.missed ?? 0) : 0;
  const uses = note.uses;
  return [
    uses?.asked
      ? { label: "Uses met", value: `${uses.met ?? 0} of ${uses.asked}`, share: (uses.met ?? 0) / uses.asked }
      : undefined,
    asked > 0
      ? { label: "Wishes met", value: `${count!.holds ?? 0} of ${asked}`, share: (count!.holds ?? 0) / asked }
      : undefined,
    metrics
      ? { label: "Floor reached", value: percent(metrics.reachableFloorShare), share: metrics.reachableFloorShare }
      : undefined,
    metrics
      ? { label: "Fronts reached", value: percent(metrics.reachableFrontShare), share: metrics.reachableFrontShare }
      : undefined,
  ].filter((one) => one !== undefined);
}

export function Measures({ note, metrics }: { note: Note; metrics: LayoutMetrics | undefined }) {
  const measures = measuresOf(note, metrics);
  if (measures.length === 0) return null;
  return (
    <dl class="measures">
      {measures.map(({ label, value, share }) => (
        <div key={label} class={share > 0.999 ? "measure is-full" : "measure"}>
          <dt>{label}</dt>
          <dd>{value}</dd>
          <svg viewBox="0 0 100 3" preserveAspectRatio="none" aria-hidden="true">
            <rect width="100" height="3" rx="1.5" class="measure-ground" />
            <rect width={Math.max(share, 0.01) * 100} height="3" rx="1.5" class="measure-bar" />
          </svg>
        </div>
      ))}
    </dl>
  );
}
