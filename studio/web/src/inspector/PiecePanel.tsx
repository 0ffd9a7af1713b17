// SPDX-License-Identifier: GPL-3.0-or-later
import { PanelHead } from "../app/PanelHead";
import { renamePiece } from "../state/commands";
import { faultsOf } from "../state/faults";
import type { OpenRoom } from "../state/open_room";
import { nameOf, type Piece } from "../state/pieces";
import { objectIn, type Demand } from "./note";
import { Faults } from "./Faults";
import { useKept } from "./kept";
import { PieceActs } from "./PieceActs";
import { PieceFields } from "./PieceFields";
import { SentenceRow } from "./Sentence";
import { capital, withStop } from "./words";

const order = { missed: 0, "not understood": 1, dropped: 2, holds: 3 };

function sorted(demands: readonly Demand[]): Demand[] {
  return [...demands].sort((a, b) => order[a.fate] - order[b.fate]);
}

const keyOf = (demand: Demand): string => demand.sentence_id ?? `${demand.about_it} ${demand.sentence}`;

// The heading, which is a field: another name makes it another piece of the same size.
function PieceName({ room, piece }: { room: OpenRoom; piece: Piece }) {
  const name = nameOf(piece.object);
  const take = (input: HTMLInputElement) => {
    const typed = input.value.trim().toLowerCase().slice(0, 80);
    if (!typed || typed === name) input.value = capital(name);
    else void renamePiece(room, piece, typed);
  };
  return (
    <h2 class="piece-name">
      <input key={name} defaultValue={capital(name)} aria-label="Name" spellcheck={false} maxLength={80}
        onBlur={(event) => take(event.currentTarget)} onKeyDown={(event) => {
          event.stopPropagation();
          if (event.key === "Escape") event.currentTarget.value = capital(name);
          if (event.key === "Enter" || event.key === "Escape") event.currentTarget.blur();
        }} />
    </h2>
  );
}

export function PiecePanel({ room, piece }: { room: OpenRoom; piece: Piece }) {
  const about = objectIn(room.explanation.value?.note, piece.id);
  const told = new Set(faultsOf(room).map((one) => room.spoken(one.message).replace(/\.$/, "")));
  const demands = useKept(sorted(about?.demands ?? []), keyOf, () => true);
  return (
    <>
      <PanelHead label="Back to the room" title="Back to the room (Esc)" onClose={() => room.select([])}>
        <PieceName room={room} piece={piece} />
      </PanelHead>
      <PieceActs room={room} pieces={[piece]} />
      <PieceFields room={room} piece={piece} />
      {about?.stands && <p class="stands">{withStop(capital(about.stands))} {about.origin}</p>}
      <Faults room={room} of={[piece]} />
      <h3 class="eyebrow">Wishes for it</h3>
      {demands.length === 0 && <p class="hint">Nothing is asked of it. Say a sentence below.</p>}
      <ul class="sentences">
        {demands.map((demand) => (
          <SentenceRow key={keyOf(demand)} room={room} demand={demand} objectId={piece.id} />
        ))}
      </ul>
      {about?.followers && about.followers.length > 0 && (
        <p class="hint followers">Placed relative to it: {about.followers.join(", ")}.</p>
      )}
      {about?.remarks
        ?.filter((remark) => !told.has(remark.replace(/\.$/, "")))
        .map((remark) => (
          <p key={remark} class="hint">
            {withStop(remark)}
          </p>
        ))}
    </>
  );
}
