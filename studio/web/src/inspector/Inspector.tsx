// SPDX-License-Identifier: GPL-3.0-or-later
// What there is to say: of the piece that is selected, of several, or of the room.
import { useRef } from "preact/hooks";
import type { OpenRoom } from "../state/open_room";
import { EffectCard } from "./EffectCard";
import { FurnishCard } from "./FurnishCard";
import { PiecePanel } from "./PiecePanel";
import { RoomPanel } from "./RoomPanel";
import { SayField } from "./SayField";
import { SeveralPanel } from "./SeveralPanel";
import { useStill } from "./still";

export function Inspector({ room }: { room: OpenRoom }) {
  const body = useRef<HTMLDivElement>(null);
  useStill(body);
  const pieces = room.pieces.value;
  const chosen = [...room.selection.value].flatMap((id) => pieces.get(id) ?? []);
  const [only] = chosen;
  return (
    <aside class="inspector" aria-label="Inspector">
      <div class="inspector-body" tabIndex={-1} ref={body}>
        {!only && <RoomPanel room={room} />}
        {only && chosen.length === 1 && <PiecePanel key={only.id} room={room} piece={only} />}
        {chosen.length > 1 && <SeveralPanel room={room} pieces={chosen} />}
      </div>
      <FurnishCard room={room} />
      <EffectCard room={room} />
      {/* In an empty room the brief is asked for above. */}
      {pieces.size > 0 && <SayField room={room} about={chosen.length === 1 ? only : undefined} />}
    </aside>
  );
}
