// SPDX-License-Identifier: GPL-3.0-or-later
// Asks again and again while the page is looked at: browsers have six connections, and the one stream is taken.
import { useEffect, useState } from "preact/hooks";
import { isAway, sentenceOf } from "../api/problems";

const kPause = 2000;

export interface Polled<T> {
  readonly value: T | undefined;
  readonly problem: string;
  // Asks at once.
  again(): void;
}

// `key` says what is asked; another one begins anew.
export function usePolling<T>(key: string, ask: () => Promise<T>): Polled<T> {
  const [state, setState] = useState<{ key: string; value?: T; problem: string }>({ key, problem: "" });
  const [turn, setTurn] = useState(0);
  useEffect(() => {
    let timer: ReturnType<typeof setTimeout> | undefined,
      isGone = false;
    const look = async () => {
      clearTimeout(timer);
      if (document.visibilityState === "hidden") return;
      try {
        const value = await ask();
        if (!isGone) setState({ key, value, problem: "" });
      } catch (error) {
        const problem = isAway(error) ? "The server does not answer." : sentenceOf(error);
        if (!isGone) setState((before) => ({ ...before, key, problem }));
      }
      if (!isGone) timer = setTimeout(look, kPause);
    };
    void look();
    document.addEventListener("visibilitychange", look);
    return () => {
      isGone = true;
      clearTimeout(timer);
      document.removeEventListener("visibilitychange", look);
    };
  }, [key, turn]);
  return {
    value: state.key === key ? state.value : undefined,
    problem: state.key === key ? state.problem : "",
    again: () => setTurn(turn + 1),
  };
}
