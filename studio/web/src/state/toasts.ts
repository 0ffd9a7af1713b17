// SPDX-License-Identifier: GPL-3.0-or-later
// Short messages that come and go.
import { signal } from "@preact/signals";

export interface Toast {
  readonly id: number;
  readonly kind: "error" | "note";
  readonly text: string;
}

const kMilliseconds = { error: 9000, note: 5000 };

export class Toasts {
  readonly shown = signal<readonly Toast[]>([]);
  private last = 0;

  error(text: string): void {
    this.add("error", text);
  }

  note(text: string): void {
    this.add("note", text);
  }

  dismiss(id: number): void {
    this.shown.value = this.shown.value.filter((one) => one.id !== id);
  }

  private add(kind: Toast["kind"], text: string): void {
    const same = this.shown.value.find((one) => one.text === text);
    if (same) this.dismiss(same.id);
    const id = ++this.last;
    this.shown.value = [...this.shown.value.slice(-3), { id, kind, text }];
    setTimeout(() => this.dismiss(id), kMilliseconds[kind]);
  }
}
