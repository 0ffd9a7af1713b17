// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/message_text.h"

#include <google/protobuf/io/tokenizer.h>
#include <google/protobuf/text_format.h>

#include <algorithm>
#include <functional>
#include <memory>

#include "absl/status/statusor.h"
#include "cli/input/field_path.h"
#include "cli/input/json_message.h"
#include "cli/input/json_place.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::TextFormat;

constexpr size_t kListedProblems = 10;
constexpr int kDeepest = 100;

// Keeps the first complaint, with its place.
class FirstError final : public google::protobuf::io::ErrorCollector {
 public:
  void AddError(int line, google::protobuf::io::ColumnNumber column, const std::string& message) override {
    if (text.empty()) text = fmt::format("{}: column {}: {}", line + 1, column + 1, message);
  }
  std::string text;
};

absl::Status ParseProtobufText(const std::string& name, const std::string& text, Message& message) {
  FirstError error;
  TextFormat::Parser parser;
  parser.RecordErrorsTo(&error);
  parser.SetRecursionLimit(kDeepest);
  if (parser.ParseFromString(text, &message)) return absl::OkStatus();
  return absl::InvalidArgumentError(fmt::format("{}:{}", name, error.text));
}

// The line, from 1 on, on which the innermost known part of the path begins; 0 when none is known.
int LineInTree(const TextFormat::ParseInfoTree& root, const google::protobuf::Descriptor* type,
               const std::vector<PathStep>& path) {
  int line = 0;
  const TextFormat::ParseInfoTree* tree = &root;
  for (size_t i = 0; i < path.size() && tree != nullptr && type != nullptr; ++i) {
    const FieldDescriptor* field = type->FindFieldByName(path[i].text);
    if (field == nullptr) break;
    int index = -1;
    if (field->is_repeated()) index = i + 1 < path.size() && path[i + 1].in_brackets ? IndexOf(path[++i]) : 0;
    if (field->is_repeated() && index < 0) break;
    const TextFormat::ParseLocation place = tree->GetLocation(field, index);
    if (place.line < 0) break;
    line = place.line + 1;
    type = field->message_type();
    tree = type == nullptr ? nullptr : tree->GetTreeForNested(field, index);
  }
  return line;
}

using LineFinder = std::function<int(const std::vector<PathStep>&)>;

LineFinder FindInProtobufText(const std::string& text, const Message& message) {
  auto tree = std::make_shared<TextFormat::ParseInfoTree>();
  const std::unique_ptr<Message> again(message.New());
  TextFormat::Parser parser;
  parser.WriteLocationsTo(tree.get());
  parser.SetRecursionLimit(kDeepest);
  FirstError ignored;
  parser.RecordErrorsTo(&ignored);
  (void)parser.ParseFromString(text, again.get());
  return [tree, type = message.GetDescriptor()](const std::vector<PathStep>& path) {
    return LineInTree(*tree, type, path);
  };
}

LineFinder FindInJson(const std::string& text) {
  return [&text](const std::vector<PathStep>& path) { return LineAt(text, FindJsonField(text, path)); };
}

absl::Status Join(const std::vector<std::string>& lines, size_t more) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
  if (more > 0) text += fmt::format("\nand {} more", more);
  return absl::InvalidArgumentError(text);
}

}  // namespace

absl::Status ParseMessageText(TextForm form, const std::string& name, const std::string& text, Message& message) {
  return form == TextForm::kJson ? ParseJsonMessage(name, text, message) : ParseProtobufText(name, text, message);
}

absl::Status LocateProblems(TextForm form, const std::string& name, const std::string& text, const Message& message,
                            const std::vector<validation::Problem>& problems) {
  if (problems.empty()) return absl::OkStatus();
  const LineFinder line_of = form == TextForm::kJson ? FindInJson(text) : FindInProtobufText(text, message);
  const size_t listed = std::min(problems.size(), kListedProblems);
  std::vector<std::string> lines;
  for (size_t i = 0; i < listed; ++i) {
    const absl::StatusOr<std::vector<PathStep>> path = ParseFieldPath(problems[i].path);
    const int line = path.ok() ? line_of(*path) : 0;
    lines.push_back(fmt::format("{}{}: {}: {}", name, line > 0 ? fmt::format(":{}", line) : "", problems[i].path,
                                problems[i].text));
  }
  return Join(lines, problems.size() - listed);
}

absl::Status ListProblems(const std::string& name, const std::vector<validation::Problem>& problems) {
  if (problems.empty()) return absl::OkStatus();
  const size_t listed = std::min(problems.size(), kListedProblems);
  std::vector<std::string> lines;
  for (size_t i = 0; i < listed; ++i) {
    lines.push_back(fmt::format("{}: {}: {}", name, problems[i].path, problems[i].text));
  }
  return Join(lines, problems.size() - listed);
}

}  // namespace flair::cli
