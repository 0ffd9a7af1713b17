// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "absl/time/time.h"
#include "orchestrator/pipeline/stage_clients.h"
#include "orchestrator/workers/workers_of_stage.h"

namespace flair::orchestrator {

// Who is called for the stages; the workers outlive the clients.
struct StageCallers {
  WorkersOfStage& language;
  WorkersOfStage& translator;
  WorkersOfStage& optimizer;
  WorkersOfStage& renderer;
  // After this a call that is not answered is made of a second worker too; never when infinite.
  absl::Duration hedge_after = absl::InfiniteDuration();
};

// The stages as their workers. Errors say which worker, where that is set and what to do.
std::unique_ptr<StageClients> MakeGrpcStageClients(const StageCallers& callers);

}  // namespace flair::orchestrator
