// SPDX-License-Identifier: GPL-3.0-or-later
import { useState } from "preact/hooks";
import type { OpenRoom } from "../state/open_room";
import examples from "./furnish_examples.json";

// What such a room might be asked to hold.
function exampleFor(roomType: string): string {
  const known: Readonly<Record<string, string>> = examples;
  return known[roomType.replace(/_/g, " ")] ?? known[""]!;
}

// For a room in which nothing stands: a brief furnishes it.
export function Furnish({ room }: { room: OpenRoom }) {
  const [text, setText] = useState("");
  const example = exampleFor(room.layout.value?.graph?.room?.roomType ?? "");
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
          placeholder={example}
          onInput={(event) => setText(event.currentTarget.value)}
          onKeyDown={(event) => {
            if (event.key !== "Enter" || event.shiftKey || event.isComposing) return;
            event.preventDefault();
            void send();
          }} />
      </label>
      <div class="furnish-foot">
        {!text && <button type="button" class="link-button" onClick={() => setText(example)}>Take this example</button>}
        <button class="button is-primary" type="submit" disabled={!text.trim() || isSent}>Furnish</button>
      </div>
      <p class="hint">Or add pieces one by one: press F.</p>
    </form>
  );
}
