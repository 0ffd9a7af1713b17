// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/message_text.h"

#include <google/protobuf/io/tokenizer.h>
#include <google/protobuf/text_format.h>
#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <set>

#include "absl/strings/ascii.h"
#include "absl/strings/str_replace.h"
#include "cli/exit_code.h"
#include "cli/output/output_folder.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

namespace pb = google::protobuf;

constexpr size_t kListedProblems = 10;
constexpr int kDeepest = 100;

// Keeps the first complaint, with its place.
class FirstError final : public pb::io::ErrorCollector {
 public:
  void AddError(int line, pb::io::ColumnNumber column, const std::string& message) override {
    if (text.empty()) text = fmt::format("{}: column {}: {}", line + 1, column + 1, message);
  }
  std::string text;
};

absl::Status ParseProtobufText(const std::string& name, const std::string& text, pb::Message& message) {
  FirstError error;
  pb::TextFormat::Parser parser;
  parser.RecordErrorsTo(&error);
  parser.SetRecursionLimit(kDeepest);
  if (parser.ParseFromString(text, &message)) return absl::OkStatus();
  return InvalidArgument("{}:{}", name, error.text);
}

// The line, from 1 on, on which the innermost known part of the path begins; 0 when none is known.
int LineInTree(const pb::TextFormat::ParseInfoTree& root, const pb::Descriptor* type,
               const std::vector<PathStep>& path) {
  int line = 0;
  const pb::TextFormat::ParseInfoTree* tree = &root;
  for (size_t i = 0; i < path.size() && tree != nullptr && type != nullptr; ++i) {
    const pb::FieldDescriptor* field = type->FindFieldByName(path[i].text);
    if (field == nullptr) break;
    int index = -1;
    if (field->is_repeated()) index = i + 1 < path.size() && path[i + 1].in_brackets ? IndexOf(path[++i]) : 0;
    if (field->is_repeated() && index < 0) break;
    const pb::TextFormat::ParseLocation place = tree->GetLocation(field, index);
    if (place.line < 0) break;
    line = place.line + 1;
    type = field->message_type();
    tree = type == nullptr ? nullptr : tree->GetTreeForNested(field, index);
  }
  return line;
}

using LineFinder = std::function<int(const std::vector<PathStep>&)>;

