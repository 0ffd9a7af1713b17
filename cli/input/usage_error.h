// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "CLI/CLI.hpp"
#include "absl/status/status.h"

namespace flair::cli {

// What is wrong with a command line, as every other error is told: what, and what would be right. INVALID_ARGUMENT.
// `program` is the one whose parse threw `error`.
absl::Status UsageError(const CLI::App& program, const CLI::ParseError& error);

}  // namespace flair::cli
