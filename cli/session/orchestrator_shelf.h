// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "cli/input/artifact_shelf.h"

namespace flair::cli {

// What an orchestrator keeps, asked for with its RPCs. Ids are looked for among its latest 1000 jobs. INVALID_ARGUMENT
// for an address that is none; who does not answer is UNAVAILABLE at the first question.
absl::StatusOr<std::unique_ptr<ArtifactShelf>> OpenOrchestratorShelf(const std::string& address);

}  // namespace flair::cli
