// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mcp/server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <condition_variable>
#include <deque>
#include <future>
#include <memory>

#include "fmt/format.h"

namespace flair::cli::mcp {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// A server with a tool that answers what it is given, one that fails, and one that waits until it is cancelled.
class ServerTest : public ::testing::Test {
 protected:
  ServerTest() {
    Offer offer;
    offer.server_info = {{"name", "test"}, {"version", "1"}};
    offer.instructions = "Use it.";
    const auto add = [&](const std::string& name, auto run) {
      offer.tools.push_back({.listed = {{"name", name},
                                        {"inputSchema",
                                         {{"type", "object"},
                                          {"properties", {{"word", {{"type", "string"}}}}},
                                          {"additionalProperties", false}}}},
                             .run = run});
    };
    add("echo", [](const Json& arguments, ToolCall& call) -> absl::StatusOr<ToolResult> {
      for (int i = 1; i <= 3; ++i) call.Tell(i, 3, "step");
      call.Tell(2, 3, "back");
      return ToolResult{.structured = {{"word", arguments.value("word", "")}}};
    });
    add("fail", [](const Json&, ToolCall&) -> absl::StatusOr<ToolResult> { return absl::NotFoundError("no desk"); });
    add("wait", [this](const Json&, ToolCall& call) -> absl::StatusOr<ToolResult> {
      std::promise<void> cancelled;
      {
        const runtime::OnCancel told(call.context().cancellation(), [&] { cancelled.set_value(); });
        started_.set_value();
        cancelled.get_future().wait();
      }
      ended_.set_value();
      return call.context().CheckAlive();
    });
    offer.resources.list = [] { return Json::array({{{"uri", "test://a"}, {"name", "a"}}}); };
    offer.resources.read = [](const std::string& uri, runtime::CallContext&) -> absl::StatusOr<Json> {
      if (uri != "test://a") return absl::NotFoundError("no such thing");
      return Json{{"uri", uri}, {"text", "A"}};
    };
    server_ = std::make_unique<Server>(std::move(offer), [this](const std::string& line) {
      const std::lock_guard lock(mutex_);
      sent_.push_back(Json::parse(line));
      arrived_.notify_all();
    });
  }

  Json Next() {
    std::unique_lock lock(mutex_);
    arrived_.wait(lock, [this] { return !sent_.empty(); });
    Json message = sent_.front();
    sent_.pop_front();
    EXPECT_EQ(message["jsonrpc"], "2.0");
    return message;
  }
  Json Ask(const std::string& line) {
    server_->Receive(line);
    return Next();
  }
  int CodeOf(const std::string& line) { return Ask(line).at("error").at("code"); }
  std::string Initialize(const std::string& version) {
    return Ask(fmt::format(
        R"({{"jsonrpc":"2.0","id":0,"method":"initialize","params":{{"protocolVersion":"{}","capabilities":{{}},)"
        R"("clientInfo":{{"name":"t","version":"1"}}}}}})",
        version))["result"]["protocolVersion"];
  }
  static std::string Request(int id, const std::string& method, const std::string& params = "{}") {
    return fmt::format(R"({{"jsonrpc":"2.0","id":{},"method":"{}","params":{}}})", id, method, params);
  }
  static std::string Modern(int id, const std::string& method, const std::string& more = "",
                            const std::string& version = "2026-07-28") {
    return Request(id, method,
                   fmt::format(R"({{"_meta":{{"io.modelcontextprotocol/protocolVersion":"{}",)"
                               R"("io.modelcontextprotocol/clientCapabilities":{{}}}}{}}})",
                               version, more));
  }

