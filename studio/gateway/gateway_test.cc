// SPDX-License-Identifier: GPL-3.0-or-later
#include "studio/gateway/gateway.h"

#include <gmock/gmock.h>

#include <future>

#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "studio/gateway/testing/browser.h"
#include "studio/gateway/testing/fake_studio.h"
#include "worker_runtime/grpc/channel.h"

namespace flair::studio::testing {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;

class GatewayTest : public ::testing::Test {
 protected:
  void Start(const GatewayLimits& limits = {}) {
    GatewayOptions options;
    options.services = {{.full_name = kService,
                         .channel = studio_.channel(),
                         .methods = {"GetDocument", "ListDocuments", "CreateDocument", "WatchDocuments"},
                         .upload_methods = {"CreateDocument"}}};
    options.token = TestToken();
    options.limits = limits;
    auto gateway = Gateway::Start(std::move(options));
    ASSERT_TRUE(gateway.ok()) << gateway.status();
    gateway_ = *std::move(gateway);
  }

  FakeStudio studio_;
  std::unique_ptr<Gateway> gateway_;
};

TEST_F(GatewayTest, AnswersUnaryCallsOnOneConnection) {
  Start();
  Browser browser(*gateway_);
  for (const std::string id : {"a", "b", "\\u00e9"}) {
    const Answer answer = browser.Ask(browser.Post(kGetDocument, fmt::format(R"({{"documentId":"{}"}})", id)));
    EXPECT_EQ(answer.status, 200);
    EXPECT_EQ(answer.headers.at("content-type"), "application/json");
    EXPECT_EQ(answer.headers.at("cache-control"), "no-store");
    EXPECT_EQ(json::parse(answer.body)["document"]["title"], json::parse("\"" + id + "\""));
  }
}

TEST_F(GatewayTest, GivesEachErrorItsNameAndStatus) {
  Start();
  Browser browser(*gateway_);
  const std::vector<std::pair<std::string, int>> codes = {{"canceled", 499},
                                                          {"unknown", 500},
                                                          {"invalid_argument", 400},
                                                          {"deadline_exceeded", 504},
                                                          {"not_found", 404},
                                                          {"already_exists", 409},
                                                          {"permission_denied", 403},
                                                          {"resource_exhausted", 429},
                                                          {"failed_precondition", 400},
                                                          {"aborted", 409},
                                                          {"out_of_range", 400},
                                                          {"unimplemented", 501},
                                                          {"internal", 500},
                                                          {"unavailable", 503},
                                                          {"data_loss", 500},
                                                          {"unauthenticated", 401}};
  for (size_t i = 0; i < codes.size(); ++i) {
    const Answer answer = browser.Ask(browser.Post(kGetDocument, fmt::format(R"({{"documentId":"error/{}"}})", i + 1)));
    EXPECT_EQ(answer.status, codes[i].second) << codes[i].first;
    EXPECT_EQ(json::parse(answer.body),
              json({{"code", codes[i].first}, {"message", fmt::format("words of error/{}", i + 1)}}));
  }
}

TEST_F(GatewayTest, SaysInPlainWordsThatTheServiceIsNotThere) {
  GatewayOptions options;
  options.services = {{.full_name = kService, .channel = *runtime::MakeChannel("unix:/nowhere/studio", kService)}};
  options.token = TestToken();
  const auto gateway = Gateway::Start(std::move(options));
  Browser browser(**gateway);
  const Answer answer = browser.Ask(browser.Post(kGetDocument, "{}"));
  EXPECT_EQ(answer.status, 503);
  EXPECT_EQ(json::parse(answer.body)["message"], "there is no socket unix:/nowhere/studio");
}

TEST_F(GatewayTest, NamesWhatIsWrongWithARequest) {
  Start();
  Browser browser(*gateway_);
  const std::vector<std::pair<std::string, std::string>> cases = {
      {R"({"documentId":"a","colour":1})", "the request is no flair.v1.GetDocumentRequest: colour: Cannot find field."},
      {R"({"documentId":{}})", "document_id"},
      {R"({"documentId":)", "Unexpected end"},
      {"", "Unexpected end"},
      {"[]", "Root element must be a message"},
      {"\xff\xfe", "UTF-8"},
      {std::string(100000, '{'), "is no flair.v1.GetDocumentRequest"},
      {R"({"documentId":")" + std::string(1000, 'a'), "is no flair.v1.GetDocumentRequest"}};
  for (const auto& [body, words] : cases) {
    const Answer answer = browser.Ask(browser.Post(kGetDocument, body));
    EXPECT_EQ(answer.status, 400) << body.substr(0, 50);
    EXPECT_EQ(json::parse(answer.body)["code"], "invalid_argument");
    EXPECT_THAT(std::string(json::parse(answer.body)["message"]), HasSubstr(words));
    EXPECT_LT(answer.body.size(), 500);
  }
}

TEST_F(GatewayTest, RefusesMessagesWithinMessagesWithoutEnd) {
  Start();
  GatewayOptions options;
  std::string deep;
  for (int i = 0; i < 10000; ++i) deep += R"({"design":{"room":)";
  Browser browser(*gateway_);
  const Answer answer = browser.Ask(browser.Post(kCreateDocument, deep));
  EXPECT_EQ(answer.status, 400);
}

TEST_F(GatewayTest, HasOnlyTheMethodsOfItsList) {
  Start();
  for (const std::string path :
       {"/flair.v1.StudioService/Act", "/flair.v1.StudioService/Nothing", "/flair.v1.OrchestratorService/ListJobs", "/",
        "/flair.v1.StudioService/GetDocument/", "/grpc.health.v1.Health/Check"}) {
    Browser browser(*gateway_);
    const Answer answer = browser.Ask(browser.Post(path, "{}"));
    EXPECT_EQ(answer.status, 404) << path;
    EXPECT_EQ(json::parse(answer.body)["code"], "unimplemented");
  }
}

TEST_F(GatewayTest, HoldsCallsToTheirDeadlines) {
  GatewayLimits limits;
  limits.call_timeout = absl::Seconds(100);
  Start(limits);
  Browser browser(*gateway_);
  const auto left = [&](const std::string& timeout) {
    const Answer answer =
        browser.Ask(browser.Post(kGetDocument, R"({"documentId":"deadline"})", {{"Connect-Timeout-Ms", timeout}}));
    return std::stoi(std::string(json::parse(answer.body)["document"]["revision"]));
  };
  EXPECT_THAT(left("50000"), AllOf(::testing::Gt(30000), ::testing::Le(50000)));
  EXPECT_THAT(left("9999999999"), AllOf(::testing::Gt(80000), ::testing::Le(100000)));
  EXPECT_THAT(left(""), AllOf(::testing::Gt(80000), ::testing::Le(100000)));
  const Answer late =
      browser.Ask(browser.Post(kGetDocument, R"({"documentId":"wait"})", {{"Connect-Timeout-Ms", "1"}}));
  EXPECT_EQ(late.status, 504);
  EXPECT_EQ(json::parse(late.body), json({{"code", "deadline_exceeded"}, {"message", "no answer in time"}}));
  for (const std::string wrong : {"-1", "x", "1.5", "12345678901", "1 "}) {
    EXPECT_EQ(browser.Ask(browser.Post(kGetDocument, "{}", {{"Connect-Timeout-Ms", wrong + "x"}})).status, 400)
        << wrong;
  }
}

TEST_F(GatewayTest, CancelsTheCallOfABrowserThatHasGone) {
  Start();
  Browser browser(*gateway_);
  browser.Say(browser.Post(kGetDocument, R"({"documentId":"wait"})"));
  studio_.AwaitWaiting(1);
  browser.Leave();
  studio_.AwaitCancelled(1);
}

// What comes before the answer must not hide that nobody waits for it any more.
TEST_F(GatewayTest, CancelsTheCallsOfBrowsersThatSendAheadAndGo) {
  Start();
  Browser caller(*gateway_);
  caller.Say(caller.Post(kGetDocument, R"({"documentId":"wait"})") + caller.Get("/"));
  Browser listener(*gateway_);
  listener.Say(listener.PostStream(kWatchDocuments, "{}") + "{}");
  EXPECT_EQ(listener.ReadStreamHead().status, 200);
  studio_.AwaitWaiting(2);
  listener.Say("more");
  caller.Say(caller.Get("/"));
  caller.Leave();
  listener.Leave();
  studio_.AwaitCancelled(2);
  Browser patient(*gateway_);
  const Answer answer = patient.Ask(patient.Post(kGetDocument, "{}") + patient.Get("/"));
  EXPECT_EQ(answer.status, 200);
  EXPECT_EQ(answer.headers.at("connection"), "close");
}

TEST_F(GatewayTest, StreamsUntilTheServiceEnds) {
  Start();
  Browser browser(*gateway_);
  browser.Say(browser.PostStream(kWatchDocuments, "{}"));
  const Answer head = browser.ReadStreamHead();
  EXPECT_EQ(head.status, 200);
  EXPECT_EQ(head.headers.at("content-type"), "application/connect+json");
  studio_.AwaitWaiting(1);
  for (const std::string id : {"a", "b"}) {
    studio_.Say(id);
    EXPECT_EQ(browser.ReadMessage()->json, fmt::format(R"({{"deletedDocumentId":"{}"}})", id));
  }
  for (int i = 0; i < 100; ++i) studio_.Say(std::to_string(i));
  studio_.EndStreams(grpc::Status::OK);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(browser.ReadMessage()->json, fmt::format(R"({{"deletedDocumentId":"{}"}})", i));
  }
  const std::optional<Message> end = browser.ReadMessage();
  EXPECT_TRUE(end->last);
  EXPECT_EQ(end->json, "{}");
  EXPECT_FALSE(browser.ReadMessage().has_value());
  // The connection goes on.
  browser.Say("\r\n");
}

TEST_F(GatewayTest, EndsAStreamWithTheErrorOfTheService) {
  Start();
  Browser browser(*gateway_);
  browser.Say(browser.PostStream(kWatchDocuments, "{}"));
  EXPECT_EQ(browser.ReadStreamHead().status, 200);
  studio_.AwaitWaiting(1);
  studio_.EndStreams({grpc::StatusCode::ABORTED, "enough \xff"});
  EXPECT_EQ(browser.ReadMessage()->json, "{\"error\":{\"code\":\"aborted\",\"message\":\"enough \xef\xbf\xbd\"}}");
  EXPECT_FALSE(browser.ReadMessage().has_value());
  EXPECT_EQ(browser.Ask(browser.Post(kGetDocument, R"({"documentId":"a"})")).status, 200);
}

TEST_F(GatewayTest, SaysInTheStreamWhatIsWrongWithItsRequest) {
  Start();
  for (const std::string message : {"{\"a\":1}", "", "x"}) {
    Browser browser(*gateway_);
    browser.Say(browser.PostStream(kWatchDocuments, message));
    EXPECT_EQ(browser.ReadStreamHead().status, 200);
    const std::optional<Message> end = browser.ReadMessage();
    EXPECT_TRUE(end->last);
    EXPECT_EQ(json::parse(end->json)["error"]["code"], "invalid_argument");
  }
  for (const std::string& body : {std::string(), std::string(4, '\0'), std::string("\0\0\0\0\1{}", 7),
                                  std::string("\1\0\0\0\2{}", 7), std::string("\0\xff\xff\xff\xff{}", 7)}) {
    Browser browser(*gateway_);
    browser.Say(browser.Post(kWatchDocuments, body, {{"Content-Type", "application/connect+json"}}));
    EXPECT_EQ(browser.ReadStreamHead().status, 200);
    EXPECT_EQ(json::parse(browser.ReadMessage()->json)["error"]["code"], "invalid_argument");
  }
}

TEST_F(GatewayTest, CancelsTheStreamOfABrowserThatHasGone) {
  Start();
  Browser browser(*gateway_);
  browser.Say(browser.PostStream(kWatchDocuments, "{}"));
  EXPECT_EQ(browser.ReadStreamHead().status, 200);
  studio_.AwaitWaiting(1);
  browser.Leave();
  studio_.AwaitCancelled(1);
}

TEST_F(GatewayTest, TakesOnlySoManyStreams) {
  GatewayLimits limits;
  limits.streams = 2;
  Start(limits);
  std::vector<std::unique_ptr<Browser>> browsers;
  for (int i = 0; i < 3; ++i) {
    browsers.push_back(std::make_unique<Browser>(*gateway_));
    browsers.back()->Say(browsers.back()->PostStream(kWatchDocuments, "{}"));
    EXPECT_EQ(browsers.back()->ReadStreamHead().status, 200);
  }
  EXPECT_EQ(json::parse(browsers[2]->ReadMessage()->json)["error"]["code"], "resource_exhausted");
  EXPECT_EQ(browsers[2]->Ask(browsers[2]->Post(kGetDocument, "{}")).status, 0);
}

// The call of the first still tells its end while the second is under way.
TEST_F(GatewayTest, AStreamThatTheGatewayEndsDoesNotEndTheNext) {
  Start({.held_bytes = 1000});
  for (int i = 0; i < 20; ++i) {
    Browser browser(*gateway_);
    browser.Say(browser.PostStream(kWatchDocuments, "{}"));
    EXPECT_EQ(browser.ReadStreamHead().status, 200);
    studio_.AwaitWaiting(2 * i + 1);
    studio_.Say(std::string(2000, 'a'));
    EXPECT_EQ(json::parse(browser.ReadMessage()->json)["error"]["code"], "resource_exhausted");
    EXPECT_FALSE(browser.ReadMessage().has_value());
    std::optional<Browser> next;
    if (!browser.Say(browser.PostStream(kWatchDocuments, "{}")) || browser.ReadStreamHead().status == 0) {
      next.emplace(*gateway_);
      next->Say(next->PostStream(kWatchDocuments, "{}"));
      EXPECT_EQ(next->ReadStreamHead().status, 200);
    }
    studio_.AwaitWaiting(2 * i + 2);
    studio_.Say("b");
    EXPECT_EQ((next.has_value() ? *next : browser).ReadMessage()->json, R"({"deletedDocumentId":"b"})");
  }
}

TEST_F(GatewayTest, StopEndsStreamsAndWaitsForAnswers) {
  Start();
  Browser listener(*gateway_);
  listener.Say(listener.PostStream(kWatchDocuments, "{}"));
  EXPECT_EQ(listener.ReadStreamHead().status, 200);
  Browser caller(*gateway_);
  caller.Say(caller.Post(kGetDocument, R"({"documentId":"wait"})"));
  Browser idle(*gateway_);
  studio_.AwaitWaiting(2);
  const auto stopped = std::async(std::launch::async, [this] { gateway_->Stop(); });
  EXPECT_EQ(listener.ReadMessage()->json, R"({"error":{"code":"unavailable","message":"the studio is stopping"}})");
  studio_.AnswerWaiting();
  EXPECT_EQ(caller.Read().status, 200);
  EXPECT_EQ(idle.ReadAll(), "");
  stopped.wait();
  gateway_->Stop();
  Browser late(*gateway_);
  EXPECT_EQ(late.Ask(late.Get("/")).status, 0);
}

TEST_F(GatewayTest, StopDoesNotWaitForEver) {
  GatewayLimits limits;
  limits.drain_timeout = absl::ZeroDuration();
  Start(limits);
  Browser browser(*gateway_);
  browser.Say(browser.Post(kGetDocument, R"({"documentId":"wait"})"));
  studio_.AwaitWaiting(1);
  gateway_->Stop();
  studio_.AwaitCancelled(1);
}

TEST_F(GatewayTest, TakesLargeFilesOnlyWhereTheyAreUploaded) {
  GatewayLimits limits;
  limits.body_bytes = 1000;
  limits.upload_bytes = 40 << 20;
  Start(limits);
  {
    Browser browser(*gateway_);
    const std::string file((30 << 20) - 100, 'A');
    const Answer answer = browser.Ask(browser.Post(kCreateDocument, R"({"file":")" + file + "\"}"));
    EXPECT_EQ(answer.status, 200) << answer.body;
    EXPECT_EQ(json::parse(answer.body)["document"]["title"], std::to_string(file.size() / 4 * 3));
  }
  {
    Browser browser(*gateway_);
    const Answer answer =
        browser.Ask(browser.Post(kGetDocument, R"({"documentId":")" + std::string(1000, 'a') + "\"}"));
    EXPECT_EQ(answer.status, 413);
    EXPECT_EQ(json::parse(answer.body)["code"], "resource_exhausted");
  }
  Browser browser(*gateway_);
  browser.Say(browser.Post(kCreateDocument, "", {{"Content-Length", std::to_string(41 << 20)}}));
  EXPECT_EQ(browser.Read().status, 413);
}

