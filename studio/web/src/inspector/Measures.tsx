// SPDX-License-Identifier: GPL-3.0-or-later
import { FindingKind, type LayoutMetrics } from "../gen/flair/v1/layout_metrics_pb";
import { findingsOf } from "../state/faults";
import type { OpenRoom } from "../state/open_room";
import type { Note } from "./note";
import { countOf } from "./wish_list";
import { capital, measureWords, percent, withStop } from "./words";

interface Measure {
  readonly words: (typeof measureWords)[keyof typeof measureWords];
  readonly value: string;
  readonly share: number;
}

const counted = (words: Measure["words"], met: number, asked: number): Measure[] =>
  asked > 0 ? [{ words, value: `${met} of ${asked}`, share: met / asked }] : [];

function measuresOf(note: Note, metrics: LayoutMetrics | undefined): Measure[] {
  const { held, asked } = countOf(note), { uses } = note;
  const shares = (metrics: LayoutMetrics): Measure[] => [
    { words: measureWords.floor, value: percent(metrics.reachableFloorShare), share: metrics.reachableFloorShare },
  ];
  return [
    ...counted(measureWords.wishes, held, asked),
    ...counted(measureWords.uses, uses?.met ?? 0, uses?.asked ?? 0),
    ...(metrics ? shares(metrics) : []),
  ];
}

// The everyday acts for which there is no room, by a click on how many there are.
function Unmet({ room }: { room: OpenRoom }) {
  const unmet = findingsOf(room).filter(({ kind }) => kind === FindingKind.USE_NOT_MET);
  if (unmet.length === 0) return null;
  return (
    <details class="unmet">
      <summary>{`What daily use lacks (${unmet.length})`}</summary>
      <ul class="lines">
        {unmet.map(({ objectId, partnerId, message }) => (
          <li key={`${objectId} ${message}`}>
            <button onClick={() => room.select([objectId, partnerId].filter((id) => room.pieces.value.has(id)))}>
              {withStop(capital(room.spoken(message)))}
            </button>
          </li>
        ))}
      </ul>
    </details>
  );
}

export function Measures({ room, note, metrics }: { room: OpenRoom; note: Note; metrics: LayoutMetrics | undefined }) {
  const measures = measuresOf(note, metrics);
  if (measures.length === 0) return null;
  return (
    <>
      <dl class="measures">
        {measures.map(({ words: { label, title }, value, share }) => (
          <div key={label} class={share > 0.999 ? "measure is-full" : "measure"} title={title}>
            <dt>{label}</dt>
            <dd>{value}</dd>
            <svg viewBox="0 0 100 3" preserveAspectRatio="none" aria-hidden="true">
              <rect width="100" height="3" rx="1.5" class="measure-ground" />
              <rect width={Math.max(share, 0.01) * 100} height="3" rx="1.5" class="measure-bar" />
            </svg>
          </div>
        ))}
      </dl>
      <Unmet room={room} />
    </>
  );
}
