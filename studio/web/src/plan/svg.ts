// SPDX-License-Identifier: GPL-3.0-or-later
// SVG of the server as elements: the server's policy forbids scripts, and what could run one is left out here as well.
const kForbidden = "script, foreignObject, iframe, a, use, image, animate, set, style";

export function elementsOf(svg: string): SVGElement[] {
  if (!svg) return [];
  const wrapped = `<svg xmlns="http://www.w3.org/2000/svg">${svg}</svg>`;
  const parsed = new DOMParser().parseFromString(wrapped, "image/svg+xml").documentElement;
  if (parsed.querySelector("parsererror")) return [];
  parsed.querySelectorAll(kForbidden).forEach((element) => element.remove());
  parsed.querySelectorAll("*").forEach((element) => {
    for (const name of element.getAttributeNames()) if (/^on/i.test(name)) element.removeAttribute(name);
  });
  return [...parsed.children].map((child) => document.importNode(child, true) as SVGElement);
}
