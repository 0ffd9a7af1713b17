// SPDX-License-Identifier: GPL-3.0-or-later
// Short messages that come and go; the latest is seen, those before it wait below it.
import { computed, signal } from "@preact/signals";
import { capital, withStop } from "../inspector/words";

// What one can do about it by a click.
export interface ToastAct {
  readonly label: string;
  run(): void;
}

export interface Toast {
  readonly id: number;
  readonly kind: "error" | "warning" | "note" | "offer";
  readonly text: string;
  readonly acts: readonly ToastAct[];
}

const kMilliseconds = { error: 12000, warning: 12000, note: 6000, offer: 20000 };
const kMost = 4;
// How soon it is looked again whether somebody still reads.
const kHeldMilliseconds = 2000;

export class Toasts {
  readonly shown = signal<readonly Toast[]>([]);
  readonly latest = computed(() => this.shown.value.at(-1));
  // While the pointer or the focus is on them, none goes.
  isHeld = false;
  // Nor while all of them are listed.
  readonly isListed = signal(false);
  private last = 0;

  error(text: string): void {
    this.add("error", text);
  }

  note(text: string): void {
    this.add("note", text);
  }

  // What is not done, and what can be done about it.
  warn(text: string, acts: readonly ToastAct[] = []): void {
    this.add("warning", text, acts);
  }

  // Stays longer than what is only to be read. Its id is for whoever withdraws it.
  offer(text: string, acts: readonly ToastAct[]): number {
    return this.add("offer", text, acts);
  }

  dismiss(id: number): void {
    this.shown.value = this.shown.value.filter((one) => one.id !== id);
    if (this.shown.peek().length < 2) this.isListed.value = false;
  }

  private add(kind: Toast["kind"], said: string, acts: readonly ToastAct[] = []): number {
    const text = withStop(capital(said.trim()));
    const same = this.shown.value.find((one) => one.text === text);
    if (same) this.dismiss(same.id);
    const id = ++this.last;
    this.shown.value = [...this.shown.value.slice(1 - kMost), { id, kind, text, acts }];
    this.expire(id, kMilliseconds[kind]);
    return id;
  }

  private expire(id: number, milliseconds: number): void {
    setTimeout(() => {
      if (this.isHeld || this.isListed.peek()) this.expire(id, kHeldMilliseconds);
      else this.dismiss(id);
    }, milliseconds);
  }
}
