// SPDX-License-Identifier: GPL-3.0-or-later
// A room in the list, with what can be done with it as a whole.
import { useState } from "preact/hooks";
import { JobState } from "../gen/flair/v1/job_pb";
import type { Document } from "../gen/flair/v1/studio_service_pb";
import { hashOf } from "../state/route";
import { useStudio } from "../state/studio";
import { Icon } from "./Icon";
import { Menu } from "./Menu";
import { whenText } from "./when";

function stateText({ jobState }: Document): string {
  if (jobState === JobState.QUEUED || jobState === JobState.RUNNING) return "in work";
  if (jobState === JobState.FAILED) return "failed";
  return "";
}

function NameField({ document, onClose }: { document: Document; onClose(): void }) {
  const studio = useStudio();
  const take = (typed: string) => {
    const title = typed.trim().slice(0, 200);
    if (title && title !== document.title) void studio.rename(document, title);
    onClose();
  };
  return (
    <input class="document-name" defaultValue={document.title} aria-label="Name of the room" maxLength={200}
      spellcheck={false} ref={(input) => { if (input && input.ownerDocument.activeElement !== input) input.select(), input.focus(); }}
      onBlur={(event) => take(event.currentTarget.value)}
      onKeyDown={(event) => {
        event.stopPropagation();
        if (event.key === "Escape") event.currentTarget.value = document.title;
        if (event.key === "Enter" || event.key === "Escape") event.currentTarget.blur();
      }} />
  );
}

export function DocumentEntry({ document, now }: { document: Document; now: Date }) {
  const studio = useStudio();
  const [isNaming, setNaming] = useState(false);
  const isOpen = studio.open.value?.id === document.id;
  const state = stateText(document), title = document.title || "Untitled room";
  if (isNaming) return <li class="document"><NameField document={document} onClose={() => setNaming(false)} /></li>;
  return (
    <li class={isOpen ? "document is-open" : "document"}>
      <a href={hashOf({ page: "document", id: document.id })} aria-current={isOpen ? "page" : undefined}
        title={title.length > 52 ? title : undefined}>
        <span class="document-title">{title}</span>
        <span class={state === "failed" ? "document-when is-bad" : "document-when"}>
          {[state, whenText(document.updateTime, now)].filter(Boolean).join(" · ")}
        </span>
      </a>
      <Menu label={`More about ${title}`} items={[
        { label: "Rename", run: () => setNaming(true) },
        { label: "Copy", run: () => void studio.copy(document) },
        "line",
        { label: "Delete", isDangerous: true, run: () => void studio.forget(document) },
      ]}><Icon name="more" /></Menu>
    </li>
  );
}
