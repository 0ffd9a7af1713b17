// SPDX-License-Identifier: GPL-3.0-or-later
// The servers that the page talks to, over whatever transport it is given.
import { createClient, type Client, type Transport } from "@connectrpc/connect";
import { OrchestratorService } from "../gen/flair/v1/orchestrator_service_pb";
import { StudioService } from "../gen/flair/v1/studio_service_pb";

export interface Clients {
  readonly studio: Client<typeof StudioService>;
  readonly orchestrator: Client<typeof OrchestratorService>;
}

export function makeClients(transport: Transport): Clients {
  return {
    studio: createClient(StudioService, transport),
    orchestrator: createClient(OrchestratorService, transport),
  };
}
