// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace flair::llm {

// A piece of a reply's text.
struct DeltaPiece {
  // A JSON string, with its quotation marks.
  std::string_view string;
  // Of what the model thinks (reasoning_content or reasoning), not of its answer (content).
  bool thought = false;

  bool operator==(const DeltaPiece&) const = default;
};

// The piece in a chunk of a stream that brings nothing else, as nearly all of the hundreds of a reply do, and the
// thousands of one that was thought about: what is in choices[0].delta. None when the chunk may bring anything more, or
// is not JSON; then it must be parsed. Takes a twentieth of the time of parsing; what it skips is not checked.
std::optional<DeltaPiece> PlainDelta(std::string_view chunk);

// The text of such a string that holds neither escapes nor anything but ASCII; none when it does.
std::optional<std::string_view> PlainText(std::string_view json_string);

// Finds the text of a chunk that differs from an earlier one in nothing else, by comparing: a tenth of PlainDelta's
// time.
class RepeatedDelta {
 public:
  // `piece` is what PlainDelta found in `chunk`, a part of it.
  void Learn(std::string_view chunk, const DeltaPiece& piece);

  // As PlainText(PlainDelta(chunk)->string); none when the chunk is not like the one learnt, or its text not plain.
  std::optional<std::string_view> Text(std::string_view chunk) const;
  // As PlainDelta(chunk)->thought of those.
  bool thought() const { return thought_; }

 private:
  // Of the chunk learnt, what is before and after the text; the quotation marks included.
  std::string before_;
  std::string after_;
  bool thought_ = false;
};

}  // namespace flair::llm
