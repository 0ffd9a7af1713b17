// SPDX-License-Identifier: GPL-3.0-or-later
#include <google/protobuf/duration.pb.h>
#include <google/protobuf/io/tokenizer.h>
#include <google/protobuf/text_format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "absl/strings/ascii.h"
#include "absl/strings/str_split.h"
#include "cli/input/message_text.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/read_number.h"

namespace flair::cli {
namespace {

absl::Status NoPath(std::string_view path, size_t at, std::string_view why) {
  return InvalidArgument(
      "\"{}\": {} at character {}; a path is such as solved_layout.placements[3].theta_rad or "
      "object_list.objects[desk].width_m",
      path.substr(0, 200), why, at + 1);
}

bool IsNameCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

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

namespace pb = google::protobuf;

bool IsDuration(const pb::FieldDescriptor& field) { return field.message_type() == pb::Duration::descriptor(); }

std::string Lower(std::string text) {
  for (char& c : text) c = c == '-' ? '_' : absl::ascii_tolower(static_cast<unsigned char>(c));
  return text;
}

// "plan" of PREVIEW_VIEW_PLAN: what follows the prefix that all values share with ..._UNSPECIFIED.
std::string ShortWord(const pb::EnumValueDescriptor& value) {
  constexpr std::string_view kZero = "unspecified";
  const std::string zero = Lower(value.type()->value(0)->name());
  const std::string name = Lower(value.name());
  return zero.ends_with(kZero) ? name.substr(zero.size() - kZero.size()) : name;
}

// Keeps errors off the terminal.
class NoErrors final : public pb::io::ErrorCollector {
  void AddError(int, pb::io::ColumnNumber, const std::string&) override {}
};

// Sets a field or adds to a list.
bool PutOne(const std::string& text, const pb::FieldDescriptor& field, pb::Message& message) {
  std::string value = text;
  if (const std::optional<double> number = ReadNumber(text); field.cpp_type() == pb::FieldDescriptor::CPPTYPE_DOUBLE) {
    if (!number) return false;
  } else if (field.enum_type() != nullptr) {
    const pb::EnumValueDescriptor* word = FindWord(*field.enum_type(), text);
    if (word == nullptr) return false;
    value = word->name();
  } else if (IsDuration(field)) {
    if (!number || *number < 0 || *number >= 1e11) return false;
    const double whole = std::floor(*number);
    value = fmt::format("{{ seconds: {:.0f} nanos: {:.0f} }}", whole, std::floor(1e9 * (*number - whole)));
  }
  pb::TextFormat::Parser parser;
  NoErrors ignored;
  parser.RecordErrorsTo(&ignored);
  return parser.ParseFieldValueFromString(value, &field, &message);
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
  return static_cast<int>(std::ranges::count(before, '\n')) + 1;
}

bool HoldsOptions(const pb::FieldDescriptor& field) {
  return field.message_type() != nullptr && !field.is_repeated() && !IsDuration(field);
}

bool IsValue(const pb::FieldDescriptor& field) {
  if (field.message_type() != nullptr) return IsDuration(field) && !field.is_repeated();
  return field.cpp_type() != pb::FieldDescriptor::CPPTYPE_STRING;
}

std::vector<std::string> ShortWords(const pb::EnumDescriptor& type) {
  std::vector<std::string> words;
  for (int i = 1; i < type.value_count(); ++i) words.push_back(ShortWord(*type.value(i)));
  return words;
}

const pb::EnumValueDescriptor* FindWord(const pb::EnumDescriptor& type, const std::string& text) {
  const std::string word = Lower(text);
  for (int i = 1; i < type.value_count(); ++i) {
    if (word == ShortWord(*type.value(i)) || word == Lower(type.value(i)->name())) return type.value(i);
  }
  return nullptr;
}

std::string ValuesInWords(const pb::FieldDescriptor& field) {
  std::string one = field.message_type() != nullptr ? "seconds" : Expected(field);
  if (field.enum_type() != nullptr) {
    std::vector<std::string> words = ShortWords(*field.enum_type());
    const std::string last = words.back();
    words.pop_back();
    one = words.empty() ? last : fmt::format("{} or {}", fmt::join(words, ", "), last);
  }
  return (field.is_repeated() ? "several, separated by commas, of: " : "") + one;
}

bool SetValue(const std::string& text, const pb::FieldDescriptor& field, pb::Message& message) {
  message.GetReflection()->ClearField(&message, &field);
  if (text.empty()) return true;
  std::vector<std::string> parts = {text};
  if (field.is_repeated()) parts = absl::StrSplit(text, ',');
  if (field.is_repeated() && field.enum_type() != nullptr && text == "all") parts = ShortWords(*field.enum_type());
  for (const std::string& part : parts) {
    if (!PutOne(std::string(absl::StripAsciiWhitespace(part)), field, message)) return false;
  }
  return true;
}

}  // namespace flair::cli
