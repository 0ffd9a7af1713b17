// SPDX-License-Identifier: GPL-3.0-or-later
import { Icon } from "../app/Icon";
import { CloseButton } from "../app/PanelHead";
import type { OpenRoom } from "../state/open_room";
import { capital } from "./words";

const words = { lost: "No longer: ", further: "Further from: " };

// What the last act has cost or brought elsewhere, until it is closed or the next act: first what got worse, the worst
// first. It lies over the end of the panel, so that nothing above it moves.
export function EffectCard({ room }: { room: OpenRoom }) {
  const effect = room.effect.value;
  if (!effect || effect.gained.length + effect.worse.length === 0) return null;
  return (
    <section class="effect" aria-label="What the last change did">
      <header>
        <h3 class="eyebrow">The last change</h3>
        <CloseButton onClose={() => { room.effect.value = undefined; }} />
      </header>
      <ul>
        {effect.worse.map(({ text, how }) => (
          <li key={text} class="is-lost">
            <Icon name="cross" size={13} />
            <span>{how === "fault" ? capital(room.spoken(text)) : `${words[how]}${room.spoken(text)}`}</span>
          </li>
        ))}
        {effect.gained.map(({ text }) => (
          <li key={text} class="is-gained">
            <Icon name="check" size={13} />
            <span>Now: {room.spoken(text)}</span>
          </li>
        ))}
      </ul>
    </section>
  );
}
