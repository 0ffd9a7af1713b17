// SPDX-License-Identifier: GPL-3.0-or-later
// Variants of a room side by side, below its plan; one is taken by a click.
import { useEffect, useState } from "preact/hooks";
import { Icon } from "../app/Icon";
import type { OpenRoom } from "../state/open_room";
import { useStudio } from "../state/studio";
import { undo } from "../state/commands";
import { percent } from "../inspector/words";
import { fetchVariants, isSame, type Variant, type Variants } from "./layouts";
import { SmallPlan } from "./SmallPlan";

const kTaken = /^take variant/;

// The first layout is no variant to take: taking one back, or else putting everything where it has it, shows it again.
async function takeFirst(room: OpenRoom, { layoutId, list }: Variants): Promise<void> {
  while (kTaken.test(room.document.peek().undoLabel)) {
    if (!(await undo(room))) return;
    if (room.document.peek().layoutId === layoutId) return;
  }
  const pieces = room.pieces.peek();
  const placements = list[0]!.placements
    .filter(({ objectId }) => pieces.has(objectId))
    .map(({ objectId, xM, yM, zM, thetaRad }) => ({ objectId, xM, yM, zM, thetaRad }));
  await room.act({ case: "move", value: { placements } });
}

function aboutOf({ held, asked, floor }: Variant): string {
  return [asked > 0 && `wishes ${held} of ${asked}`, floor !== undefined && `floor ${percent(floor)}`]
    .filter(Boolean)
    .join(" · ");
}

export function VariantStrip({ room }: { room: OpenRoom }) {
  const { clients } = useStudio();
  const { variantCount, jobId } = room.document.value;
  const [variants, setVariants] = useState<Variants | undefined>();
  const [isOpen, setOpen] = useState(true);
  useEffect(() => {
    if (variantCount === 0) return;
    let isGone = false;
    void fetchVariants(clients, room.document.peek())
      .catch(() => undefined)
      .then((found) => {
        if (!isGone && found) setVariants(found);
      });
    return () => {
      isGone = true;
    };
  }, [room, variantCount, jobId]);
  if (variantCount === 0) return null;
  const shown = room.layout.value?.placements ?? [];
  const list: readonly Variant[] =
    variants?.list ??
    Array.from({ length: variantCount }, (_, index) => ({ index, placements: [], held: 0, asked: 0 }));
  // It takes the place of what was changed by hand, which is offered back.
  const take = async (variant: Variant) => {
    if (variant.index < 0) return takeFirst(room, variants!);
    const { undoLabel } = room.document.peek();
    const isTaken = await room.act({ case: "takeVariant", value: { index: variant.index } });
    if (isTaken && undoLabel && !kTaken.test(undoLabel)) {
      room.tell("Your changes are not in this variant.", [{ label: "Back to them", run: () => void undo(room) }]);
    }
  };
  return (
    <section class={isOpen ? "variant-strip" : "variant-strip is-closed"} aria-label="Variants">
      <button class="variant-head" aria-expanded={isOpen} onClick={() => setOpen(!isOpen)}>
        <span>{variantCount + 1} variants</span>
        <Icon name={isOpen ? "minus" : "plus"} size={14} />
      </button>
      {isOpen && (
        <ul>
          {list.map((variant) => {
            const isShown = variants !== undefined && isSame(shown, variant.placements);
            return (
              <li key={variant.index}>
                <button
                  aria-pressed={isShown}
                  disabled={room.isBusy.value}
                  onClick={() => {
                    if (!isShown) void take(variant);
                  }}
                >
                  {variants && (
                    <SmallPlan layout={variants.layout} placements={variant.placements} parts={room.parts.value} />
                  )}
                  <span class="variant-text">
                    <strong>Variant {variant.index + 2}</strong>
                    <span>{aboutOf(variant)}</span>
                  </span>
                </button>
              </li>
            );
          })}
        </ul>
      )}
    </section>
  );
}
