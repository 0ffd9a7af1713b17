// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "absl/status/status.h"

namespace flair::runtime {

// What a written file survives. What is not flushed is cheap; after a loss of power it may be there without its content.
enum class Durability { kProcessCrash, kPowerLoss };

// Writes the file whole or not at all, also when the process is killed or, flushed, the power fails: a temporary file
// beside it is written and renamed. RESOURCE_EXHAUSTED when the disk is full, else UNAVAILABLE, naming the path. Its
// folder must exist.
absl::Status WriteFileAtomically(const std::string& path, const std::string& bytes,
                                 Durability durability = Durability::kPowerLoss);

// Makes files survive a loss of power, all with as few waits for the disk as it allows. Files that are gone are left
// out. Errors as WriteFileAtomically.
absl::Status FlushFiles(std::span<const std::string> paths);

}  // namespace flair::runtime
