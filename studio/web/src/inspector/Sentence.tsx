// SPDX-License-Identifier: GPL-3.0-or-later
// One demand: its verdict, its reason, whose wish it is, and what one can do about it.
import { useState } from "preact/hooks";
import { Icon } from "../app/Icon";
import { SentenceOrigin } from "../gen/flair/v1/constraint_list_pb";
import { OutcomeStatus } from "../gen/flair/v1/solved_layout_pb";
import { say, weigh } from "../state/commands";
import type { OpenRoom } from "../state/open_room";
import { useStudio } from "../state/studio";
import type { Demand, Fate } from "./note";
import { Weight } from "./Weight";
import { capital, missedText, withStop } from "./words";

const origins: Record<SentenceOrigin, string> = {
  [SentenceOrigin.BRIEF]: "you asked for it", [SentenceOrigin.IMPLIED]: "follows from its use",
  [SentenceOrigin.UNSPECIFIED]: "the designer's wish",
};

const fateWords: Record<Fate, string> = {
  holds: "Holds", missed: "Does not hold", dropped: "Dropped", "not understood": "Not understood",
};

// The fate as things stand, or as they would while something is dragged.
function liveFate(room: OpenRoom, demand: Demand): { fate: Fate; shortfall: string; isLive: boolean } {
  const outcomes = room.judging.verdict.value?.outcomes;
  const asked = demand.edge_ids?.flatMap((id) => outcomes?.get(id) ?? []) ?? [];
  if (asked.length === 0 || demand.fate === "dropped")
    return { fate: demand.fate, shortfall: demand.shortfall ?? "", isLive: false };
  const missed = asked.find((one) => one.status === OutcomeStatus.VIOLATED);
  return { fate: missed ? "missed" : "holds", shortfall: missed?.reason ?? "", isLive: true };
}

export function SentenceRow({ room, demand, objectId }: { room: OpenRoom; demand: Demand; objectId?: string }) {
  const [isOpen, setOpen] = useState(false);
  const { units } = useStudio().settings;
  const { fate, shortfall, isLive } = liveFate(room, demand);
  const text = room.spoken(demand.about_it || demand.sentence || "").replace(/\.$/, "");
  const sentences = room.layout.value?.graph?.constraintList?.sentences;
  const origin = sentences?.find((one) => one.id === demand.sentence_id)?.origin ?? SentenceOrigin.UNSPECIFIED;
  // What is dropped has no constraint left; saying it again makes one.
  const isGone = fate === "dropped" || fate === "not understood";
  const point = () => {
    const own = objectId ? [objectId] : [];
    room.pointedAt.value = { ...demand, other_object_ids: [...own, ...(demand.other_object_ids ?? [])] };
  };
  const unpoint = () => { room.pointedAt.value = undefined; };
  const isNew = fate === "missed" && room.effect.value?.lost.some((one) => one.sentenceId === demand.sentence_id);
  const mark = fate === "holds" ? "check" : fate === "missed" ? "cross" : "dash";
  const missed = fate === "missed" ? (isLive ? room.spoken(shortfall) : shortfall || missedText(demand, units.value)) : shortfall;
  return (
    <li
      class={`sentence is-${fate.replace(" ", "-")} ${isLive ? "is-live" : ""}`}
      onPointerEnter={point}
      onPointerLeave={unpoint}
    >
      <button
        class="sentence-line"
        aria-expanded={isOpen}
        onClick={() => setOpen(!isOpen)}
        onFocus={point}
        onBlur={unpoint}
      >
        <span class="sentence-mark" role="img" aria-label={fateWords[fate]}>
          <Icon name={mark} size={14} />
        </span>
        <span class="sentence-text">{text}</span>
      </button>
      {(missed || isNew) && (
        <p class="sentence-missed">{[missed, isNew && "since the last change"].filter(Boolean).join(", ")}</p>
      )}
      {fate === "missed" && !isLive && demand.because && (
        <p class="sentence-because">{withStop(capital(demand.because))}</p>
      )}
      {isOpen && (
        <div class="sentence-more">
          {demand.reason && <p class="sentence-reason">{demand.reason}</p>}
          <p class="sentence-origin">{origins[origin]}</p>
          {demand.sentence_id && (
            <div class="sentence-acts">
              {!isGone && <Weight room={room} demand={demand} text={text} />}
              {isGone ? (
                <button class="link-button" onClick={() => void say(room, demand.sentence || text)}>
                  Ask for it again
                </button>
              ) : (
                <button class="link-button" onClick={() => void weigh(room, demand.sentence_id!, 0)}>
                  Drop
                </button>
              )}
            </div>
          )}
        </div>
      )}
    </li>
  );
}
