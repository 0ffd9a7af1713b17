// SPDX-License-Identifier: GPL-3.0-or-later
import { lengthText, type Units } from "../app/units";
import type { Demand } from "./note";

// "0.12 m short" of a demand that is missed by a number.
export function missedText({ missed_by: by, unit }: Demand, units: Units): string {
  if (by === undefined) return "";
  if (unit === "m") return `${lengthText(by, units)} short`;
  if (unit === "deg") return `${by.toFixed(0)}° off`;
  if (unit === "m2") return `${by.toFixed(2)} m² short`;
  return `${(by * 100).toFixed(0)} % short`;
}

export const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

export function withStop(text: string): string {
  return /[.!?]$/.test(text) ? text : `${text}.`;
}
