// SPDX-License-Identifier: GPL-3.0-or-later
import type { OpenRoom } from "../state/open_room";

// Other layouts of the same pieces, to be looked at one by one; undo goes back.
export function Variants({ room }: { room: OpenRoom }) {
  const { variantCount } = room.document.value;
  if (variantCount === 0) return null;
  return (
    <section>
      <h3 class="eyebrow">Other layouts</h3>
      <div class="variants">
        {Array.from({ length: variantCount }, (_, index) => (
          <button key={index} class="button" disabled={room.isBusy.value} aria-label={`Show layout ${index + 2}`}
            onClick={() => void room.act({ case: "takeVariant", value: { index } })}>{index + 2}</button>
        ))}
      </div>
    </section>
  );
}
