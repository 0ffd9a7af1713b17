// SPDX-License-Identifier: GPL-3.0-or-later
// "Done": a new document of a drawn room, or a change of the room of one that is there.
import { isConflict, isNothingToDo, sentenceOf } from "../api/problems";
import { length } from "../geometry/vec";
import { capital } from "../inspector/words";
import type { GetDocumentResponse } from "../gen/flair/v1/studio_service_pb";
import { goTo } from "../state/route";
import type { Act } from "../state/open_room";
import type { Studio } from "../state/studio";
import type { Sketch } from "./sketch";
import { roomOf } from "./to_room";

export async function saveNew(studio: Studio, sketch: Sketch): Promise<boolean> {
  const { room } = roomOf(sketch, capital(`my ${sketch.roomType}`.trim()));
  return (await studio.create({ case: "room", value: room })) !== undefined;
}

const kToldOneByOne = 2;

// What the change of walls and openings has made void.
function tellDropped(studio: Studio, messages: readonly string[]): void {
  if (messages.length <= kToldOneByOne) messages.forEach((message) => studio.toasts.note(message));
  else studio.toasts.note(`${messages.length} wishes are dropped: they speak of walls or openings that are gone.`);
}

// What stands in the room stays where it is also when the room's lower left corner, from which all is measured, moves.
export async function saveChanged(studio: Studio, sketch: Sketch, shown: GetDocumentResponse): Promise<boolean> {
  const before = shown.layout!.graph!.room!,
    document = shown.document!;
  const { room, shift } = roomOf(sketch, before.title, before);
  const call = studio.clients.studio;
  try {
    let { revision } = document;
    const act = async (asked: Act) => {
      const answer = await call.act({ documentId: document.id, revision, act: asked });
      revision = answer.document!.revision;
      return answer;
    };
    const placements = shown.layout!.placements.map((one) => ({
      objectId: one.objectId,
      xM: one.xM + shift.x,
      yM: one.yM + shift.y,
      zM: one.zM,
      thetaRad: one.thetaRad,
    }));
    // Before the room changes: what is moved after that would be held when the room is settled.
    if (length(shift) > 1e-6 && placements.length > 0) await act({ case: "move", value: { placements } });
    const changed = await act({ case: "room", value: room });
    tellDropped(
      studio,
      changed.diagnostics.map(({ message }) => message),
    );
    if (studio.settings.autoSettle.peek() === "on" && placements.length > 0) {
      await act({ case: "settle", value: {} }).catch((error: unknown) => {
        if (!isNothingToDo(error)) throw error;
      });
    }
  } catch (error) {
    studio.toasts.error(
      isConflict(error)
        ? "The room was changed in another window meanwhile. Cancel, and edit its newest state."
        : sentenceOf(error),
    );
    return false;
  }
  goTo({ page: "document", id: document.id });
  return true;
}
