// SPDX-License-Identifier: GPL-3.0-or-later
import { useState } from "preact/hooks";
import type { OpenRoom } from "../state/open_room";

// For a room in which nothing stands: a brief furnishes it.
export function Furnish({ room }: { room: OpenRoom }) {
  const [text, setText] = useState("");
  const [isSent, setSent] = useState(false);
  const send = async () => {
    if (!text.trim() || isSent) return;
    setSent(true);
    await room.act({ case: "furnish", value: { text: text.trim() } });
    setSent(false);
  };
  return (
    <form class="furnish" onSubmit={(event) => { event.preventDefault(); void send(); }}>
      <label>
        <span class="eyebrow">Furnish it</span>
        <textarea
          rows={3}
          value={text}
          maxLength={4000}
          placeholder="A living room with a piano and two armchairs by the window"
          onInput={(event) => setText(event.currentTarget.value)}
          onKeyDown={(event) => {
            if (event.key !== "Enter" || event.shiftKey || event.isComposing) return;
            event.preventDefault();
            void send();
          }} />
      </label>
      <div class="furnish-foot">
        <span class="hint">Or add pieces one by one: press F.</span>
        <button class="button is-primary" type="submit" disabled={!text.trim() || isSent}>Furnish</button>
      </div>
    </form>
  );
}
