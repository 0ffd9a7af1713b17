// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes, place and heading of a piece, to be typed.
import { useLayoutEffect, useRef } from "preact/hooks";
import { figure, parseLength } from "../app/units";
import { wrapped } from "../geometry/vec";
import { placementOf, type Piece } from "../state/pieces";
import { movePieces, resizePiece } from "../state/commands";
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
  const move = (to: Partial<typeof pose>) => void movePieces(room, [placementOf(piece, { ...piece.pose, ...to })]);
  const place = (text: string, axis: "x" | "y") => {
    const metres = parseLength(text, units);
    if (metres !== undefined) move({ [axis]: metres });
    return metres !== undefined;
  };
  const turn = (text: string) => {
    const degrees = Number(text.replace("°", "").trim());
    if (!text.trim() || !Number.isFinite(degrees)) return false;
    move({ theta: wrapped((degrees * Math.PI) / 180) });
    return true;
  };
  const heading = Math.round(((wrapped(pose.theta) * 180) / Math.PI) * 10) / 10 % 360;
  return (
    <div class="fields">
      <Field label="Width" text={figure(width, units)} take={(text) => size(text, (metres) =>
        resizePiece(room, piece, { pose: piece.pose, size: { width: metres, depth } }))} />
      <Field label="Depth" text={figure(depth, units)} take={(text) => size(text, (metres) =>
        resizePiece(room, piece, { pose: piece.pose, size: { width, depth: metres } }))} />
      <Field label="Height" text={figure(piece.object.heightM, units)} take={(text) => size(text, (metres) =>
        resizePiece(room, piece, { pose: piece.pose, size: piece.size }, metres))} />
      <Field label="From west" title="Of its middle, from the room's western end" text={figure(pose.x, units)} isLocked={piece.pinned} take={(text) => place(text, "x")} />
      <Field label="From south" title="Of its middle, from the room's southern end" text={figure(pose.y, units)} isLocked={piece.pinned} take={(text) => place(text, "y")} />
      <Field label="Turned" title="0° looks north, 90° west" text={`${heading}°`} isLocked={piece.pinned} take={turn} />
    </div>
  );
}
