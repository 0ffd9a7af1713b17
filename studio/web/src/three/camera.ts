// SPDX-License-Identifier: GPL-3.0-or-later
// The camera of the view as the renderer takes it: room frame R, z up, where the view's frame has y up and south as z.
import type { MessageInitShape } from "@bufbuild/protobuf";
import type { ViewCameraSchema } from "../gen/flair/v1/renderer_service_pb";

interface Point {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

export interface Sight {
  readonly eye: Point;
  readonly target: Point;
  // Of the height of the picture, degrees; and its width by its height.
  readonly angle: number;
  readonly aspect: number;
}

// The renderer takes no wider ones, radians.
const kWidest = 2.6;

const inRoom = ({ x, y, z }: Point): number[] => [x, -z, y];

// The renderer's pictures are square: this one holds all that is in sight, with more above and below or at the sides.
export function viewCameraOf({ eye, target, angle, aspect }: Sight): MessageInitShape<typeof ViewCameraSchema> {
  const half = Math.tan((angle * Math.PI) / 360) * Math.max(aspect, 1);
  const [eyeM, targetM] = [inRoom(eye), inRoom(target)];
  // Straight down has no upright.
  if (Math.hypot(eye.x - target.x, eye.z - target.z) < 1e-3) targetM[1]! += 1e-2;
  return { eyeM, targetM, fieldOfViewRad: Math.min(2 * Math.atan(half), kWidest) };
}
