// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes brought into line with each other, or to equal distances.
import type { Box } from "./polygon";
import { vec, type Vec } from "./vec";

export type Axis = "x" | "y";

// Where along an axis boxes are brought into line: at their smaller or larger sides or their middles.
export type Line = "min" | "middle" | "max";

const along = (axis: Axis, metres: number): Vec => (axis === "x" ? vec(metres, 0) : vec(0, metres));
const middleOf = ({ min, max }: Box, axis: Axis): number => (min[axis] + max[axis]) / 2;

// How far each box goes so that all are in line within what they take up together.
export function aligned(boxes: readonly Box[], axis: Axis, line: Line): Vec[] {
  const from = Math.min(...boxes.map(({ min }) => min[axis])), to = Math.max(...boxes.map(({ max }) => max[axis]));
  return boxes.map((box) => along(axis, {
    min: from - box.min[axis],
    middle: (from + to) / 2 - middleOf(box, axis),
    max: to - box.max[axis],
  }[line]));
}

// How far each goes so that the gaps between them are equal; the first and the last stay.
export function spread(boxes: readonly Box[], axis: Axis): Vec[] {
  const order = boxes.map((_, i) => i).sort((a, b) => middleOf(boxes[a]!, axis) - middleOf(boxes[b]!, axis));
  const sizeOf = ({ min, max }: Box) => max[axis] - min[axis];
  const first = boxes[order[0]!]!, last = boxes[order.at(-1)!]!;
  const taken = boxes.reduce((sum, box) => sum + sizeOf(box), 0);
  const gap = (last.max[axis] - first.min[axis] - taken) / Math.max(boxes.length - 1, 1);
  const by = boxes.map(() => vec(0, 0));
  let at = first.min[axis];
  for (const i of order) {
    by[i] = along(axis, at - boxes[i]!.min[axis]);
    at += sizeOf(boxes[i]!) + gap;
  }
  return by;
}
