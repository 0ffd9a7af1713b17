// SPDX-License-Identifier: GPL-3.0-or-later
import { useComputed } from "@preact/signals";
import { memo } from "preact/compat";
import { boxOf } from "../../geometry/polygon";
import type { Pose } from "../../geometry/footprint";
import { vec, type Vec } from "../../geometry/vec";
import type { PlanPart } from "../../gen/flair/v1/renderer_service_pb";
import { ObjectKind } from "../../gen/flair/v1/object_list_pb";
import { carriersOf, footprintOf, isSolid, nameOf, theName, type Piece } from "../../state/pieces";
import { usePlan } from "../context";
import { toScreen } from "../view";

const kLeading = 1.18;
// Pixels: below, letters are not read; above, they are louder than the drawing.
const kSmallest = 7.5;
const kLargest = 15;
const kPlainSize = 11.5;
// From the middle of letters to their foot, pixels.
const kLowered = 4;
const kBeyondM = 0.09;
const kCeilingSizeM = 0.1;

interface LabelProps {
  piece: Piece;
  text: string;
  // Of the letters, and from the piece's middle, metres; 0 for letters of a size in pixels.
  size: number;
  shiftX: number;
  shiftY: number;
}

// Only its transform changes while a piece is dragged.
const Label = memo(
  function Label({ piece, text, size, shiftX, shiftY }: LabelProps) {
    const { room, view } = usePlan();
    const pixels = useComputed(() => (size > 0 ? Math.min(size * view.value.scale, kLargest) : kPlainSize));
    const place = useComputed(() => {
      const at = toScreen(view.value, room.poseOf(piece.id) ?? piece.pose),
        { scale } = view.value;
      return `translate(${(at.x + shiftX * scale).toFixed(1)} ${(at.y + shiftY * scale).toFixed(1)})`;
    });
    const isShown = useComputed(() => pixels.value >= kSmallest);
    const lines = text.split("\n");
    if (!isShown.value) return null;
    return (
      <text transform={place} font-size={pixels}>
        {lines.map((line, i) => (
          <tspan key={i} x="0" y={`${0.35 + (i - (lines.length - 1) / 2) * kLeading}em`}>
            {line}
          </tspan>
        ))}
      </text>
    );
  },
  (a, b) => a.text === b.text,
);

// What hangs from the ceiling is taken by its name: its outline is a line above other pieces.
const isOfCeiling = ({ object }: Piece): boolean => object.kind === ObjectKind.CEILING;

// Where its name may stand, from its middle in halves of its height: below it, above it, within it.
const kRows = [-1, 1, -0.5, 0.5];
// How near to each other names are not read, metres.
const kAside = 0.5;
const kRow = 0.13;

function anchorOf(piece: Piece, pose: Pose, row: number): Vec {
  const { min, max } = boxOf(footprintOf(piece, pose)), middle = (min.y + max.y) / 2;
  return vec((min.x + max.x) / 2, middle + (row * (max.y - min.y)) / 2 + (Math.abs(row) < 1 ? 0 : Math.sign(row) * kBeyondM));
}

// The first row in which no other name stands.
function freeRow(piece: Piece, others: readonly Vec[]): number {
  const isFree = (row: number) => {
    const at = anchorOf(piece, piece.pose, row);
    return others.every((one) => Math.abs(one.x - at.x) > kAside || Math.abs(one.y - at.y) > kRow);
  };
  return kRows.find(isFree) ?? kRows[0]!;
}

function CeilingLabel({ piece, row }: { piece: Piece; row: number }) {
  const { room, view } = usePlan();
  const place = useComputed(() => {
    const at = toScreen(view.value, anchorOf(piece, room.poseOf(piece.id) ?? piece.pose, row));
    return `translate(${at.x.toFixed(1)} ${(at.y + kLowered).toFixed(1)})`;
  });
  const pixels = useComputed(() => Math.min(kCeilingSizeM * view.value.scale, kPlainSize));
  if (pixels.value < kSmallest) return null;
  return (
    <text class="is-of-ceiling" transform={place} font-size={pixels} data-piece={piece.id}>{nameOf(piece.object)}</text>
  );
}

function hasLabel(piece: Piece, part: PlanPart | undefined): boolean {
  return isOfCeiling(piece) || (part ? part.label !== "" : isSolid(piece));
}

// The name of what is pointed at, above it where nothing is written on it.
function Pointed({ parts }: { parts: ReadonlyMap<string, PlanPart> }) {
  const plan = usePlan(), { room } = plan;
  const piece = plan.gesture.value ? undefined : room.pieces.value.get(room.hovered.value);
  if (!piece || room.selection.value.has(piece.id) || hasLabel(piece, parts.get(piece.id))) return null;
  const box = boxOf(footprintOf(piece, room.poseOf(piece.id)));
  const at = toScreen(plan.view.value, vec((box.min.x + box.max.x) / 2, box.max.y));
  const host = room.pieces.value.get(carriersOf(room.pieces.value, piece.id)[1] ?? "");
  const words = host ? `${nameOf(piece.object)}, on ${theName(host.object)}` : nameOf(piece.object);
  return <text class="is-pointed" font-size={kPlainSize} x={at.x} y={at.y - 8}>{words}</text>;
}

// On paper one label stands for all that look alike, "4 × dining chair"; pieces that are moved apart have one each.
const kFolded = /^\d+ ×\s+/;
const kindOf = ({ object, size }: Piece) => [object.name, size.width, size.depth].join(" ");

// The renderer's labels, upright; without a drawing, the names of what stands on the floor.
export function Labels() {
  const { room } = usePlan();
  const parts = new Map(room.parts.value?.parts.map((part) => [part.objectId, part]));
  const pieces = [...room.pieces.value.values()];
  const shared = new Map(pieces.flatMap((piece) => {
    const part = parts.get(piece.id);
    return part && kFolded.test(part.label) ? [[kindOf(piece), part] as const] : [];
  }));
  const labelOf = (piece: Piece) => shared.get(kindOf(piece)) ?? parts.get(piece.id);
  const anchors = pieces.filter((piece) => !isOfCeiling(piece) && hasLabel(piece, labelOf(piece))).map((piece) => {
    const { labelXM = 0, labelYM = 0 } = labelOf(piece) ?? {};
    return vec(piece.pose.x + labelXM, piece.pose.y - labelYM);
  });
  return (
    <g class="labels" pointer-events="none">
      {pieces
        .filter((piece) => hasLabel(piece, labelOf(piece)))
        .map((piece) => {
          if (isOfCeiling(piece)) {
            const row = freeRow(piece, anchors), { width, depth } = piece.size;
            return <CeilingLabel key={[piece.id, width, depth, row].join(" ")} piece={piece} row={row} />;
          }
          const {
            label = piece.object.name,
            labelSizeM: size = 0,
            labelXM: shiftX = 0,
            labelYM: shiftY = 0,
          } = labelOf(piece) ?? {};
          // Computed signals keep what they have read of their component: what that depends on is in the key.
          return (
            <Label
              key={[piece.id, size, shiftX, shiftY].join(" ")}
              piece={piece}
              text={label.replace(kFolded, "")}
              size={size}
              shiftX={shiftX}
              shiftY={shiftY}
            />
          );
        })}
      <Pointed parts={parts} />
    </g>
  );
}
