// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "orchestrator/pipeline/stage_channels.h"
#include "orchestrator/pipeline/stage_clients.h"

namespace flair::orchestrator {

// The stages behind gRPC channels. An unreachable one is UNAVAILABLE with its name, address and what to do.
std::unique_ptr<StageClients> MakeGrpcStageClients(const StageChannels& channels);

}  // namespace flair::orchestrator
