// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "absl/status/status.h"

namespace flair::llm {

// Reads server-sent events out of bytes that arrive in any pieces. Lines end in LF, CR LF or CR. Only the data of
// events is of interest here: their names, ids and comments are skipped.
class SseReader {
 public:
  // Takes the data of one event; an error ends the reading with it.
  using OnEvent = std::function<absl::Status(std::string_view data)>;

  absl::Status Take(std::string_view piece, const OnEvent& on_event);

  // At the end of the stream: an event that no empty line ended counts too.
  absl::Status Finish(const OnEvent& on_event);

  // Of the event that has not ended.
  size_t kept_byte_count() const { return line_.size() + data_.size(); }

 private:
  absl::Status TakeLine(std::string_view line, const OnEvent& on_event);

  std::string line_;
  std::string data_;
  bool has_data_ = false;
  // The last line ended in CR: a LF that follows belongs to it.
  bool after_cr_ = false;
  bool first_line_ = true;
};

}  // namespace flair::llm
