// SPDX-License-Identifier: GPL-3.0-or-later
import { pulled, type Grip, type Resized } from "../../geometry/resize";
import type { Piece } from "../../state/pieces";
import { resizePiece } from "../../state/commands";
import type { PlanController } from "../controller";
import { signal } from "@preact/signals";
import type { Gesture } from "../gesture";

// What the piece in hand would be; drawn instead of it.
export const resizing = signal<{ id: string; to: Resized } | undefined>(undefined);

const kCentimetre = 0.01;

// Pulls a side or corner, in whole centimetres; alt in millimetres.
export function resizeGesture(plan: PlanController, piece: Piece, grip: Grip): Gesture {
  let to: Resized | undefined;
  return {
    cursor: "move",
    move(event) {
      to = pulled(piece.pose, piece.size, grip, plan.pointOf(event), event.altKey ? kCentimetre / 10 : kCentimetre);
      resizing.value = { id: piece.id, to };
    },
    end() {
      if (!to) return;
      void resizePiece(plan.room, piece, to).finally(() => { resizing.value = undefined; });
    },
    cancel() { resizing.value = undefined; },
  };
}
