// SPDX-License-Identifier: GPL-3.0-or-later
import { useState } from "preact/hooks";
import { capital } from "../inspector/words";
import { useDrawing } from "./context";
import roomTypes from "./room_types.json";

const kAnother = "another";

function focused(input: HTMLInputElement | null): void {
  input?.focus();
  input?.select();
}

// A kind from the list, or one's own word for it.
export function RoomType() {
  const drawing = useDrawing(), { roomType } = drawing.sketch.value;
  const [isTyping, setTyping] = useState(false);
  const known = roomTypes as readonly string[];
  const take = (kind: string) => {
    setTyping(false);
    const typed = kind.trim().toLowerCase().slice(0, 60);
    if (typed && typed !== roomType)
      drawing.commit({ ...drawing.sketch.peek(), roomType: typed }, "change the kind of room");
  };
  if (isTyping) {
    return (
      <label class="field">
        <span>Kind of room</span>
        <input defaultValue={roomType} maxLength={60} ref={focused}
          onBlur={(event) => take(event.currentTarget.value)}
          onKeyDown={(event) => {
            event.stopPropagation();
            if (event.key === "Escape") event.currentTarget.value = roomType;
            if (event.key === "Enter" || event.key === "Escape") event.currentTarget.blur();
          }} />
      </label>
    );
  }
  return (
    <label class="field">
      <span>Kind of room</span>
      <select value={roomType} onKeyDown={(event) => event.stopPropagation()}
        onChange={(event) => (event.currentTarget.value === kAnother ? setTyping(true) : take(event.currentTarget.value))}>
        {[...new Set([roomType, ...known])].map((kind) => <option key={kind} value={kind}>{capital(kind)}</option>)}
        <option value={kAnother}>Another...</option>
      </select>
    </label>
  );
}
