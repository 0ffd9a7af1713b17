// SPDX-License-Identifier: GPL-3.0-or-later
// Every wish of the room with its mark: those that do not hold first, the others by a click.
import { useState } from "preact/hooks";
import type { OpenRoom } from "../state/open_room";
import { useKept } from "./kept";
import type { Note } from "./note";
import { SentenceRow } from "./Sentence";
import { isMet, keyOf, wishesOf, type Wish } from "./wish_list";

const choices = { missed: "Do not hold", holds: "Hold", all: "All" } as const;
type Choice = keyof typeof choices;

const isOf = (choice: Choice, wish: Wish): boolean => choice === "all" || isMet(wish) === (choice === "holds");

function Rows({ room, wishes, choice }: { room: OpenRoom; wishes: readonly Wish[]; choice: Choice }) {
  // One that comes to hold leaves the missed ones, but not from under the pointer that weighs it.
  const inHand = room.pointedAt.value?.sentence_id;
  const shown = useKept(wishes, keyOf, (wish) => isOf(choice, wish),
    ({ demand }) => inHand !== undefined && demand.sentence_id === inHand);
  if (shown.length === 0) return <p class="hint">{choice === "missed" ? "Every wish holds." : "None."}</p>;
  return (
    <ul class="sentences">
      {shown.map((wish) => (
        <SentenceRow key={keyOf(wish)} room={room} demand={wish.demand} objectId={wish.objectId} />
      ))}
    </ul>
  );
}

export function Wishes({ room, note }: { room: OpenRoom; note: Note }) {
  const [choice, setChoice] = useState<Choice>("missed");
  const wishes = wishesOf(note);
  if (wishes.length === 0) return null;
  return (
    <section>
      <h3 class="eyebrow">Wishes</h3>
      <div class="segmented is-worded wish-choice" role="group" aria-label="Which wishes">
        {(Object.keys(choices) as Choice[]).map((one) => (
          <button key={one} aria-pressed={one === choice} onClick={() => setChoice(one)}>
            {choices[one]} <span class="hint">{wishes.filter((wish) => isOf(one, wish)).length}</span>
          </button>
        ))}
      </div>
      <Rows key={choice} room={room} wishes={wishes} choice={choice} />
    </section>
  );
}
