// SPDX-License-Identifier: GPL-3.0-or-later
// Weights on a slider: its places are powers, from a tenth to thirty times.
export const kLeast = -1;
export const kMost = 1.5;

export const weightAt = (place: number): number => Number((10 ** place).toPrecision(2));
export const placeOf = (weight: number): number => Math.min(kMost, Math.max(kLeast, Math.log10(weight)));

const words: Array<[number, string]> = [[0.3, "hardly"], [0.75, "less"], [1.5, "as usual"], [5, "more"], [15, "much"]];

// "more" of 3: what a weight means beside the usual one.
export const weightWords = (weight: number): string => words.find(([most]) => weight <= most)?.[1] ?? "above all";
