// SPDX-License-Identifier: GPL-3.0-or-later
import type { Signal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";

export interface MenuItem {
  readonly label: string;
  readonly hint?: string;
  readonly isDangerous?: boolean;
  run(): void;
}

// One of a few values, all to be seen; the menu stays open.
export interface MenuChoice {
  readonly label: string;
  readonly values: readonly string[];
  readonly setting: Signal<string>;
}

interface MenuProps {
  label: string;
  class?: string;
  items: ReadonlyArray<MenuItem | MenuChoice | "line">;
  children: ComponentChildren;
}

function Choice({ choice: { label, values, setting } }: { choice: MenuChoice }) {
  return (
    <div class="menu-choice" role="group" aria-label={label}>
      <span>{label}</span>
      <div class="segmented">
        {values.map((value) => (
          <button key={value} role="menuitemradio" tabIndex={-1} aria-checked={setting.value === value}
            onClick={() => { setting.value = value; }}>{value}</button>
        ))}
      </div>
    </div>
  );
}

// A button with a menu below it: arrows go through it, escape closes it.
export function Menu({ label, class: name = "icon-button", items, children }: MenuProps) {
  const [isOpen, setOpen] = useState(false);
  const root = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (!isOpen) return;
    root.current!.querySelector<HTMLElement>("[role=menuitem]")?.focus();
    const outside = (event: PointerEvent) => { if (!root.current!.contains(event.target as Node)) setOpen(false); };
    addEventListener("pointerdown", outside, true);
    return () => removeEventListener("pointerdown", outside, true);
  }, [isOpen]);
  const close = () => {
    setOpen(false);
    root.current!.querySelector("button")!.focus();
  };
  const onKeyDown = (event: KeyboardEvent) => {
    if (!isOpen) return;
    const entries = [...root.current!.querySelectorAll<HTMLElement>("[role^=menuitem]")];
    const at = entries.indexOf(document.activeElement as HTMLElement);
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (by) entries[(at + by + entries.length) % entries.length]!.focus();
    else if (event.key === "Escape") close();
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <div class="menu" ref={root} onKeyDown={onKeyDown}>
      <button
        class={name}
        aria-label={label}
        title={label}
        aria-haspopup="menu"
        aria-expanded={isOpen}
        onClick={() => setOpen(!isOpen)}
      >
        {children}
      </button>
      {isOpen && (
        <div class="menu-list" role="menu" aria-label={label}>
          {items.map((item, i) => item === "line" ? <hr key={i} /> : "setting" in item ? <Choice key={i} choice={item} /> : (
            <button key={i} role="menuitem" tabIndex={-1} class={item.isDangerous ? "is-dangerous" : ""}
              onClick={() => { close(); item.run(); }}>
              <span>{item.label}</span>
              {item.hint && <small>{item.hint}</small>}
            </button>
          ))}
        </div>
      )}
    </div>
  );
}
