// SPDX-License-Identifier: GPL-3.0-or-later
import { useEffect, useState } from "preact/hooks";
import { Icon } from "../app/Icon";
import { say } from "../state/commands";
import type { OpenRoom } from "../state/open_room";
import { theName, type Piece } from "../state/pieces";
import { capital } from "./words";

// Adds what one sentence asks for; the server says when it does not understand.
export function SayField({ room, about }: { room: OpenRoom; about: Piece | undefined }) {
  const [text, setText] = useState("");
  const [isSent, setSent] = useState(false);
  const [remark, setRemark] = useState("");
  // What was said of one piece is no answer about the next.
  useEffect(() => setRemark(""), [about?.id]);
  const label = about ? `Say something about ${theName(about.object)}` : "Say something about the room";
  const send = async () => {
    if (!text.trim() || isSent) return;
    setSent(true);
    setRemark("");
    const answer = await say(room, text.trim(), (told) =>
      setRemark((before) => [before, told].filter(Boolean).join(" ")),
    );
    setSent(false);
    if (!answer) return;
    setText("");
    // Keys are for the plan again: what was said can be undone.
    (document.activeElement as HTMLElement | null)?.blur();
  };
  return (
    <form class="say" onSubmit={(event) => { event.preventDefault(); void send(); }}>
      {remark && <p class="say-remark" role="alert">{remark}</p>}
      <div class="say-line">
        <input value={text} maxLength={400} aria-label={label} aria-busy={isSent}
          placeholder={about ? `${capital(theName(about.object))} faces the window` : "The armchair faces the window"}
          onInput={(event) => { setText(event.currentTarget.value); setRemark(""); }}
          onKeyDown={(event) => { if (event.key === "Escape") event.currentTarget.blur(); }} />
        <button class="icon-button" type="submit" aria-label="Add the sentence" title="Add the sentence (Enter)"
          disabled={!text.trim() || isSent}><Icon name="chat" /></button>
      </div>
    </form>
  );
}
