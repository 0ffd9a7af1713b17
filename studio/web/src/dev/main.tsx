// SPDX-License-Identifier: GPL-3.0-or-later
// The page with a server in its own memory, to be developed and looked at without one. Never in the product.
import { startPage } from "../start";
import { fakeTransport } from "./fake_transport";

startPage(fakeTransport());
