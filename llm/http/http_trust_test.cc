// SPDX-License-Identifier: GPL-3.0-or-later
// Whom the HTTP client trusts, and the way that it takes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "llm/testing/test_http.h"

namespace flair::llm {
namespace {

using absl::StatusCode;
using ::flair::testing::MakeExpiredCertificate;
using ::flair::testing::MakeTestCertificate;
using ::flair::testing::ScriptedServer;
using ::flair::testing::TestCertificate;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class HttpTrustTest : public HttpClientTest {};

TEST_F(HttpTrustTest, TrustsTheCertificateItWasTold) {
  const TestCertificate certificate = MakeTestCertificate();
  ScriptedServer server(One(R"({"body": "ok"})"), certificate);
  const auto response = Ask(server.address(), Trusting(certificate));
  ASSERT_TRUE(response.ok()) << response.status();
  EXPECT_EQ(response->body, "ok");
}

TEST_F(HttpTrustTest, OffersHttp2OverTls) {
  const TestCertificate certificate = MakeTestCertificate();
  ScriptedServer server(One(R"({"body": "ok"})"), certificate);
  ASSERT_TRUE(Ask(server.address(), Trusting(certificate)).ok());
  EXPECT_THAT(server.offered_protocols(), Contains("h2"));
}

TEST_F(HttpTrustTest, SendsNothingToAServerWhoseCertificateIsNotTrusted) {
  const TestCertificate certificate = MakeTestCertificate();
  const TestCertificate expired = MakeExpiredCertificate();
  const TestCertificate other_name = MakeTestCertificate("model.example");
  const std::pair<TestCertificate, TestCertificate> cases[] = {
      {certificate, MakeTestCertificate()}, {expired, expired}, {other_name, other_name}};
  for (const auto& [shown, trusted] : cases) {
    ScriptedServer server(One(R"({"body": "ok"})"), shown);
    const auto response = Ask(server.address(), Trusting(trusted));
    EXPECT_EQ(response.status().code(), StatusCode::kFailedPrecondition) << response.status();
    EXPECT_THAT(response.status().message(), HasSubstr("certificate"));
    EXPECT_THAT(server.requests(), ::testing::IsEmpty());
  }
}

TEST_F(HttpTrustTest, AMissingFileOfCertificatesTrustsNobody) {
  ScriptedServer server(One(R"({"body": "ok"})"), MakeTestCertificate());
  const auto response = Ask(server.address(), {.ca_path = "/nonexistent/ca.pem"});
  EXPECT_EQ(response.status().code(), StatusCode::kFailedPrecondition) << response.status();
}

TEST_F(HttpTrustTest, GoesThroughTheProxy) {
  ScriptedServer proxy(One(R"({"body": "through the proxy"})"));
  HttpOptions options;
  options.proxy = "http://user:proxy-password@127.0.0.1:" + std::to_string(proxy.port());
  const auto response = Ask("http://model.invalid", options);
  ASSERT_TRUE(response.ok()) << response.status();
  EXPECT_EQ(response->body, "through the proxy");
  EXPECT_EQ(proxy.requests().front().target, "http://model.invalid/v1/chat/completions");
  EXPECT_THAT(proxy.requests().front().header("proxy-authorization"), StartsWith("Basic "));
}

TEST_F(HttpTrustTest, ABrokenProxyIsUnavailableAndItsPasswordStaysSecret) {
  const auto response = Ask("http://model.invalid", {.proxy = "http://u:proxy-password@127.0.0.1:1"});
  EXPECT_EQ(response.status().code(), StatusCode::kUnavailable) << response.status();
  EXPECT_THAT(response.status().message(), Not(HasSubstr("proxy-password")));
}

}  // namespace
}  // namespace flair::llm
