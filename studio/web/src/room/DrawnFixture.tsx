// SPDX-License-Identifier: GPL-3.0-or-later
// A door, window or socket on the drawing.
import { add, times, type Vec } from "../geometry/vec";
import { pixelPoints } from "../plan/overlay/pixels";
import { toScreen } from "../plan/view";
import { useDrawing } from "./context";
import { kWallThickness, leafOf, spanOf } from "./shapes";
import type { Door, Fixture, Socket, WallLine } from "./sketch";

interface Props {
  fixture: Fixture;
  wall: WallLine;
  state: string;
}

const kHitPixels = 9;

function Line({ a, b, name }: { a: Vec; b: Vec; name: string }) {
  const view = useDrawing().view.value;
  const p = toScreen(view, a),
    q = toScreen(view, b);
  return <line class={name} x1={p.x} y1={p.y} x2={q.x} y2={q.y} />;
}

function DoorLines({ door, wall }: { door: Door; wall: WallLine }) {
  const view = useDrawing().view.value;
  const leaf = leafOf(door, wall),
    { start, end } = spanOf(door, wall);
  const out = times(wall.inward, -kWallThickness / 2);
  return (
    <>
      {leaf && <polyline class="room-arc" points={pixelPoints(view, leaf.arc)} />}
      {leaf && <Line a={leaf.hinge} b={leaf.tip} name="room-leaf" />}
      {door.swing === "sliding" && <Line a={add(start, out)} b={add(end, out)} name="room-leaf" />}
      {door.swing === "sliding" && (
        <Line
          a={add(end, times(wall.inward, 0.05))}
          b={add(add(end, times(wall.along, -door.width)), times(wall.inward, 0.05))}
          name="room-arc"
        />
      )}
    </>
  );
}

function SocketMark({ socket, wall, state }: { socket: Socket; wall: WallLine; state: string }) {
  const view = useDrawing().view.value;
  const at = toScreen(view, add(wall.a, times(wall.along, socket.offset)));
  const n = { x: wall.inward.x, y: -wall.inward.y },
    t = { x: wall.along.x, y: -wall.along.y };
  const r = 7,
    sweep = t.x * n.y - t.y * n.x > 0 ? 0 : 1;
  const path = `M${at.x - t.x * r} ${at.y - t.y * r}A${r} ${r} 0 0 ${sweep} ${at.x + t.x * r} ${at.y + t.y * r}Z`;
  const end = { x: at.x + n.x * (r + 5), y: at.y + n.y * (r + 5) };
  return (
    <g class={`room-fixture is-socket ${state}`} data-fixture={socket.id}>
      <circle class="hit" cx={at.x + n.x * 5} cy={at.y + n.y * 5} r={14} />
      <path class="room-socket" d={path} />
      <line class="room-leaf" x1={at.x + n.x * r} y1={at.y + n.y * r} x2={end.x} y2={end.y} />
    </g>
  );
}

export function DrawnFixture({ fixture, wall, state }: Props) {
  const view = useDrawing().view.value;
  if (fixture.kind === "socket") return <SocketMark socket={fixture} wall={wall} state={state} />;
  const { start, end, gap } = spanOf(fixture, wall);
  const reach = times(wall.inward, kHitPixels / view.scale);
  const hit = [add(start, reach), add(end, reach), add(gap[2]!, times(reach, -1)), add(gap[3]!, times(reach, -1))];
  const out = (share: number) => times(wall.inward, -kWallThickness * share);
  return (
    <g class={`room-fixture is-${fixture.kind} ${state}`} data-fixture={fixture.id}>
      <polygon class="room-gap" points={pixelPoints(view, gap)} />
      {fixture.kind === "window" && <polygon class="room-pane" points={pixelPoints(view, gap)} />}
      {fixture.kind === "window" && <Line a={add(start, out(0.5))} b={add(end, out(0.5))} name="room-glass" />}
      {fixture.kind === "door" && <DoorLines door={fixture} wall={wall} />}
      <polygon class="hit" points={pixelPoints(view, hit)} />
    </g>
  );
}
