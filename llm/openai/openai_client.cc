// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/openai/openai_client.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include "llm/openai/dialect.h"
#include "llm/openai/endpoint.h"
#include "llm/openai/json_fields.h"
#include "llm/openai/reply_reader.h"
#include "llm/openai/request_body.h"
#include "llm/openai/server_error.h"

namespace flair::llm {
namespace {

// One Ask on its way.
struct Question {
  ChatRequest request;
  runtime::CallContext& call;
  AnswerCallback done;
  Confidential confidential;
  Dialect dialect;
  // A weaker dialect is being tried, which the client learns when the server takes it.
  bool dialect_is_new = false;
  // That is because of this schema alone.
  bool schema_rejected = false;
  std::optional<ReplyReader> reader;
};

// Whether an answer is what a server writes that keeps to the schema: one JSON object with all that it requires.
bool KeepsTo(const std::string& schema_text, const std::string& answer_text) {
  const nlohmann::json schema = ParseJson(schema_text), answer = ParseJson(answer_text);
  const nlohmann::json* const required = Field(schema, "required");
  if (required == nullptr || !required->is_array()) return true;
  return answer.is_object() && std::ranges::all_of(*required, [&](const nlohmann::json& name) {
           return !name.is_string() || answer.contains(name.get_ref<const std::string&>());
         });
}

}  // namespace

class OpenAiClient::Impl : public std::enable_shared_from_this<OpenAiClient::Impl> {
 public:
  Impl(OpenAiOptions options, HttpLoop& loop, HttpOptions http)
      : options_(std::move(options)),
        http_(loop, std::move(http)),
        url_(CompletionsUrl(options_)),
        address_(PublicAddress(url_)),
        dialect_{.form = options_.answer_form} {}

  const OpenAiOptions& options() const { return options_; }

  void Ask(const ChatRequest& request, runtime::CallContext& call, AnswerCallback done) {
    auto question = std::make_shared<Question>(Question{.request = request,
                                                        .call = call,
                                                        .done = std::move(done),
                                                        .confidential = {SecretsOf(options_), {}},
                                                        .dialect = Known(request.schema_name),
                                                        .reader = {}});
    question->confidential.messages = question->request.messages;
    Send(std::move(question));
  }

 private:
  using QuestionPtr = std::shared_ptr<Question>;

  void Send(QuestionPtr question);
  void OnResponse(QuestionPtr question, absl::StatusOr<HttpResponse> response);
  // Asks again in a weaker dialect when that may help.
  bool AskedAgain(const QuestionPtr& question, int http_status, const ServerError& error);
  Dialect Known(const std::string& schema_name) const;
  // Learns from a request that the server took, and from its answer.
  void Learn(const Question& question, const ChatAnswer& answer);
  void LearnWhetherSchemasAreKept(const Question& question, const ChatAnswer& answer);

