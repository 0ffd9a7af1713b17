// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/openai/sse_reader.h"

#include <algorithm>
#include <utility>

namespace flair::llm {

absl::Status SseReader::Take(std::string_view piece, const OnEvent& on_event) {
  while (!piece.empty()) {
    if (std::exchange(after_cr_, false) && piece.front() == '\n') piece.remove_prefix(1);
    // Two searches for one byte are faster than one for two.
    const size_t line_feed = piece.find('\n');
    const size_t end = std::min(line_feed, piece.substr(0, line_feed).find('\r'));
    if (end == std::string_view::npos) {
      line_ += piece;
      return absl::OkStatus();
    }
    // Nearly every line lies within one piece and is read where it is.
    std::string_view line = piece.substr(0, end);
    if (!line_.empty()) line = line_ += line;
    after_cr_ = piece[end] == '\r';
    piece.remove_prefix(end + 1);
    if (auto status = TakeLine(line, on_event); !status.ok()) return status;
    line_.clear();
  }
  return absl::OkStatus();
}

absl::Status SseReader::Finish(const OnEvent& on_event) {
  const std::string line = std::exchange(line_, {});
  if (auto status = TakeLine(line, on_event); !status.ok()) return status;
  return TakeLine("", on_event);
}

absl::Status SseReader::TakeLine(std::string_view line, const OnEvent& on_event) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (std::exchange(first_line_, false) && line.starts_with(kByteOrderMark)) line.remove_prefix(kByteOrderMark.size());
  if (line.empty()) {
    if (!std::exchange(has_data_, false)) return absl::OkStatus();
    const absl::Status status = on_event(data_);
    data_.clear();
    return status;
  }
  if (!line.starts_with("data") || (line.size() > 4 && line[4] != ':')) return absl::OkStatus();
  line.remove_prefix(std::min<size_t>(line.size(), 5));
  if (line.starts_with(' ')) line.remove_prefix(1);
  if (std::exchange(has_data_, true)) data_ += '\n';
  data_ += line;
  return absl::OkStatus();
}

}  // namespace flair::llm
