// SPDX-License-Identifier: GPL-3.0-or-later
// The wall, corner, door, window or socket that is selected.
import { Icon } from "../app/Icon";
import { PanelHead, RemoveButton } from "../app/PanelHead";
import { capital } from "../inspector/words";
import { addCornerOn, addToWall, cornerIndex, fixtureOf, nameOfWall, removeSelected, setFixture } from "./acts";
import { useDrawing } from "./context";
import { Choice, MetresField, TextField } from "./fields";
import { gapsOf, placed } from "./fixtures";
import { endsOf, spokenFixture, withArticle } from "./names";
import { widthOf, type Door, type Fixture, type WallLine } from "./sketch";
import { withCornerAt, withWallLength } from "./walls";

const kLeastWidth = 0.2;

function Head({ title, remove }: { title: string; remove?: string }) {
  const drawing = useDrawing();
  return (
    <>
      <PanelHead label="Back to the room" title="Back to the room (Esc)" onClose={() => drawing.select(undefined)}>
        <h2>{title}</h2>
      </PanelHead>
      {remove && (
        <div class="button-group piece-acts">
          <RemoveButton label={remove} run={() => removeSelected(drawing)} />
        </div>
      )}
    </>
  );
}

function WallPanel({ wall }: { wall: WallLine }) {
  const drawing = useDrawing();
  return (
    <>
      <Head title={capital(nameOfWall(drawing, wall.key))} />
      <div class="fields">
        <MetresField
          label="Length"
          metres={wall.length}
          least={0.05}
          take={(metres) =>
            drawing.commit(withWallLength(drawing.sketch.peek(), wall.index, metres), "change a length")
          }
        />
      </div>
      <p class="hint room-hint">
        Drag the wall to move it; its neighbours follow. Double-click it for a new corner: the half of a wall, dragged,
        makes a niche or an L.
      </p>
      <h3 class="eyebrow">Put into it</h3>
      <div class="panel-buttons">
        <button class="button" onClick={() => addToWall(drawing, "door", wall.key)}>
          <Icon name="door" />
          Door
        </button>
        <button class="button" onClick={() => addToWall(drawing, "window", wall.key)}>
          <Icon name="window" />
          Window
        </button>
        <button class="button" onClick={() => addToWall(drawing, "socket", wall.key)}>
          <Icon name="socket" />
          Socket
        </button>
        <button class="button" onClick={() => addCornerOn(drawing, wall.index, Math.round(wall.length * 50) / 100)}>
          <Icon name="plus" />
          Corner
        </button>
      </div>
    </>
  );
}

function CornerPanel({ index }: { index: number }) {
  const drawing = useDrawing(),
    corner = drawing.sketch.value.corners[index]!;
  const move = (to: { x?: number; y?: number }) => {
    const at = drawing.sketch.peek().corners[index]!;
    drawing.commit(withCornerAt(drawing.sketch.peek(), index, { x: to.x ?? at.x, y: to.y ?? at.y }), "move a corner");
  };
  return (
    <>
      <Head title="Corner" remove="Remove the corner" />
      <div class="fields">
        <MetresField label="East" metres={corner.x} least={-200} take={(x) => move({ x })} />
        <MetresField label="North" metres={corner.y} least={-200} take={(y) => move({ y })} />
      </div>
      <p class="hint room-hint">Arrows move it by 1 cm, with Shift by 10 cm.</p>
    </>
  );
}

