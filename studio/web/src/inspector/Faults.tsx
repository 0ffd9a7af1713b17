// SPDX-License-Identifier: GPL-3.0-or-later
import { faultsOf } from "../state/faults";
import type { OpenRoom } from "../state/open_room";
import type { Piece } from "../state/pieces";
import { capital, withStop } from "./words";

// What is wrong in the room, or with these pieces. A click selects what it is about.
export function Faults({ room, of, title }: { room: OpenRoom; of?: readonly Piece[]; title?: string }) {
  const ids = of && new Set(of.map(({ id }) => id));
  const faults = faultsOf(room).filter((one) => !ids || ids.has(one.objectId) || ids.has(one.partnerId));
  if (faults.length === 0) return null;
  const isNamed = (id: string) => room.pieces.value.has(id);
  return (
    <section class="faults">
      {title && <h3 class="eyebrow">{title}</h3>}
      <ul class="notices">
        {faults.map(({ objectId, partnerId, message }) => (
          <li key={`${objectId} ${message}`} class="notice is-bad">
            <button onClick={() => room.select([objectId, partnerId].filter(isNamed))}>
              {withStop(capital(room.spoken(message)))}
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}
