// SPDX-License-Identifier: GPL-3.0-or-later
import { useEffect, useState } from "preact/hooks";
import { Icon } from "../app/Icon";
import { say, undo } from "../state/commands";
import type { OpenRoom } from "../state/open_room";
import { isSolid, theName, type Piece } from "../state/pieces";
import { ObjectKind } from "../gen/flair/v1/object_list_pb";
import { capital, withStop } from "./words";

// A sentence about what is there.
function exampleFor(room: OpenRoom, about: Piece | undefined): string {
  const pieces = [...room.pieces.value.values()];
  const piece = about ?? pieces.find((one) => isSolid(one) && one.object.seat) ?? pieces.find(isSolid);
  if (!piece) return "The room has an armchair";
  const name = capital(theName(piece.object));
  // After every act another kind of wish.
  const asked = [`Move ${theName(piece.object)} 20 cm to the left`, `Make ${theName(piece.object)} bigger`,
    `Remove ${theName(piece.object)}`, ""][Number(room.document.value.revision % 4n)];
  if (asked) return asked;
  const { kind, walkOver } = piece.object;
  if (walkOver) return `${name} is in the middle of the room`;
  if (kind === ObjectKind.FLOOR) return piece.object.seat ? `${name} faces the window` : `${name} is against the north wall`;
  const host = room.pieces.value.get(piece.object.hostId);
  if (kind === ObjectKind.SURFACE && host) return `${name} is on ${theName(host.object)}`;
  return kind === ObjectKind.WALL ? `${name} hangs on the north wall` : `${name} is in the middle of the room`;
}

// Does what is typed, and shows what the server answers; what was not understood stays in the field.
export function SayField({ room, about }: { room: OpenRoom; about: Piece | undefined }) {
  const [text, setText] = useState("");
  const [isSent, setSent] = useState(false);
  const [remark, setRemark] = useState("");
  const [done, setDone] = useState("");
  // What was said of one piece is no answer about the next.
  useEffect(() => { setRemark(""); setDone(""); }, [about?.id]);
  const label = about ? `Say something about ${theName(about.object)}` : "Say something about the room";
  const send = async () => {
    if (!text.trim() || isSent) return;
    setSent(true);
    setRemark("");
    setDone("");
    let isTold = false;
    const answer = await say(room, text.trim(), (told) => {
      isTold = true;
      setRemark((before) => [before, withStop(capital(told))].filter(Boolean).join(" "));
    });
    setSent(false);
    if (!answer) return;
    // Every sentence is answered.
    const note = isTold ? "" : answer.diagnostics[0]?.message ?? "Done.";
    setDone(room.spoken(answer.answer || note));
    // What was not done stays for mending. The focus stays, too: letters that are typed next are a sentence, not keys of
    // the plan.
    setText(answer.leftOver);
  };
  return (
    <form class="say" onSubmit={(event) => { event.preventDefault(); void send(); }}>
      {done && <p class="say-done" role="status">{done}</p>}
      {remark && <p class="say-remark" role="alert">{remark}</p>}
      <div class="say-line">
        <input value={text} maxLength={400} aria-label={label} aria-busy={isSent}
          placeholder={exampleFor(room, about)}
          onInput={(event) => { setText(event.currentTarget.value); setRemark(""); setDone(""); }}
          onKeyDown={(event) => {
            if (event.key === "Escape") event.currentTarget.blur();
            // With nothing left to take back here, it is the last act that is meant.
            if (text || !(event.ctrlKey || event.metaKey) || event.shiftKey || event.key.toLowerCase() !== "z") return;
            event.preventDefault();
            if (room.document.peek().undoLabel) void undo(room);
          }} />
        <button class="icon-button" type="submit" aria-label="Add the sentence" title="Add the sentence (Enter)"
          disabled={!text.trim() || isSent}><Icon name="chat" /></button>
      </div>
    </form>
  );
}
