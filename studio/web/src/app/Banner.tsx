// SPDX-License-Identifier: GPL-3.0-or-later
import type { Connection } from "../api/watch";
import { useStudio } from "../state/studio";
import { Icon } from "./Icon";

const words: Partial<Record<Connection, string>> = {
  away: "The studio's server does not answer. What you see is kept; it is tried again every few seconds.",
  refused: "The studio was started anew. Open the address that it has printed; your rooms are kept.",
};

// Over the page while there is no server; what is shown stays, also where it is.
export function Banner() {
  const text = words[useStudio().connection.value];
  return text ? <div class="banner" role="status"><Icon name="warning" /><span>{text}</span></div> : null;
}
