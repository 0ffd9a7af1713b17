// SPDX-License-Identifier: GPL-3.0-or-later
import { useEffect, useState } from "preact/hooks";
import { JobState } from "../gen/flair/v1/job_pb";
import type { Document } from "../gen/flair/v1/studio_service_pb";
import { goTo, hashOf, route } from "../state/route";
import { useStudio } from "../state/studio";
import { Icon } from "./Icon";
import { Menu } from "./Menu";
import { whenText } from "./when";

function stateText({ jobState }: Document): string {
  if (jobState === JobState.QUEUED || jobState === JobState.RUNNING) return "in work";
  if (jobState === JobState.FAILED) return "failed";
  return "";
}

function Entry({ document, now }: { document: Document; now: Date }) {
  const studio = useStudio();
  const isOpen = studio.open.value?.id === document.id;
  const state = stateText(document);
  return (
    <li class={isOpen ? "document is-open" : "document"}>
      <a href={hashOf({ page: "document", id: document.id })} aria-current={isOpen ? "page" : undefined}>
        <span class="document-title">{document.title || "Untitled room"}</span>
        <span class={state === "failed" ? "document-when is-bad" : "document-when"}>
          {[state, whenText(document.updateTime, now)].filter(Boolean).join(" · ")}
        </span>
      </a>
      <Menu label={`More about ${document.title || "this room"}`} items={[
        { label: "Delete", isDangerous: true, run: () => void studio.forget(document.id) },
      ]}><Icon name="more" /></Menu>
    </li>
  );
}

export function Documents() {
  const studio = useStudio();
  const [now, setNow] = useState(() => new Date());
  useEffect(() => {
    const timer = setInterval(() => setNow(new Date()), 30_000);
    return () => clearInterval(timer);
  }, []);
  const documents = studio.documents.value;
  return (
    <>
      <button class="button is-wide" onClick={() => goTo({ page: "start" })}>
        <Icon name="plus" />
        New room
      </button>
      <button
        class="sidebar-link"
        aria-current={route.value.page === "jobs" ? "page" : undefined}
        onClick={() => goTo({ page: "jobs" })}
      >
        <Icon name="queue" />
        Jobs and batches
      </button>
      {documents.length === 0 && studio.isListed.value && <p class="hint">Rooms that you make are listed here.</p>}
      <ul class="documents">{documents.map((one) => <Entry key={one.id} document={one} now={now} />)}</ul>
    </>
  );
}
