// SPDX-License-Identifier: GPL-3.0-or-later
// The room as a whole: what was not done of the brief, what is wrong, how well it can be used, what stands in it.
import { areaText } from "../app/units";
import { area } from "../geometry/polygon";
import type { OpenRoom } from "../state/open_room";
import { goTo } from "../state/route";
import { useStudio } from "../state/studio";
import { faultsOf } from "../plan/overlay/Findings";
import type { Demand, Note } from "./note";
import { Furnish } from "./Furnish";
import { Measures } from "./Measures";
import { PieceList } from "./PieceList";
import { SentenceRow } from "./Sentence";
import { capital, withStop } from "./words";

function missedOf(note: Note): Array<{ demand: Demand; objectId: string }> {
  const seen = new Set<string>();
  return (note.zones ?? []).flatMap((zone) => zone.objects ?? []).flatMap((object) =>
    (object.demands ?? []).filter(({ fate, sentence_id: id }) => {
      if (fate !== "missed" || (id && seen.has(id))) return false;
      if (id) seen.add(id);
      return true;
    }).map((demand) => ({ demand, objectId: object.id })));
}

function Lines({ title, lines }: { title: string; lines: readonly string[] | undefined }) {
  if (!lines || lines.length === 0) return null;
  return (
    <section>
      <h3 class="eyebrow">{title}</h3>
      <ul class="lines">{lines.map((line) => <li key={line}>{withStop(capital(line))}</li>)}</ul>
    </section>
  );
}

export function RoomPanel({ room }: { room: OpenRoom }) {
  const { units } = useStudio().settings;
  const explanation = room.explanation.value, note = explanation?.note ?? {};
  const layout = room.layout.value, shape = layout?.graph?.room;
  const findings = faultsOf(room);
  const missed = missedOf(note);
  return (
    <>
      <header class="panel-head">
        <h2>{capital(shape?.roomType || "room")}</h2>
        <span class="hint">{areaText(area(room.floor.value), units.value)}</span>
        <button
          class="link-button room-edit"
          title="Change walls, doors and windows"
          onClick={() => goTo({ page: "draw", id: room.id })}
        >
          Edit room
        </button>
      </header>
      {note.room && <p class="stands">{note.room}</p>}
      {explanation && explanation.notAsAsked.length > 0 && (
        <section>
          <h3 class="eyebrow">Not as asked</h3>
          <ul class="notices">
            {explanation.notAsAsked.map((line) => (
              <li key={line} class="notice is-warning">
                {withStop(capital(line))}
              </li>
            ))}
          </ul>
        </section>
      )}
      {findings.length > 0 && (
        <section>
          <h3 class="eyebrow">What is wrong</h3>
          <ul class="notices">
            {findings.map((one) => (
              <li key={`${one.objectId} ${one.message}`} class="notice is-bad">
                <button onClick={() => room.select([one.objectId])}>{withStop(capital(one.message))}</button>
              </li>
            ))}
          </ul>
        </section>
      )}
      {room.pieces.value.size === 0 ? <Furnish room={room} /> : <Measures note={note} metrics={layout?.metrics} />}
      {missed.length > 0 && (
        <section>
          <h3 class="eyebrow">Wishes that do not hold</h3>
          <ul class="sentences">
            {missed.map(({ demand, objectId }, i) => (
              <SentenceRow key={demand.sentence_id ?? i} room={room} demand={demand} objectId={objectId} />
            ))}
          </ul>
        </section>
      )}
      <Lines title="Cannot hold together" lines={note.clashes} />
      <PieceList room={room} note={note} />
      <Lines title="Left out" lines={note.left_out} />
      <Lines title="Remarks" lines={note.remarks} />
    </>
  );
}
