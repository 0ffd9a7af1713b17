// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/doctor_model.h"

#include <memory>
#include <string_view>
#include <vector>

#include "absl/time/clock.h"
#include "flair/config/v1/runtime_config.pb.h"
#include "fmt/format.h"
#include "llm/make_llm_client.h"
#include "nlohmann/json.hpp"
#include "worker_runtime/bootstrap/worker_context.h"

namespace flair::cli {
namespace {

using config::v1::LlmConfig;

constexpr absl::Duration kAnswerWithin = absl::Seconds(60);
// Models that think before they answer need some room for it.
constexpr int kMostTokens = 1000;

// Which of the forms are to be tried.
std::vector<config::v1::AnswerForm> Forms(const LlmConfig& config) {
  if (config.answer_form() != config::v1::ANSWER_FORM_UNSPECIFIED) return {config.answer_form()};
  return {config::v1::ANSWER_FORM_JSON_SCHEMA, config::v1::ANSWER_FORM_JSON_OBJECT, config::v1::ANSWER_FORM_TEXT};
}

std::string_view FormText(config::v1::AnswerForm form) {
  switch (form) {
    case config::v1::ANSWER_FORM_JSON_SCHEMA:
      return "takes JSON schemas";
    case config::v1::ANSWER_FORM_JSON_OBJECT:
      return "takes JSON mode";
    default:
      return "takes neither JSON schemas nor JSON mode: plain text";
  }
}

// Some servers take a schema and heed it not; answers are then read as text would be.
std::string_view FollowedText(const std::string& text) {
  return nlohmann::json::parse(text, nullptr, false).is_object() ? "" : " (but this answer was not JSON alone)";
}

llm::ChatRequest TinyQuestion() {
  llm::ChatRequest request;
  request.step = "doctor";
  request.messages = {{llm::Role::kUser, "Answer with the JSON object {\"ready\":true} and nothing else."}};
  request.schema =
      R"({"type":"object","properties":{"ready":{"type":"boolean"}},"required":["ready"],"additionalProperties":false})";
  request.schema_name = "doctor_answer";
  request.max_output_token_count = kMostTokens;
  return request;
}

std::string RemedyFor(const absl::Status& status) {
  switch (status.code()) {
    case absl::StatusCode::kUnauthenticated:
    case absl::StatusCode::kPermissionDenied:
      return "Check the key: api_key_env or api_key_path names where it is.";
    case absl::StatusCode::kNotFound:
      return "Check model and base_url; the latter ends before /chat/completions.";
    case absl::StatusCode::kUnavailable:
    case absl::StatusCode::kDeadlineExceeded:
      return "Check base_url and proxy, and whether the server is running.";
    default:
      return "docs/models.md has a config for each kind of server.";
  }
}

absl::StatusOr<llm::ChatAnswer> AskOnce(LlmConfig config, config::v1::AnswerForm form) {
  config.clear_record_path();
  config.clear_replay_path();
  config.clear_cache_path();
  config.mutable_retry()->set_attempt_limit(1);
  config.set_answer_form(form);
  config::v1::RuntimeConfig quiet;
  quiet.set_log_level("error");
  runtime::WorkerResources resources("flair-doctor", quiet);
  absl::StatusOr<std::unique_ptr<llm::LlmClient>> client = llm::MakeLlmClient(config, resources.context());
  if (!client.ok()) return client.status();
  runtime::CallContext call("doctor", absl::Now() + kAnswerWithin, resources.context().clock);
  return (*client)->Ask(TinyQuestion(), call);
}

}  // namespace

ModelFindings AskModel(const LlmConfig& config) {
  ModelFindings findings;
  for (const config::v1::AnswerForm form : Forms(config)) {
    const absl::StatusOr<llm::ChatAnswer> answer = AskOnce(config, form);
    findings.status = answer.status();
    if (answer.ok()) {
      const bool keyed = !config.api_key_env().empty() || !config.api_key_path().empty();
      findings.answer = fmt::format("{} answers{}, {}{}; {} + {} tokens", answer->model,
                                    keyed ? ", the key is accepted" : "", FormText(form), FollowedText(answer->text),
                                    answer->usage.input_token_count, answer->usage.output_token_count);
      return findings;
    }
    // Only what the server does not take may be taken in another form.
    if (!absl::IsInvalidArgument(answer.status())) break;
  }
  findings.remedy = RemedyFor(findings.status);
  return findings;
}

}  // namespace flair::cli
