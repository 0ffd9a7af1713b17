// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines for what the server has not drawn, or not yet.
import type { Size } from "../geometry/footprint";
import type { Vec } from "../geometry/vec";
import type { Piece } from "../state/pieces";

const points = (list: readonly Vec[]) => list.map((p) => `${p.x},${-p.y}`).join(" ");

export function plainFloor(floor: readonly Vec[]): { floor: string; walls: string } {
  if (floor.length === 0) return { floor: "", walls: "" };
  return {
    floor: `<polygon points="${points(floor)}" fill="#faf6ef"/>`,
    walls: `<polygon points="${points(floor)}" fill="none" stroke="#57534c" stroke-width="0.06"/>`,
  };
}

export function plainSymbol({ width, depth }: Size, isRound: boolean): string {
  const line = 'fill="#f1ece3" stroke="#57534c" stroke-width="0.012"';
  if (isRound) return `<ellipse rx="${width / 2}" ry="${depth / 2}" ${line}/>`;
  return `<rect x="${-width / 2}" y="${-depth / 2}" width="${width}" height="${depth}" ${line}/>`;
}

export const plainPiece = ({ size, object }: Piece): string => plainSymbol(size, object.round);
