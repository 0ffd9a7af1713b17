// SPDX-License-Identifier: GPL-3.0-or-later
// The room as a whole, and all that it has: the way to each wall and door for those who use no mouse.
import { Icon, type IconName } from "../app/Icon";
import { areaText, figure, lengthText } from "../app/units";
import { area } from "../geometry/polygon";
import { capital } from "../inspector/words";
import { nameOfWall } from "./acts";
import { useDrawing } from "./context";
import { MetresField } from "./fields";
import { spokenFixture } from "./names";
import { PicturePanel } from "./PicturePanel";
import { RoomType } from "./RoomType";
import { emptySketch, extentOf } from "./sketch";

const icons: Record<string, IconName> = { door: "door", window: "window", socket: "socket" };

export function ShapePanel({ isNew }: { isNew: boolean }) {
  const drawing = useDrawing(),
    sketch = drawing.sketch.value,
    units = drawing.studio.settings.units.value;
  const { width, depth } = extentOf(sketch);
  return (
    <>
      <header class="panel-head">
        <h2>{isNew ? "Your own room" : "The room"}</h2>
        <span class="hint">{areaText(Math.abs(area(sketch.corners)), units)}</span>
      </header>
      <p class="stands">
        {lengthText(width, units)} by {lengthText(depth, units)}, {sketch.corners.length} walls
      </p>
      <div class="fields is-two">
        <RoomType />
        <MetresField
          label="Ceiling"
          metres={sketch.height}
          take={(height) => drawing.commit({ ...drawing.sketch.peek(), height }, "change the ceiling")}
        />
      </div>
      {sketch.fixtures.every(({ kind }) => kind !== "door") && (
        <p class="notice is-warning room-no-door">There is no door yet. Press D, then click a wall.</p>
      )}
      <section>
        <h3 class="eyebrow">Walls</h3>
        <ul class="pieces">
          {drawing.walls.value.map((wall) => (
            <li key={wall.key}>
              <button
                class="piece-row"
                aria-label={`${capital(nameOfWall(drawing, wall.key))} ${lengthText(wall.length, units)}`}
                onClick={() => drawing.select({ kind: "wall", key: wall.key })}
                onPointerEnter={() => {
                  drawing.hovered.value = { kind: "wall", key: wall.key };
                }}
                onPointerLeave={() => {
                  drawing.hovered.value = undefined;
                }}
              >
                {capital(nameOfWall(drawing, wall.key))}{" "}
                <span class="hint">{figure(wall.length, units)}</span>
              </button>
            </li>
          ))}
        </ul>
      </section>
      {sketch.fixtures.length > 0 && (
        <section>
          <h3 class="eyebrow">In the walls</h3>
          <ul class="pieces">
            {sketch.fixtures.map((one) => (
              <li key={one.id}>
                <button
                  class="piece-row"
                  aria-label={`${capital(spokenFixture(one.id))} ${nameOfWall(drawing, one.wall)}`}
                  onClick={() => drawing.select({ kind: "fixture", id: one.id })}
                  onPointerEnter={() => {
                    drawing.hovered.value = { kind: "fixture", id: one.id };
                  }}
                  onPointerLeave={() => {
                    drawing.hovered.value = undefined;
                  }}
                >
                  <span class="with-icon">
                    <Icon name={icons[one.kind]!} size={14} />
                    {capital(spokenFixture(one.id))}
                  </span>{" "}
                  <span class="hint">{nameOfWall(drawing, one.wall)}</span>
                </button>
              </li>
            ))}
          </ul>
        </section>
      )}
      <PicturePanel />
      {isNew && (
        <section>
          <button
            class="link-button"
            onClick={() => {
              drawing.commit({ ...emptySketch, height: sketch.height, roomType: sketch.roomType }, "start again");
              drawing.fit();
            }}
          >
            Draw the walls anew
          </button>
        </section>
      )}
    </>
  );
}
