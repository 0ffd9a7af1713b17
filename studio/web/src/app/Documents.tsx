// SPDX-License-Identifier: GPL-3.0-or-later
import { useEffect, useState } from "preact/hooks";
import { goTo, route } from "../state/route";
import { useStudio } from "../state/studio";
import { DocumentEntry } from "./DocumentEntry";
import { Icon } from "./Icon";

// What can still be put back.
function Deleted() {
  const studio = useStudio(), deleted = studio.deleted.value;
  if (deleted.length === 0) return null;
  return (
    <details class="deleted">
      <summary>{`${deleted.length} deleted`}</summary>
      <ul>
        {deleted.map((one) => (
          <li key={one.id}>
            <span class="document-title">{one.title || "Untitled room"}</span>
            <button class="link-button" onClick={() => void studio.putBack(one)}>Put back</button>
          </li>
        ))}
      </ul>
    </details>
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
      <ul class="documents">{documents.map((one) => <DocumentEntry key={one.id} document={one} now={now} />)}</ul>
      <Deleted />
    </>
  );
}
