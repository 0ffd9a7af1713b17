// SPDX-License-Identifier: GPL-3.0-or-later
// The room as a whole: what was not done of the brief, what is wrong, how well it can be used, what stands in it.
import { useState } from "preact/hooks";
import { areaText } from "../app/units";
import { area } from "../geometry/polygon";
import type { OpenRoom } from "../state/open_room";
import { goTo } from "../state/route";
import { isWorking } from "../state/jobs";
import { useStudio } from "../state/studio";
import { OtherLayouts } from "../variants/Searching";
import { Faults } from "./Faults";
import { Furnish, FurnishAgain } from "./Furnish";
import { Measures } from "./Measures";
import { PieceList } from "./PieceList";
import { Wishes } from "./Wishes";
import { capital, withStop } from "./words";

function Lines({ title, lines }: { title: string; lines: readonly string[] | undefined }) {
  if (!lines || lines.length === 0) return null;
  return (
    <section>
      <h3 class="eyebrow">{title}</h3>
      <ul class="lines">{lines.map((line) => <li key={line}>{withStop(capital(line))}</li>)}</ul>
    </section>
  );
}

// What one can do with the whole room.
function RoomActs({ room }: { room: OpenRoom }) {
  const [isAsking, setAsking] = useState(false);
  const isEmpty = room.pieces.value.size === 0;
  return (
    <>
      <div class="room-acts">
        <button class="button" title="Change walls, doors and windows"
          onClick={() => goTo({ page: "draw", id: room.id })}>
          Edit room
        </button>
        {!isEmpty && <OtherLayouts room={room} />}
        {!isEmpty && (
          <button
            class="button"
            aria-expanded={isAsking}
            disabled={isWorking(room.document.value)}
            title="Change what was asked for, and furnish these walls anew"
            onClick={() => setAsking(!isAsking)}
          >
            Furnish again
          </button>
        )}
      </div>
      {isEmpty && <Furnish room={room} />}
      {!isEmpty && isAsking && <FurnishAgain room={room} close={() => setAsking(false)} />}
    </>
  );
}

// What the room was made for: words of its user, no description of what stands in it now.
function Asked({ room }: { room: OpenRoom }) {
  const text = room.document.value.brief?.text;
  return text ? <p class="hint asked">Asked: “{text}”</p> : null;
}

export function RoomPanel({ room }: { room: OpenRoom }) {
  const { units } = useStudio().settings;
  const explanation = room.explanation.value, note = explanation?.note ?? {};
  const layout = room.layout.value, shape = layout?.graph?.room;
  return (
    <>
      <header class="panel-head">
        <h2>{capital(shape?.roomType || "room")}</h2>
        <span class="hint">{areaText(area(room.floor.value), units.value)}</span>
      </header>
      <RoomActs room={room} />
      {note.room && <p class="stands is-room">{note.room}</p>}
      <Asked room={room} />
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
      <Faults room={room} title="What is wrong" />
      {room.pieces.value.size > 0 && <Measures room={room} note={note} metrics={layout?.metrics} />}
      <Wishes room={room} note={note} />
      <Lines title="Wishes that contradict each other" lines={note.clashes} />
      <PieceList room={room} note={note} />
      <Lines title="Left out of the room" lines={note.left_out} />
      <Lines title="Remarks" lines={note.remarks} />
    </>
  );
}
