// SPDX-License-Identifier: GPL-3.0-or-later
// What a page of another site, a name of another site's and a program without the token get: nothing.
#include "studio/gateway/admission.h"

#include <gmock/gmock.h>

#include "fmt/format.h"
#include "studio/gateway/gateway.h"
#include "studio/gateway/testing/browser.h"
#include "studio/gateway/testing/fake_studio.h"

namespace flair::studio::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class AdmissionTest : public ::testing::Test {
 protected:
  AdmissionTest() {
    GatewayOptions options;
    options.services = {{.full_name = kService, .channel = studio_.channel()}};
    options.token = TestToken();
    gateway_ = *Gateway::Start(std::move(options));
  }

  Answer Ask(const std::string& request) { return Browser(*gateway_).Ask(request); }
  std::string Get(const std::string& path, const Headers& changes = {}) const {
    return Browser(*gateway_).Get(path, changes);
  }
  std::string Post(const Headers& changes) const {
    return Browser(*gateway_).Post(kGetDocument, R"({"documentId":"a"})", changes);
  }
  std::string Own(const std::string& host) const { return fmt::format("{}:{}", host, gateway_->port()); }
  std::string Cookie(const std::string& value) const {
    return fmt::format("flair_studio_{}={}", gateway_->port(), value);
  }

  FakeStudio studio_;
  std::unique_ptr<Gateway> gateway_;
};

TEST_F(AdmissionTest, TheTokenBecomesACookieAndLeavesTheAddress) {
  const std::string query = gateway_->url().substr(gateway_->address().size());
  const Answer answer = Ask(Get("/" + query, {{"Cookie", ""}, {"Sec-Fetch-Site", "none"}}));
  EXPECT_EQ(answer.status, 303);
  EXPECT_EQ(answer.headers.at("location"), "/");
  EXPECT_EQ(answer.headers.at("set-cookie"), Cookie(TestToken()) + "; Path=/; HttpOnly; SameSite=Strict");
  EXPECT_EQ(answer.headers.at("cache-control"), "no-store");
  EXPECT_EQ(answer.body, "");
  // The page is not built, but its reader is let in.
  EXPECT_EQ(Ask(Get("/")).status, 503);
}

TEST_F(AdmissionTest, WithoutTheRightCookieThereIsNothing) {
  std::string wrong = TestToken();
  wrong.back() = '8';
  const std::string longer = TestToken() + "7";
  const std::string shorter = TestToken().substr(1);
  for (const std::string& cookie :
       {std::string(), std::string("x"), Cookie(""), Cookie(wrong), Cookie(longer), Cookie(shorter),
        "flair_studio_1=" + TestToken(), "x" + Cookie(TestToken()), "flair_studio_" + Cookie(TestToken())}) {
    for (const std::string& path : {std::string("/"), std::string("/index.html"), std::string("/nothing"),
                                    "/?token=" + wrong, std::string("/?token="), std::string("/?x=1")}) {
      const Answer answer = Ask(Get(path, {{"Cookie", cookie}}));
      EXPECT_EQ(answer.status, 401) << cookie << path;
      EXPECT_THAT(answer.body,
                  AllOf(HasSubstr("Open the address that flair studio printed"), Not(HasSubstr("refresh"))));
    }
    const Answer call = Ask(Post({{"Cookie", cookie}}));
    EXPECT_EQ(call.status, 401);
    EXPECT_THAT(call.body, HasSubstr(R"({"code":"unauthenticated",)"));
  }
  EXPECT_EQ(Ask(Post({})).status, 200);
}

TEST_F(AdmissionTest, TheTokenIsForTheFirstPageOnly) {
  const std::string query = "?token=" + TestToken();
  for (const std::string path : {"/index.html", "/x", "//"}) {
    EXPECT_EQ(Ask(Get(path + query, {{"Cookie", ""}})).status, 401) << path;
  }
  EXPECT_EQ(Ask(Post({{"Cookie", ""}, {"Authorization", "Bearer " + TestToken()}})).status, 401);
}

TEST_F(AdmissionTest, OtherHostsAreRefused) {
  for (const std::string& host : {Own("studio.example"), Own("127.0.0.1.example"), Own("127.0.0.2"), Own("0.0.0.0"),
                                  std::string("127.0.0.1"), std::string("127.0.0.1:1"), std::string("localhost"),
                                  Own("localhost") + "0", Own("user@localhost"), Own("::1"), std::string()}) {
    const Answer page = Ask(Get("/", {{"Host", host}}));
    EXPECT_EQ(page.status, 403) << host;
    const Answer token = Ask(Get("/?token=" + TestToken(), {{"Host", host}}));
    EXPECT_EQ(token.status, 403) << host;
    EXPECT_FALSE(token.headers.contains("set-cookie"));
    EXPECT_EQ(Ask(Post({{"Host", host}, {"Origin", "http://" + host}})).status, 403) << host;
  }
  for (const std::string name : {"localhost", "LocalHost", "[::1]", "127.0.0.1"}) {
    EXPECT_EQ(Ask(Post({{"Host", Own(name)}, {"Origin", "http://" + Own(name)}})).status, 200) << name;
  }
  const std::string twice = Get("/", {{"host", Own("studio.example")}});
  EXPECT_EQ(Ask(twice).status, 403);
}

