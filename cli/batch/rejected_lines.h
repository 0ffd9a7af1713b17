// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "absl/status/status.h"

namespace flair::cli {

// rejected.jsonl: the lines that are no briefs, one JSON object each: {"line": 7, "reason": "...", "text": "..."}.
class RejectedLines {
 public:
  explicit RejectedLines(std::filesystem::path path) : path_(std::move(path)) {}

  // Goes on behind the first `size_bytes` of what an earlier submission wrote and forgets the rest of it.
  absl::Status Open(int64_t size_bytes);
  // Of long texts the beginning.
  void Add(int64_t line, const std::string& reason, std::string_view text);
  // Returns when all is written; FAILED_PRECONDITION when it is not.
  absl::Status Flush();
  int64_t size_bytes() const { return size_bytes_; }

 private:
  const std::filesystem::path path_;
  std::ofstream file_;
  int64_t size_bytes_ = 0;
};

}  // namespace flair::cli
