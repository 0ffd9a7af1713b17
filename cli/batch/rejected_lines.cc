// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/rejected_lines.h"

#include <system_error>

#include "cli/exit_code.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"

namespace flair::cli {
namespace {

// A line that was wrong is mostly short; one that has no end must not fill the disk.
constexpr size_t kLongestText = 64 << 10;

}  // namespace

absl::Status RejectedLines::Open(int64_t size_bytes) {
  std::error_code error;
  size_bytes_ = size_bytes;
  if (std::filesystem::exists(path_, error)) {
    if (size_bytes == 0) {
      std::filesystem::remove(path_, error);
    } else {
      std::filesystem::resize_file(path_, static_cast<uintmax_t>(size_bytes), error);
    }
  }
  if (!error) return absl::OkStatus();
  return FileError(fmt::format("{}: cannot be written: {}", path_.string(), error.message()));
}

void RejectedLines::Add(int64_t line, const std::string& reason, std::string_view text) {
  // The file is made for the first of them.
  if (!file_.is_open()) file_.open(path_, std::ios::app | std::ios::binary);
  const nlohmann::ordered_json object = {
      {"line", line}, {"reason", reason}, {"text", std::string(text.substr(0, kLongestText))}};
  const std::string written = object.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  file_ << written;
  size_bytes_ += static_cast<int64_t>(written.size());
}

absl::Status RejectedLines::Flush() {
  if (!file_.is_open() && size_bytes_ == 0) return absl::OkStatus();
  if (file_.is_open()) file_.flush();
  if (!file_.fail()) return absl::OkStatus();
  return FileError(fmt::format("{}: cannot be written; is the disk full?", path_.string()));
}

}  // namespace flair::cli
