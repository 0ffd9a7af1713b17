// SPDX-License-Identifier: GPL-3.0-or-later
// Whoever sends bytes that are no requests, sends them slowly, or opens many connections: the gateway stays, and serves
// the others.
#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
#include <future>
#include <random>

#include "fmt/format.h"
#include "studio/gateway/gateway.h"
#include "studio/gateway/testing/browser.h"
#include "studio/gateway/testing/fake_studio.h"

namespace flair::studio::testing {
namespace {

using ::testing::AnyOf;

constexpr absl::Duration kShort = absl::Milliseconds(50);

class HostileTest : public ::testing::Test {
 protected:
  void Start(const GatewayLimits& limits) {
    GatewayOptions options;
    options.services = {
        {.full_name = kService, .channel = studio_.channel(), .methods = {}, .upload_methods = {"CreateDocument"}}};
    options.token = TestToken();
    options.limits = limits;
    gateway_ = *Gateway::Start(std::move(options));
  }

  void ExpectStillServes() {
    Browser browser(*gateway_);
    EXPECT_EQ(browser.Ask(browser.Post(kGetDocument, R"({"documentId":"a"})")).status, 200);
  }

  FakeStudio studio_;
  std::unique_ptr<Gateway> gateway_;
};

TEST_F(HostileTest, RefusesWhatIsNoHttp) {
  Start({.header_timeout = absl::Milliseconds(300)});
  const std::string host = fmt::format("Host: 127.0.0.1:{}\r\n", gateway_->port());
  struct Row {
    std::string said;
    int status;
  };
  for (const Row& row : std::vector<Row>{
           {"\x16\x03\x01\x02\r\n\r\n", 400},
           {"GET / HTTP/9.9\r\n\r\n", 400},
           {"GET / HTTP/1.0\r\n" + host + "\r\n", 505},
           {"GET /\r\n\r\n", 400},
           {std::string("GET /\0 HTTP/1.1\r\n\r\n", 19), 400},
           {"GET / HTTP/1.1\r\nA b: c\r\n\r\n", 400},
           {"GET / HTTP/1.1\r\n" + host + "X: " + std::string(20000, 'x') + "\r\n\r\n", 431},
           {"GET /" + std::string(20000, 'x') + " HTTP/1.1\r\n" + host + "\r\n", 431},
           {"GET / HTTP/1.1\r\n\r\n", 403},
           {"GET http://127.0.0.1/ HTTP/1.1\r\n" + host + "\r\n", 401},
           {"POST / HTTP/1.1\r\n" + host + "Content-Length: 99999999999999999999\r\n\r\n", 400},
           {"POST / HTTP/1.1\r\n" + host + "Content-Length: -1\r\n\r\n", 400},
           {"POST / HTTP/1.1\r\n" + host + "Content-Length: 1\r\nContent-Length: 2\r\n\r\n", 400},
           {"POST / HTTP/1.1\r\n" + host + "Content-Length: 1\r\nTransfer-Encoding: chunked\r\n\r\n", 400}}) {
    Browser browser(*gateway_);
    EXPECT_EQ(browser.Ask(row.said).status, row.status) << row.said.substr(0, 60);
    EXPECT_EQ(browser.ReadAll(), "");
  }
  Browser chunked(*gateway_);
  EXPECT_EQ(
      chunked.Ask(chunked.Post(kGetDocument, "", {{"Content-Length", ""}, {"Transfer-Encoding", "chunked"}})).status,
      411);
  Browser zipped(*gateway_);
  EXPECT_EQ(zipped.Ask(zipped.Post(kGetDocument, "{}", {{"Content-Encoding", "gzip"}})).status, 501);
  Browser later(*gateway_);
  EXPECT_EQ(later.Ask(later.Post(kGetDocument, "{}", {{"Connect-Protocol-Version", "2"}})).status, 400);
  ExpectStillServes();
}

// FLAIR_TEST_SEED repeats a run.
TEST_F(HostileTest, OutlivesRandomAndTruncatedRequests) {
  Start({.header_timeout = absl::Seconds(30), .body_timeout = absl::Seconds(30)});
  const char* const given = std::getenv("FLAIR_TEST_SEED");
  const uint64_t seed = given != nullptr ? std::stoull(given) : std::random_device()();
  SCOPED_TRACE(fmt::format("FLAIR_TEST_SEED={}", seed));
  std::mt19937_64 random(seed);
  const auto below = [&random](size_t limit) { return static_cast<size_t>(random() % limit); };
  const Browser writer(*gateway_);
  const std::vector<std::string> whole = {
      writer.Get("/"), writer.Post(kGetDocument, R"({"documentId":"a","x":[1,2.5e3,{"y":null}]})"),
      writer.Post(kCreateDocument, R"({"requestId":"r","room":{"floor":{"vertices":[{"xM":1}]}},"file":"AAAA"})"),
      writer.PostStream(kWatchDocuments, "{}"),
      writer.Post(kGetDocument, R"({"documentId":"error/3"})", {{"Expect", "100-continue"}})};
  constexpr int kRounds = 1500;
  for (int i = 0; i < kRounds; ++i) {
    std::string said = whole[below(whole.size())];
    switch (below(4)) {
      case 0:
        said.resize(below(said.size()));
        break;
      case 1:
        for (size_t n = below(8) + 1; n > 0; --n) said[below(said.size())] = static_cast<char>(random());
        break;
      case 2: {
        const size_t from = below(said.size());
        said.insert(below(said.size()), said.substr(from, below(60)));
        break;
      }
      default:
        // What is in the body, not its length.
        for (size_t n = below(4) + 1; n > 0; --n) {
          said[said.size() - 1 - below(std::min<size_t>(said.size(), 40))] = "{}[]\",:\\u0e-"[below(12)];
        }
    }
    Browser browser(*gateway_);
    browser.Say(said);
    // Every second one waits until something has come of it: an answer, or the end that the half-open connection means.
    if (below(2) == 0) {
      browser.FinishSaying();
      browser.ReadAll();
    }
  }
  ExpectStillServes();
}

TEST_F(HostileTest, LeavesThoseWhoDripTheirRequests) {
  Start({.header_timeout = kShort, .idle_timeout = kShort, .body_timeout = kShort});
  Browser silent(*gateway_);
  EXPECT_EQ(silent.ReadAll(), "");
  Browser started(*gateway_);
  started.Say("GET / HTTP/1.1\r\nX: ");
  EXPECT_EQ(started.ReadAll(), "");
  // However often it says something.
  Browser dripping(*gateway_);
  dripping.Say("GET / HTTP/1.1\r\nX: ");
  while (dripping.Say("x")) continue;
  Browser body(*gateway_);
  body.Say(body.Post(kGetDocument, "{", {{"Content-Length", "1000000"}}));
  while (body.Say(" ")) continue;
  Browser idle(*gateway_);
  EXPECT_EQ(idle.Ask(idle.Post(kGetDocument, "{}")).status, 200);
  EXPECT_EQ(idle.ReadAll(), "");
  ExpectStillServes();
}

TEST_F(HostileTest, LeavesThoseWhoDoNotRead) {
  Start({.write_timeout = kShort});
  // More than the sockets of both ends hold.
  Browser browser(*gateway_);
  browser.Say(browser.Post(kListDocuments, R"({"pageSize":20000})"));
  Browser listener(*gateway_);
  listener.Say(listener.PostStream(kWatchDocuments, "{}"));
  studio_.AwaitWaiting(1);
  for (int i = 0; i < 20; ++i) studio_.Say(std::string(1 << 20, 'a'));
  studio_.AwaitCancelled(1);
  ExpectStillServes();
}

TEST_F(HostileTest, CallsAndStreamsMayTakeTheirTime) {
  Start({.header_timeout = kShort, .idle_timeout = kShort, .body_timeout = kShort, .write_timeout = kShort});
  Browser listener(*gateway_);
  listener.Say(listener.PostStream(kWatchDocuments, "{}"));
  EXPECT_EQ(listener.ReadStreamHead().status, 200);
  Browser caller(*gateway_);
  caller.Say(caller.Post(kGetDocument, R"({"documentId":"wait"})"));
  studio_.AwaitWaiting(2);
  // Others meanwhile are idle for longer than all that.
  Browser idle(*gateway_);
  EXPECT_EQ(idle.ReadAll(), "");
  studio_.Say("a");
  EXPECT_EQ(listener.ReadMessage()->json, R"({"deletedDocumentId":"a"})");
  studio_.AnswerWaiting();
  EXPECT_EQ(caller.Read().status, 200);
}

TEST_F(HostileTest, TakesOnlySoManyConnectionsAndServesTheNextAfterThem) {
  constexpr int kConnections = 8;
  Start({.connections = kConnections});
  std::vector<std::unique_ptr<Browser>> browsers;
  for (int i = 0; i < kConnections; ++i) {
    browsers.push_back(std::make_unique<Browser>(*gateway_));
    EXPECT_EQ(browsers.back()->Ask(browsers.back()->Post(kGetDocument, "{}")).status, 200);
  }
  Browser next(*gateway_);
  next.Say(next.Post(kGetDocument, R"({"documentId":"wait"})"));
  // Those that are taken answer; the next has to wait for one of them.
  EXPECT_EQ(browsers[3]->Ask(browsers[3]->Post(kGetDocument, "{}")).status, 200);
  browsers[5]->Leave();
  studio_.AwaitWaiting(1);
  studio_.AnswerWaiting();
  EXPECT_EQ(next.Read().status, 200);
}

int64_t ResidentBytes() {
  int64_t pages = 0;
  std::ifstream statm("/proc/self/statm");
  statm >> pages >> pages;
  return pages * ::sysconf(_SC_PAGESIZE);
}

// gateway.h: connections * (2 * header_bytes + 64 KiB) + 3 * held_bytes.
TEST_F(HostileTest, HoldsNoMoreMemoryThanItSays) {
  constexpr int64_t kHeld = int64_t{16} << 20;
  const GatewayLimits limits = {.connections = 64, .upload_bytes = kHeld, .held_bytes = kHeld};
  Start(limits);
  const int64_t before = ResidentBytes();
  // Each sends a body of 4 MiB that lacks its last byte: four find room, the others are told that there is none.
  constexpr int64_t kBody = int64_t{4} << 20;
  std::vector<std::unique_ptr<Browser>> browsers;
  std::vector<std::future<int>> answers;
  int64_t most = 0;
  for (int i = 0; i < limits.connections; ++i) {
    browsers.push_back(std::make_unique<Browser>(*gateway_));
    Browser& browser = *browsers.back();
    browser.Say(browser.Post(kCreateDocument, "", {{"Content-Length", std::to_string(kBody)}}));
    // Refused, it may be cut off before all is said.
    static const std::string part(kBody - 1, ' ');
    browser.Say(part);
    most = std::max(most, ResidentBytes() - before);
  }
  EXPECT_LT(most, limits.connections * (2 * limits.header_bytes + (64 << 10)) + 3 * kHeld + (16 << 20));
}

}  // namespace
}  // namespace flair::studio::testing
