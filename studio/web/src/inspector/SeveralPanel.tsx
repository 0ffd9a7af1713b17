// SPDX-License-Identifier: GPL-3.0-or-later
import { PanelHead } from "../app/PanelHead";
import type { OpenRoom } from "../state/open_room";
import type { Piece } from "../state/pieces";
import { AlignActs } from "./AlignActs";
import { Faults } from "./Faults";
import { PieceActs } from "./PieceActs";
import { PieceRows } from "./PieceRows";

export function SeveralPanel({ room, pieces }: { room: OpenRoom; pieces: readonly Piece[] }) {
  return (
    <>
      <PanelHead label="Back to the room" title="Back to the room (Esc)" onClose={() => room.select([])}>
        <h2>{pieces.length} pieces</h2>
      </PanelHead>
      <PieceActs room={room} pieces={pieces} />
      <AlignActs room={room} pieces={pieces} />
      <PieceRows room={room} pieces={pieces} />
      <Faults room={room} of={pieces} title="What is wrong with them" />
    </>
  );
}
