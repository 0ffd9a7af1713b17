// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "absl/status/status.h"

namespace flair::runtime {

// Writes the file whole or not at all, also when the process is killed or the power fails: a temporary file beside it
// is flushed and renamed. RESOURCE_EXHAUSTED when the disk is full, else UNAVAILABLE, naming the path. Its folder must
// exist.
absl::Status WriteFileAtomically(const std::string& path, const std::string& bytes);

}  // namespace flair::runtime
