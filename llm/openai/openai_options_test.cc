// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "absl/strings/match.h"
#include "llm/openai/openai_client.h"

namespace flair::llm {
namespace {

std::string UrlOf(const std::string& base_url) {
  OpenAiOptions options;
  options.config.set_base_url(base_url);
  return CompletionsUrl(options);
}

std::string AzureUrlOf(const std::string& base_url) {
  OpenAiOptions options;
  options.config.set_base_url(base_url);
  options.config.mutable_azure()->set_deployment("rooms");
  options.config.mutable_azure()->set_api_version("2024-10-21");
  return CompletionsUrl(options);
}

TEST(CompletionsUrl, AddsThePathWhereItIsMissing) {
  EXPECT_EQ(UrlOf("https://a.example/v1"), "https://a.example/v1/chat/completions");
  EXPECT_EQ(UrlOf("https://a.example/v1//"), "https://a.example/v1/chat/completions");
  EXPECT_EQ(UrlOf("https://a.example/v1/chat/completions/"), "https://a.example/v1/chat/completions");
}

TEST(CompletionsUrl, AQueryStaysAtTheEnd) {
  EXPECT_EQ(UrlOf("https://a.example/openai/v1/?api-version=preview"),
            "https://a.example/openai/v1/chat/completions?api-version=preview");
  EXPECT_EQ(UrlOf("https://a.example/v1/chat/completions?team=rooms"),
            "https://a.example/v1/chat/completions?team=rooms");
}

TEST(CompletionsUrl, KnowsEveryFormOfAzuresAddress) {
  const std::string url = "https://n.example/openai/deployments/rooms/chat/completions?api-version=2024-10-21";
  EXPECT_EQ(AzureUrlOf("https://n.example"), url);
  EXPECT_EQ(AzureUrlOf("https://n.example/openai/"), url);
  // As Azure's portal shows it, with another version than the configured or without any.
  EXPECT_EQ(AzureUrlOf("https://n.example/openai/deployments/rooms/chat/completions"), url);
  EXPECT_EQ(AzureUrlOf("https://n.example/openai/deployments/own/chat/completions?api-version=2025-01-01"),
            "https://n.example/openai/deployments/own/chat/completions?api-version=2025-01-01");
  EXPECT_EQ(AzureUrlOf("https://gate.example/?tenant=7"),
            "https://gate.example/openai/deployments/rooms/chat/completions?tenant=7&api-version=2024-10-21");
}

TEST(RequestHeaders, AreSentOnceAndTheUsersOwnBeforeOurs) {
  OpenAiOptions options;
  options.api_key = "sk-of-the-file";
  options.headers = {{"authorization", "Basic abc"}, {"ACCEPT", "*/*"}, {"X-Team", "rooms"}};
  const auto headers = RequestHeaders(options);
  const auto count = [&](const char* name) {
    return std::ranges::count_if(headers,
                                 [&](const HttpHeader& header) { return absl::EqualsIgnoreCase(header.name, name); });
  };
  for (const char* name : {"authorization", "accept", "content-type", "user-agent", "x-team"})
    EXPECT_EQ(count(name), 1);
  EXPECT_EQ(headers.back().value, "rooms");
  for (const HttpHeader& header : headers) EXPECT_EQ(header.value.find("sk-of-the-file"), std::string::npos);
}

}  // namespace
}  // namespace flair::llm
