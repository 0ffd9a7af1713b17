// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "CLI/CLI.hpp"
#include "absl/status/status.h"

namespace flair::cli {

// What is done with a batch that is there: status, watch, pause, resume, cancel, retry, delete, report, list.
void AddBatchActions(CLI::App& batch, absl::Status& result);

}  // namespace flair::cli
