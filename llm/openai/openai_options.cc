// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/openai/openai_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "absl/strings/match.h"

namespace flair::llm {
namespace {

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

}  // namespace

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

std::vector<std::string> SecretsOf(const OpenAiOptions& options) {
  std::vector<std::string> secrets = {options.api_key};
  for (const HttpHeader& header : options.headers) secrets.push_back(header.value);
  // Nothing so short is a secret, and every error would hold it.
  std::erase_if(secrets, [](const std::string& secret) { return secret.size() < 4; });
  return secrets;
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

}  // namespace flair::llm
