// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines for what the server has not drawn, or not yet.
import type { Size } from "../geometry/footprint";
import type { Vec } from "../geometry/vec";
import type { Piece } from "../state/pieces";

interface Hung {
  readonly widthM: number;
  readonly heightM: number;
  readonly round: boolean;
}

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

// What hangs on a wall, from the front.
export function frontSymbol({ widthM: width, heightM: height, round }: Hung): string {
  const line = 'fill="#f1ece3" stroke="#57534c" stroke-width="0.012"', inner = 'fill="#dfe7e4" stroke="#57534c" stroke-width="0.006"';
  const frame = Math.min(width, height) * 0.1;
  const [w, h] = [width - 2 * frame, height - 2 * frame];
  if (round) {
    return `<ellipse rx="${width / 2}" ry="${height / 2}" ${line}/><ellipse rx="${w / 2}" ry="${h / 2}" ${inner}/>`;
  }
  return `<rect x="${-width / 2}" y="${-height / 2}" width="${width}" height="${height}" ${line}/>` +
    `<rect x="${-w / 2}" y="${-h / 2}" width="${w}" height="${h}" ${inner}/>`;
}

export const plainPiece = ({ size, object }: Piece): string => plainSymbol(size, object.round);
