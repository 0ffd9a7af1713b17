// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes, place and heading of a piece, to be typed.
import { useLayoutEffect, useRef } from "preact/hooks";
import { figure, parseLength } from "../app/units";
import { headingText, parseHeading } from "../geometry/compass";
import { boxOf } from "../geometry/polygon";
import { gapsOf } from "../geometry/gaps";
import { ObjectKind } from "../gen/flair/v1/object_list_pb";
import { footprintOf, placementOf, type Piece } from "../state/pieces";
import { movePieces, resizePiece, turnPieces } from "../state/commands";
import type { OpenRoom } from "../state/open_room";
import { useStudio } from "../state/studio";
import { kLargest, kSmallest } from "../geometry/resize";

interface FieldProps {
  label: string;
  title?: string;
  text: string;
  isLocked?: boolean;
  // False when the text is no use; the field then shows what was there.
  take(text: string): boolean;
}

function Field({ label, title, text, isLocked, take }: FieldProps) {
  const input = useRef<HTMLInputElement>(null);
  // While a piece is dragged the text changes with every frame; what is being typed stays.
  useLayoutEffect(() => { if (document.activeElement !== input.current) input.current!.value = text; }, [text]);
  return (
    <label class="field" title={title}>
      <span>{label}</span>
      <input ref={input} disabled={isLocked} inputMode="decimal" onFocus={(event) => event.currentTarget.select()}
        onBlur={(event) => {
          const typed = event.currentTarget.value;
          if (typed !== text && !take(typed)) event.currentTarget.value = text;
        }}
        onKeyDown={(event) => {
          event.stopPropagation();
          if (event.key === "Escape") event.currentTarget.value = text;
          if (event.key === "Enter" || event.key === "Escape") event.currentTarget.blur();
        }} />
    </label>
  );
}

export function PieceFields({ room, piece }: { room: OpenRoom; piece: Piece }) {
  const units = useStudio().settings.units.value;
  const pose = room.poseOf(piece.id) ?? piece.pose;
  const { width, depth } = piece.size;
  const size = (text: string, apply: (metres: number) => Promise<unknown>) => {
    const metres = parseLength(text, units);
    if (metres === undefined || metres < kSmallest || metres > kLargest) return false;
    void apply(metres);
    return true;
  };
  const move = (to: Partial<typeof pose>, z = piece.z) =>
    void movePieces(room, [{ ...placementOf(piece, { ...piece.pose, ...to }), zM: z }]);
  const gaps = gapsOf(boxOf(footprintOf(piece, pose)), room.floor.value);
  const place = (text: string, axis: "x" | "y") => {
    const metres = parseLength(text, units);
    if (metres !== undefined) move({ [axis]: pose[axis] + metres - gaps[axis] });
    return metres !== undefined;
  };
  const turn = (text: string) => {
    const theta = parseHeading(text);
    if (theta !== undefined) turnPieces(room, [piece], theta - piece.pose.theta);
    return theta !== undefined;
  };
  const hang = (text: string) => {
    const metres = parseLength(text, units);
    if (metres === undefined || metres < 0 || metres > kLargest) return false;
    move({}, metres);
    return true;
  };
  const isHung = piece.object.kind === ObjectKind.WALL || piece.object.kind === ObjectKind.CEILING;
  return (
    <div class="fields">
      <Field label="Width" text={figure(width, units)} take={(text) => size(text, (metres) =>
        resizePiece(room, piece, { pose: piece.pose, size: { width: metres, depth } }))} />
      <Field label="Depth" text={figure(depth, units)} take={(text) => size(text, (metres) =>
        resizePiece(room, piece, { pose: piece.pose, size: { width, depth: metres } }))} />
      <Field label="Height" text={figure(piece.object.heightM, units)} take={(text) => size(text, (metres) =>
        resizePiece(room, piece, { pose: piece.pose, size: piece.size }, metres))} />
      <Field label="To west wall" title="From its western side to the wall west of it" isLocked={piece.pinned}
        text={figure(gaps.x, units)} take={(text) => place(text, "x")} />
      <Field label="To south wall" title="From its southern side to the wall south of it" isLocked={piece.pinned}
        text={figure(gaps.y, units)} take={(text) => place(text, "y")} />
      <Field label="Faces" title="N, NE, E... or degrees clockwise from north, which is up on the plan; R adds 90"
        isLocked={piece.pinned} text={headingText(pose.theta)} take={turn} />
      {isHung && <Field label="Above floor" title="From the floor to its lower edge" isLocked={piece.pinned}
        text={figure(piece.z, units)} take={hang} />}
    </div>
  );
}
