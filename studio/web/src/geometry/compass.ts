// SPDX-License-Identifier: GPL-3.0-or-later
// Headings as people say them: degrees clockwise from north, and compass points. North is up on the plan.
import { wrapped, type Vec } from "./vec";

const points = ["north", "north-east", "east", "south-east", "south", "south-west", "west", "north-west"] as const;

const shortOf = (point: string): string => point.split("-").map((word) => word.charAt(0).toUpperCase()).join("");

// Degrees clockwise from north of a heading, [0, 360).
export function bearingOf(theta: number): number {
  return (Math.round((wrapped(-theta) * 1800) / Math.PI) / 10) % 360;
}

// The nearest of the eight points to a direction in the room.
export function pointOf({ x, y }: Vec): string {
  return points[Math.round(bearingOf(Math.atan2(-x, y)) / 45) % 8]!;
}

// "N", "SW", "37°".
export function headingText(theta: number): string {
  const bearing = bearingOf(theta);
  return bearing % 45 === 0 ? shortOf(points[bearing / 45]!) : `${bearing}°`;
}

// The heading of "E", "south-west", "90" or "90°"; undefined when it is none.
export function parseHeading(text: string): number | undefined {
  const word = text.trim().toLowerCase().replace(/[\s-]+/g, "-").replace(/^(north|south)(east|west)$/, "$1-$2");
  const at = points.findIndex((point) => point === word || shortOf(point).toLowerCase() === word);
  const degrees = at >= 0 ? at * 45 : Number(word.replace(/°$/, "") || Number.NaN);
  return Number.isFinite(degrees) ? wrapped((-degrees * Math.PI) / 180) : undefined;
}
