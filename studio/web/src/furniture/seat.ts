// SPDX-License-Identifier: GPL-3.0-or-later
// What one sits or stands at comes with an offer of its seat.
import { toRoom } from "../geometry/footprint";
import { distance, vec, wrapped } from "../geometry/vec";
import { addPiece } from "../state/commands";
import type { OpenRoom } from "../state/open_room";
import { theName } from "../state/pieces";
import type { Studio } from "../state/studio";
import { offerNamed } from "./usual";

const seats: Readonly<Record<string, string>> = { piano: "piano bench", bar_counter: "bar stool" };
const kUsualSeat = "office chair";
// The front of a seat is below the top, as far as this.
const kBelow = 0.15;
const kTaken = 0.6;

// Of the piece that was added last, which is selected.
export async function offerSeat(studio: Studio, room: OpenRoom): Promise<void> {
  const [id] = room.selection.peek(), piece = room.pieces.peek().get(id ?? "");
  if (!piece?.object.satAt) return;
  const offer = await offerNamed(studio, seats[piece.object.category] ?? kUsualSeat), seat = offer?.object;
  if (!seat) return;
  const placeBefore = () => {
    const { pose, size } = room.pieces.peek().get(piece.id) ?? piece;
    const at = toRoom(pose, vec(0, (size.depth + seat.depthM) / 2 - kBelow));
    return { ...at, theta: wrapped(pose.theta + Math.PI) };
  };
  const isTaken = [...room.pieces.peek().values()].some((one) =>
    one.object.seat && distance(one.pose, placeBefore()) < kTaken);
  if (isTaken) return;
  const name = /^[aeiou]/.test(seat.name) ? `an ${seat.name}` : `a ${seat.name}`;
  room.tell(`Nobody can sit at ${theName(piece.object)} yet.`,
    [{ label: `Add ${name}`, run: () => void addPiece(room, seat, placeBefore()) }]);
}
