// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/wrappers/answer_json.h"

#include <array>
#include <utility>

#include "fmt/format.h"
#include "nlohmann/json.hpp"

namespace flair::llm {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::pair<Role, const char*>, 3> kRoles = {
    {{Role::kSystem, "system"}, {Role::kUser, "user"}, {Role::kAssistant, "assistant"}}};
constexpr std::array<std::pair<FinishReason, const char*>, 4> kFinishReasons = {{{FinishReason::kStop, "stop"},
                                                                                 {FinishReason::kLength, "length"},
                                                                                 {FinishReason::kRefused, "refused"},
                                                                                 {FinishReason::kOther, "other"}}};

template <typename Table, typename Value>
const char* NameOf(const Table& table, Value value) {
  for (const auto& [known, name] : table) {
    if (known == value) return name;
  }
  return "";
}

Json ToJson(const ChatRequest& request) {
  Json messages = Json::array();
  for (const Message& message : request.messages) {
    messages.push_back({{"role", NameOf(kRoles, message.role)}, {"text", message.text}});
  }
  Json json = {{"messages", std::move(messages)},
               {"schema_name", request.schema_name},
               {"schema", request.schema},
               {"max_output_token_count", request.max_output_token_count}};
  // Requests without one are what they were before there were seeds, and so are the names of their files.
  if (request.seed != 0) json["seed"] = request.seed;
  return json;
}

Json ToJson(const ChatAnswer& answer) {
  return {{"text", answer.text},
          {"finish", NameOf(kFinishReasons, answer.finish)},
          {"model", answer.model},
          {"usage",
           {{"input_token_count", answer.usage.input_token_count},
            {"output_token_count", answer.usage.output_token_count},
            {"cached_input_token_count", answer.usage.cached_input_token_count},
            {"estimated", answer.usage.estimated}}},
          {"cost_usd", answer.cost_usd}};
}

std::string Dump(const Json& json, int indent) { return json.dump(indent, ' ', false, Json::error_handler_t::replace); }

absl::Status Bad(const std::string& path, const char* expected) {
  return absl::DataLossError(fmt::format("{}: expected {}", path, expected));
}

// Reads fields one after the other; remembers the first that is wrong.
class Reader {
 public:
  Reader(const Json& json, std::string path) : json_(json), path_(std::move(path)) {}

  void Text(const char* field, std::string& value) {
    if (const Json* found = Find(field, &Json::is_string, "a text")) value = found->get<std::string>();
  }
  void Count(const char* field, int64_t& value) {
    const Json* found = Find(field, &Json::is_number_integer, "a count of 0 or more");
    if (found == nullptr) return;
    value = found->get<int64_t>();
    if (value < 0) Fail(field, "a count of 0 or more");
  }
  void Amount(const char* field, double& value) {
    if (const Json* found = Find(field, &Json::is_number, "a number")) value = found->get<double>();
  }
  void Flag(const char* field, bool& value) {
    if (const Json* found = Find(field, &Json::is_boolean, "true or false")) value = found->get<bool>();
  }
  const Json& Object(const char* field) {
    static const Json empty = Json::object();
    const Json* found = Find(field, &Json::is_object, "an object");
    return found != nullptr ? *found : empty;
  }
  void Fail(const std::string& field, const char* expected) {
    if (status_.ok()) status_ = Bad(path_ + field, expected);
  }
  const absl::Status& status() const { return status_; }

 private:
  const Json* Find(const char* field, bool (Json::*is)() const noexcept, const char* expected) {
    const auto it = json_.find(field);
    if (it != json_.end() && ((*it).*is)()) return &*it;
    Fail(field, expected);
    return nullptr;
  }

  const Json& json_;
  const std::string path_;
  absl::Status status_;
};

}  // namespace

std::string RequestJson(const ChatRequest& request) { return Dump(ToJson(request), -1); }

std::string RecordJson(const ChatRequest& request, const ChatAnswer& answer) {
  const Json record = {{"step", request.step}, {"request", ToJson(request)}, {"answer", ToJson(answer)}};
  return Dump(record, 1) + "\n";
}

absl::StatusOr<ChatAnswer> ReadRecordJson(const std::string& text) {
  const Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (!json.is_object()) return absl::DataLossError("expected a JSON object with \"request\" and \"answer\"");
  Reader record(json, "");
  Reader reader(record.Object("answer"), "answer.");
  if (!record.status().ok()) return record.status();
  ChatAnswer answer;
  std::string finish;
  reader.Text("text", answer.text);
  reader.Text("finish", finish);
  reader.Text("model", answer.model);
  reader.Amount("cost_usd", answer.cost_usd);
  Reader usage(reader.Object("usage"), "answer.usage.");
  usage.Count("input_token_count", answer.usage.input_token_count);
  usage.Count("output_token_count", answer.usage.output_token_count);
  usage.Count("cached_input_token_count", answer.usage.cached_input_token_count);
  usage.Flag("estimated", answer.usage.estimated);
  bool known = false;
  for (const auto& [reason, name] : kFinishReasons) {
    if (finish != name) continue;
    answer.finish = reason;
    known = true;
  }
  if (!known) reader.Fail("finish", "\"stop\", \"length\", \"refused\" or \"other\"");
  if (!reader.status().ok()) return reader.status();
  if (!usage.status().ok()) return usage.status();
  return answer;
}

}  // namespace flair::llm
