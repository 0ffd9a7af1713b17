// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/openai/reply_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "absl/strings/ascii.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::llm {
namespace {

constexpr std::string_view kSpace = " \t\r\n";

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
  return {.input_token_count = EstimateTokens(request),
          .output_token_count = EstimateTokens(answer),
          .cached_input_token_count = 0,
          .estimated = true};
}

// Gateways fill in an error of no kind beside an answer: {"code": 0, "message": ""}, "" or false.
bool SaysAnything(const json& error) {
  if (error.is_structured()) return std::ranges::any_of(error, SaysAnything);
  if (error.is_string()) return !error.get_ref<const std::string&>().empty();
  if (error.is_boolean()) return error.get<bool>();
  return !error.is_null() && error != 0;
}

// The error inside a reply of status 200, or inside a stream; null when there is none, or one that says nothing.
const json* ErrorInside(const json& object) {
  const json* const error = Field(object, "error");
  return error != nullptr && SaysAnything(*error) ? error : nullptr;
}

// A completion as it is put together: at once from a "message", or bit by bit from "delta"s.
class Completion {
 public:
  // Takes in one object of the protocol, a whole completion or a chunk of a stream; what it does not have is left as it
  // was.
  void Add(const json& object) {
    const std::string model = TextField(object, "model");
    if (!model.empty() && model.size() <= kModelByteLimit) model_ = model;
    if (const json* const choices = Field(object, "choices"); choices != nullptr && choices->is_array()) {
      for (const json& choice : *choices) {
        // One answer was asked for.
        if (CountField(choice, "index").value_or(0) == 0) AddChoice(choice);
      }
    }
    if (const json* const usage = Field(object, "usage")) AddUsage(*usage);
  }

  // Whether there was a choice.
  bool answered() const { return has_choice_; }
  // Whether a choice said why it ended.
  bool finished() const { return !finish_.empty(); }

  // `model` and the lengths of the texts stand in for what the server did not say.
  ChatReply ToReply(const ChatRequest& request, const std::string& model) const {
    ChatAnswer answer;
    answer.finish = ReadFinish(finish_);
    answer.text = content_.empty() ? tool_arguments_ : content_;
    // Servers that take all of an answer for thoughts, as its model was told not to think, say so by an end without
    // text.
    if (answer.text.empty() && answer.finish == FinishReason::kStop) answer.text = thoughts_;
    if (!refusal_.empty()) {
      answer.finish = FinishReason::kRefused;
      if (answer.text.empty()) answer.text = refusal_;
    }
    answer.model = model_.empty() ? model : model_;
    answer.usage = usage_.has_value() ? *usage_ : Estimate(request, answer.text);
    const bool aloud = std::string_view(content_).substr(0, 20).find("<think") != std::string_view::npos;
    return {std::move(answer), thought_ || aloud || !thoughts_.empty()};
  }

 private:
  void AddChoice(const json& choice) {
    const json* message = Field(choice, "message");
    if (message == nullptr) message = Field(choice, "delta");
    if (message != nullptr && message->is_object()) {
      has_choice_ = true;
      content_ += ContentText(*message);
      refusal_ += TextField(*message, "refusal");
      // Servers that know both names send the same under both.
      const std::string thoughts = TextField(*message, "reasoning_content");
      thoughts_ += thoughts.empty() ? TextField(*message, "reasoning") : thoughts;
      tool_arguments_ += ToolArguments(*message);
    }
    if (const std::string finish = TextField(choice, "finish_reason"); !finish.empty()) {
      // A choice may end before it says anything.
      has_choice_ = true;
      finish_ = finish;
    }
  }

