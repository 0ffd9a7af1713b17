// SPDX-License-Identifier: GPL-3.0-or-later
// Where a room begins: a sentence, a drawing of one's own, or a file.
import { useEffect, useRef, useState } from "preact/hooks";
import { Icon } from "../app/Icon";
import { ModelChip } from "../model/ModelChip";
import { chooseFile } from "../app/files";
import { goTo } from "../state/route";
import { useStudio } from "../state/studio";
import examples from "./examples.json";
import { firstBrief } from "./first_brief";

const kLongest = 4000;
const kVariants = 3;

export function Start() {
  const studio = useStudio();
  const field = useRef<HTMLTextAreaElement>(null);
  const [text, setText] = useState(firstBrief.peek());
  useEffect(() => { firstBrief.value = ""; }, []);
  const [isSent, setSent] = useState(false);
  const [hasVariants, setVariants] = useState(false);
  const send = async (brief: string) => {
    if (!brief.trim() || isSent) return;
    setSent(true);
    const solveOptions = hasVariants ? { variantCount: kVariants } : undefined;
    await studio.create({ case: "design", value: { brief: { text: brief.trim() }, solveOptions } });
    setSent(false);
  };
  return (
    <div class="start">
      <h1>What room shall it be?</h1>
      <form class="brief" onSubmit={(event) => { event.preventDefault(); void send(text); }}>
        <textarea ref={field} value={text} rows={3} maxLength={kLongest} autoFocus aria-label="Brief"
          placeholder="A living room of 4 m by 6 m with a piano, two armchairs by the window and a desk..."
          onInput={(event) => setText(event.currentTarget.value)}
          onKeyDown={(event) => {
            if (event.key !== "Enter" || event.shiftKey || event.isComposing) return;
            event.preventDefault();
            void send(text);
          }} />
        <div class="brief-foot">
          <span class="hint">Say sizes, furniture, wishes. Enter designs it.</span>
          <div class="brief-options">
            <ModelChip />
            <button
              type="button"
              class="chip"
              aria-pressed={hasVariants}
              title="Three layouts of the room, side by side; take one"
              onClick={() => setVariants(!hasVariants)}
            >
              {hasVariants && <Icon name="check" size={13} />}
              Make {kVariants} variants
            </button>
            <button class="button is-primary" type="submit" disabled={!text.trim() || isSent}>
              Design
            </button>
          </div>
        </div>
      </form>
      <h2 class="eyebrow">Or try one of these</h2>
      <ul class="examples">
        {examples.map((example) => (
          <li key={example}><button onClick={() => { setText(example); void send(example); }}>{example}</button></li>
        ))}
      </ul>
      <div class="start-others">
        <button class="button" onClick={() => goTo({ page: "draw" })}><Icon name="draw" />Draw your own room</button>
        <button class="button" onClick={() => chooseFile(studio)}><Icon name="file" />Open a file</button>
      </div>
    </div>
  );
}
