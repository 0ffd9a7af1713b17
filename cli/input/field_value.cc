// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/field_value.h"

#include <google/protobuf/duration.pb.h>
#include <google/protobuf/io/tokenizer.h>
#include <google/protobuf/text_format.h>

#include <cmath>

#include "absl/strings/ascii.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_split.h"
#include "cli/input/message_text.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

using google::protobuf::EnumDescriptor;
using google::protobuf::EnumValueDescriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

bool IsDuration(const FieldDescriptor& field) {
  return field.message_type() == google::protobuf::Duration::descriptor();
}

std::string Lower(std::string text) {
  for (char& c : text) c = c == '-' ? '_' : absl::ascii_tolower(static_cast<unsigned char>(c));
  return text;
}

// "plan" of PREVIEW_VIEW_PLAN: what follows the prefix that all values share with ..._UNSPECIFIED.
std::string ShortWord(const EnumValueDescriptor& value) {
  constexpr std::string_view kZero = "unspecified";
  const std::string zero = Lower(value.type()->value(0)->name());
  const std::string name = Lower(value.name());
  return zero.ends_with(kZero) ? name.substr(zero.size() - kZero.size()) : name;
}

}  // namespace

bool HoldsOptions(const FieldDescriptor& field) {
  return field.message_type() != nullptr && !field.is_repeated() && !IsDuration(field);
}

bool IsValue(const FieldDescriptor& field) {
  if (field.message_type() != nullptr) return IsDuration(field) && !field.is_repeated();
  return field.cpp_type() != FieldDescriptor::CPPTYPE_STRING;
}

std::vector<std::string> ShortWords(const EnumDescriptor& type) {
  std::vector<std::string> words;
  for (int i = 1; i < type.value_count(); ++i) words.push_back(ShortWord(*type.value(i)));
  return words;
}

const EnumValueDescriptor* FindWord(const EnumDescriptor& type, const std::string& text) {
  const std::string word = Lower(text);
  for (int i = 1; i < type.value_count(); ++i) {
    if (word == ShortWord(*type.value(i)) || word == Lower(type.value(i)->name())) return type.value(i);
  }
  return nullptr;
}

std::string ValuesInWords(const FieldDescriptor& field) {
  std::string one = field.message_type() != nullptr ? "seconds" : Expected(field);
  if (field.enum_type() != nullptr) {
    std::vector<std::string> words = ShortWords(*field.enum_type());
    const std::string last = words.back();
    words.pop_back();
    one = words.empty() ? last : fmt::format("{} or {}", fmt::join(words, ", "), last);
  }
  return (field.is_repeated() ? "several, with commas between, of: " : "") + one;
}

namespace {

// Keeps errors off the terminal.
class NoErrors final : public google::protobuf::io::ErrorCollector {
  void AddError(int, google::protobuf::io::ColumnNumber, const std::string&) override {}
};

// Sets a field or adds to a list.
bool PutOne(const std::string& text, const FieldDescriptor& field, Message& message) {
  std::string value = text;
  if (double number = 0; field.cpp_type() == FieldDescriptor::CPPTYPE_DOUBLE) {
    if (!absl::SimpleAtod(text, &number) || !std::isfinite(number)) return false;
  } else if (field.enum_type() != nullptr) {
    const EnumValueDescriptor* word = FindWord(*field.enum_type(), text);
    if (word == nullptr) return false;
    value = word->name();
  } else if (IsDuration(field)) {
    if (!absl::SimpleAtod(text, &number) || !(number >= 0 && number < 1e11)) return false;
    const double whole = std::floor(number);
    value = fmt::format("{{ seconds: {:.0f} nanos: {:.0f} }}", whole, std::floor(1e9 * (number - whole)));
  }
  google::protobuf::TextFormat::Parser parser;
  NoErrors ignored;
  parser.RecordErrorsTo(&ignored);
  return parser.ParseFieldValueFromString(value, &field, &message);
}

}  // namespace

bool SetValue(const std::string& text, const FieldDescriptor& field, Message& message) {
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