  std::promise<void> started_, ended_;
  std::mutex mutex_;
  std::condition_variable arrived_;
  std::deque<Json> sent_;
  std::unique_ptr<Server> server_;
};

TEST_F(ServerTest, AnswersTheRevisionAskedForOrItsNewest) {
  EXPECT_EQ(Initialize("2025-06-18"), "2025-06-18");
  EXPECT_EQ(CodeOf(Request(1, "initialize", R"({"protocolVersion":"2025-06-18"})")), kInvalidRequest);
}
TEST_F(ServerTest, KnowsTheNewestRevisionWithAHandshake) { EXPECT_EQ(Initialize("2025-11-25"), "2025-11-25"); }
TEST_F(ServerTest, AnswersOlderRevisionsWithItsNewest) { EXPECT_EQ(Initialize("2024-11-05"), "2025-11-25"); }
TEST_F(ServerTest, AnswersUnknownRevisionsWithItsNewest) { EXPECT_EQ(Initialize("tomorrow"), "2025-11-25"); }

TEST_F(ServerTest, OnlyPingComesBeforeInitialize) {
  EXPECT_EQ(Ask(Request(1, "ping"))["result"], Json::object());
  EXPECT_EQ(CodeOf(Request(2, "tools/list")), kInvalidRequest);
  EXPECT_EQ(CodeOf(Request(3, "initialize", "{}")), kInvalidParams);
  Initialize("2025-11-25");
  EXPECT_EQ(Ask(Request(4, "tools/list"))["result"]["tools"].size(), 3u);
}

TEST_F(ServerTest, ServesRequestsThatNameTheirRevisionWithoutAHandshake) {
  const Json found = Ask(Modern(1, "server/discover"))["result"];
  EXPECT_EQ(found["supportedVersions"], Json::array({"2026-07-28"}));
  EXPECT_EQ(found["resultType"], "complete");
  EXPECT_GT(found["ttlMs"], 0);
  EXPECT_EQ(found["_meta"]["io.modelcontextprotocol/serverInfo"]["name"], "test");
  const Json listed = Ask(Modern(2, "resources/list"))["result"];
  EXPECT_EQ(listed["cacheScope"], "private");
  EXPECT_EQ(Ask(Modern(3, "tools/call", R"(,"name":"echo","arguments":{"word":"a"})"))["result"]["resultType"],
            "complete");
  const Json refused = Ask(Modern(4, "tools/list", "", "1900-01-01"))["error"];
  EXPECT_EQ(refused["code"], kUnsupportedVersion);
  EXPECT_EQ(refused["data"]["supported"], Json::array({"2026-07-28"}));
  EXPECT_EQ(refused["data"]["requested"], "1900-01-01");
  EXPECT_EQ(CodeOf(Modern(5, "ping")), kMethodNotFound);
  EXPECT_EQ(CodeOf(Request(6, "server/discover")), kInvalidParams);
  EXPECT_EQ(CodeOf(Request(7, "tools/list", R"({"_meta":{"io.modelcontextprotocol/protocolVersion":"2026-07-28"}})")),
            kInvalidParams);
}

TEST_F(ServerTest, ListensUntilTheClientEndsIt) {
  const Json told = Ask(Modern(1, "subscriptions/listen", R"(,"notifications":{"toolsListChanged":true})"));
  EXPECT_EQ(told["method"], "notifications/subscriptions/acknowledged");
  EXPECT_EQ(told["params"]["_meta"]["io.modelcontextprotocol/subscriptionId"], 1);
  EXPECT_EQ(CodeOf(Modern(1, "tools/call", R"(,"name":"echo")")), kInvalidRequest) << "its id is taken";
  server_->Receive(R"({"jsonrpc":"2.0","method":"notifications/cancelled","params":{"requestId":1}})");
  EXPECT_TRUE(Ask(Modern(1, "tools/call", R"(,"name":"echo")")).contains("result"));
}

TEST_F(ServerTest, CallsToolsAndToldOfTheirFaultsAsResults) {
  Initialize("2025-11-25");
  const Json done = Ask(Request(1, "tools/call", R"({"name":"echo","arguments":{"word":"chair"}})"))["result"];
  EXPECT_EQ(done["structuredContent"]["word"], "chair");
  EXPECT_EQ(done["content"][0]["text"], R"({"word":"chair"})");
  EXPECT_EQ(done["isError"], false);
  EXPECT_FALSE(done.contains("resultType"));
  EXPECT_EQ(Ask(Request(9, "tools/call", R"({"name":"echo","arguments":{"word":null}})"))["result"]["isError"], false);
  const Json failed = Ask(Request(2, "tools/call", R"({"name":"fail"})"))["result"];
  EXPECT_EQ(failed["isError"], true);
  EXPECT_EQ(failed["content"][0]["text"], "no desk");
  const Json wrong = Ask(Request(3, "tools/call", R"({"name":"echo","arguments":{"word":7}})"))["result"];
  EXPECT_EQ(wrong["isError"], true);
  EXPECT_EQ(wrong["content"][0]["text"], "word: 7; must be a string");
  EXPECT_EQ(CodeOf(Request(4, "tools/call", R"({"name":"sing"})")), kInvalidParams);
  EXPECT_EQ(CodeOf(Request(5, "tools/call", R"({"name":"echo","arguments":[]})")), kInvalidParams);
  EXPECT_EQ(CodeOf(Request(6, "tools/call", "{}")), kInvalidParams);
  EXPECT_EQ(CodeOf(Request(7, "prompts/list")), kMethodNotFound);
  EXPECT_EQ(CodeOf(Request(8, "tools/list", R"({"cursor":"x"})")), kInvalidParams);
}

TEST_F(ServerTest, ProgressGrowsAndOnlyWhoAsksIsTold) {
  Initialize("2025-11-25");
  server_->Receive(Request(1, "tools/call", R"({"name":"echo","_meta":{"progressToken":"p"}})"));
  for (int i = 1; i <= 3; ++i) {
    const Json told = Next();
    EXPECT_EQ(told["method"], "notifications/progress");
    EXPECT_EQ(told["params"]["progressToken"], "p");
    EXPECT_EQ(told["params"]["progress"], i);
    EXPECT_EQ(told["params"]["total"], 3);
  }
  EXPECT_EQ(Next()["id"], 1);
  EXPECT_EQ(CodeOf(Request(2, "tools/call", R"({"name":"echo","_meta":{"progressToken":1.5}})")), kInvalidParams);
}

TEST_F(ServerTest, ACancelledCallEndsAndIsNotAnswered) {
  Initialize("2025-11-25");
  server_->Receive(Request(1, "tools/call", R"({"name":"wait"})"));
  started_.get_future().wait();
  server_->Receive(R"({"jsonrpc":"2.0","method":"notifications/cancelled","params":{"requestId":99}})");
  server_->Receive(
      R"({"jsonrpc":"2.0","method":"notifications/cancelled","params":{"requestId":1,"reason":"enough"}})");
  ended_.get_future().wait();
  EXPECT_EQ(Ask(Request(2, "ping"))["id"], 2);
  EXPECT_THAT(sent_, IsEmpty());
}

TEST_F(ServerTest, AnotherCallIsAnsweredWhileOneRuns) {
  Initialize("2025-11-25");
  server_->Receive(Request(1, "tools/call", R"({"name":"wait"})"));
  started_.get_future().wait();
  EXPECT_EQ(Ask(Request(2, "tools/call", R"({"name":"echo"})"))["id"], 2);
  EXPECT_EQ(CodeOf(Request(1, "tools/call", R"({"name":"echo"})")), kInvalidRequest);
  server_.reset();  // cancels it
  ended_.get_future().wait();
  EXPECT_THAT(sent_, IsEmpty());
}

TEST_F(ServerTest, TooManyCallsAreRefused) {
  Initialize("2025-11-25");
  for (int i = 0; i < 64; ++i) {
    server_->Receive(Modern(100 + i, "subscriptions/listen", R"(,"notifications":{})"));
    Next();
  }
  EXPECT_EQ(CodeOf(Request(1, "tools/call", R"({"name":"echo"})")), kInternalError);
}

TEST_F(ServerTest, ResourcesAreReadAndMissingOnesAreToldAsTheRevisionWants) {
  Initialize("2025-06-18");
  EXPECT_EQ(Ask(Request(1, "resources/read", R"({"uri":"test://a"})"))["result"]["contents"][0]["text"], "A");
  const Json missing = Ask(Request(2, "resources/read", R"({"uri":"test://b"})"))["error"];
  EXPECT_EQ(missing["code"], kResourceNotFound);
  EXPECT_EQ(missing["data"]["uri"], "test://b");
  EXPECT_EQ(CodeOf(Modern(3, "resources/read", R"(,"uri":"test://b")")), kInvalidParams);
  EXPECT_EQ(CodeOf(Request(4, "resources/read", R"({"uri":4})")), kInvalidParams);
}

TEST_F(ServerTest, LinesThatAreNoMessagesAreRefusedEachInItsWay) {
  Initialize("2025-11-25");
  const std::string deep(200, '[');
  struct Case {
    std::string line;
    int code;
    std::string says;
    Json id = Json();
  };
  const Case cases[] = {
      {"{", kParseError, "no JSON"},
      {"{\"a\":\"\xff\"}", kParseError, "UTF-8"},
      {R"({"jsonrpc":"2.0","id":1e999,"method":"ping"})", kParseError, "number overflow"},
      {R"({"jsonrpc":"2.0","id":1,"id":2,"method":"ping"})", kParseError, "\"id\" twice"},
      {deep, kParseError, "levels deep"},
      {R"({"jsonrpc":"2.0","id":1,"method":"ping"} x)", kParseError, "no JSON"},
      {R"([{"jsonrpc":"2.0","id":1,"method":"ping"}])", kInvalidRequest, "batches"},
      {"[]", kInvalidRequest, "batches"},
      {"7", kInvalidRequest, "an object"},
      {R"({"id":1,"method":"ping"})", kInvalidRequest, "jsonrpc", 1},
      {R"({"jsonrpc":"1.0","id":"x","method":"ping"})", kInvalidRequest, "jsonrpc", "x"},
      {R"({"jsonrpc":"2.0","id":null,"method":"ping"})", kInvalidRequest, "id"},
      {R"({"jsonrpc":"2.0","id":1.5,"method":"ping"})", kInvalidRequest, "id"},
      {R"({"jsonrpc":"2.0","id":1})", kInvalidRequest, "method", 1},
      {R"({"jsonrpc":"2.0","id":1,"method":7})", kInvalidRequest, "method", 1},
      {R"({"jsonrpc":"2.0","id":1,"method":"ping","params":[]})", kInvalidParams, "params", 1},
  };
  for (const Case& one : cases) {
    const Json answer = Ask(one.line);
    EXPECT_EQ(answer["error"]["code"], one.code) << one.line;
    EXPECT_THAT(answer["error"]["message"].get<std::string>(), HasSubstr(one.says)) << one.line;
    EXPECT_EQ(answer.value("id", Json()), one.id) << one.line;
  }
  server_->ReceiveTooLong();
  EXPECT_THAT(Next()["error"]["message"].get<std::string>(), HasSubstr("8 MiB"));
}

TEST_F(ServerTest, NotificationsAndAnswersAreNotAnswered) {
  Initialize("2025-11-25");
  server_->Receive(R"({"jsonrpc":"2.0","method":"notifications/initialized"})");
  server_->Receive(R"({"jsonrpc":"2.0","method":"ping"})");
  server_->Receive(R"({"jsonrpc":"2.0","id":1,"result":{}})");
  server_->Receive(R"({"jsonrpc":"2.0","method":"notifications/cancelled","params":{}})");
  server_->Receive(" \r");
  EXPECT_EQ(Ask(Request(5, "ping"))["id"], 5);
  EXPECT_THAT(sent_, IsEmpty());
}

}  // namespace
}  // namespace flair::cli::mcp
