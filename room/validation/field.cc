// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/validation/field.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace flair::validation {
namespace {

constexpr size_t kReportedProblems = 5;
constexpr size_t kListedNames = 12;
constexpr size_t kQuotedBytes = 60;

// Short enough for one line of an error message, cut at a character's start.
std::string Quoted(std::string_view value) {
  if (value.size() <= kQuotedBytes) return fmt::format("\"{}\"", value);
  size_t end = kQuotedBytes;
  while (end > 0 && (static_cast<unsigned char>(value[end]) & 0xC0) == 0x80) --end;
  return fmt::format("\"{}…\"", value.substr(0, end));
}

bool IsIdCharacter(char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; }

bool IsHexDigit(char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); }

// Bytes of the character that starts with `lead`; 0 when none starts so.
size_t SequenceLength(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead < 0xE0) return 2;
  if (lead >= 0xE0 && lead < 0xF0) return 3;
  return lead >= 0xF0 && lead < 0xF5 ? 4 : 0;
}

}  // namespace

absl::Status Problems::ToStatus() const {
  if (problems_.empty()) return absl::OkStatus();
  std::string text;
  for (size_t i = 0; i < std::min(problems_.size(), kReportedProblems); ++i) {
    text += fmt::format("{}{}: {}", i > 0 ? "; " : "", problems_[i].path, problems_[i].text);
  }
  if (problems_.size() > kReportedProblems) text += fmt::format("; and {} more", problems_.size() - kReportedProblems);
  return absl::InvalidArgumentError(text);
}

bool Range::Holds(double value) const {
  return (open_least ? value > least : value >= least) && (open_most ? value < most : value <= most);
}

std::string Range::Text() const {
  return fmt::format("{}{}, {}{}", open_least ? "(" : "[", least, most, open_most ? ")" : "]");
}

std::string Field::path() const {
  std::string path = root_;
  for (size_t i = 0; i < depth_; ++i) {
    if (steps_[i].index >= 0) {
      path += fmt::format("[{}]", steps_[i].index);
    } else {
      path += fmt::format("{}{}", path.empty() ? "" : ".", std::string_view(steps_[i].name, steps_[i].name_size));
    }
  }
  return path;
}

Field Field::Inner(Step step) const {
  Field inner(*problems_, depth_ < steps_.size() ? root_ : path());
  if (depth_ < steps_.size()) {
    std::copy_n(steps_.begin(), depth_, inner.steps_.begin());
    inner.depth_ = depth_;
  }
  inner.steps_[inner.depth_++] = step;
  return inner;
}

bool Field::InRange(double value, const Range& range) const {
  if (!std::isfinite(value)) return Reject("{} is not a number; must be in {}", value, range.Text());
  return range.Holds(value) || Reject("{} is outside {}", value, range.Text());
}

bool Field::Text(std::string_view value, int least, int most) const {
  const int count = CharacterCount(value);
  if (count < 0) return Reject("is not valid UTF-8 text");
  if (count < least && value.empty()) return Reject("is empty");
  if (count < least) return Reject("{} has {} characters; at least {}", Quoted(value), count, least);
  return count <= most || Reject("has {} characters; at most {}", count, most);
}

bool Field::Count(int count, int least, int most, std::string_view what) const {
  if (count < least) return Reject("has {} {}; at least {}", count, what, least);
  return count <= most || Reject("has {} {}; at most {}", count, what, most);
}

bool Field::Id(std::string_view value) const {
  if (value.empty()) return Reject("is empty");
  const bool good = value.size() <= 64 && std::ranges::all_of(value, IsIdCharacter);
  return good || Reject("{} is not an id; 1 to 64 of a-z, 0-9 and _", Quoted(value));
}

bool Field::NewId(std::string_view value, NameSet& seen) const {
  if (!Id(value)) return false;
  return seen.insert(value).second || Reject("{} is taken already; ids are unique", Quoted(value));
}

bool Field::Refers(std::string_view value, const NameSet& known, std::string_view what) const {
  if (known.contains(value)) return true;
  std::vector<std::string_view> sorted(known.begin(), known.end());
  std::ranges::sort(sorted);
  sorted.resize(std::min(sorted.size(), kListedNames));
  std::string names = fmt::format("{}", fmt::join(sorted, ", "));
  if (known.size() > kListedNames) names += fmt::format(" and {} more", known.size() - kListedNames);
  return Reject("{} is not {} here; there {}", Quoted(value), what,
                known.empty() ? "is none" : (known.size() == 1 ? "is " : "are ") + names);
}

bool Field::Digest(std::string_view value) const {
  const bool good = value.size() == 64 && std::ranges::all_of(value, IsHexDigit);
  return good || Reject("{} is no SHA-256 digest; 64 of 0-9 and a-f", Quoted(value));
}

bool Field::Enum(int value, bool is_valid) const {
  if (value == 0) return Reject("is not set");
  return is_valid || Reject("{} is not a known value", value);
}

int CharacterCount(std::string_view text) {
  int count = 0;
  for (size_t i = 0; i < text.size(); ++count) {
    const size_t length = SequenceLength(static_cast<unsigned char>(text[i]));
    if (length == 0 || i + length > text.size()) return -1;
    for (size_t k = 1; k < length; ++k) {
      if ((static_cast<unsigned char>(text[i + k]) & 0xC0) != 0x80) return -1;
    }
    i += length;
  }
  return count;
}

}  // namespace flair::validation
