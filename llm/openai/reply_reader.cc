// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/openai/reply_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "absl/strings/ascii.h"
#include "llm/openai/json_fields.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::llm {
namespace {

constexpr std::string_view kSpace = " \t\r\n";
constexpr size_t kKeptByteLimit = 16 << 20;

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

}  // namespace

absl::Status SseReader::Take(std::string_view piece, const OnEvent& on_event) {
  while (!piece.empty()) {
    if (std::exchange(after_cr_, false) && piece.front() == '\n') piece.remove_prefix(1);
    const size_t end = piece.find_first_of("\r\n");
    if (end == std::string_view::npos) {
      line_ += piece;
      return absl::OkStatus();
    }
    // Nearly every line lies within one piece and is read where it is.
    std::string_view line = piece.substr(0, end);
    if (!line_.empty()) line = line_ += line;
    after_cr_ = piece[end] == '\r';
    piece.remove_prefix(end + 1);
    if (auto status = TakeLine(line, on_event); !status.ok()) return status;
    line_.clear();
  }
  return absl::OkStatus();
}

absl::Status SseReader::Finish(const OnEvent& on_event) {
  const std::string line = std::exchange(line_, {});
  if (auto status = TakeLine(line, on_event); !status.ok()) return status;
  return TakeLine("", on_event);
}

absl::Status SseReader::TakeLine(std::string_view line, const OnEvent& on_event) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (std::exchange(first_line_, false) && line.starts_with(kByteOrderMark)) line.remove_prefix(kByteOrderMark.size());
  if (line.empty()) {
    if (!std::exchange(has_data_, false)) return absl::OkStatus();
    const absl::Status status = on_event(data_);
    data_.clear();
    return status;
  }
  if (!line.starts_with("data") || (line.size() > 4 && line[4] != ':')) return absl::OkStatus();
  line.remove_prefix(std::min<size_t>(line.size(), 5));
  if (line.starts_with(' ')) line.remove_prefix(1);
  if (std::exchange(has_data_, true)) data_ += '\n';
  data_ += line;
  return absl::OkStatus();
}

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

absl::Status ReplyReader::Take(std::string_view piece) {
  if (absl::Status status = TakePiece(piece); !status.ok()) return status;
  const size_t kept = whole_.size() + sse_.kept_byte_count() + completion_.text_byte_count();
  return kept <= kKeptByteLimit ? absl::OkStatus() : NotOfTheProtocol("an answer of more than 16 MiB");
}

absl::Status ReplyReader::TakePiece(std::string_view piece) {
  if (kind_ == Kind::kUnknown) {
    const size_t begin = piece.find_first_not_of(kSpace);
    if (begin == std::string_view::npos) return absl::OkStatus();
    const bool whole = piece[begin] == '{' || piece[begin] == '[' || piece[begin] == '<';
    kind_ = whole ? Kind::kWhole : Kind::kEvents;
    // As if it had come in a piece of its own.
    piece.remove_prefix(begin);
  }
  if (kind_ == Kind::kWhole) {
    whole_ += piece;
    return absl::OkStatus();
  }
  return sse_.Take(piece, [this](std::string_view data) { return TakeEvent(data); });
}

absl::StatusOr<ChatAnswer> ReplyReader::FinishStream(const std::string& model) {
  if (kind_ != Kind::kEvents) return Read(whole_, model);
  const absl::Status status = sse_.Finish([this](std::string_view data) { return TakeEvent(data); });
  if (!status.ok()) return status;
  if (!done_ && !completion_.finished()) {
    return absl::UnavailableError(fmt::format("{}: the stream of the answer ended early", address_));
  }
  return ToAnswer(model);
}

absl::StatusOr<ChatAnswer> ReplyReader::Read(std::string_view body, const std::string& model) {
  const size_t begin = body.find_first_not_of(kSpace);
  if (begin == std::string_view::npos) return NotOfTheProtocol("an empty body");
  if (body[begin] == '<') return NotOfTheProtocol("HTML instead of an answer; is the base address right?");
  if (auto status = Add(body); !status.ok()) return status;
  return ToAnswer(model);
}

absl::Status ReplyReader::TakeEvent(std::string_view data) {
  if (done_) return absl::OkStatus();
  if (data.find_first_not_of(kSpace) == std::string_view::npos) return absl::OkStatus();
  if (data == "[DONE]") {
    done_ = true;
    return absl::OkStatus();
  }
  return Add(data);
}

absl::Status ReplyReader::Add(std::string_view json_text) {
  const nlohmann::json object = ParseJson(json_text);
  if (object.is_discarded()) return NotOfTheProtocol("a reply that is not JSON");
  if (ErrorInside(object) != nullptr) {
    const ServerError error = ReadServerError(json_text);
    return StatusOf(HttpStatusOf(error), error, fmt::format("{}: an error inside the reply", address_), confidential_);
  }
  const absl::Status added = completion_.Add(object);
  return added.ok() ? added : NotOfTheProtocol(std::string_view(added.message().data(), added.message().size()));
}

absl::StatusOr<ChatAnswer> ReplyReader::ToAnswer(const std::string& model) const {
  auto answer = completion_.ToAnswer(request_, model);
  if (answer.ok()) return answer;
  return NotOfTheProtocol(std::string_view(answer.status().message().data(), answer.status().message().size()));
}

absl::Status ReplyReader::NotOfTheProtocol(std::string_view what) const {
  return absl::DataLossError(fmt::format("{}: {}", address_, what));
}

}  // namespace flair::llm
