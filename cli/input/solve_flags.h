// SPDX-License-Identifier: GPL-3.0-or-later
// How to solve, as a person says it: flags, or a file, or both.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "CLI/CLI.hpp"
#include "absl/status/statusor.h"
#include "flair/v1/optimizer_service.pb.h"

namespace flair::cli {

struct SolveFlags {
  std::string file;
  std::optional<int64_t> seed;
  std::optional<int> restarts;
  std::optional<int> threads;
  std::optional<int> variants;
  std::optional<double> path_width_m;
  std::optional<double> time_limit_s;
  std::string misfits;
  bool contradictions = false;
  // "name=value"
  std::vector<std::string> lambdas;
  std::vector<std::string> tolerances;
};

// Adds the flags to a command; `flags` must outlive it.
void AddSolveFlags(CLI::App& command, SolveFlags& flags);

// The options of the file with those of the flags over them. INVALID_ARGUMENT names file and line, or flag and value,
// and says what would be right. Ranges are checked by the optimizer.
absl::StatusOr<v1::SolveOptions> ReadSolveFlags(const SolveFlags& flags);

}  // namespace flair::cli
