// SPDX-License-Identifier: GPL-3.0-or-later
// Every `title` of the page as a tip: sooner than browsers show them, and at the keyboard's focus too.
import { useEffect, useRef } from "preact/hooks";

const kMilliseconds = 450;
const kGap = 6;

function placed(tip: HTMLElement, at: DOMRect): void {
  const { width, height } = tip.getBoundingClientRect();
  const x = Math.min(Math.max(at.left + at.width / 2 - width / 2, kGap), innerWidth - width - kGap);
  const below = at.bottom + kGap, y = below + height < innerHeight - kGap ? below : at.top - kGap - height;
  tip.style.transform = `translate(${Math.round(x)}px, ${Math.round(y)}px)`;
}

export function Tips() {
  const tip = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const element = tip.current!;
    let owner: Element | undefined, title = "", timer: ReturnType<typeof setTimeout> | undefined;
    const hide = () => {
      clearTimeout(timer);
      if (owner && !owner.hasAttribute("title")) owner.setAttribute("title", title);
      owner = undefined;
      element.hidden = true;
    };
    const show = () => {
      if (!owner?.isConnected) return hide();
      element.textContent = title;
      element.hidden = false;
      placed(element, owner.getBoundingClientRect());
    };
    // The browser's own tip stays away while this one is there.
    const look = (event: Event) => {
      const next = (event.target as Element).closest?.("[title]") ?? undefined;
      if (next && next === owner) return;
      if (owner?.contains(event.target as Node)) return;
      hide();
      if (!next || (event.type === "focusin" && !next.matches(":focus-visible"))) return;
      owner = next;
      title = next.getAttribute("title")!;
      if (!title) return;
      next.removeAttribute("title");
      timer = setTimeout(show, kMilliseconds);
    };
    const events = { pointerover: look, focusin: look, pointerdown: hide, keydown: hide, dragstart: hide, scroll: hide, focusout: hide };
    for (const [name, listener] of Object.entries(events)) addEventListener(name, listener, true);
    return () => {
      hide();
      for (const [name, listener] of Object.entries(events)) removeEventListener(name, listener, true);
    };
  }, []);
  // What it says, its owner says to screen readers.
  return <div class="tip" ref={tip} hidden aria-hidden="true" />;
}
