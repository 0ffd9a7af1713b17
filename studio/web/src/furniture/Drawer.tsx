// SPDX-License-Identifier: GPL-3.0-or-later
// Furniture to add: searched, dragged into the room, or put into its middle by a click.
import { useEffect, useState } from "preact/hooks";
import { Icon } from "../app/Icon";
import { ObjectKind } from "../gen/flair/v1/object_list_pb";
import type { FurnitureOffer } from "../gen/flair/v1/studio_service_pb";
import { addPieceSomewhere, replacePiece } from "../state/commands";
import type { OpenRoom } from "../state/open_room";
import { theName } from "../state/pieces";
import { useStudio } from "../state/studio";
import { OfferTile } from "./OfferTile";
import { offerSeat } from "./seat";
import { useUsual } from "./usual";

const kPause = 120;

function useOffers(query: string): readonly FurnitureOffer[] | undefined {
  const studio = useStudio();
  const [offers, setOffers] = useState<readonly FurnitureOffer[]>();
  useEffect(() => {
    let isStale = false;
    const timer = setTimeout(async () => {
      const answer = await studio.told(() => studio.clients.studio.listFurniture({ query }));
      if (!isStale && answer) setOffers(answer.offers);
    }, query ? kPause : 0);
    return () => {
      isStale = true;
      clearTimeout(timer);
    };
  }, [query, studio]);
  return offers;
}

// Own models may be called alike.
const keyOf = ({ object }: FurnitureOffer): string =>
  [object?.name, object?.category, object?.widthM, object?.depthM, object?.heightM].join(" ");

// What stands on the floor first, then rugs and what goes on walls, tables and ceilings.
function groupsOf(offers: readonly FurnitureOffer[]): Array<{ name: string; offers: FurnitureOffer[] }> {
  const groups = new Map<string, FurnitureOffer[]>();
  for (const offer of offers) groups.set(offer.group, [...(groups.get(offer.group) ?? []), offer]);
  const isSmall = (list: readonly FurnitureOffer[]) =>
    !list.some(({ object }) => object?.kind === ObjectKind.FLOOR && !object.walkOver);
  return [...groups]
    .map(([name, list]) => ({ name: name.replace(/_/g, " "), offers: list }))
    .sort((a, b) => Number(isSmall(a.offers)) - Number(isSmall(b.offers)));
}

export function Drawer({ room }: { room: OpenRoom }) {
  const [query, setQuery] = useState("");
  const offers = useOffers(query.trim());
  const chosen = [...room.selection.value].flatMap((id) => room.pieces.value.get(id) ?? []);
  const replaced = chosen.length === 1 ? chosen[0] : undefined;
  const studio = useStudio();
  const roomType = room.layout.value?.graph?.room?.roomType ?? "";
  const usual = useUsual(roomType);
  const isSearch = query.trim() !== "";
  // Answers to a search come best first; the rest by what it is, after what such a room usually has.
  const groups = isSearch
    ? [{ name: "found", offers: offers ?? [] }]
    : [...(usual.length > 0 ? [{ name: `for the ${roomType.replace(/_/g, " ")}`, offers: usual }] : []), ...groupsOf(offers ?? [])];
  const add = async (offer: FurnitureOffer) => {
    if (await addPieceSomewhere(room, offer.object!)) await offerSeat(studio, room);
  };
  return (
    <div class="drawer">
      <label class="search">
        <Icon name="search" />
        <input type="search" value={query} placeholder="Search furniture" aria-label="Search furniture"
          onInput={(event) => setQuery(event.currentTarget.value)} />
      </label>
      {replaced && <p class="hint"><Icon name="swap" size={13} /> replaces {theName(replaced.object)}.</p>}
      {offers?.length === 0 && <p class="hint">Nothing is called that.</p>}
      {groups.filter((group) => group.offers.length > 0).map((group) => (
        <section key={group.name}>
          <h3 class="eyebrow">{group.name}</h3>
          <ul class="offers">
            {group.offers.filter((offer) => offer.object).map((offer) => (
              <OfferTile key={keyOf(offer)} offer={offer} onAdd={() => void add(offer)}
                onReplace={replaced && (() => void replacePiece(room, replaced.id, offer.object!))} />
            ))}
          </ul>
        </section>
      ))}
    </div>
  );
}
