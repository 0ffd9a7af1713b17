// SPDX-License-Identifier: GPL-3.0-or-later
// The sketch that is not sent yet, kept by the browser: a reload or a crash loses no wall.
import type { Sketch } from "./sketch";

const kName = "flair.sketch";

interface Kept {
  readonly of: string;
  readonly sketch: Sketch;
}

// `of` says which room at which revision it is of; a sketch of another one is none.
export function keptSketch(of: string): Sketch | undefined {
  try {
    const kept = JSON.parse(localStorage.getItem(kName) ?? "null") as Kept | null;
    return kept?.of === of && kept.sketch.corners.length > 0 ? kept.sketch : undefined;
  } catch {
    return undefined;
  }
}

export function keepSketch(of: string, sketch: Sketch): void {
  try {
    localStorage.setItem(kName, JSON.stringify({ of, sketch } satisfies Kept));
  } catch {
    // A browser that keeps nothing keeps no sketch.
  }
}

export function forgetSketch(): void {
  try {
    localStorage.removeItem(kName);
  } catch {
    // As above.
  }
}
