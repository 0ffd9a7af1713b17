// SPDX-License-Identifier: GPL-3.0-or-later
// Short messages that come and go.
import { signal } from "@preact/signals";

// What one can do about it by a click.
export interface ToastAct {
  readonly label: string;
  run(): void;
}

export interface Toast {
  readonly id: number;
  readonly kind: "error" | "note" | "offer";
  readonly text: string;
  readonly acts: readonly ToastAct[];
}

const kMilliseconds = { error: 9000, note: 5000, offer: 15000 };

export class Toasts {
  readonly shown = signal<readonly Toast[]>([]);
  private last = 0;

  error(text: string): void {
    this.add("error", text);
  }

  note(text: string): void {
    this.add("note", text);
  }

  // Stays longer than what is only to be read.
  offer(text: string, acts: readonly ToastAct[]): void {
    this.add("offer", text, acts);
  }

  dismiss(id: number): void {
    this.shown.value = this.shown.value.filter((one) => one.id !== id);
  }

  private add(kind: Toast["kind"], text: string, acts: readonly ToastAct[] = []): void {
    const same = this.shown.value.find((one) => one.text === text);
    if (same) this.dismiss(same.id);
    const id = ++this.last;
    this.shown.value = [...this.shown.value.slice(-3), { id, kind, text, acts }];
    setTimeout(() => this.dismiss(id), kMilliseconds[kind]);
  }
}