  void AddUsage(const json& usage) {
    const auto input = CountField(usage, "prompt_tokens"), output = CountField(usage, "completion_tokens");
    if (!input.has_value() || !output.has_value()) return;
    const auto detail = [&](const char* details, const char* name) {
      const json* const found = Field(usage, details);
      return found == nullptr ? 0 : CountField(*found, name).value_or(0);
    };
    // Some servers count thoughts in the sum alone.
    thought_ = thought_ || detail("completion_tokens_details", "reasoning_tokens") > 0 ||
               CountField(usage, "total_tokens").value_or(0) > *input + *output;
    usage_ = Usage{.input_token_count = *input,
                   .output_token_count = *output,
                   .cached_input_token_count = std::min(detail("prompt_tokens_details", "cached_tokens"), *input),
                   .estimated = false};
  }

  bool has_choice_ = false;
  std::string content_;
  std::string refusal_;
  std::string thoughts_;        // what the model thought, where the server tells that apart
  bool thought_ = false;        // it spent tokens on that
  std::string tool_arguments_;  // of the first tool called
  std::string finish_;
  std::string model_;
  std::optional<Usage> usage_;
};

absl::Status NotOfTheProtocol(std::string_view what, const ReplyContext& context) {
  return DataLoss("{}: {}", context.address, what);
}

// Adds an object of the protocol.
absl::Status Add(std::string_view json_text, const ReplyContext& context, Completion& completion) {
  const json object = ParseJson(json_text);
  if (object.is_discarded()) return NotOfTheProtocol("a reply that is not JSON", context);
  if (ErrorInside(object) != nullptr) {
    const ServerError error = ReadServerError(json_text);
    return StatusOf(HttpStatusOf(error), error, fmt::format("{}: an error inside the reply", context.address),
                    context.confidential);
  }
  if (!object.is_object()) return NotOfTheProtocol("not a JSON object", context);
  completion.Add(object);
  return absl::OkStatus();
}

absl::Status AddEvents(std::string_view stream, const ReplyContext& context, Completion& completion) {
  bool done = false;
  for (const std::string& data : EventsOf(stream)) {
    done = data == "[DONE]";
    if (done) break;
    if (data.find_first_not_of(kSpace) != std::string::npos) RETURN_IF_ERROR(Add(data, context, completion));
  }
  if (done || completion.finished()) return absl::OkStatus();
  return Unavailable("{}: the stream of the answer ended early", context.address);
}

}  // namespace

std::vector<std::string> EventsOf(std::string_view stream) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf", kField = "data";
  if (stream.starts_with(kByteOrderMark)) stream.remove_prefix(kByteOrderMark.size());
  std::vector<std::string> events;
  std::optional<std::string> event;
  while (!stream.empty()) {
    std::string_view line = stream.substr(0, stream.find_first_of("\r\n"));
    stream.remove_prefix(line.size());
    stream.remove_prefix(stream.starts_with("\r\n") ? 2 : stream.empty() ? 0 : 1);
    if (line.empty() && event) events.push_back(*std::exchange(event, std::nullopt));
    if (!line.starts_with(kField) || (line.size() > kField.size() && line[kField.size()] != ':')) continue;
    line.remove_prefix(std::min(line.size(), kField.size() + 1));
    if (line.starts_with(' ')) line.remove_prefix(1);
    event = (event ? *event + "\n" : "") + std::string(line);
  }
  if (event) events.push_back(*event);
  return events;
}

absl::StatusOr<ChatReply> ReadReply(std::string_view body, bool streamed, const ReplyContext& context) {
  const size_t begin = body.find_first_not_of(kSpace);
  if (begin == std::string_view::npos) return NotOfTheProtocol("an empty body", context);
  if (body[begin] == '<') return NotOfTheProtocol("HTML instead of an answer; is the base address right?", context);
  Completion completion;
  if (streamed && body[begin] != '{' && body[begin] != '[') {
    RETURN_IF_ERROR(AddEvents(body.substr(begin), context, completion));
  } else {
    RETURN_IF_ERROR(Add(body, context, completion));
  }
  if (!completion.answered()) return NotOfTheProtocol("a reply without an answer (choices)", context);
  return completion.ToReply(context.request, context.model);
}

}  // namespace flair::llm
