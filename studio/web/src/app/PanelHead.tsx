// SPDX-License-Identifier: GPL-3.0-or-later
// The head of a panel: at its right end, in every one, what closes it and nothing else.
import type { ComponentChildren } from "preact";
import { Icon } from "./Icon";

interface CloseProps {
  label?: string;
  title?: string;
  onClose(): void;
}

export function CloseButton({ label = "Close", title = label, onClose }: CloseProps) {
  return (
    <button type="button" class="icon-button is-close" aria-label={label} title={title} onClick={onClose}>
      <Icon name="close" />
    </button>
  );
}

export function PanelHead({ children, ...close }: CloseProps & { children: ComponentChildren }) {
  return (
    <header class="panel-head">
      {children}
      <CloseButton {...close} />
    </header>
  );
}

// What takes something out of the room says so in words, and stands apart from what closes its panel.
export function RemoveButton({ label, run }: { label: string; run(): void }) {
  return (
    <button class="button is-remove" aria-label={label} title={`${label} (Delete)`} onClick={run}>
      <Icon name="trash" />
      Remove
    </button>
  );
}