function DoorFields({ door, wall }: { door: Door; wall: WallLine }) {
  const drawing = useDrawing(),
    ends = endsOf(wall.along);
  const hinges = [
    ["start", capital(ends.start)],
    ["end", capital(ends.end)],
  ] as const;
  // As on the plan, from left to right.
  const isTurned = ends.start === "east" || ends.start === "south";
  const set = (part: Partial<Door>) => setFixture(drawing, { ...door, ...part });
  const swings = door.swing === "inward" || door.swing === "outward";
  return (
    <>
      <Choice
        label="Opens"
        value={door.swing}
        take={(swing) => set({ swing })}
        choices={[
          ["inward", "Inward"],
          ["outward", "Outward"],
          ["sliding", "Slides"],
          ["none", "No leaf"],
        ]}
      />
      {swings && (
        <Choice
          label="Hinges at the end"
          value={door.hinge}
          take={(hinge) => set({ hinge })}
          choices={isTurned ? [hinges[1], hinges[0]] : hinges}
        />
      )}
      {swings && (
        <div class="fields">
          <TextField
            label="Opens by"
            text={`${Math.round((door.angle * 180) / Math.PI)}°`}
            take={(text) => {
              const degrees = Number(text.replace("°", "").trim());
              if (!(degrees > 0 && degrees <= 180)) return false;
              set({ angle: (degrees * Math.PI) / 180 });
              return true;
            }}
          />
        </div>
      )}
    </>
  );
}

function FixturePanel({ fixture, wall }: { fixture: Fixture; wall: WallLine | undefined }) {
  const drawing = useDrawing();
  const set = (part: Partial<Fixture>) => setFixture(drawing, { ...fixture, ...part } as Fixture);
  const place = (offset: number) => setFixture(drawing, placed(fixture, wall, wall!, offset));
  const gaps = wall && gapsOf(fixture, wall),
    ends = endsOf(wall?.along ?? { x: 1, y: 0 });
  const isTurned = ends.start === "east" || ends.start === "south";
  const before = gaps && (
    <MetresField
      key="before"
      label={`From the ${ends.start} end`}
      metres={gaps.before}
      take={place}
    />
  );
  const behind = gaps && (
    <MetresField
      key="behind"
      label={`From the ${ends.end} end`}
      metres={Math.max(0, gaps.behind)}
      take={(rest) => place(wall!.length - widthOf(fixture) - rest)}
    />
  );
  return (
    <>
      <Head title={capital(spokenFixture(fixture.id))} remove={`Remove ${spokenFixture(fixture.id)}`} />
      <p class="stands">In {withArticle(nameOfWall(drawing, fixture.wall))}. Drag it along, or to another wall.</p>
      <div class="fields">
        {fixture.kind !== "socket" && (
          <MetresField label="Width" metres={fixture.width} least={kLeastWidth} take={(width) => set({ width })} />
        )}
        {fixture.kind === "window" && <MetresField label="Sill" metres={fixture.sill} take={(sill) => set({ sill })} />}
        {fixture.kind !== "socket" && (
          <MetresField
            label={fixture.kind === "door" ? "Height" : "Head"}
            metres={fixture.head}
            least={0.1}
            take={(head) => set({ head })}
          />
        )}
        {fixture.kind === "socket" && (
          <MetresField label="Height" metres={fixture.height} take={(height) => set({ height })} />
        )}
      </div>
      {gaps && wall && <div class="fields is-two">{isTurned ? [behind, before] : [before, behind]}</div>}
      {fixture.kind === "door" && wall && <DoorFields door={fixture} wall={wall} />}
    </>
  );
}

export function ChosenPanel() {
  const drawing = useDrawing(),
    one = drawing.selection.value,
    sketch = drawing.sketch.value,
    walls = drawing.walls.value;
  if (one?.kind === "wall") {
    const wall = walls.find(({ key }) => key === one.key);
    return wall ? <WallPanel key={one.key} wall={wall} /> : null;
  }
  if (one?.kind === "corner") {
    const index = cornerIndex(sketch, one.key);
    return index >= 0 ? <CornerPanel key={one.key} index={index} /> : null;
  }
  const fixture = one && fixtureOf(sketch, one.id);
  return fixture ? (
    <FixturePanel key={fixture.id} fixture={fixture} wall={walls.find(({ key }) => key === fixture.wall)} />
  ) : null;
}
