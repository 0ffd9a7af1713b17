// SPDX-License-Identifier: GPL-3.0-or-later
// Starts the page over a transport.
import type { Transport } from "@connectrpc/connect";
import { render } from "preact";
import { makeClients } from "./api/clients";
import { App } from "./app/App";
import { Studio, StudioContext } from "./state/studio";
import "./styles/main.css";

export function startPage(transport: Transport): void {
  const studio = new Studio(makeClients(transport));
  render(<StudioContext.Provider value={studio}><App /></StudioContext.Provider>, document.getElementById("app")!);
}