TEST_F(AdmissionTest, PagesOfOtherOriginsAreRefused) {
  for (const std::string& origin :
       {std::string("https://studio.example"), std::string("null"), "https://" + Own("127.0.0.1"),
        "http://" + Own("localhost"), "http://" + Own("127.0.0.1") + "0", "http://" + Own("127.0.0.1") + "/",
        std::string("http://127.0.0.1"), std::string("http://127.0.0.1:1")}) {
    EXPECT_EQ(Ask(Post({{"Origin", origin}})).status, 403) << origin;
    EXPECT_EQ(Ask(Get("/", {{"Origin", origin}})).status, 403) << origin;
  }
  // Without an origin, the browser must say that the page is ours.
  for (const std::string site : {"", "none", "same-site", "cross-site", "x"}) {
    EXPECT_EQ(Ask(Post({{"Origin", ""}, {"Sec-Fetch-Site", site}})).status, 403) << site;
  }
  EXPECT_EQ(Ask(Post({{"Origin", ""}})).status, 200);
}

TEST_F(AdmissionTest, OtherSitesEmbedNothing) {
  for (const std::string site : {"same-site", "cross-site"}) {
    for (const std::string path : {"/", "/app.js", "/favicon.ico"}) {
      EXPECT_EQ(Ask(Get(path, {{"Sec-Fetch-Site", site}, {"Sec-Fetch-Dest", "script"}})).status, 403) << path;
      EXPECT_EQ(Ask(Get(path, {{"Sec-Fetch-Site", site}})).status, 403) << path;
    }
    EXPECT_EQ(Ask(Get("/", {{"Sec-Fetch-Site", site}, {"Sec-Fetch-Dest", "iframe"}})).status, 403);
    EXPECT_EQ(Ask(Get("/", {{"Sec-Fetch-Site", site}, {"Sec-Fetch-Dest", "document"}})).status, 503);
  }
}

// The browser keeps the cookie to itself when the way began on another site.
TEST_F(AdmissionTest, ALinkOnAnotherSiteLeadsToTheStudioAllTheSame) {
  const Answer answer =
      Ask(Get("/", {{"Cookie", ""}, {"Sec-Fetch-Site", "cross-site"}, {"Sec-Fetch-Dest", "document"}}));
  EXPECT_EQ(answer.status, 401);
  EXPECT_THAT(answer.body, HasSubstr(R"(<meta http-equiv="refresh" content="0; url=/">)"));
}

TEST_F(AdmissionTest, FormsOfOtherSitesAreRefused) {
  for (const std::string type : {"application/x-www-form-urlencoded", "multipart/form-data; boundary=x", "text/plain",
                                 "", "application/json, text/plain", "text/plain; application/json",
                                 "application/json; charset=utf-16", "application/connect+json", "application/proto"}) {
    const Answer answer = Ask(Post({{"Content-Type", type}}));
    EXPECT_EQ(answer.status, 415) << type;
  }
  EXPECT_EQ(Ask(Post({{"Content-Type", "Application/JSON; Charset=UTF-8"}})).status, 200);
}

TEST_F(AdmissionTest, EveryAnswerTellsTheBrowserToTrustNobodyElse) {
  const std::vector<std::string> requests = {Get("/"),
                                             Get("/nothing"),
                                             Get("/", {{"Cookie", ""}}),
                                             Get("/", {{"Host", "x"}}),
                                             Post({}),
                                             Post({{"Origin", "x"}}),
                                             "x\r\n\r\n"};
  for (const std::string& request : requests) {
    const Answer answer = Ask(request);
    ASSERT_GT(answer.status, 0) << request;
    EXPECT_THAT(answer.headers.at("content-security-policy"),
                AllOf(HasSubstr("default-src 'none'"), HasSubstr("script-src 'self';"), HasSubstr("style-src 'self';"),
                      HasSubstr("frame-ancestors 'none'"), HasSubstr("base-uri 'none'"),
                      HasSubstr("form-action 'none'"), Not(HasSubstr("unsafe"))));
    EXPECT_EQ(answer.headers.at("x-content-type-options"), "nosniff");
    EXPECT_EQ(answer.headers.at("referrer-policy"), "no-referrer");
    EXPECT_EQ(answer.headers.at("cross-origin-opener-policy"), "same-origin");
    EXPECT_EQ(answer.headers.at("cross-origin-resource-policy"), "same-origin");
    for (const auto& [name, value] : answer.headers) EXPECT_THAT(name, Not(HasSubstr("access-control")));
    EXPECT_THAT(answer.body, Not(HasSubstr(TestToken())));
  }
}

TEST_F(AdmissionTest, OtherMethodsAreRefused) {
  for (const std::string method : {"OPTIONS", "PUT", "DELETE", "TRACE", "CONNECT", "PATCH"}) {
    const Answer answer = Ask(method + Get("/").substr(3));
    EXPECT_EQ(answer.status, 405) << method;
    EXPECT_EQ(answer.headers.at("allow"), "GET, HEAD, POST");
  }
}

}  // namespace
}  // namespace flair::studio::testing
