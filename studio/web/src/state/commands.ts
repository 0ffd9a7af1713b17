// SPDX-License-Identifier: GPL-3.0-or-later
// What one can do to a room; each is one act and one entry of its history.
import type { MessageInitShape } from "@bufbuild/protobuf";
import { moved, type Pose } from "../geometry/footprint";
import type { Resized } from "../geometry/resize";
import { vec } from "../geometry/vec";
import type { LayoutEditSchema } from "../gen/flair/v1/layout_edit_pb";
import { ObjectRole, type Object$, type ObjectSchema } from "../gen/flair/v1/object_list_pb";
import type { OpenRoom } from "./open_room";
import type { Placements } from "./judging";
import { homeFor, orphansInWords, orphansOf, seatsAt, seatsInWords } from "./orphans";
import { guestsOf, placementOf, theName, withGuests, type Piece, type Poses } from "./pieces";
import type { ToastAct } from "./toasts";
import { freeBeside } from "./beside";
import { turnedInside } from "./turning";

type Edit = MessageInitShape<typeof LayoutEditSchema>;

const kCopyOffset = 0.25;

function edit(room: OpenRoom, edits: Edit[], withoutSolving: boolean) {
  return room.act({ case: "edit", value: { edits, withoutSolving } });
}

// Changes pieces; what that affects is solved where the user wants it so ("Auto").
const change = (room: OpenRoom, edits: Edit[]) => edit(room, edits, !room.settlesAlone());

// Puts objects there; alone, or with all that this affects.
export function movePieces(room: OpenRoom, placements: Placements) {
  return room.settlesAlone() ? moveAndSettle(room, placements) : room.act({ case: "move", value: { placements } });
}

// Puts pieces there with all that stands on them.
export function standAt(room: OpenRoom, poses: Poses) {
  const pieces = room.pieces.peek(), all = withGuests(pieces, poses);
  // The server takes along what it knows to stand on them; what was merely put there is named.
  const isNamed = (id: string) => poses.has(id) || !all.has(pieces.get(id)!.object.hostId);
  return movePieces(room, [...all].filter(([id]) => isNamed(id)).map(([id, pose]) => placementOf(pieces.get(id)!, pose)));
}

// Turns those that are not locked, counter-clockwise.
export function turnPieces(room: OpenRoom, pieces: readonly Piece[], angle: number): void {
  const free = pieces.filter((piece) => !piece.pinned);
  if (free.length > 0) void standAt(room, turnedInside(free, angle, room.floor.peek()));
}

// Puts objects there and solves what that affects, as one act.
function moveAndSettle(room: OpenRoom, placements: Placements) {
  return edit(room, placements.map((value): Edit => ({ edit: { case: "moveObject", value } })), false);
}

export function resizePiece(room: OpenRoom, piece: Piece, { pose, size }: Resized, heightM?: number) {
  const value = { objectId: piece.id, widthM: size.width, depthM: size.depth, ...(heightM ? { heightM } : {}) };
  const move: Edit = { edit: { case: "moveObject", value: placementOf(piece, pose) } };
  return change(room, [{ edit: { case: "resizeObject", value } }, move]);
}

const remove = (room: OpenRoom, ids: readonly string[]) =>
  change(room, ids.map((id): Edit => ({ edit: { case: "removeObjectId", value: id } })));

const removedInWords = (gone: readonly Piece[]): string =>
  gone.length === 1 ? `${theName(gone[0]!.object)} is removed.` : `${gone.length} pieces are removed.`;

// Takes the last act back as long as it is the last.
function undoOf(room: OpenRoom): ToastAct {
  const { revision } = room.document.peek();
  return {
    label: "Put it back",
    run: () => {
      if (room.document.peek().revision === revision) void undo(room);
      else room.tell("More was changed since. Undo goes back step by step (Ctrl Z).");
    },
  };
}

