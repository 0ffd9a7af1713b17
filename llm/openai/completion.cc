// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/openai/completion.h"

#include <algorithm>

#include "absl/strings/ascii.h"
#include "llm/openai/json_fields.h"

namespace flair::llm {
namespace {

using nlohmann::json;

// Longer names are none.
constexpr size_t kModelByteLimit = 200;

// The content of a message: a text, or parts of which the texts count.
std::string ContentText(const json& message) {
  const json* const content = Field(message, "content");
  if (content == nullptr) return "";
  if (content->is_string()) return content->get<std::string>();
  std::string text;
  if (content->is_array()) {
    for (const json& part : *content) text += TextField(part, "text");
  }
  return text;
}

// Arguments of the first tool that is called; some servers send them as an object instead of its text.
std::string ToolArguments(const json& message) {
  const json* function = Field(message, "function_call");
  const json* const calls = Field(message, "tool_calls");
  if (function == nullptr && calls != nullptr && calls->is_array() && !calls->empty()) {
    const json& first = calls->front();
    if (CountField(first, "index").value_or(0) != 0) return "";
    function = Field(first, "function");
  }
  const json* const arguments = function != nullptr ? Field(*function, "arguments") : nullptr;
  if (arguments == nullptr) return "";
  return arguments->is_string() ? arguments->get<std::string>() : arguments->dump();
}

FinishReason ReadFinish(const std::string& written) {
  const std::string finish = absl::AsciiStrToLower(written);
  if (finish == "length" || finish == "max_tokens" || finish == "model_length") return FinishReason::kLength;
  if (finish == "content_filter" || finish == "safety" || finish == "refusal") return FinishReason::kRefused;
  for (const char* stop : {"", "stop", "tool_calls", "function_call", "eos", "end_turn", "stop_sequence"}) {
    if (finish == stop) return FinishReason::kStop;
  }
  return FinishReason::kOther;
}

Usage Estimate(const ChatRequest& request, const std::string& answer) {
  Usage usage{.input_token_count = EstimateTokens(request.schema), .output_token_count = EstimateTokens(answer)};
  for (const Message& message : request.messages) usage.input_token_count += EstimateTokens(message.text);
  usage.estimated = true;
  return usage;
}

// Gateways fill in an error of no kind beside an answer: {"code": 0, "message": ""}, "" or false.
bool SaysAnything(const json& error) {
  if (error.is_structured()) return std::ranges::any_of(error, SaysAnything);
  if (error.is_string()) return !error.get_ref<const std::string&>().empty();
  if (error.is_boolean()) return error.get<bool>();
  return !error.is_null() && error != 0;
}

}  // namespace

absl::Status Completion::Add(const json& object) {
  if (!object.is_object()) return absl::DataLossError("not a JSON object");
  const std::string model = TextField(object, "model");
  if (!model.empty() && model.size() <= kModelByteLimit) model_ = model;
  if (const json* const choices = Field(object, "choices"); choices != nullptr && choices->is_array()) {
    for (const json& choice : *choices) {
      // One answer was asked for.
      if (CountField(choice, "index").value_or(0) == 0) AddChoice(choice);
    }
  }
  if (const json* const usage = Field(object, "usage")) AddUsage(*usage);
  return absl::OkStatus();
}

bool Completion::AddText(std::string_view text, bool thought) {
  if (has_choice_) (thought ? thoughts_ : content_) += text;
  return has_choice_;
}

void Completion::AddChoice(const json& choice) {
  const json* message = Field(choice, "message");
  if (message == nullptr) message = Field(choice, "delta");
  if (message != nullptr && message->is_object()) {
    has_choice_ = true;
    content_ += ContentText(*message);
    refusal_ += TextField(*message, "refusal");
    for (const char* name : {"reasoning_content", "reasoning"}) {
      const std::string thoughts = TextField(*message, name);
      thoughts_ += thoughts;
      // Servers that know both names send the same under both.
      if (!thoughts.empty()) break;
    }
    tool_arguments_ += ToolArguments(*message);
  }
  if (const std::string finish = TextField(choice, "finish_reason"); !finish.empty()) {
    // A choice may end before it says anything.
    has_choice_ = true;
    finish_ = finish;
  }
}

void Completion::AddUsage(const json& usage) {
  const auto input = CountField(usage, "prompt_tokens"), output = CountField(usage, "completion_tokens");
  if (!input.has_value() || !output.has_value()) return;
  if (const json* const details = Field(usage, "completion_tokens_details")) {
    thought_ = thought_ || CountField(*details, "reasoning_tokens").value_or(0) > 0;
  }
  // Some servers count thoughts in the sum alone.
  thought_ = thought_ || CountField(usage, "total_tokens").value_or(0) > *input + *output;
  int64_t cached = 0;
  if (const json* const details = Field(usage, "prompt_tokens_details")) {
    cached = CountField(*details, "cached_tokens").value_or(0);
  }
  usage_ = Usage{.input_token_count = *input,
                 .output_token_count = *output,
                 .cached_input_token_count = std::min(cached, *input),
                 .estimated = false};
}

absl::StatusOr<ChatAnswer> Completion::ToAnswer(const ChatRequest& request, const std::string& model) const {
  if (!has_choice_) return absl::DataLossError("a reply without an answer (choices)");
  ChatAnswer answer;
  answer.finish = ReadFinish(finish_);
  answer.text = content_.empty() ? tool_arguments_ : content_;
  // Servers that take all of an answer for thoughts, as its model was told not to think, say so by an end without text.
  if (answer.text.empty() && answer.finish == FinishReason::kStop) answer.text = thoughts_;
  if (!refusal_.empty()) {
    answer.finish = FinishReason::kRefused;
    if (answer.text.empty()) answer.text = refusal_;
  }
  answer.model = model_.empty() ? model : model_;
  answer.usage = usage_.has_value() ? *usage_ : Estimate(request, answer.text);
  return answer;
}

const json* ErrorInside(const json& object) {
  const json* const error = Field(object, "error");
  return error != nullptr && SaysAnything(*error) ? error : nullptr;
}

}  // namespace flair::llm
