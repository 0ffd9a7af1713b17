// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/json_message.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "cli/input/field_path.h"
#include "cli/input/json_place.h"
#include "cli/input/message_words.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"

namespace flair::cli {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;

// Takes no part of a JSON text and keeps what is wrong with it.
class SyntaxCheck : public nlohmann::json_sax<nlohmann::json> {
 public:
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(size_t) override { return true; }
  bool key(string_t&) override { return true; }
  bool end_object() override { return true; }
  bool start_array(size_t) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(size_t position, const std::string&, const nlohmann::detail::exception& error) override {
    offset = position;
    // "[json.exception.parse_error.101] parse error at line 1, column 24: syntax error while ...".
    problem = error.what();
    const size_t column = problem.find("column ");
    const size_t words = problem.find(": ", column == std::string::npos ? 0 : column);
    if (words != std::string::npos) problem = problem.substr(words + 2);
    return false;
  }
  size_t offset = 0;
  std::string problem;
};

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
const FieldDescriptor* FieldAt(const std::vector<PathStep>& path, const Descriptor*& type) {
  const FieldDescriptor* field = nullptr;
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
absl::Status Explain(const std::string& name, const std::string& json, const Descriptor* type,
                     const Complaint& complaint) {
  std::vector<PathStep> path;
  if (!complaint.path.empty()) path = ParseFieldPath(complaint.path).value_or(path);
  const FieldDescriptor* field = FieldAt(path, type);
  const Descriptor* inside = field == nullptr ? (path.empty() ? type : nullptr) : field->message_type();
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
  return absl::InvalidArgumentError(fmt::format("{}:{}: {}{}{}", name, LineAt(json, FindJsonField(json, path)), where,
                                                where.empty() ? "" : ": ", words));
}

}  // namespace

absl::Status ParseJsonMessage(const std::string& name, const std::string& json, google::protobuf::Message& message) {
  const auto status = google::protobuf::util::JsonStringToMessage(json, &message);
  if (status.ok()) return absl::OkStatus();
  SyntaxCheck check;
  if (!nlohmann::json::sax_parse(json, &check)) {
    const int line = LineAt(json, check.offset > 0 ? check.offset - 1 : 0);
    const bool cut = check.offset >= json.size();
    return absl::InvalidArgumentError(
        fmt::format("{}:{}: {}{}", name, line, cut ? "ends too early: " : "", check.problem));
  }
  const std::string text(status.message());
  if (const std::optional<Complaint> complaint = ReadComplaint(text)) {
    return Explain(name, json, message.GetDescriptor(), *complaint);
  }
  return absl::InvalidArgumentError(fmt::format("{}: {}", name, text.substr(0, text.find('\n'))));
}

}  // namespace flair::cli