  const OpenAiOptions options_;
  HttpClient http_;
  const std::string url_;
  const std::string address_;
  mutable std::mutex mutex_;
  Dialect dialect_;
  // Forms of those schemas that the server did not take in the dialect's.
  std::map<std::string, AnswerForm> form_of_schema_;
  // An answer kept to its schema, which no server does by chance.
  bool schemas_are_kept_ = false;
};

void OpenAiClient::Impl::Send(QuestionPtr question) {
  auto body = EncodeRequest(options_, question->dialect, question->request);
  if (!body.ok()) return question->done(body.status());
  HttpRequest request{.url = url_, .headers = RequestHeaders(options_), .body = *std::move(body)};
  question->reader.emplace(address_, question->request, question->confidential);
  if (options_.stream) {
    request.on_piece = [question](std::string_view piece) { return question->reader->Take(piece); };
  }
  runtime::CallContext& call = question->call;
  http_.Send(
      std::move(request), call,
      [self = shared_from_this(), question = std::move(question)](absl::StatusOr<HttpResponse> response) mutable {
        self->OnResponse(std::move(question), std::move(response));
      });
}

void OpenAiClient::Impl::OnResponse(QuestionPtr question, absl::StatusOr<HttpResponse> response) {
  if (!response.ok()) return question->done(response.status());
  if (response->status / 100 == 2) {
    auto answer = options_.stream ? question->reader->FinishStream(options_.model)
                                  : question->reader->Read(response->body, options_.model);
    if (answer.ok()) Learn(*question, *answer);
    return question->done(std::move(answer));
  }
  const ServerError error = ReadServerError(response->body);
  if (AskedAgain(question, response->status, error)) return;
  if (response->status / 100 == 4 && IsRefusal(error)) {
    ChatAnswer refusal{.text = "", .finish = FinishReason::kRefused, .usage = {}, .model = options_.model};
    return question->done(std::move(refusal));
  }
  std::string where = fmt::format("{}: HTTP {}", address_, response->status);
  if (response->status == 404 && error.message.empty()) where += ", no such address; most base addresses end in /v1";
  absl::Status status = StatusOf(response->status, error, std::move(where), question->confidential);
  AddRetryAfter(*response, status);
  question->done(std::move(status));
}

bool OpenAiClient::Impl::AskedAgain(const QuestionPtr& question, int http_status, const ServerError& error) {
  const auto weaker = WeakerDialect(question->dialect, options_, !question->request.schema.empty(), http_status, error);
  if (!weaker.has_value()) return false;
  question->schema_rejected = weaker->form != question->dialect.form && RejectsSchema(error);
  question->dialect = *weaker;
  question->dialect_is_new = true;
  Send(question);
  return true;
}

Dialect OpenAiClient::Impl::Known(const std::string& schema_name) const {
  const std::lock_guard lock(mutex_);
  Dialect dialect = dialect_;
  const auto form = form_of_schema_.find(schema_name);
  if (form != form_of_schema_.end()) dialect.form = std::max(dialect.form, form->second);
  return dialect;
}

void OpenAiClient::Impl::Learn(const Question& question, const ChatAnswer& answer) {
  const std::lock_guard lock(mutex_);
  if (question.dialect_is_new) {
    const Dialect known = dialect_;
    dialect_ = question.dialect;
    dialect_.thinks = known.thinks;
    dialect_.schema_in_prompt = known.schema_in_prompt;
    if (question.schema_rejected) {
      form_of_schema_[question.request.schema_name] = question.dialect.form;
      dialect_.form = known.form;
    }
  }
  // An answer that had no room for any text was thought away, whether the server says so or not.
  const bool thought_away = answer.finish == FinishReason::kLength && answer.text.empty();
  dialect_.thinks = dialect_.thinks || question.reader->thought() || thought_away;
  LearnWhetherSchemasAreKept(question, answer);
}

void OpenAiClient::Impl::LearnWhetherSchemasAreKept(const Question& question, const ChatAnswer& answer) {
  const bool by_schema = !question.request.schema.empty() && question.dialect.form == AnswerForm::kJsonSchema;
  if (!by_schema || question.dialect.schema_in_prompt || schemas_are_kept_ || answer.finish != FinishReason::kStop) {
    return;
  }
  schemas_are_kept_ = KeepsTo(question.request.schema, answer.text);
  dialect_.schema_in_prompt = !schemas_are_kept_;
}

OpenAiClient::OpenAiClient(OpenAiOptions options, HttpLoop& loop, HttpOptions http)
    : impl_(std::make_shared<Impl>(std::move(options), loop, std::move(http))) {}

OpenAiClient::~OpenAiClient() = default;

void OpenAiClient::Ask(const ChatRequest& request, runtime::CallContext& call, AnswerCallback done) {
  impl_->Ask(request, call, std::move(done));
}

std::string OpenAiClient::identity() const { return IdentityOf(impl_->options()); }

}  // namespace flair::llm