LineFinder FindInProtobufText(const std::string& text, const pb::Message& message) {
  auto tree = std::make_shared<pb::TextFormat::ParseInfoTree>();
  const std::unique_ptr<pb::Message> again(message.New());
  pb::TextFormat::Parser parser;
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

absl::Status List(const std::string& name, const std::vector<validation::Problem>& problems,
                  const LineFinder& line_of) {
  if (problems.empty()) return absl::OkStatus();
  const size_t listed = std::min(problems.size(), kListedProblems);
  std::string text;
  for (size_t i = 0; i < listed; ++i) {
    const absl::StatusOr<std::vector<PathStep>> path = ParseFieldPath(problems[i].path);
    const int line = path.ok() && line_of != nullptr ? line_of(*path) : 0;
    text += fmt::format("{}{}{}: {}: {}", text.empty() ? "" : "\n", name, line > 0 ? fmt::format(":{}", line) : "",
                        problems[i].path, problems[i].text);
  }
  if (problems.size() > listed) text += fmt::format("\nand {} more", problems.size() - listed);
  return absl::InvalidArgumentError(text);
}

// What is wrong with a JSON text and behind which byte; nothing when it is JSON.
struct Fault {
  size_t offset;
  std::string problem;
};
std::optional<Fault> FindSyntaxFault(const std::string& json) {
  try {
    [[maybe_unused]] const nlohmann::json read = nlohmann::json::parse(json);
  } catch (const nlohmann::json::parse_error& error) {
    // "[json.exception.parse_error.101] parse error at line 1, column 24: syntax error while ...".
    const std::string text = error.what();
    const size_t column = text.find("column ");
    const size_t words = text.find(": ", column == std::string::npos ? 0 : column);
    return Fault{error.byte, words == std::string::npos ? text : text.substr(words + 2)};
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;  // a number out of range, of which protobuf says more
  }
  return std::nullopt;
}

// What protobuf complains about: "(layout_graph.edges[0].weight): invalid value "x" for type TYPE_DOUBLE",
// "(layout_graph) edge: Cannot find field.".
struct Complaint {
  std::string path;
  std::string field;  // that is not known; else empty
  std::string value;  // that does not suit; else empty
  std::string words;
};

std::optional<Complaint> ReadComplaint(const std::string& text) {
  Complaint complaint;
  size_t at = 0;
  if (text.starts_with("(")) {
    const size_t end = text.find(')');
    if (end == std::string::npos) return std::nullopt;
    complaint.path = text.substr(1, end - 1);
    at = end + 1;
  }
  const size_t colon = text.find(": ", at);
  if (colon == std::string::npos || (at == 0 && colon != 0 && !text.ends_with("Cannot find field."))) {
    return std::nullopt;
  }
  complaint.words = text.substr(colon + 2);
  const std::string between = text.substr(at, colon - at);
  const size_t name = between.find_first_not_of(' ');
  if (name != std::string::npos) complaint.field = between.substr(name);
  const std::string_view kInvalid = "invalid value ";
  const size_t type = complaint.words.rfind(" for type ");
  if (complaint.words.starts_with(kInvalid) && type != std::string::npos) {
    complaint.value = complaint.words.substr(kInvalid.size(), std::min<size_t>(type - kInvalid.size(), 80));
  }
  return complaint;
}

// The field that a path leads to and the message that it is in; null for the message itself.
const pb::FieldDescriptor* FieldAt(const std::vector<PathStep>& path, const pb::Descriptor*& type) {
  const pb::FieldDescriptor* field = nullptr;
  for (const PathStep& step : path) {
    if (step.in_brackets) continue;
    if (field != nullptr) type = field->message_type();
    if (type == nullptr) return nullptr;
    field = type->FindFieldByName(step.text);
    if (field == nullptr) field = type->FindFieldByCamelcaseName(step.text);
    if (field == nullptr) return nullptr;
  }
  return field;
}

// The complaint with its line, in our words where the field is known.
absl::Status Explain(const std::string& name, const std::string& json, const pb::Descriptor* type,
                     const Complaint& complaint) {
  std::vector<PathStep> path;
  if (!complaint.path.empty()) path = ParseFieldPath(complaint.path).value_or(path);
  const pb::FieldDescriptor* field = FieldAt(path, type);
  const pb::Descriptor* inside = field == nullptr ? (path.empty() ? type : nullptr) : field->message_type();
  std::string words = complaint.words;
  std::string where = complaint.path;
  if (!complaint.field.empty()) {
    path.push_back({complaint.field});
    where += (where.empty() ? "" : ".") + complaint.field;
    if (inside != nullptr && complaint.words == "Cannot find field.") {
      words = NoSuchField(*inside, complaint.field) + "; or a newer Flair wrote it";
    }
  } else if (!complaint.value.empty() && field != nullptr && !complaint.value.starts_with("Field ")) {
    words = fmt::format("is {}; expected {}", complaint.value, Expected(*field));
  }
  return InvalidArgument("{}:{}: {}{}{}", name, LineAt(json, FindJsonField(json, path)), where,
                         where.empty() ? "" : ": ", words);
}

constexpr size_t kLongestName = 64;

// Letters to insert, delete or replace on the way from one to the other.
size_t Distance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), size_t{0});
  for (size_t i = 0; i < a.size(); ++i) {
    size_t diagonal = std::exchange(row[0], i + 1);
    for (size_t k = 0; k < b.size(); ++k) {
      const size_t replaced = diagonal + (a[i] == b[k] ? 0 : 1);
      diagonal = row[k + 1];
      row[k + 1] = std::min({replaced, row[k] + 1, diagonal + 1});
    }
  }
  return row.back();
}

}  // namespace

absl::Status ParseMessageText(TextForm form, const std::string& name, const std::string& text, pb::Message& message) {
  return form == TextForm::kJson ? ParseJsonMessage(name, text, message) : ParseProtobufText(name, text, message);
}

absl::Status LocateProblems(TextForm form, const std::string& name, const std::string& text, const pb::Message& message,
                            const std::vector<validation::Problem>& problems) {
  if (problems.empty()) return absl::OkStatus();
  return List(name, problems, form == TextForm::kJson ? FindInJson(text) : FindInProtobufText(text, message));
}

absl::Status ListProblems(const std::string& name, const std::vector<validation::Problem>& problems) {
  return List(name, problems, nullptr);
}

std::string RepeatedKey(std::string_view json) {
  using Event = nlohmann::json::parse_event_t;
  std::vector<std::set<std::string>> objects;
  std::string repeated;
  const auto see = [&](int, Event event, nlohmann::json& value) {
    if (event == Event::object_start) objects.emplace_back();
    if (event == Event::object_end) objects.pop_back();
    if (event == Event::key) {
      const std::string key = absl::AsciiStrToLower(value.get<std::string>());
      if (!objects.back().insert(absl::StrReplaceAll(key, {{"_", ""}})).second) repeated = value;
    }
    return true;
  };
  return nlohmann::json::parse(json, see, false).is_discarded() ? "" : repeated;
}

