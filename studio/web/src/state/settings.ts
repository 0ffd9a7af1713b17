// SPDX-License-Identifier: GPL-3.0-or-later
// What this browser remembers of how one likes the page.
import { effect, signal, type Signal } from "@preact/signals";
import type { Units } from "../app/units";

export type Theme = "system" | "light" | "dark";
export type Panes = "plan" | "split" | "3d";
export type Paper = "A4" | "A3";

function remembered<T extends string>(key: string, values: readonly T[], initial: T): Signal<T> {
  const name = `flair.${key}`;
  let stored: string | null = null;
  try {
    stored = localStorage.getItem(name);
  } catch {
    // A browser that keeps nothing starts anew each time.
  }
  const value = signal(values.find((one) => one === stored) ?? initial);
  effect(() => {
    try {
      localStorage.setItem(name, value.value);
    } catch {
      // As above.
    }
  });
  return value;
}

// The next of the values, the first after the last.
function turnOver<T extends string>(setting: Signal<T>, values: readonly T[]): void {
  setting.value = values[(values.indexOf(setting.peek()) + 1) % values.length]!;
}

export class Settings {
  readonly theme = remembered<Theme>("theme", ["system", "light", "dark"], "system");
  readonly units = remembered<Units>("units", ["m", "ft"], "m");
  readonly panes = remembered<Panes>("panes", ["plan", "split", "3d"], "plan");
  readonly autoSettle = remembered<"on" | "off">("auto-settle", ["on", "off"], "off");
  // What plans are printed on.
  readonly paper = remembered<Paper>("paper", ["A4", "A3"], "A4");
  readonly sidebar = remembered<"open" | "closed">("sidebar", ["open", "closed"], innerWidth > 900 ? "open" : "closed");

  private readonly isSystemDark = signal(false);

  constructor() {
    const dark = matchMedia("(prefers-color-scheme: dark)"), isDark = this.isSystemDark;
    isDark.value = dark.matches;
    dark.addEventListener("change", () => { isDark.value = dark.matches; });
    effect(() => {
      const theme = this.theme.value, ofSystem = isDark.value ? "dark" : "light";
      document.documentElement.dataset.theme = theme === "system" ? ofSystem : theme;
    });
  }
  // From the system's to the other one first, which can be seen.
  readonly turnTheme = () =>
    turnOver(this.theme, this.isSystemDark.peek() ? ["system", "light", "dark"] : ["system", "dark", "light"]);
  readonly turnUnits = () => turnOver(this.units, ["m", "ft"]);
  readonly turnSidebar = () => turnOver(this.sidebar, ["open", "closed"]);
  readonly turnAuto = () => turnOver(this.autoSettle, ["on", "off"]);
}
