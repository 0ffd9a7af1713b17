// SPDX-License-Identifier: GPL-3.0-or-later
// Lengths as people write and read them. Everything else in the page is in metres.

export type Units = "m" | "ft";

const kInch = 0.0254;
const kFoot = 0.3048;

function feet(metres: number): string {
  const inches = Math.round(Math.abs(metres) / kInch);
  const whole = Math.floor(inches / 12), rest = inches % 12;
  const sign = metres < 0 && inches > 0 ? "-" : "";
  if (whole === 0) return `${sign}${rest}″`;
  return rest === 0 ? `${sign}${whole}′` : `${sign}${whole}′ ${rest}″`;
}

// "0.90 m", or "2′ 11″".
export function lengthText(metres: number, units: Units): string {
  return units === "m" ? `${metres.toFixed(2)} m` : feet(metres);
}

// The same without its unit, for figures on the plan.
export function figure(metres: number, units: Units): string {
  return units === "m" ? metres.toFixed(2) : feet(metres);
}

export function areaText(squareMetres: number, units: Units): string {
  return units === "m" ? `${squareMetres.toFixed(1)} m²` : `${(squareMetres / (kFoot * kFoot)).toFixed(0)} sq ft`;
}

const kFactors: Record<string, number> = {
  m: 1, cm: 0.01, mm: 0.001, ft: kFoot, feet: kFoot, foot: kFoot, "'": kFoot, "′": kFoot, "’": kFoot,
  in: kInch, inch: kInch, inches: kInch, '"': kInch, "″": kInch, "”": kInch, "''": kInch,
};

// Metres of "0.9", "90 cm", "3' 2\"", "3 ft 2 in"; without a unit, in `units`. Undefined when it is no length.
export function parseLength(text: string, units: Units): number | undefined {
  const trimmed = text.trim().toLowerCase().replace(/,(?=\d)/g, ".");
  const bare = /^-?\d*\.?\d+$/;
  if (bare.test(trimmed)) return Number(trimmed) * (units === "m" ? 1 : kFoot);
  const term = /(\d*\.?\d+)\s*([a-z]+|''|["'′″’”])?\s*/y;
  let metres = 0, at = 0, unit = "";
  while (at < trimmed.length) {
    term.lastIndex = at;
    const match = term.exec(trimmed);
    if (!match) return undefined;
    // The 2 of "3' 2" is inches.
    const factor = match[2] ? kFactors[match[2]] : kFactors[unit] === kFoot ? kInch : undefined;
    if (factor === undefined) return undefined;
    unit = match[2] ?? unit;
    metres += Number(match[1]) * factor;
    at = term.lastIndex;
  }
  return at > 0 ? metres : undefined;
}
