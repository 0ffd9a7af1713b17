// SPDX-License-Identifier: GPL-3.0-or-later
import { createContext } from "preact";
import { useContext } from "preact/hooks";
import type { PlanController } from "./controller";

export const PlanContext = createContext<PlanController | undefined>(undefined);

export function usePlan(): PlanController {
  const plan = useContext(PlanContext);
  if (!plan) throw new Error("no plan above this component");
  return plan;
}
