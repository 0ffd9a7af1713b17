// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace flair::cli {

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
  ~LineReader();
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;

  // False after the last line.
  absl::StatusOr<bool> Next(Line& line);

 private:
  LineReader(std::filesystem::path path, int file, int64_t offset, int64_t number)
      : path_(std::move(path)), file_(file), offset_(offset), number_(number) {}
  // Reads more behind what is left; false at the end of the file.
  absl::StatusOr<bool> Fill();
  // Reads up to the end of a line of which `line` has the beginning.
  absl::StatusOr<bool> SkipRest(Line& line);
  void Trim(Line& line) const;

  const std::filesystem::path path_;
  const int file_;
  // Of the next line.
  int64_t offset_;
  int64_t number_;
  std::string buffer_;
  // What of the buffer has been given out.
  size_t used_ = 0;
  // The beginning of a line that is too long.
  std::string beginning_;
};

}  // namespace flair::cli
