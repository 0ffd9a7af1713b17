// SPDX-License-Identifier: GPL-3.0-or-later
import type { Polled } from "./polling";

// What went wrong with the last question, or that the first answer is not there yet.
export function Asked({ of: { value, problem } }: { of: Polled<unknown> }) {
  if (problem) return <p class="notice is-bad" role="alert">{problem}</p>;
  if (value) return null;
  return <p class="jobs-empty" aria-busy="true"><span class="spinner" /></p>;
}
