// SPDX-License-Identifier: GPL-3.0-or-later
// The page of the studio; its server is the one it came from.
import { createConnectTransport } from "@connectrpc/connect-web";
import { startPage } from "./start";

startPage(createConnectTransport({ baseUrl: location.origin, useBinaryFormat: false }));
