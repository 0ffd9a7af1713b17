// SPDX-License-Identifier: GPL-3.0-or-later
// What a pointer does from press to release. One of them runs at a time.
export interface Gesture {
  readonly cursor: string;
  move(event: PointerEvent): void;
  end(event: PointerEvent): void;
  // Escape, or the pointer is lost: as if it had never begun.
  cancel(): void;
}

// Below this many pixels a press is a click.
export const kDragStart = 4;
// How near a line catches what is dragged, pixels.
export const kSnapPixels = 8;
