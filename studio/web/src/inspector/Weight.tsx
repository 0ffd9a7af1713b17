// SPDX-License-Identifier: GPL-3.0-or-later
// How much a wish matters, on a slider. What is in hand stays in hand whatever is answered meanwhile; one act at its release.
import { useEffect, useRef, useState } from "preact/hooks";
import { weigh } from "../state/commands";
import type { OpenRoom } from "../state/open_room";
import type { Demand } from "./note";
import { kLeast, kMost, placeOf, weightAt, weightWords } from "./weights";

export function Weight({ room, demand, text }: { room: OpenRoom; demand: Demand; text: string }) {
  const edge = room.layout.value?.graph?.edges.find((one) => one.id === demand.edge_ids?.[0]);
  const stored = edge?.weight || 1;
  // Where it is dragged to; undefined once the room says so itself.
  const [place, setPlace] = useState<number>();
  const slider = useRef<HTMLInputElement>(null);
  const isKeyDown = useRef(false), drags = useRef(0);
  const weight = place === undefined ? stored : weightAt(place);
  const release = async () => {
    if (place === undefined) return;
    const drag = drags.current;
    if (weightAt(place) !== Number(stored.toPrecision(2))) await weigh(room, demand.sentence_id!, weightAt(place));
    if (drag === drags.current) setPlace(undefined);
  };
  const releaseKey = () => {
    isKeyDown.current = false;
    void release();
  };
  // "change" comes at the release; Preact's onChange is called for every step.
  useEffect(() => {
    const changed = () => { if (!isKeyDown.current) void release(); };
    const input = slider.current!;
    input.addEventListener("change", changed);
    return () => input.removeEventListener("change", changed);
  });
  return (
    <label class="weight" title="How much this wish matters beside the others">
      <span>Matters</span>
      <input ref={slider} type="range" min={kLeast} max={kMost} step="0.05" value={place ?? placeOf(stored)}
        aria-label={`How much it matters: ${text}`} aria-valuetext={`${weightWords(weight)}, ${weight.toPrecision(2)}`}
        onInput={(event) => {
          drags.current += 1;
          setPlace(Number(event.currentTarget.value));
        }}
        onKeyDown={() => { isKeyDown.current = true; }} onKeyUp={releaseKey} onBlur={releaseKey} />
      <output title={`Weight ${Number(weight.toPrecision(2))}`}>{weightWords(weight)}</output>
    </label>
  );
}
