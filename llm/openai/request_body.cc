// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/openai/request_body.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "llm/openai/json_text.h"

namespace flair::llm {
namespace {

// Keeps the order of the fields: a model writes them in the order of the schema.
using nlohmann::ordered_json;

const char* NameOf(Role role) {
  switch (role) {
    case Role::kSystem:
      return "system";
    case Role::kUser:
      return "user";
    case Role::kAssistant:
      return "assistant";
  }
  return "user";
}

// Puts a text behind the first message when that is the system's, and else before all.
void AddToSystem(std::vector<Message>& messages, const std::string& text) {
  if (!messages.empty() && messages.front().role == Role::kSystem) {
    messages.front().text += "\n\n" + text;
  } else {
    messages.insert(messages.begin(), {Role::kSystem, text});
  }
}

// For servers without the role: what the system says begins the first question.
void SystemToUser(std::vector<Message>& messages) {
  std::string text;
  for (const Message& message : messages) {
    if (message.role == Role::kSystem) text += message.text + "\n\n";
  }
  std::erase_if(messages, [](const Message& message) { return message.role == Role::kSystem; });
  const auto user = std::ranges::find(messages, Role::kUser, &Message::role);
  if (user == messages.end()) {
    messages.insert(messages.begin(), {Role::kUser, text});
  } else {
    user->text = text + user->text;
  }
}

std::string EncodeMessages(const Dialect& dialect, const ChatRequest& request) {
  std::vector<Message> messages = request.messages;
  if (!request.schema.empty() && (dialect.form != AnswerForm::kJsonSchema || dialect.schema_in_prompt)) {
    AddToSystem(messages,
                "Answer with one JSON object and nothing else. It must follow this JSON schema:\n" + request.schema);
  }
  if (!dialect.system_role) SystemToUser(messages);
  std::string encoded = "[";
  for (const Message& message : messages) {
    encoded += fmt::format(R"({}{{"role":"{}","content":)", encoded.size() > 1 ? "," : "", NameOf(message.role));
    AppendJsonString(message.text, encoded);
    encoded += '}';
  }
  return encoded + "]";
}

// Takes the limits of numbers and lists off a schema.
void DropLimits(ordered_json& schema) {
  if (!schema.is_structured()) return;
  if (schema.is_object() && schema.contains("type")) {
    for (const char* limit : {"minimum", "maximum", "minItems", "maxItems"}) schema.erase(limit);
  }
  for (ordered_json& part : schema) DropLimits(part);
}

absl::StatusOr<ordered_json> EncodeFormat(const Dialect& dialect, const ChatRequest& request) {
  if (dialect.form == AnswerForm::kJsonObject) return ordered_json{{"type", "json_object"}};
  ordered_json schema = ordered_json::parse(request.schema, nullptr, false);
  if (!schema.is_object()) {
    return absl::InvalidArgumentError(fmt::format("the schema of step '{}' is no JSON object", request.step));
  }
  if (!dialect.schema_limits) DropLimits(schema);
  ordered_json format = {{"type", "json_schema"}};
  format["json_schema"] = {{"name", request.schema_name}, {"strict", true}, {"schema", std::move(schema)}};
  return format;
}

int TokenLimit(const OpenAiOptions& options, const Dialect& dialect, const ChatRequest& request) {
  if (request.max_output_token_count > 0) return request.max_output_token_count;
  if (options.max_output_token_count > 0) return options.max_output_token_count;
  return dialect.thinks ? kThinkersOutputTokenCount : kUsualOutputTokenCount;
}

}  // namespace

absl::StatusOr<std::string> EncodeRequest(const OpenAiOptions& options, const Dialect& dialect,
                                          const ChatRequest& request) {
  ordered_json body = ordered_json::object();
  if (!request.schema.empty() && dialect.form != AnswerForm::kText) {
    auto format = EncodeFormat(dialect, request);
    if (!format.ok()) return format.status();
    body["response_format"] = *std::move(format);
  }
  if (options.temperature.has_value() && dialect.temperature) body["temperature"] = *options.temperature;
  if (dialect.seed) body["seed"] = options.seed.value_or(request.seed);
  if (dialect.token_limit) {
    body[dialect.completion_token_limit ? "max_completion_tokens" : "max_tokens"] =
        TokenLimit(options, dialect, request);
  }
  if (options.stream && dialect.stream) {
    body["stream"] = true;
    if (dialect.stream_usage) body["stream_options"] = {{"include_usage", true}};
  }
  std::string text = R"({"model":)";
  AppendJsonString(options.model, text);
  text += R"(,"messages":)";
  text += EncodeMessages(dialect, request);
  // Whatever is not UTF-8 in a schema becomes U+FFFD.
  const std::string rest = body.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  if (!body.empty()) text += ',';
  text.append(rest, 1);
  return text;
}

}  // namespace flair::llm
