// SPDX-License-Identifier: GPL-3.0-or-later
// What the server would refuse, said before it does, in words that name the wall or door.
import { capital } from "../inspector/words";
import { lengthText, type Units } from "../app/units";
import { spokenFixture, spokenWallsOf, withArticle } from "./names";
import { segmentsMeet } from "./pen";
import { extentOf, wallsOf, widthOf, type Fixture, type Sketch, type WallLine } from "./sketch";

export interface Problem {
  readonly text: string;
  // Wall keys and fixture ids that it is about.
  readonly about: readonly string[];
}

const kShortest = 0.05;
const kExtent = { least: 1, most: 100 };
export const kHeights = { least: 2, most: 12 };
const kMostOpenings = 100;
const kTolerance = 1e-4;

function wallProblems(
  sketch: Sketch,
  walls: readonly WallLine[],
  name: (key: string) => string,
  units: Units,
): Problem[] {
  const problems: Problem[] = [];
  walls
    .filter((wall) => wall.length < kShortest)
    .forEach((wall) =>
      problems.push({
        text: `${capital(name(wall.key))} is too short: ${lengthText(wall.length, units)}.`,
        about: [wall.key],
      }),
    );
  walls.forEach((wall, i) =>
    walls.slice(i + 1).forEach((other, k) => {
      const j = i + 1 + k;
      const isNext = j === i + 1 || (i === 0 && j === walls.length - 1 && sketch.isClosed);
      const folded = isNext && wall.along.x * other.along.x + wall.along.y * other.along.y < -1 + 1e-6;
      if (folded || (!isNext && segmentsMeet(wall.a, wall.b, other.a, other.b))) {
        problems.push({
          text: `${capital(name(wall.key))} and ${name(other.key)} cross or touch.`,
          about: [wall.key, other.key],
        });
      }
    }),
  );
  return problems;
}

function extentProblems(sketch: Sketch, units: Units): Problem[] {
  const { width, depth } = extentOf(sketch);
  const text = (metres: number) => lengthText(metres, units);
  const problems: Problem[] = [];
  const least = Math.min(width, depth),
    most = Math.max(width, depth);
  if (least < kExtent.least - kTolerance)
    problems.push({
      text: `The room is too narrow: ${text(least)}. It needs at least ${text(kExtent.least)} each way.`,
      about: [],
    });
  if (most > kExtent.most + kTolerance)
    problems.push({
      text: `The room is too large: ${lengthText(most, units)}. At most ${lengthText(kExtent.most, units)} each way.`,
      about: [],
    });
  if (sketch.height < kHeights.least || sketch.height > kHeights.most) {
    problems.push({
      text: `A ceiling is between ${lengthText(kHeights.least, units)} and ${lengthText(kHeights.most, units)} high.`,
      about: [],
    });
  }
  return problems;
}

function heightProblem(fixture: Fixture, ceiling: number, units: Units): string | undefined {
  if (fixture.kind === "socket") return fixture.height > ceiling ? "is above the ceiling." : undefined;
  if (fixture.head > ceiling + kTolerance)
    return `is higher than the ceiling, which is at ${lengthText(ceiling, units)}.`;
  if (fixture.kind === "window" && fixture.head <= fixture.sill) return "has its head below its sill.";
  return undefined;
}

function fixtureProblems(
  sketch: Sketch,
  walls: readonly WallLine[],
  name: (key: string) => string,
  units: Units,
): Problem[] {
  const problems: Problem[] = [];
  const text = (metres: number) => lengthText(metres, units);
  const byKey = new Map(walls.map((wall) => [wall.key, wall]));
  const { fixtures } = sketch;
  fixtures.forEach((fixture, i) => {
    const wall = byKey.get(fixture.wall),
      called = capital(spokenFixture(fixture.id));
    if (!wall) return problems.push({ text: `${called} is in no wall.`, about: [fixture.id] });
    const free = wall.length - fixture.offset - widthOf(fixture);
    if (widthOf(fixture) > wall.length + kTolerance) {
      problems.push({
        text: `${called} is wider than ${name(wall.key)}: ${text(widthOf(fixture))} in ${text(wall.length)}.`,
        about: [fixture.id],
      });
    } else if (free < -kTolerance || fixture.offset < -kTolerance) {
      problems.push({ text: `${called} reaches beyond the end of ${name(wall.key)}.`, about: [fixture.id] });
    }
    const high = heightProblem(fixture, sketch.height, units);
    if (high) problems.push({ text: `${called} ${high}`, about: [fixture.id] });
    fixtures.slice(i + 1).forEach((other) => {
      if (overlap(fixture, other)) {
        problems.push({ text: `${called} and ${spokenFixture(other.id)} overlap.`, about: [fixture.id, other.id] });
      }
    });
  });
  if (fixtures.filter(({ kind }) => kind !== "socket").length > kMostOpenings) {
    problems.push({ text: `At most ${kMostOpenings} doors and windows.`, about: [] });
  }
  return problems;
}

const heights = (fixture: Fixture): [number, number] =>
  fixture.kind === "door" ? [0, fixture.head] : fixture.kind === "window" ? [fixture.sill, fixture.head] : [0, 0];

function overlap(a: Fixture, b: Fixture): boolean {
  if (a.kind === "socket" || b.kind === "socket" || a.wall !== b.wall) return false;
  const along = Math.min(a.offset + a.width, b.offset + b.width) - Math.max(a.offset, b.offset);
  const [a0, a1] = heights(a),
    [b0, b1] = heights(b);
  return along > kTolerance && Math.min(a1, b1) - Math.max(a0, b0) > kTolerance;
}

export function problemsOf(sketch: Sketch, units: Units): Problem[] {
  const walls = wallsOf(sketch),
    names = spokenWallsOf(sketch, units);
  const name = (key: string) => withArticle(names.get(key) ?? key);
  const crossing = wallProblems(sketch, walls, name, units);
  if (!sketch.isClosed) return crossing;
  return [...crossing, ...extentProblems(sketch, units), ...fixtureProblems(sketch, walls, name, units)];
}
