// SPDX-License-Identifier: GPL-3.0-or-later
// What the pointer is on stays below it while an answer changes what stands above it in a panel that scrolls.
import { useEffect, type MutableRef } from "preact/hooks";

export interface Scrolled {
  readonly top: number;
  // The farthest that it scrolls; negative by what its content lacks to fill it.
  readonly most: number;
}

export interface Correction {
  readonly top: number;
  // Room that is lacking above and below for that much scrolling.
  readonly above: number;
  readonly below: number;
}

// How to scroll after something went down by `by` pixels, up when negative.
export function corrected(by: number, { top, most }: Scrolled): Correction {
  const wanted = top + by;
  return { top: Math.max(wanted, 0), above: Math.max(-wanted, 0), below: Math.max(wanted - most, 0) };
}

function mostOf(element: HTMLElement): number {
  const end = element.lastElementChild?.getBoundingClientRect().bottom ?? 0;
  const padding = parseFloat(getComputedStyle(element).paddingBottom);
  return end - element.getBoundingClientRect().top + element.scrollTop + padding - element.clientHeight;
}

const kHeld = "li, label, header";

export function useStill(panel: MutableRef<HTMLElement | null>): void {
  useEffect(() => {
    const element = panel.current!;
    let held: Element | undefined, at = 0, above = 0, below = 0;
    const look = () => { if (held) at = held.getBoundingClientRect().top; };
    const pad = () => {
      element.style.setProperty("--above", `${above}px`);
      element.style.setProperty("--below", `${below}px`);
    };
    const over = (event: Event) => {
      held = (event.target as Element).closest(kHeld) ?? undefined;
      look();
    };
    const leave = () => {
      held = undefined;
      above = below = 0;
      pad();
    };
    const keep = () => {
      // Another panel is shown.
      if (held && !held.isConnected) leave();
      if (!held) return;
      const by = held.getBoundingClientRect().top - at;
      if (Math.abs(by) < 1) return;
      const to = corrected(by, { top: element.scrollTop, most: mostOf(element) });
      above += to.above;
      below += to.below;
      pad();
      element.scrollTop = to.top;
    };
    const observer = new MutationObserver(keep);
    observer.observe(element, { subtree: true, childList: true, characterData: true });
    element.addEventListener("pointermove", over);
    element.addEventListener("pointerleave", leave);
    element.addEventListener("scroll", look);
    return () => {
      observer.disconnect();
      element.removeEventListener("pointermove", over);
      element.removeEventListener("pointerleave", leave);
      element.removeEventListener("scroll", look);
    };
  }, []);
}