absl::Status ParseJsonMessage(const std::string& name, const std::string& json, pb::Message& message) {
  if (const std::string key = RepeatedKey(json); !key.empty()) {
    return InvalidArgument("{}: \"{}\" stands twice in one object; keep one", name, key);
  }
  // Protobuf takes "0x4" for a number, as C does. Marked, it does not, and what is text stays so.
  const std::string marked =
      absl::StrReplaceAll(json, {{"\"0x", "\"?0x"}, {"\"0X", "\"?0X"}, {"\"-0x", "\"?-0x"}, {"\"-0X", "\"?-0X"}});
  auto status = pb::util::JsonStringToMessage(marked, &message);
  if (status.ok() && marked != json) status = pb::util::JsonStringToMessage(json, &message);
  if (status.ok()) return absl::OkStatus();
  if (const std::optional<Fault> fault = FindSyntaxFault(json)) {
    const int line = LineAt(json, fault->offset > 0 ? fault->offset - 1 : 0);
    const bool cut = fault->offset >= json.size();
    return InvalidArgument("{}:{}: {}{}", name, line, cut ? "ends too early: " : "", fault->problem);
  }
  const std::string text = absl::StrReplaceAll(std::string(status.message()), {{"\"?", "\""}});
  if (const std::optional<Complaint> complaint = ReadComplaint(text)) {
    return Explain(name, json, message.GetDescriptor(), *complaint);
  }
  return InvalidArgument("{}: {}", name, text.substr(0, text.find('\n')));
}

absl::Status ReadTextMessage(const std::string& flag, const std::string& path, const std::string& example,
                             pb::Message& message) {
  const absl::StatusOr<std::string> text = ReadFile(path);
  if (!text.ok()) return About(flag, text.status());
  const absl::Status read = ParseMessageText(TextForm::kProtobufText, path, *text, message);
  if (read.ok()) return read;
  return InvalidArgument("{}: {}; should hold {}", flag, read.message(), example);
}

std::string ListNames(const std::vector<std::string>& names, size_t most) {
  std::string text;
  for (size_t i = 0; i < std::min(most, names.size()); ++i) text += (i > 0 ? ", " : "") + names[i];
  if (names.size() > most) text += fmt::format(" and {} more", names.size() - most);
  return text;
}

std::string DidYouMean(std::string_view name, const std::vector<std::string>& names) {
  if (name.size() > kLongestName) return "";
  const std::string* nearest = nullptr;
  size_t least = std::max<size_t>(2, name.size() / 3) + 1;
  for (const std::string& candidate : names) {
    if (candidate.size() > kLongestName) continue;
    const size_t distance = Distance(name, candidate);
    if (distance < least) least = distance, nearest = &candidate;
  }
  return nearest == nullptr ? "" : fmt::format(" (did you mean {}?)", *nearest);
}

std::string NoSuchField(const pb::Descriptor& type, std::string_view name) {
  std::vector<std::string> names;
  for (int i = 0; i < type.field_count(); ++i) names.push_back(type.field(i)->name());
  return fmt::format("{} has no field \"{}\"{}; it has {}", type.name(), name.substr(0, kLongestName),
                     DidYouMean(name, names), ListNames(names));
}

std::string Expected(const pb::FieldDescriptor& field) {
  switch (field.cpp_type()) {
    case pb::FieldDescriptor::CPPTYPE_INT32:
    case pb::FieldDescriptor::CPPTYPE_INT64:
    case pb::FieldDescriptor::CPPTYPE_UINT32:
    case pb::FieldDescriptor::CPPTYPE_UINT64:
      return "a whole number";
    case pb::FieldDescriptor::CPPTYPE_DOUBLE:
    case pb::FieldDescriptor::CPPTYPE_FLOAT:
      return "a number";
    case pb::FieldDescriptor::CPPTYPE_BOOL:
      return "true or false";
    case pb::FieldDescriptor::CPPTYPE_ENUM: {
      std::vector<std::string> names;
      for (int i = 0; i < field.enum_type()->value_count(); ++i) {
        if (field.enum_type()->value(i)->number() != 0) names.push_back(field.enum_type()->value(i)->name());
      }
      return "one of " + ListNames(names);
    }
    case pb::FieldDescriptor::CPPTYPE_STRING:
      return field.type() == pb::FieldDescriptor::TYPE_BYTES ? "bytes in base64" : "text";
    case pb::FieldDescriptor::CPPTYPE_MESSAGE:
      return fmt::format("a {}", field.message_type()->name());
  }
  return "something else";
}

}  // namespace flair::cli
