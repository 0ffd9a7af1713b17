// SPDX-License-Identifier: GPL-3.0-or-later
import type { Studio } from "../state/studio";

// Its document hears of it when it has ended.
export const cancelJob = (studio: Studio, jobId: string) =>
  studio.told(() => studio.clients.orchestrator.cancelJob({ jobId }));
