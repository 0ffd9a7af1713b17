// SPDX-License-Identifier: GPL-3.0-or-later
#include <google/protobuf/text_format.h>
#include <google/protobuf/util/message_differencer.h>

#include <algorithm>

#include "cli/replay/comparison.h"
#include "fmt/format.h"

namespace flair::cli {

namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::util::MessageDifferencer;

constexpr size_t kShownLength = 80;

std::string Shortened(std::string text) {
  if (text.size() <= kShownLength) return text;
  size_t end = kShownLength - 3;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end) + "...";
}

// One value of a field; `index` is -1 for fields that are no lists.
std::string ValueText(const Message& message, const FieldDescriptor& field, int index) {
  if (field.type() == FieldDescriptor::TYPE_BYTES) {
    const google::protobuf::Reflection& reflection = *message.GetReflection();
    const std::string bytes =
        index < 0 ? reflection.GetString(message, &field) : reflection.GetRepeatedString(message, &field, index);
    return fmt::format("{} bytes", bytes.size());
  }
  google::protobuf::TextFormat::Printer printer;
  printer.SetSingleLineMode(true);
  printer.SetUseUtf8StringEscaping(true);
  std::string text;
  printer.PrintFieldValueToString(message, &field, index, &text);
  if (field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) text = "{ " + text + "}";
  return Shortened(text);
}

using FieldPath = std::vector<MessageDifferencer::SpecificField>;

// Keeps the first difference and counts them all.
class FirstOnly final : public MessageDifferencer::Reporter {
 public:
  const std::optional<FieldDifference>& found() const { return found_; }

  void ReportAdded(const Message&, const Message& second, const FieldPath& path) override {
    if (See(path)) found_->second = ValueAt(second, path, true);
  }
  void ReportDeleted(const Message& first, const Message&, const FieldPath& path) override {
    if (See(path)) found_->first = ValueAt(first, path, false);
  }
  void ReportModified(const Message& first, const Message& second, const FieldPath& path) override {
    // After the fields of a message, the message itself is reported, too.
    if (path.back().field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE || !See(path)) return;
    found_->first = ValueAt(first, path, false);
    found_->second = ValueAt(second, path, true);
  }

 private:
  bool See(const FieldPath& path) {
    const bool is_first = !found_.has_value();
    if (is_first) found_ = FieldDifference{PathText(path), "none", "none", 0};
    ++found_->field_count;
    return is_first;
  }

  static std::string PathText(const FieldPath& path) {
    std::string text;
    for (const MessageDifferencer::SpecificField& step : path) {
      if (step.field == nullptr) continue;
      text += (text.empty() ? "" : ".") + step.field->name();
      if (step.field->is_repeated()) text += fmt::format("[{}]", std::max(step.index, step.new_index));
    }
    return text;
  }

  // The reporter is given the messages that the last field of the path belongs to.
  static std::string ValueAt(const Message& message, const FieldPath& path, bool second) {
    const MessageDifferencer::SpecificField& last = path.back();
    if (!last.field->is_repeated()) return ValueText(message, *last.field, -1);
    return ValueText(message, *last.field, second ? last.new_index : last.index);
  }

  std::optional<FieldDifference> found_;
};

std::optional<FieldDifference> Compare(const Message& first, const Message& second,
                                       const std::vector<std::string>& without) {
  MessageDifferencer differencer;
  for (const std::string& name : without) {
    const FieldDescriptor* field = first.GetDescriptor()->FindFieldByName(name);
    if (field != nullptr) differencer.IgnoreField(field);
  }
  FirstOnly reporter;
  differencer.ReportDifferencesTo(&reporter);
  differencer.Compare(first, second);
  return reporter.found();
}

}  // namespace

std::string FieldDifference::InWords() const {
  // Two pictures of one size may differ.
  if (first == second) return fmt::format("{}: {}, other content", path, first);
  return fmt::format("{}: {} -> {}", path, first, second);
}

std::optional<FieldDifference> FirstDifference(const Message& first, const Message& second,
                                               const std::vector<std::string>& aside) {
  std::optional<FieldDifference> found = Compare(first, second, aside);
  if (!found.has_value() && !aside.empty()) found = Compare(first, second, {});
  return found;
}

}  // namespace flair::cli
