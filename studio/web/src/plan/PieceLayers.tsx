// SPDX-License-Identifier: GPL-3.0-or-later
// Floor, pieces, walls, in the order of the renderer's plan. A piece's element is made once; its transform changes.
import { useComputed } from "@preact/signals";
import { memo } from "preact/compat";
import { ObjectKind } from "../gen/flair/v1/object_list_pb";
import type { PlanPart } from "../gen/flair/v1/renderer_service_pb";
import { nameOf, type Piece } from "../state/pieces";
import { usePlan } from "./context";
import { Drawn } from "./Drawn";
import { plainFloor, plainPiece } from "./plain";
import { resizing } from "./gestures/resize";

interface Shadow {
  svg: string;
  x: number;
  y: number;
}

const kDegrees = 180 / Math.PI;

interface PieceProps {
  id: string;
  svg: string;
  shadow: Shadow | undefined;
  width: number;
  depth: number;
  isCeiling: boolean;
  name: string;
}

const PieceElement = memo(
  function PieceElement({ id, svg, shadow, width, depth, isCeiling, name }: PieceProps) {
    const { room } = usePlan();
    const transformAt = (shiftX: number, shiftY: number) => {
      const pulled = resizing.value?.id === id ? resizing.value.to : undefined;
      const pose = pulled?.pose ?? room.poseOf(id);
      if (!pose) return "";
      const scale = pulled ? ` scale(${pulled.size.width / width} ${pulled.size.depth / depth})` : "";
      return `translate(${pose.x + shiftX} ${shiftY - pose.y}) rotate(${-pose.theta * kDegrees})${scale}`;
    };
    const transform = useComputed(() => transformAt(0, 0));
    const shadowTransform = useComputed(() => (shadow ? transformAt(shadow.x, shadow.y) : ""));
    const state = useComputed(() => (room.selection.value.has(id) ? "piece is-selected" : "piece"));
    return (
      <>
        {shadow && (
          <g transform={shadowTransform} pointer-events="none">
            <Drawn svg={shadow.svg} />
          </g>
        )}
        <g class={state} transform={transform} data-piece={id} aria-hidden="true" data-name={name}>
          <Drawn svg={svg} />
          <rect
            class={isCeiling ? "hit hit-outline" : "hit"}
            x={-width / 2}
            y={-depth / 2}
            width={width}
            height={depth}
          />
        </g>
      </>
    );
  },
  (a, b) => a.svg === b.svg && a.name === b.name && a.shadow?.svg === b.shadow?.svg,
);

function shadowOf(part: PlanPart | undefined): Shadow | undefined {
  return part?.shadowSvg ? { svg: part.shadowSvg, x: part.shadowXM, y: part.shadowYM } : undefined;
}

function layerOf(piece: Piece, part: PlanPart | undefined): "below" | "middle" | "above" {
  if (part ? part.belowFurniture : piece.object.walkOver) return "below";
  const isHigh = piece.object.kind === ObjectKind.WALL || piece.object.kind === ObjectKind.CEILING;
  return (part ? part.aboveWalls : isHigh) ? "above" : "middle";
}

export function PieceLayers() {
  const { room } = usePlan();
  const parts = room.parts.value;
  const pieces = room.pieces.value;
  const order = new Map(parts?.parts.map((part, i) => [part.objectId, { part, i }]));
  const sorted = [...pieces.values()].sort((a, b) => (order.get(a.id)?.i ?? 1e6) - (order.get(b.id)?.i ?? 1e6));
  const layer = (which: "below" | "middle" | "above") => sorted
    .filter((piece) => layerOf(piece, order.get(piece.id)?.part) === which)
    .map((piece) => {
      const { width, depth } = piece.size;
      const shadow = shadowOf(order.get(piece.id)?.part);
      // Computed signals keep what they have read of their component: what that depends on is in the key.
      return <PieceElement key={[piece.id, width, depth, shadow?.x, shadow?.y].join(" ")} id={piece.id}
        svg={order.get(piece.id)?.part.svg ?? plainPiece(piece)} shadow={shadow} width={width} depth={depth}
        isCeiling={piece.object.kind === ObjectKind.CEILING} name={nameOf(piece.object)} />;
    });
  const plain = parts ? undefined : plainFloor(room.floor.value);
  return (
    <>
      <Drawn svg={parts?.floorSvg ?? plain?.floor ?? ""} name="floor" />
      <g>{layer("below")}</g>
      <g>{layer("middle")}</g>
      <Drawn svg={parts?.wallsSvg ?? plain?.walls ?? ""} name="walls" />
      <g>{layer("above")}</g>
    </>
  );
}