export async function removePieces(room: OpenRoom, ids: readonly string[]) {
  const pieces = room.pieces.peek();
  const free = ids.filter((id) => !pieces.get(id)?.pinned);
  if (free.length < ids.length) tellLocked(room, ids.flatMap((id) => pieces.get(id) ?? []));
  const orphans = orphansOf(pieces, free), seats = seatsAt(pieces, free);
  if (free.length === 0 || !(await remove(room, free))) return;
  const gone = free.map((id) => pieces.get(id)!), back = undoOf(room);
  if (orphans.length + seats.length === 0) room.tell(removedInWords(gone), [back]);
  if (orphans.length > 0) offerForOrphans(room, orphans, gone, back);
  if (seats.length > 0) {
    const act = { label: "Remove too", run: () => void remove(room, seats.map(({ id }) => id)) };
    room.tell(seatsInWords(seats), [act, back]);
  }
}

// What stood on a piece that is gone goes too, or onto other pieces, by a click.
function offerForOrphans(
  room: OpenRoom,
  orphans: readonly Piece[],
  hosts: readonly Piece[],
  back: ToastAct,
): void {
  const taken = new Map(room.pieces.peek());
  const homes = orphans.flatMap((orphan) => {
    const home = homeFor(taken, orphan);
    if (home) taken.set(orphan.id, { ...orphan, pose: home.pose, z: home.z });
    return home ? [{ orphan, ...home }] : [];
  });
  const [first] = homes;
  const isEach = first !== undefined && homes.length === orphans.length;
  const isOneHost = homes.every(({ host }) => host === first?.host);
  const placements = homes.map(({ orphan, pose, z }) => ({ ...placementOf(orphan, pose), zM: z }));
  room.tell(orphansInWords(orphans, hosts), [
    { label: "Remove too", run: () => void remove(room, orphans.map(({ id }) => id)) },
    ...(isEach ? [{
      label: isOneHost ? `Put on ${theName(first.host.object)}` : "Put elsewhere",
      run: () => void movePieces(room, placements),
    }] : []),
    back,
  ]);
}

export function lockPieces(room: OpenRoom, pieces: readonly Piece[]) {
  const lock = pieces.some((piece) => !piece.pinned);
  return edit(room, pieces.filter((piece) => piece.pinned !== lock).map((piece): Edit => lock
    ? { edit: { case: "pinObjectId", value: piece.id } }
    : { edit: { case: "unpinObjectId", value: piece.id } }), true);
}

// Says which pieces stay because they are locked.
export function tellLocked(room: OpenRoom, pieces: readonly Piece[]): void {
  const locked = pieces.filter(({ pinned }) => pinned), [first] = locked;
  if (!first) return;
  const text = locked.length === 1 ? `${theName(first.object)} is locked.` : `${locked.length} pieces are locked.`;
  room.tellLocked(text, () => void lockPieces(room, locked));
}

// An id that no object of the room has: "armchair", "armchair_2"...
export function freeId(taken: ReadonlySet<string>, name: string): string {
  const base = name.toLowerCase().replace(/[^a-z0-9]+/g, "_").replace(/^_+|_+$|_\d+$/g, "") || "piece";
  if (!taken.has(base) && !taken.has(`${base}_1`)) return base;
  for (let number = 2; ; number += 1) if (!taken.has(`${base}_${number}`)) return `${base}_${number}`;
}

function takenIds(room: OpenRoom): Set<string> {
  return new Set(room.layout.peek()?.graph?.objectList?.objects.map((object) => object.id));
}

// Adds an object at a pose and selects it.
export async function addPiece(room: OpenRoom, object: MessageInitShape<typeof ObjectSchema>, pose: Pose, z = 0) {
  const id = freeId(takenIds(room), object.name ?? "piece");
  const added = { role: ObjectRole.SECONDARY, ...object, id, requested: true, spare: false };
  const move = { objectId: id, xM: pose.x, yM: pose.y, zM: z, thetaRad: pose.theta };
  const response = await edit(room, [
    { edit: { case: "addObject", value: { object: added } } },
    { edit: { case: "moveObject", value: move } },
  ], true);
  if (response) room.select([id]);
  return response !== undefined;
}

