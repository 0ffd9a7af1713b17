// SPDX-License-Identifier: GPL-3.0-or-later
import { createContext } from "preact";
import { useContext } from "preact/hooks";
import type { RoomDrawing } from "./controller";

export const DrawingContext = createContext<RoomDrawing | undefined>(undefined);

export function useDrawing(): RoomDrawing {
  const drawing = useContext(DrawingContext);
  if (!drawing) throw new Error("no room drawing above this component");
  return drawing;
}