TEST_F(GatewayTest, HoldsOnlySoManyBytes) {
  GatewayLimits limits;
  limits.held_bytes = 100000;
  Start(limits);
  // A body that never comes whole.
  const Headers large = {{"Content-Length", "60000"}, {"Expect", "100-continue"}};
  Browser first(*gateway_);
  EXPECT_EQ(first.Ask(first.Post(kCreateDocument, "", large)).status, 100);
  Browser second(*gateway_);
  const Answer answer = second.Ask(second.Post(kCreateDocument, "", large));
  EXPECT_EQ(answer.status, 429);
  EXPECT_EQ(json::parse(answer.body)["code"], "resource_exhausted");
  // Answers count too.
  Browser third(*gateway_);
  EXPECT_EQ(third.Ask(third.Post(kListDocuments, R"({"pageSize":20})")).status, 200);
  EXPECT_EQ(third.Ask(third.Post(kListDocuments, R"({"pageSize":80})")).status, 429);
  first.Leave();
}

TEST(GatewayStart, RefusesWhatItCannotServe) {
  FakeStudio studio;
  const auto start = [](GatewayOptions options) {
    return std::string(Gateway::Start(std::move(options)).status().message());
  };
  for (const std::string address :
       {"0.0.0.0:0", "[::]:0", "192.168.1.5:80", "studio.example:0", "127.0.0.1", "", ":0"}) {
    EXPECT_THAT(start({.listen_address = address}),
                HasSubstr("expected 127.0.0.1:PORT, localhost:PORT or [::1]:PORT; to serve other machines"))
        << address;
  }
  EXPECT_EQ(start({.services = {{.full_name = "flair.v1.No", .channel = studio.channel()}}}),
            "this program knows no service flair.v1.No");
  EXPECT_EQ(start({.services = {{.full_name = kService, .channel = studio.channel(), .methods = {"No"}}}}),
            "flair.v1.StudioService has no method No");
  EXPECT_EQ(start({.services = {{.full_name = kService}}}), "flair.v1.StudioService: there is no channel to it");
  const auto first = Gateway::Start({});
  EXPECT_THAT(start({.listen_address = fmt::format("127.0.0.1:{}", (*first)->port())}),
              HasSubstr("another program listens there"));
}

TEST(GatewayStart, MakesAnAddressWithATokenOfItsOwn) {
  const auto first = Gateway::Start({});
  const auto second = Gateway::Start({.listen_address = "localhost:0"});
  EXPECT_THAT((*first)->url(), ::testing::MatchesRegex("http://127\\.0\\.0\\.1:[0-9]+/\\?token=[0-9a-f]+"));
  EXPECT_EQ((*first)->url(), (*first)->address() + (*first)->url().substr((*first)->url().find('?')));
  EXPECT_THAT((*second)->url(), ::testing::StartsWith("http://localhost:"));
  const auto token = [](const Gateway& gateway) { return gateway.url().substr(gateway.url().find('=') + 1); };
  EXPECT_EQ(token(**first).size(), 64);
  EXPECT_NE(token(**first), token(**second));
}

}  // namespace
}  // namespace flair::studio::testing
