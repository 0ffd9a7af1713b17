// SPDX-License-Identifier: GPL-3.0-or-later
import { useState } from "preact/hooks";
import { CloseButton } from "../app/PanelHead";
import type { OpenRoom } from "../state/open_room";
import examples from "./furnish_examples.json";

// What such a room might be asked to hold.
function exampleFor(roomType: string): string {
  const known: Readonly<Record<string, string>> = examples;
  return known[roomType.replace(/_/g, " ")] ?? known[""]!;
}

interface BriefProps {
  label: string;
  // What was asked before.
  before?: string;
  example: string;
  button(text: string): string;
  send(text: string): Promise<unknown>;
  close?(): void;
}

function BriefForm({ label, before = "", example, button, send, close }: BriefProps) {
  const [text, setText] = useState(before);
  const [isSent, setSent] = useState(false);
  const submit = async () => {
    if (!text.trim() || isSent) return;
    setSent(true);
    await send(text.trim());
    setSent(false);
  };
  return (
    <form class="furnish" onSubmit={(event) => { event.preventDefault(); void submit(); }}>
      {close && <CloseButton onClose={close} />}
      <label>
        <span class="eyebrow">{label}</span>
        <textarea
          rows={before ? 5 : 3}
          value={text}
          maxLength={4000}
          placeholder={example}
          onInput={(event) => setText(event.currentTarget.value)}
          onKeyDown={(event) => {
            if (event.key === "Escape" && close) return close();
            if (event.key !== "Enter" || event.shiftKey || event.isComposing) return;
            event.preventDefault();
            void submit();
          }} />
      </label>
      <div class="furnish-foot">
        {!text && <button type="button" class="link-button" onClick={() => setText(example)}>Take this example</button>}
        <button class="button is-primary" type="submit" disabled={!text.trim() || isSent}>{button(text.trim())}</button>
      </div>
    </form>
  );
}

const exampleOf = (room: OpenRoom) => exampleFor(room.layout.value?.graph?.room?.roomType ?? "");

// For a room in which nothing stands: a brief furnishes it.
export function Furnish({ room }: { room: OpenRoom }) {
  return (
    <>
      <BriefForm
        label="Furnish it"
        before={room.document.peek().brief?.text}
        example={exampleOf(room)}
        button={() => "Furnish"}
        send={(text) => room.act({ case: "furnish", value: { text } })}
      />
      <p class="hint">Or add pieces one by one: press F.</p>
    </>
  );
}

// The same words again: another seed makes another room of them.
export function furnishAgain(room: OpenRoom, text: string) {
  const before = room.document.peek().brief;
  const seed = before?.text === text ? before.seed + 1n : 0n;
  return room.act({ case: "furnish", value: { text, seed } });
}

// For a room that somebody wants otherwise: the brief is changed, or run again as it is.
export function FurnishAgain({ room, close }: { room: OpenRoom; close(): void }) {
  const before = room.document.value.brief?.text ?? "";
  return (
    <>
      <BriefForm
        key={before}
        label="What shall it hold?"
        before={before}
        example={exampleOf(room)}
        button={(text) => (text === before ? "Furnish otherwise" : "Furnish")}
        send={async (text) => { if (await furnishAgain(room, text)) close(); }}
        close={close}
      />
      <p class="hint">Walls, doors and windows stay; all that stands in the room is replaced. Undo brings it back.</p>
    </>
  );
}
