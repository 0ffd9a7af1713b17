// SPDX-License-Identifier: GPL-3.0-or-later
import { Icon } from "../app/Icon";
import { figure } from "../app/units";
import { ObjectKind } from "../gen/flair/v1/object_list_pb";
import type { FurnitureOffer } from "../gen/flair/v1/studio_service_pb";
import { Drawn } from "../plan/Drawn";
import { frontSymbol, plainSymbol } from "../plan/plain";
import { useStudio } from "../state/studio";
import { carried } from "./carried";

interface OfferProps {
  offer: FurnitureOffer;
  onAdd(): void;
  onReplace?: (() => void) | undefined;
}

// A piece with its plan symbol.
export function OfferTile({ offer, onAdd, onReplace }: OfferProps) {
  const { units } = useStudio().settings;
  const object = offer.object!;
  // What hangs is known by its front, all else by its plan.
  const isHung = object.kind === ObjectKind.WALL, across = isHung ? object.heightM : object.depthM;
  const size = Math.max(object.widthM, across) * 1.12;
  const sizes = [object.widthM, object.depthM, object.heightM];
  const sizesText = units.value === "m"
    ? `${sizes.map((one) => Math.round(one * 100)).join(" × ")} cm`
    : sizes.map((one) => figure(one, units.value)).join(" × ");
  return (
    <li class="offer">
      <button draggable onClick={onAdd} title={[`Add a ${object.name}: click, or drag it into the room`, object.description].filter(Boolean).join("\n")}
        onDragStart={(event) => {
          carried.value = object;
          event.dataTransfer?.setData("text/plain", object.name);
        }}
        onDragEnd={() => {
          carried.value = undefined;
        }}
      >
        <svg viewBox={`${-size / 2} ${-size / 2} ${size} ${size}`} aria-hidden="true">
          <Drawn svg={(isHung && frontSymbol(object)) || offer.svg || plainSymbol({ width: object.widthM, depth: object.depthM }, object.round)} />
        </svg>
        <span class="offer-name">{object.name}</span>
        <small title="Width, depth, height">{sizesText}</small>
      </button>
      {onReplace && (
        <button class="icon-button offer-replace" onClick={onReplace} aria-label={`Replace by the ${object.name}`}
          title="Put it in the place of the selected piece"><Icon name="swap" size={14} /></button>
      )}
    </li>
  );
}
