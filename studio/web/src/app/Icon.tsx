// SPDX-License-Identifier: GPL-3.0-or-later
// Line icons, 16 x 16.
const paths = {
  plus: "M8 3.5v9M3.5 8h9",
  minus: "M3.5 8h9",
  fit: "M3 6V3h3M10 3h3v3M13 10v3h-3M6 13H3v-3",
  undo: "M6 4 3 7l3 3M3.5 7H10a3 3 0 0 1 0 6H7",
  redo: "m10 4 3 3-3 3M12.500 7H6a3 3 0 0 0 0 6h3",
  settle: "M2.500 13h11M5 13V9h6v4M8 2v4.500M6 4.800 8 6.800l2-2",
  sidebar: "M2.500 3.500h11v9h-11zM6.500 3.500v9",
  sun: "M8 5.200a2.800 2.800 0 1 0 0 5.600 2.800 2.800 0 0 0 0-5.600M8 1.500v1.300M8 13.200v1.300M1.500 8h1.300M13.200 8h1.300M3.400 3.400l.9.9M11.700 11.700l.9.9M3.400 12.600l.9-.9M11.700 4.300l.9-.9",
  moon: "M13 9.500A5.500 5.500 0 0 1 6.500 3a5.500 5.500 0 1 0 6.500 6.500",
  system: "M2.500 3.500h11v7.500h-11zM6 13.500h4M8 11v2.500",
  export: "M8 9.500v-7M5.300 5 8 2.300 10.700 5M3 9v4h10V9",
  close: "m4 4 8 8M12 4l-8 8",
  check: "m3.500 8.500 3 3 6-7",
  cross: "m4.500 4.500 7 7M11.500 4.500l-7 7",
  dash: "M4 8h8",
  lock: "M4 7.500h8v6H4zM5.500 7.500V5.200a2.500 2.500 0 0 1 5 0v2.300",
  unlock: "M4 7.500h8v6H4zM5.500 7.500V5.200a2.500 2.500 0 0 1 4.800-1",
  trash: "M3 4.500h10M6 4.500V3h4v1.500M4.500 4.500l.6 8.500h5.800l.6-8.500",
  copy: "M5.500 5.500h7v7h-7zM3.500 10.500v-7h7",
  turn: "M12.800 8A4.800 4.800 0 1 1 8 3.200h3M9.200 1.200l2 2-2 2",
  more: "M3.500 8h.01M8 8h.01M12.500 8h.01",
  search: "M7 2.800a4.200 4.200 0 1 0 0 8.400 4.200 4.200 0 0 0 0-8.400M10.200 10.200l3.300 3.300",
  file: "M4 2.500h5l3 3v8H4zM9 2.500v3h3",
  draw: "M3 13V3h10v6H8v4z",
  question: "M6 6a2 2 0 1 1 2.800 1.800c-.6.300-.8.700-.8 1.400M8 11.700h.01",
  swap: "M4 5.500h8.500M10 3l2.500 2.500L10 8M12 10.500H3.500M6 8l-2.500 2.500L6 13",
  warning: "M8 2.500 14 13H2zM8 6.500v3M8 11.300h.01",
  cube: "M8 2 13 4.800v6.400L8 14l-5-2.800V4.800zM3 4.800l5 2.800 5-2.800M8 7.600V14",
  plan: "M2.500 2.500h11v11h-11zM2.500 7.500h4.500M9.500 7.500h4M7 2.500v2.500",
  split: "M2.500 3h11v10h-11zM8 3v10",
  camera: "M2.500 5h2.800l1-1.700h3.400l1 1.700h2.800v8h-11zM8 6.800a2.200 2.200 0 1 0 0 4.400 2.200 2.200 0 0 0 0-4.400",
  walk: "M8.500 2.500a.8.8 0 1 0 0 1.600.8.8 0 0 0 0-1.600M6 8l1.800-2.500 2 1.700 1.700.5M7.800 6v3.200l2 1.800.4 2.700M7.600 9.500l-.8 2-1.600 2",
  orbit: "M8 5a3 3 0 1 0 0 6 3 3 0 0 0 0-6M1.500 8c0 1.500 3 2.700 6.500 2.700s6.500-1.200 6.500-2.700S11.500 5.300 8 5.300",
  chat: "M2.500 3.500h11v7.500H7l-3 2.500V11H2.500z",
  rooms: "M2.500 3h11v3h-11zM2.500 9h11v4h-11z",
  chair: "M5 2.500v6h6v-6M4 8.500h8v2.500H4zM5 11v2.500M11 11v2.500",
  pointer: "M4 2.500 12.500 8 8.600 8.900 6.700 12.500z",
  door: "M3 13.500V2.500h1.500M3 13.500h1.500M4.500 2.500a9 9 0 0 1 8.500 9M4.500 2.500v11",
  window: "M2 6h12v4H2zM2 8h12",
  socket: "M2.500 10.500a5.500 5.500 0 0 1 11 0zM8 5V2.500M2 10.500h12",
  ruler: "M2.500 5.500h11v5h-11zM5 5.500v2M7.500 5.500v3M10 5.500v2",
  picture: "M2.500 3.500h11v9h-11zM2.500 11l3.500-3.500 2.500 2.500 2-2 3 3M10.500 6h.01",
  queue: "M3 4h10M3 8h10M3 12h6",
  pause: "M5.500 3.500v9M10.500 3.500v9",
  alignWest: "M3 2.500v11M5.500 4.500h7v3h-7zM5.500 9.500h4v3h-4z",
  alignAcross: "M8 2.500v2M8 7.500v2M8 12.500v1.500M3.500 4.500h9v3h-9zM5.500 9.500h5v3h-5z",
  alignEast: "M13 2.500v11M3.500 4.500h7v3h-7zM6.500 9.500h4v3h-4z",
  alignNorth: "M2.500 3h11M4.500 5.500h3v7h-3zM9.500 5.500h3v4h-3z",
  alignAlong: "M2.500 8h2M7.500 8h2M12.500 8h1.500M4.500 3.500h3v9h-3zM9.500 5.500h3v5h-3z",
  alignSouth: "M2.500 13h11M4.500 3.500h3v7h-3zM9.500 6.500h3v4h-3z",
  spreadAcross: "M3 3v10M13 3v10M6.500 5h3v6h-3z",
  spreadAlong: "M3 3h10M3 13h10M5 6.500h6v3h-6z",
  play: "M5 3.300v9.400L12.500 8z",
} as const;

export type IconName = keyof typeof paths;

export function Icon({ name, size = 16 }: { name: IconName; size?: number }) {
  return (
    <svg class={`icon icon-${name}`} width={size} height={size} viewBox="0 0 16 16" fill="none" stroke="currentColor"
      stroke-width={name === "more" ? 2 : 1.3} stroke-linecap="round" stroke-linejoin="round" aria-hidden="true">
      <path d={paths[name]} />
    </svg>
  );
}
