// SPDX-License-Identifier: GPL-3.0-or-later
// Changes of walls. What is in a wall stays where it is in the room as far as its wall lets it.
import { add, cross, distance, dot, sub, times, type Vec } from "../geometry/vec";
import { counterClockwise, freeKey, wallsOf, widthOf, type Corner, type Fixture, type Sketch } from "./sketch";

const kSame = 1e-4;
// Sine of the angle below which two walls are taken for one line.
const kStraight = 0.05;

const round = (metres: number) => Math.round(metres * 1e4) / 1e4;

// Offsets along the walls as they now run.
function carried(before: Sketch, after: Sketch): Sketch {
  const were = new Map(wallsOf(before).map((wall) => [wall.key, wall]));
  const are = new Map(wallsOf(after).map((wall) => [wall.key, wall]));
  const fixtures = after.fixtures.map((fixture): Fixture => {
    const was = were.get(fixture.wall),
      is = are.get(fixture.wall);
    if (!was || !is || (distance(was.a, is.a) < kSame && Math.abs(was.length - is.length) < kSame)) return fixture;
    const spot = add(was.a, times(was.along, fixture.offset));
    const offset = dot(sub(spot, is.a), is.along);
    const most = is.length - widthOf(fixture);
    return { ...fixture, offset: round(most < 0 ? 0 : Math.min(Math.max(offset, 0), most)) };
  });
  return { ...after, fixtures };
}

// Without corners that lie on the one before.
function withoutEmptyWalls(sketch: Sketch): Sketch {
  const { corners } = sketch;
  const kept = corners.filter((corner, i) => distance(corner, corners[(i + 1) % corners.length]!) > kSame);
  if (kept.length === corners.length || kept.length < 3) return sketch;
  const keys = new Set(kept.map((corner) => corner.wall));
  return { ...sketch, corners: kept, fixtures: sketch.fixtures.filter(({ wall }) => keys.has(wall)) };
}

// What a gesture leaves behind: no empty walls, corners counter-clockwise.
export function tidied(sketch: Sketch): Sketch {
  return sketch.isClosed ? counterClockwise(withoutEmptyWalls(sketch)) : sketch;
}

export function withCornerAt(sketch: Sketch, index: number, to: Vec): Sketch {
  const corners = sketch.corners.map((corner, i) =>
    i === index ? { ...corner, x: round(to.x), y: round(to.y) } : corner,
  );
  return carried(sketch, { ...sketch, corners });
}

// Where line p + t d meets line q + s e; undefined when they run alike.
function meeting(p: Vec, d: Vec, q: Vec, e: Vec): Vec | undefined {
  const det = cross(d, e);
  return Math.abs(det) < kStraight ? undefined : add(p, times(d, cross(sub(q, p), e) / det));
}

// The wall moved by `metres` to its left, its neighbours made longer or shorter. Where a neighbour goes straight on, a
// step is built: so a rectangle becomes an L.
export function withWallMoved(sketch: Sketch, index: number, metres: number): Sketch {
  const walls = wallsOf(sketch),
    count = walls.length;
  const wall = walls[index];
  if (!wall || !sketch.isClosed || Math.abs(metres) < kSame) return sketch;
  const n = { x: -wall.along.y, y: wall.along.x };
  const shift = times(n, metres);
  const a = add(wall.a, shift),
    b = add(wall.b, shift);
  const before = walls[(index - 1 + count) % count]!,
    after = walls[(index + 1) % count]!;
  const start = meeting(a, wall.along, before.a, before.along),
    end = meeting(b, wall.along, after.a, after.along);
  const corners: Corner[] = [];
  const put = (p: Vec, key: string) => corners.push({ x: round(p.x), y: round(p.y), wall: key });
  const keyFor = () => freeKey([...sketch.corners, ...corners]);
  sketch.corners.forEach((corner, i) => {
    if (i === index) {
      if (!start) put(corner, keyFor());
      put(start ?? a, corner.wall);
    } else if (i === (index + 1) % count) {
      if (!end) put(b, keyFor());
      put(end ?? corner, corner.wall);
    } else {
      corners.push(corner);
    }
  });
  return carried(sketch, { ...sketch, corners });
}

// The wall that long: the one after it goes along, or its last corner alone when that one is at no right angle.
export function withWallLength(sketch: Sketch, index: number, metres: number): Sketch {
  const walls = wallsOf(sketch),
    wall = walls[index];
  if (!wall || metres < kSame) return sketch;
  const by = metres - wall.length;
  const next = (index + 1) % sketch.corners.length,
    after = walls[next];
  if (after && sketch.isClosed && Math.abs(dot(after.along, wall.along)) < kStraight) {
    const n = { x: -after.along.y, y: after.along.x };
    return withWallMoved(sketch, next, by * dot(wall.along, n));
  }
  return withCornerAt(sketch, next, add(wall.b, times(wall.along, by)));
}

// A new corner on a wall; what is beyond it goes to the new wall.
export function withCornerOn(sketch: Sketch, index: number, offset: number): Sketch {
  const wall = wallsOf(sketch)[index];
  if (!wall || offset < kSame || offset > wall.length - kSame) return sketch;
  const at = add(wall.a, times(wall.along, offset)),
    key = freeKey(sketch.corners);
  const corners = sketch.corners.flatMap((corner, i) =>
    i === index ? [corner, { x: round(at.x), y: round(at.y), wall: key }] : [corner],
  );
  const fixtures = sketch.fixtures.map((fixture) =>
    fixture.wall === wall.key && fixture.offset + widthOf(fixture) / 2 > offset
      ? { ...fixture, wall: key, offset: round(Math.max(0, fixture.offset - offset)) }
      : fixture,
  );
  return { ...sketch, corners, fixtures };
}

// Without that corner; its two walls become one, under the name of the first.
export function withoutCorner(sketch: Sketch, index: number): Sketch {
  const { corners } = sketch,
    count = corners.length;
  if (count === 0 || (sketch.isClosed && count <= 3)) return sketch;
  const gone = corners[index]!,
    keeper = corners[(index - 1 + count) % count]!;
  const rest = corners.filter((_, i) => i !== index);
  const first = wallsOf(sketch).find(({ key }) => key === keeper.wall);
  const fixtures = sketch.fixtures.map((fixture) =>
    fixture.wall === gone.wall
      ? { ...fixture, wall: keeper.wall, offset: round(fixture.offset + (first?.length ?? 0)) }
      : fixture,
  );
  const merged = { ...sketch, corners: rest, fixtures };
  const lengths = new Map(wallsOf(merged).map(({ key, length }) => [key, length]));
  return {
    ...merged,
    fixtures: fixtures.map((fixture) => {
      const most = Math.max(0, (lengths.get(fixture.wall) ?? 0) - widthOf(fixture));
      return fixture.wall === keeper.wall ? { ...fixture, offset: Math.min(fixture.offset, most) } : fixture;
    }),
  };
}
