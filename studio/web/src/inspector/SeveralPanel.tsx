// SPDX-License-Identifier: GPL-3.0-or-later
import type { OpenRoom } from "../state/open_room";
import type { Piece } from "../state/pieces";
import { Faults } from "./Faults";
import { PieceActs } from "./PieceActs";
import { PieceRows } from "./PieceRows";

export function SeveralPanel({ room, pieces }: { room: OpenRoom; pieces: readonly Piece[] }) {
  return (
    <>
      <header class="panel-head">
        <h2>{pieces.length} pieces</h2>
        <PieceActs room={room} pieces={pieces} />
      </header>
      <PieceRows room={room} pieces={pieces} />
      <Faults room={room} of={pieces} title="What is wrong with them" />
    </>
  );
}
