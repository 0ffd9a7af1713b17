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

// What is measured of a room, in words for whoever lives in it; their titles explain them. Every page takes them from here.
export const measureWords = {
  uses: {
    label: "Daily use",
    title: "Everyday acts for which there is room: getting in and to each seat, bed and desk, sitting down, opening doors and drawers, getting out of bed.",
  },
  wishes: { label: "Wishes met", title: "Your wishes and the designer's that hold as things stand." },
  floor: { label: "Floor in reach", title: "How much of the free floor you can walk to from the door, through gaps of 0.6 m or more." },
} as const;

// What a stage of a job is about.
const stages: Record<string, string> = {
  brief: "Brief",
  room: "Room",
  zones: "Zones",
  objects: "Furniture",
  style: "Style",
  constraints: "Wishes",
  cleaning: "Wishes, checked",
  completion: "Wishes, completed",
  translation: "Wishes, measured",
  solve: "Layout",
  render: "Drawing",
  report: "Report",
};

export const stageWords = (stage: string): string => stages[stage] ?? stage;

export const percent = (share: number): string => `${Math.floor(share * 100 + 1e-6)} %`;

export const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

export function withStop(text: string): string {
  return /[.!?]$/.test(text) ? text : `${text}.`;
}
