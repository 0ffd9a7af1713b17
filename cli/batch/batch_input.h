// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "absl/status/statusor.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::cli {

// A file of briefs, read once to know which it is; it is read a second time to submit it.
struct BatchInput {
  // Where the lines are: the file itself, or a copy of what came by a pipe.
  std::filesystem::path path;
  // Of all its bytes, lower-case hex.
  std::string sha256;
  int64_t size_bytes = 0;
  // What people know it by: the file's name.
  std::string name;
};

// `given` is a file, or "-" for standard input; that and other pipes are first copied to `copy`.
// NOT_FOUND, FAILED_PRECONDITION for what cannot be read; INVALID_ARGUMENT for an empty file and for one that is of
// another kind than text; CANCELLED when `stop` is asked for meanwhile.
absl::StatusOr<BatchInput> OpenBatchInput(const std::string& given, const std::filesystem::path& copy,
                                          runtime::Cancellation& stop);

}  // namespace flair::cli
