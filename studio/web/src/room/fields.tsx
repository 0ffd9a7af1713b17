// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of the room editor's panel.
import { useLayoutEffect, useRef } from "preact/hooks";
import { figure, parseLength } from "../app/units";
import { useStudio } from "../state/studio";

interface TextProps {
  label: string;
  text: string;
  // False when the text is no use; the field then shows what was there.
  take(text: string): boolean;
}

export function TextField({ label, text, take }: TextProps) {
  const input = useRef<HTMLInputElement>(null), isTyped = useRef(false);
  // What the field before has changed is shown, but what is being typed stays.
  useLayoutEffect(() => {
    const element = input.current!;
    if (isTyped.current) return;
    element.value = text;
    if (document.activeElement === element) element.select();
  }, [text]);
  return (
    <label class="field">
      <span>{label}</span>
      <input
        ref={input}
        inputMode="decimal"
        onFocus={(event) => event.currentTarget.select()}
        onInput={() => { isTyped.current = true; }}
        onBlur={(event) => {
          const typed = event.currentTarget.value;
          isTyped.current = false;
          event.currentTarget.value = text;
          if (typed !== text) take(typed);
        }}
        onKeyDown={(event) => {
          event.stopPropagation();
          if (event.key === "Escape") event.currentTarget.value = text;
          if (event.key === "Enter" || event.key === "Escape") event.currentTarget.blur();
        }}
      />
    </label>
  );
}

interface MetresProps {
  label: string;
  metres: number;
  least?: number;
  take(metres: number): void;
}

export function MetresField({ label, metres, least = 0, take }: MetresProps) {
  const units = useStudio().settings.units.value;
  return (
    <TextField
      label={label}
      text={figure(metres, units)}
      take={(text) => {
        const typed = parseLength(text, units);
        if (typed === undefined || typed < least) return false;
        take(typed);
        return true;
      }}
    />
  );
}

interface ChoiceProps<T extends string> {
  label: string;
  value: T;
  choices: ReadonlyArray<readonly [T, string]>;
  take(value: T): void;
}

export function Choice<T extends string>({ label, value, choices, take }: ChoiceProps<T>) {
  return (
    <div class="choice">
      <span>{label}</span>
      <div class="segmented is-worded" role="group" aria-label={label}>
        {choices.map(([one, text]) => (
          <button key={one} type="button" aria-pressed={one === value} onClick={() => take(one)}>
            {text}
          </button>
        ))}
      </div>
    </div>
  );
}
