// SPDX-License-Identifier: GPL-3.0-or-later
// How good a job's room came out, from its report.
import type { Report } from "../gen/flair/v1/report_pb";
import { measureWords } from "../inspector/words";

export interface Measures {
  // Shares, [0, 1]; undefined where nothing is measured.
  readonly held?: number;
  readonly uses?: number;
  readonly floor?: number;
}

export const measureNames = { held: measureWords.wishes, uses: measureWords.uses, floor: measureWords.floor } as const;
export type MeasureName = keyof typeof measureNames;

export function measuresOf({ metrics, constraints }: Report): Measures {
  const asked = (constraints?.satisfiedCount ?? 0) + (constraints?.violatedCount ?? 0);
  return {
    held: asked > 0 ? constraints!.satisfiedCount / asked : undefined,
    uses: metrics?.useCount ? (metrics.metUseCount ?? 0) / metrics.useCount : undefined,
    floor: metrics?.reachableFloorShare,
  };
}

export type Least = Readonly<Record<MeasureName, number>>;
export const anyMeasures: Least = { held: 0, uses: 0, floor: 0 };
export const isFiltered = (least: Least): boolean => Object.values(least).some((share) => share > 0);

// What is not measured does not pass a filter on it; what is not known yet passes none.
export function passes(measures: Measures | undefined, least: Least): boolean {
  return (Object.keys(least) as MeasureName[]).every(
    (name) => least[name] === 0 || (measures?.[name] ?? -1) >= least[name] - 1e-9,
  );
}
