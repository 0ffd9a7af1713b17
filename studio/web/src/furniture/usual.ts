// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in rooms of a kind, first in the catalogue.
import { useEffect, useState } from "preact/hooks";
import type { FurnitureOffer } from "../gen/flair/v1/studio_service_pb";
import { useStudio, type Studio } from "../state/studio";
import { usualNames } from "./usual_names";

const known = new Map<string, Promise<FurnitureOffer | undefined>>();

// The offer of that very name.
export function offerNamed(studio: Studio, name: string): Promise<FurnitureOffer | undefined> {
  const asked = known.get(name) ?? studio.clients.studio.listFurniture({ query: name })
    .then(({ offers }) => offers.find(({ object }) => object?.name === name))
    .catch(() => {
      known.delete(name);
      return undefined;
    });
  known.set(name, asked);
  return asked;
}

export function useUsual(roomType: string): readonly FurnitureOffer[] {
  const studio = useStudio();
  const [offers, setOffers] = useState<readonly FurnitureOffer[]>([]);
  useEffect(() => {
    let isStale = false;
    void Promise.all(usualNames(roomType).map((name) => offerNamed(studio, name))).then((found) => {
      if (!isStale) setOffers(found.filter((one) => one !== undefined));
    });
    return () => { isStale = true; };
  }, [roomType, studio]);
  return offers;
}
