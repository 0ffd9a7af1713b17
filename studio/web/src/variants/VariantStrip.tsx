// SPDX-License-Identifier: GPL-3.0-or-later
// Layouts of a room side by side, below its plan; one is taken by a click.
import { useEffect, useState } from "preact/hooks";
import { Icon } from "../app/Icon";
import type { OpenRoom } from "../state/open_room";
import { useStudio } from "../state/studio";
import { undo } from "../state/commands";
import { percent } from "../inspector/words";
import { changedSince, fetchVariants, isSame, type Variant, type Variants } from "./layouts";
import { OtherLayouts, Searching } from "./Searching";
import { SmallPlan } from "./SmallPlan";

function aboutOf({ held, asked, floor }: Variant): string {
  return [asked > 0 && `wishes ${held} of ${asked}`, floor !== undefined && `floor ${percent(floor)}`]
    .filter(Boolean)
    .join(" · ");
}

const changes = {
  "": "",
  walls: "The walls were changed since these were found: taking one brings back those before.",
  pieces: "Pieces were changed since these were found: taking one brings back those before.",
};

function useVariants(room: OpenRoom): Variants | undefined {
  const { clients } = useStudio();
  const { variantsLayoutId } = room.document.value;
  const [variants, setVariants] = useState<Variants | undefined>();
  useEffect(() => {
    if (!variantsLayoutId) return;
    let isGone = false;
    void fetchVariants(clients, room.document.peek())
      .catch(() => undefined)
      .then((found) => {
        if (!isGone && found) setVariants(found);
      });
    return () => {
      isGone = true;
    };
  }, [room, variantsLayoutId]);
  return variants?.layoutId === variantsLayoutId ? variants : undefined;
}

// What was moved by hand is placed otherwise in all of them, and is offered back.
async function take(room: OpenRoom, { index }: Variant, isOneShown: boolean): Promise<void> {
  const isTaken = await room.act({ case: "takeVariant", value: { index } });
  if (isTaken && !isOneShown) {
    room.tell("What you moved is placed anew in this variant.", [{ label: "Back to them", run: () => void undo(room) }]);
  }
}

function Tiles({ room, variants }: { room: OpenRoom; variants: Variants }) {
  const placements = room.layout.value?.placements ?? [];
  const shown = variants.list.find((variant) => isSame(placements, variant.placements));
  return (
    <ul onWheel={(event) => { event.currentTarget.scrollLeft += event.deltaX + event.deltaY; }}>
      {variants.list.map((variant) => {
        const isShown = variant === shown;
        return (
          <li key={variant.index}>
            <button
              aria-pressed={isShown}
              disabled={room.isBusy.value}
              onClick={() => {
                if (!isShown) void take(room, variant, shown !== undefined);
              }}
            >
              <SmallPlan layout={variants.layout} placements={variant.placements} parts={room.parts.value} />
              <span class="variant-text">
                <strong>Variant {variant.index + 2}</strong>
                <span>{aboutOf(variant)}</span>
              </span>
            </button>
          </li>
        );
      })}
    </ul>
  );
}

export function VariantStrip({ room }: { room: OpenRoom }) {
  const { variantCount } = room.document.value;
  const variants = useVariants(room);
  const [isOpen, setOpen] = useState(true);
  const began = room.search.began.value;
  useEffect(() => {
    if (began !== undefined) setOpen(true);
  }, [began]);
  if (variantCount === 0 && began === undefined) return null;
  const changed = variants ? changes[changedSince(variants, room.layout.value)] : "";
  return (
    <section class={isOpen ? "variant-strip" : "variant-strip is-closed"} aria-label="Variants">
      <div class="variant-side">
        {variantCount > 0 && (
          <button class="variant-head" aria-expanded={isOpen} onClick={() => setOpen(!isOpen)}>
            <span>{variantCount + 1} variants</span>
            <Icon name={isOpen ? "minus" : "plus"} size={14} />
          </button>
        )}
        {isOpen && began === undefined && <OtherLayouts room={room} label="Search others" />}
        {isOpen && changed && <p class="hint">{changed}</p>}
      </div>
      {began !== undefined
        ? <Searching room={room} began={began} />
        : isOpen && variants && <Tiles room={room} variants={variants} />}
    </section>
  );
}
