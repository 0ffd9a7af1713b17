// SPDX-License-Identifier: GPL-3.0-or-later
// The file of briefs: read once to know which it is, then line by line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>

#include "absl/status/status.h"
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

// One line of a file that may be larger than memory.
struct Line {
  // From 1 on.
  int64_t number = 0;
  // Without its break (\n or \r\n), valid until the next one is read; of a line that is too long, its beginning.
  std::string_view text;
  bool too_long = false;
  // Where the next line begins, bytes from the file's beginning.
  int64_t end_offset = 0;
};

// Reads a file line by line. A byte order mark before the first line is left out.
class LineReader {
 public:
  // The longest line that is read whole.
  static constexpr size_t kLongestLine = 4u << 20;

  // Begins at the byte `offset`, where a line begins, the first of which has `number`. Errors as ReadFile; a pipe is
  // none.
  static absl::StatusOr<std::unique_ptr<LineReader>> Open(const std::filesystem::path& path, int64_t offset = 0,
                                                          int64_t number = 1);

  // False after the last line.
  absl::StatusOr<bool> Next(Line& line);

 private:
  LineReader(std::filesystem::path path, int64_t offset, int64_t number);

  const std::filesystem::path path_;
  std::ifstream file_;
  // Of the next line.
  int64_t offset_;
  int64_t number_;
  std::string buffer_;
};

}  // namespace flair::cli
