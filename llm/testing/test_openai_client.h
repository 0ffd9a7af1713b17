// SPDX-License-Identifier: GPL-3.0-or-later
// For the tests of this folder: a client of a scripted server.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "llm/openai/openai_client.h"
#include "tests/fixtures/llm_server/scripted_server.h"

namespace flair::llm {

// What the scripts' models say.
inline constexpr char kBedroom[] = R"({"zones":[{"name":"Schlafen","objects":["Bett","Nachttisch größer 🛏"]}]})";

// Asks for zones.
inline ChatRequest ZonesRequest() {
  return {.step = "zones",
          .messages = {{Role::kSystem, "You divide rooms into zones."},
                       {Role::kUser, "The brief: \"a bedroom for a deep-sea diver, 4 by 3 metres\""}},
          .schema = R"({"type":"object","properties":{"zones":{"type":"array"},"about":{"type":"string"}}})",
          .schema_name = "zones"};
}

class OpenAiClientTest : public ::testing::Test {
 protected:
  OpenAiClientTest() {
    options_.config.set_model("some-model");
    options_.api_key = "sk-0123456789abcdef";
  }

  // The server found no fault with what the client sent.
  ~OpenAiClientTest() override {
    if (server_ != nullptr) {
      EXPECT_THAT(server_->problems(), ::testing::IsEmpty());
    }
  }

  flair::testing::ScriptedServer& Serve(flair::testing::Script script) {
    server_ = std::make_unique<flair::testing::ScriptedServer>(std::move(script));
    options_.config.set_base_url(server_->base_url());
    client_.reset();
    return *server_;
  }
  flair::testing::ScriptedServer& Serve(const std::string& script) { return Serve(flair::testing::LoadScript(script)); }

  // Made with the first use, so that a test can change options_ and http_ before.
  OpenAiClient& client() {
    if (client_ == nullptr) client_ = std::make_unique<OpenAiClient>(options_, http_);
    return *client_;
  }

  absl::StatusOr<ChatAnswer> Ask(const ChatRequest& request = ZonesRequest()) { return client().Ask(request, call_); }

  // The body of a request that the server saw.
  nlohmann::json Sent(int index) const { return nlohmann::json::parse(server_->requests().at(index).body); }

  OpenAiOptions options_;
  HttpOptions http_;
  runtime::CallContext call_;
  std::unique_ptr<flair::testing::ScriptedServer> server_;
  std::unique_ptr<OpenAiClient> client_;
};

}  // namespace flair::llm