// Adds an object where there is room for it, and selects it.
export async function addPieceSomewhere(room: OpenRoom, object: MessageInitShape<typeof ObjectSchema>) {
  const id = freeId(takenIds(room), object.name ?? "piece");
  const added = { role: ObjectRole.SECONDARY, ...object, id, requested: true, spare: false };
  if (await edit(room, [{ edit: { case: "addObject", value: { object: added } } }], false)) room.select([id]);
  return room.pieces.peek().has(id);
}

// Zones and hosts that the room does not have are left out, as of what was copied in another one.
function atHome(room: OpenRoom, object: Object$): MessageInitShape<typeof ObjectSchema> {
  const zones = room.layout.peek()?.graph?.zonePlan?.zones ?? [];
  const zoneId = zones.some((zone) => zone.id === object.zoneId) ? object.zoneId : "";
  const hostId = room.pieces.peek().has(object.hostId) ? object.hostId : "";
  return { ...plain(object), zoneId, hostId };
}

// Pieces and all that stands on them.
export function withCarried(room: OpenRoom, chosen: readonly Piece[]): Piece[] {
  const pieces = room.pieces.peek(), ids = chosen.map(({ id }) => id);
  return [...chosen, ...guestsOf(pieces, ids).map((id) => pieces.get(id)!)];
}

// The same again, beside it where there is room, else a little aside; what stands on one of them stands on its copy.
export async function duplicatePieces(room: OpenRoom, pieces: readonly Piece[]) {
  const taken = takenIds(room);
  const copies = new Map<string, string>();
  const ids: string[] = [];
  const aside = freeBeside(room.pieces.peek(), pieces, room.floor.peek()) ?? vec(kCopyOffset, -kCopyOffset);
  const edits = pieces.flatMap((piece): Edit[] => {
    const id = freeId(taken, piece.object.id), host = copies.get(piece.object.hostId);
    taken.add(id);
    copies.set(piece.id, id);
    if (host === undefined) ids.push(id);
    const pose = moved(piece.pose, aside);
    const object = { ...atHome(room, piece.object), id, ...(host === undefined ? {} : { hostId: host }) };
    return [
      { edit: { case: "addObject", value: { object } } },
      { edit: { case: "moveObject", value: { ...placementOf(piece, pose), objectId: id } } },
    ];
  });
  if (edits.length === 0) return;
  if (await edit(room, edits, true)) room.select(ids);
}

function plain(object: Object$): MessageInitShape<typeof ObjectSchema> {
  const { $typeName: _name, $unknown: _unknown, placement: _placement, ...rest } = object;
  return { ...rest, spare: false };
}

// The server says what came of it, also that nothing could be better and why.
export async function settle(room: OpenRoom): Promise<void> {
  const response = await room.act({ case: "settle", value: {} });
  if (response?.answer) room.tell(room.spoken(response.answer));
}

// What was undone is told: it may be out of sight.
async function inHistory(room: OpenRoom, step: "undo" | "redo") {
  const { undoLabel, redoLabel } = room.document.peek();
  const answer = await room.act({ case: step, value: {} });
  if (answer) room.withdrawOffers();
  if (answer) room.tell(step === "undo" ? `Undone: ${undoLabel}.` : `Done again: ${redoLabel}.`);
  return answer;
}

export const undo = (room: OpenRoom) => inHistory(room, "undo");
export const redo = (room: OpenRoom) => inHistory(room, "redo");
export const rename = (room: OpenRoom, title: string) => room.act({ case: "title", value: title });

export const say = (room: OpenRoom, text: string, tell?: (text: string) => void) =>
  room.act({ case: "say", value: { text, selectedObjectIds: [...room.selection.peek()] } }, tell);

export const weigh = (room: OpenRoom, sentenceId: string, weight: number) =>
  room.act({ case: "weigh", value: { sentenceId, weight } });

export const replacePiece = (room: OpenRoom, objectId: string, by: MessageInitShape<typeof ObjectSchema>) =>
  room.act({ case: "replace", value: { objectId, by, withoutSolving: !room.settlesAlone() } });

export const renamePiece = (room: OpenRoom, piece: Piece, name: string) =>
  replacePiece(room, piece.id, { ...plain(piece.object), name });
