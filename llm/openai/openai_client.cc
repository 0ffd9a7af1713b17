// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/openai/openai_client.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::llm {
namespace {

// Whether an answer is what a server writes that keeps to the schema: one JSON object with all that it requires.
bool KeepsTo(const std::string& schema_text, const std::string& answer_text) {
  const nlohmann::json schema = ParseJson(schema_text), answer = ParseJson(answer_text);
  const nlohmann::json* const required = Field(schema, "required");
  if (required == nullptr || !required->is_array()) return true;
  return answer.is_object() && std::ranges::all_of(*required, [&](const nlohmann::json& name) {
           return !name.is_string() || answer.contains(name.get_ref<const std::string&>());
         });
}

// What wraps a token of a stream is fifty times as long as the token.
HttpOptions ForStreams(HttpOptions http, bool stream) {
  constexpr int64_t kStreamByteLimit = 64 << 20;
  if (stream) http.body_byte_limit = kStreamByteLimit;
  return http;
}

// As one segment of a path, or one value of a query.
std::string Escaped(const std::string& text) {
  std::string escaped;
  for (const unsigned char c : text) {
    const bool plain = std::isalnum(c) != 0 || c == '-' || c == '.' || c == '_' || c == '~';
    escaped += plain ? std::string(1, static_cast<char>(c)) : fmt::format("%{:02X}", c);
  }
  return escaped;
}

bool HasHeader(const OpenAiOptions& options, std::string_view name) {
  return std::ranges::any_of(options.headers, [&](const HttpHeader& header) {
    return absl::EqualsIgnoreCase(header.name, std::string(name));
  });
}

const char* NameOf(config::v1::AnswerForm form) {
  if (form == config::v1::ANSWER_FORM_TEXT) return "text";
  return form == config::v1::ANSWER_FORM_JSON_OBJECT ? "json_object" : "json_schema";
}

bool Contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

bool ContainsAny(const std::string& text, std::initializer_list<std::string_view> parts) {
  return std::ranges::any_of(parts, [&](std::string_view part) { return Contains(text, part); });
}

// All that the server said, in lower case.
std::string AllText(const ServerError& error) {
  return absl::AsciiStrToLower(error.param + " " + error.code + " " + error.type + " " + error.message);
}

// Rejected for what no other form of the request changes.
bool IsOfTheQuestion(const std::string& text) {
  return ContainsAny(text, {"context_length", "context length", "context window", "too long", "too large",
                            "content_filter", "content management policy", "responsibleai", "api_key", "api key",
                            "model_not_found", "model not found", "valid model", "unknown model"});
}

// Servers call a field that they do not know by many words.
bool RejectsField(const std::string& text, std::string_view field) {
  return Contains(text, field) &&
         ContainsAny(text,
                     {"unsupported",      "not supported",     "not support",     "unknown",     "unrecognized",
                      "unexpected",       "not permitted",     "not allowed",     "forbidden",   "not available",
                      "only the default", "may only",          "no longer",       "deprecated",  "invalid parameter",
                      "invalid field",    "cannot find field", "extra_forbidden", "extra field", "additional propert",
                      "not implemented",  "not accepted",      "must be verified"});
}

// The answer may not be as long as the request lets it be, or not together with the question.
bool RejectsTokenLimit(const std::string& text) {
  return ContainsAny(text, {"max_tokens", "max_completion_tokens", "in the completion", "completion tokens"}) &&
         ContainsAny(text, {"too large", "too big", "too high", "at most", "maximum", "less than", "exceed"});
}

// Templates of some models know users and assistants alone.
bool RejectsSystemRole(const std::string& text) {
  return (RejectsField(text, "system") && Contains(text, "role")) || Contains(text, "roles must alternate");
}

// "'minItems' is not permitted"
bool RejectsLimits(const std::string& text) {
  return ContainsAny(text, {"minitems", "maxitems", "minimum", "maximum"}) &&
         ContainsAny(text, {"permitted", "supported", "allowed", "unknown", "invalid", "keyword"});
}

bool NamesForm(const std::string& text) {
  return ContainsAny(text, {"response_format", "json_schema", "json_object", "json schema", "structured output",
                            "grammar", "guided_json", "guided decoding"});
}

std::optional<Dialect> WithWeakerForm(Dialect dialect, bool with_schema, bool fall_back) {
  if (!with_schema || !fall_back || dialect.form == config::v1::ANSWER_FORM_TEXT) return std::nullopt;
  dialect.form = dialect.form == config::v1::ANSWER_FORM_JSON_SCHEMA ? config::v1::ANSWER_FORM_JSON_OBJECT
                                                                     : config::v1::ANSWER_FORM_TEXT;
  return dialect;
}

// Keeps the order of the fields: a model writes them in the order of the schema.
using nlohmann::ordered_json;

const char* NameOf(Role role) {
  constexpr const char* kNames[] = {"system", "user", "assistant"};
  return kNames[static_cast<int>(role)];
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

ordered_json EncodeMessages(const Dialect& dialect, const ChatRequest& request) {
  std::vector<Message> messages = request.messages;
  if (!request.schema.empty() && (dialect.form != config::v1::ANSWER_FORM_JSON_SCHEMA || dialect.schema_in_prompt)) {
    AddToSystem(messages,
                "Answer with one JSON object and nothing else. It must follow this JSON schema:\n" + request.schema);
  }
  if (!dialect.system_role) SystemToUser(messages);
  ordered_json encoded = ordered_json::array();
  for (const Message& message : messages) {
    encoded.push_back({{"role", NameOf(message.role)}, {"content", message.text}});
  }
  return encoded;
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
  if (dialect.form == config::v1::ANSWER_FORM_JSON_OBJECT) return ordered_json{{"type", "json_object"}};
  ordered_json schema = ordered_json::parse(request.schema, nullptr, false);
  if (!schema.is_object()) return InvalidArgument("the schema of step '{}' is no JSON object", request.step);
  if (!dialect.schema_limits) DropLimits(schema);
  ordered_json format = {{"type", "json_schema"}};
  format["json_schema"] = {{"name", request.schema_name}, {"strict", true}, {"schema", std::move(schema)}};
  return format;
}

int TokenLimit(const OpenAiOptions& options, const Dialect& dialect, const ChatRequest& request) {
  if (request.max_output_token_count > 0) return request.max_output_token_count;
  if (options.config.max_output_token_count() > 0) return options.config.max_output_token_count();
  return dialect.thinks ? kThinkersOutputTokenCount : kUsualOutputTokenCount;
}

// The key and the values of the user's own headers.
std::vector<std::string> SecretsOf(const OpenAiOptions& options) {
  std::vector<std::string> secrets = {options.api_key};
  for (const HttpHeader& header : options.headers) secrets.push_back(header.value);
  // Nothing so short is a secret, and every error would hold it.
  std::erase_if(secrets, [](const std::string& secret) { return secret.size() < 4; });
  return secrets;
}

}  // namespace

OpenAiClient::OpenAiClient(OpenAiOptions options, HttpOptions http, const runtime::Clock& clock)
    : options_(std::move(options)),
      http_(ForStreams(std::move(http), options_.config.stream()), clock),
      url_(CompletionsUrl(options_)),
      address_(PublicAddress(url_)),
      dialect_{.form = options_.first_form()} {}

absl::StatusOr<ChatAnswer> OpenAiClient::Ask(const ChatRequest& request, runtime::CallContext& call) {
  const Confidential confidential{SecretsOf(options_), request.messages};
  Attempt attempt{.dialect = Known(request.schema_name)};
  // Ends: each dialect is weaker than the one before.
  while (true) {
    HttpRequest sent{.url = url_, .headers = RequestHeaders(options_)};
    ASSIGN_OR_RETURN(sent.body, EncodeRequest(options_, attempt.dialect, request));
    ASSIGN_OR_RETURN(const HttpResponse response, http_.Send(sent, call));
    if (response.status / 100 == 2) {
      ASSIGN_OR_RETURN(const ChatReply reply, ReadReply(response.body, options_.config.stream(),
                                                        {address_, request, confidential, options_.config.model()}));
      attempt.thought = reply.thought;
      Learn(request, attempt, reply.answer);
      return reply.answer;
    }
    const ServerError error = ReadServerError(response.body);
    const std::optional<Dialect> weaker =
        WeakerDialect(attempt.dialect, options_, !request.schema.empty(), response.status, error);
    if (!weaker.has_value()) return Failure(response, error, confidential);
    attempt = {.dialect = *weaker,
               .dialect_is_new = true,
               .schema_rejected = weaker->form != attempt.dialect.form && RejectsSchema(error)};
  }
}

absl::StatusOr<ChatAnswer> OpenAiClient::Failure(const HttpResponse& response, const ServerError& error,
                                                 const Confidential& confidential) const {
  if (response.status / 100 == 4 && IsRefusal(error)) {
    return ChatAnswer{.text = "", .finish = FinishReason::kRefused, .usage = {}, .model = options_.config.model()};
  }
  std::string where = fmt::format("{}: HTTP {}", address_, response.status);
  if (response.status == 404 && error.message.empty()) where += ", no such address; most base addresses end in /v1";
  absl::Status status = StatusOf(response.status, error, std::move(where), confidential);
  AddRetryAfter(response, status);
  return status;
}

Dialect OpenAiClient::Known(const std::string& schema_name) const {
  const std::lock_guard lock(mutex_);
  Dialect dialect = dialect_;
  const auto form = form_of_schema_.find(schema_name);
  if (form != form_of_schema_.end()) dialect.form = std::max(dialect.form, form->second);
  return dialect;
}

void OpenAiClient::Learn(const ChatRequest& request, const Attempt& attempt, const ChatAnswer& answer) {
  const std::lock_guard lock(mutex_);
  if (attempt.dialect_is_new) {
    const Dialect known = dialect_;
    dialect_ = attempt.dialect;
    dialect_.thinks = known.thinks;
    dialect_.schema_in_prompt = known.schema_in_prompt;
    if (attempt.schema_rejected) {
      form_of_schema_[request.schema_name] = attempt.dialect.form;
      dialect_.form = known.form;
    }
  }
  // An answer that had no room for any text was thought away, whether the server says so or not.
  const bool thought_away = answer.finish == FinishReason::kLength && answer.text.empty();
  dialect_.thinks = dialect_.thinks || attempt.thought || thought_away;
  LearnWhetherSchemasAreKept(request, attempt.dialect, answer);
}

void OpenAiClient::LearnWhetherSchemasAreKept(const ChatRequest& request, const Dialect& dialect,
                                              const ChatAnswer& answer) {
  const bool by_schema = !request.schema.empty() && dialect.form == config::v1::ANSWER_FORM_JSON_SCHEMA;
  if (!by_schema || dialect.schema_in_prompt || schemas_are_kept_ || answer.finish != FinishReason::kStop) return;
  schemas_are_kept_ = KeepsTo(request.schema, answer.text);
  dialect_.schema_in_prompt = !schemas_are_kept_;
}

std::string CompletionsUrl(const OpenAiOptions& options) {
  // Gateways and Azure have addresses with a query, which stays at the end.
  const size_t query_begin = std::min(options.config.base_url().find('?'), options.config.base_url().size());
  std::string path = options.config.base_url().substr(0, query_begin);
  std::string query = options.config.base_url().substr(query_begin);
  while (path.ends_with('/')) path.pop_back();
  // The whole address, as it is in many manuals.
  const bool whole = path.ends_with("/chat/completions");
  if (options.config.has_azure()) {
    if (path.ends_with("/openai")) path.resize(path.size() - std::string_view("/openai").size());
    if (!whole) path += "/openai/deployments/" + Escaped(options.config.azure().deployment());
    if (query.find("api-version=") == std::string::npos) {
      query +=
          fmt::format("{}api-version={}", query.empty() ? "?" : "&", Escaped(options.config.azure().api_version()));
    }
  }
  return path + (whole ? "" : "/chat/completions") + query;
}

std::vector<HttpHeader> RequestHeaders(const OpenAiOptions& options) {
  std::vector<HttpHeader> headers = {
      {"Content-Type", "application/json"},
      {"Accept", options.config.stream() ? "text/event-stream, application/json" : "application/json"},
      {"User-Agent", "flair"}};
  if (!options.api_key.empty()) {
    headers.push_back(options.config.has_azure() ? HttpHeader{"api-key", options.api_key}
                                                 : HttpHeader{"Authorization", "Bearer " + options.api_key});
  }
  // One of the user's own is sent instead: a server may take the first of two, or neither.
  std::erase_if(headers, [&](const HttpHeader& header) { return HasHeader(options, header.name); });
  headers.insert(headers.end(), options.headers.begin(), options.headers.end());
  return headers;
}

std::string IdentityOf(const OpenAiOptions& options) {
  std::string identity = fmt::format(
      "openai {} model={} form={} fall_back={} max_output_tokens={}", PublicAddress(CompletionsUrl(options)),
      options.config.model(), NameOf(options.first_form()), options.falls_back(),
      options.config.max_output_token_count() > 0 ? options.config.max_output_token_count() : kUsualOutputTokenCount);
  if (options.config.has_azure()) identity += " api_version=" + options.config.azure().api_version();
  if (options.config.has_temperature()) identity += fmt::format(" temperature={}", options.config.temperature());
  if (options.config.has_seed()) identity += fmt::format(" seed={}", options.config.seed());
  return identity;
}

std::optional<Dialect> WeakerDialect(const Dialect& dialect, const OpenAiOptions& options, bool with_schema,
                                     int http_status, const ServerError& error) {
  const std::string text = AllText(error);
  const bool rejected = http_status == 400 || http_status == 422;
  // Some servers find out only while they answer.
  if (!rejected && !((http_status == 500 || http_status == 501) && NamesForm(text))) return std::nullopt;

  Dialect weaker = dialect;
  const bool streamed = options.config.stream() && dialect.stream;
  if (RejectsField(text, "max_tokens") && !dialect.completion_token_limit) {
    weaker.completion_token_limit = true;
  } else if (RejectsTokenLimit(text) && dialect.token_limit) {
    weaker.token_limit = false;
  } else if (IsOfTheQuestion(text)) {
    return std::nullopt;
  } else if (RejectsField(text, "temperature") && dialect.temperature && options.config.has_temperature()) {
    weaker.temperature = false;
  } else if (RejectsField(text, "seed") && dialect.seed) {
    weaker.seed = false;
  } else if (RejectsField(text, "stream_options") && dialect.stream_usage && streamed) {
    weaker.stream_usage = false;
  } else if (RejectsField(text, "stream") && !Contains(text, "stream_options") && streamed) {
    weaker.stream = false;
  } else if (RejectsSystemRole(text) && dialect.system_role) {
    weaker.system_role = false;
  } else if (RejectsLimits(text) && with_schema && dialect.form == config::v1::ANSWER_FORM_JSON_SCHEMA &&
             dialect.schema_limits) {
    weaker.schema_limits = false;
  } else {
    // It names the form, or does not say what is wrong: then the form is the likeliest.
    return WithWeakerForm(dialect, with_schema, options.falls_back());
  }
  return weaker;
}

bool RejectsSchema(const ServerError& error) {
  return ContainsAny(AllText(error), {"invalid schema", "invalid_json_schema", "schema is invalid",
                                      "failed to parse grammar", "unsupported schema", "schema is not supported"});
}

absl::StatusOr<std::string> EncodeRequest(const OpenAiOptions& options, const Dialect& dialect,
                                          const ChatRequest& request) {
  ordered_json body = {{"model", options.config.model()}, {"messages", EncodeMessages(dialect, request)}};
  if (!request.schema.empty() && dialect.form != config::v1::ANSWER_FORM_TEXT) {
    ASSIGN_OR_RETURN(body["response_format"], EncodeFormat(dialect, request));
  }
  if (options.config.has_temperature() && dialect.temperature) body["temperature"] = options.config.temperature();
  if (dialect.seed) body["seed"] = options.config.has_seed() ? options.config.seed() : request.seed;
  if (dialect.token_limit) {
    body[dialect.completion_token_limit ? "max_completion_tokens" : "max_tokens"] =
        TokenLimit(options, dialect, request);
  }
  if (options.config.stream() && dialect.stream) {
    body["stream"] = true;
    if (dialect.stream_usage) body["stream_options"] = {{"include_usage", true}};
  }
  // Whatever is not UTF-8 becomes U+FFFD.
  return body.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace flair::llm
