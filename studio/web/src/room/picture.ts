// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of a plan below the drawing, scaled by one known length. It stays in the browser.
import { distance, type Vec } from "../geometry/vec";

export interface Picture {
  readonly address: string;
  readonly name: string;
  readonly widthPx: number;
  readonly heightPx: number;
  readonly metresPerPixel: number;
  // Its upper left corner in the room.
  readonly at: Vec;
  readonly opacity: number;
}

// About as wide as a flat, until its scale is known.
const kFirstWidth = 10;

export function placed(address: string, name: string, widthPx: number, heightPx: number): Picture {
  const metresPerPixel = kFirstWidth / widthPx;
  return { address, name, widthPx, heightPx, metresPerPixel, at: { x: 0, y: heightPx * metresPerPixel }, opacity: 0.6 };
}

// The picture in the scale in which a and b of it are `metres` apart; a stays where it is.
export function scaled(picture: Picture, a: Vec, b: Vec, metres: number): Picture {
  const seen = distance(a, b);
  if (seen < 1e-6 || metres <= 0) return picture;
  const k = metres / seen;
  return {
    ...picture,
    metresPerPixel: picture.metresPerPixel * k,
    at: { x: a.x + (picture.at.x - a.x) * k, y: a.y + (picture.at.y - a.y) * k },
  };
}

const kLargest = 64 << 20;

export async function readPicture(file: File): Promise<Picture> {
  if (file.size > kLargest) throw new Error(`${file.name} is larger than ${kLargest >> 20} MB.`);
  const address = URL.createObjectURL(file);
  const image = new Image();
  image.src = address;
  try {
    await image.decode();
  } catch {
    URL.revokeObjectURL(address);
    throw new Error(`${file.name} is no picture that this browser can read. Take a PNG or JPEG.`);
  }
  return placed(address, file.name, image.naturalWidth, image.naturalHeight);
}
