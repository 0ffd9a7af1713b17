// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/field_path.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>

#include "fmt/format.h"

namespace flair::cli {

namespace {

absl::Status NoPath(std::string_view path, size_t at, std::string_view why) {
  return absl::InvalidArgumentError(
      fmt::format("\"{}\": {} at character {}; a path is such as solved_layout.placements[3].theta_rad or "
                  "object_list.objects[desk].width_m",
                  path.substr(0, 200), why, at + 1));
}

bool IsNameCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

}  // namespace

absl::StatusOr<std::vector<PathStep>> ParseFieldPath(std::string_view path) {
  std::vector<PathStep> steps;
  for (size_t at = 0; at < path.size() || at == 0;) {
    if (!steps.empty() && path[at] == '[') {
      const size_t end = path.find(']', at);
      if (end == std::string_view::npos) return NoPath(path, at, "a \"[\" without \"]\"");
      if (end == at + 1) return NoPath(path, at, "nothing between \"[\" and \"]\"");
      steps.push_back({std::string(path.substr(at + 1, end - at - 1)), true});
      at = end + 1;
      continue;
    }
    if (!steps.empty() && path[at] != '.') return NoPath(path, at, "neither \".\" nor \"[\"");
    if (!steps.empty()) ++at;
    const size_t start = at;
    while (at < path.size() && IsNameCharacter(path[at])) ++at;
    if (at == start) return NoPath(path, at, "no name");
    steps.push_back({std::string(path.substr(start, at - start)), false});
  }
  return steps;
}

std::string PathText(const std::vector<PathStep>& steps, size_t count) {
  std::string text;
  for (size_t i = 0; i < std::min(count, steps.size()); ++i) {
    if (steps[i].in_brackets) {
      text += fmt::format("[{}]", steps[i].text);
    } else {
      text += (text.empty() ? "" : ".") + steps[i].text;
    }
  }
  return text;
}

int IndexOf(const PathStep& step) {
  int index = -1;
  const char* const end = step.text.data() + step.text.size();
  const auto [rest, error] = std::from_chars(step.text.data(), end, index);
  return error == std::errc() && rest == end && index >= 0 ? index : -1;
}

namespace {

// Reads a JSON text from left to right; whatever is no JSON ends it.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  // Where the next value, name or bracket begins.
  size_t Next() {
    while (at_ < text_.size() && std::string_view(" \t\r\n,:").find(text_[at_]) != std::string_view::npos) ++at_;
    return at_;
  }
  bool At(char c) { return Next() < text_.size() && text_[at_] == c; }
  bool Take(char c) {
    if (!At(c)) return false;
    ++at_;
    return true;
  }
  // A string with its escapes as they are.
  std::optional<std::string_view> TakeString() {
    if (!Take('"')) return std::nullopt;
    const size_t start = at_;
    for (; at_ < text_.size(); ++at_) {
      if (text_[at_] == '\\') {
        ++at_;
      } else if (text_[at_] == '"') {
        return text_.substr(start, at_++ - start);
      }
    }
    at_ = text_.size();
    return std::nullopt;
  }
  // False at the end of the text.
  bool SkipValue() {
    for (int depth = 0; Next() < text_.size();) {
      if (text_[at_] == '"') {
        if (!TakeString()) return false;
      } else if (text_[at_] == '{' || text_[at_] == '[') {
        ++depth, ++at_;
      } else if (text_[at_] == '}' || text_[at_] == ']') {
        if (--depth < 0) return false;
        ++at_;
      } else {
        const size_t end = text_.find_first_of(" \t\r\n,:{}[]\"", at_);
        at_ = end == std::string_view::npos ? text_.size() : end;
      }
      if (depth == 0) return true;
    }
    return false;
  }

 private:
  const std::string_view text_;
  size_t at_ = 0;
};

// width_m and widthM are the same field.
bool SameName(std::string_view key, std::string_view name) {
  size_t k = 0;
  bool upper = false;
  for (const char c : name) {
    if (c == '_' && (k >= key.size() || key[k] != '_')) {
      upper = true;
      continue;
    }
    if (k >= key.size()) return false;
    const char expected = upper && c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    if (key[k++] != expected) return false;
    upper = false;
  }
  return k == key.size();
}

// Moves into the value of the field and returns where its name stands.
std::optional<size_t> EnterField(Reader& reader, std::string_view name) {
  if (!reader.Take('{')) return std::nullopt;
  while (true) {
    const size_t place = reader.Next();
    const std::optional<std::string_view> key = reader.TakeString();
    if (!key) return std::nullopt;
    reader.Next();
    if (SameName(*key, name)) return place;
    if (!reader.SkipValue()) return std::nullopt;
  }
}

std::optional<size_t> EnterItem(Reader& reader, int index) {
  if (index < 0 || !reader.Take('[')) return std::nullopt;
  for (; index > 0; --index) {
    if (!reader.SkipValue()) return std::nullopt;
  }
  if (reader.At(']')) return std::nullopt;
  return reader.Next();
}

}  // namespace

size_t FindJsonField(std::string_view json, const std::vector<PathStep>& path) {
  Reader reader(json);
  size_t place = reader.Next();
  for (const PathStep& step : path) {
    const std::optional<size_t> inner =
        step.in_brackets ? EnterItem(reader, IndexOf(step)) : EnterField(reader, step.text);
    if (!inner || *inner >= json.size()) break;
    place = *inner;
  }
  return place < json.size() ? place : 0;
}

int LineAt(std::string_view text, size_t offset) {
  const std::string_view before = text.substr(0, offset);
  return static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1;
}

}  // namespace flair::cli
