// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "llm/http/http_client.h"

namespace flair::llm {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(PublicAddress, ShowsNeitherUserNorQuery) {
  EXPECT_EQ(PublicAddress("https://user:pass@host:8443/v1/chat?key=k#f"), "https://host:8443/v1/chat");
  EXPECT_EQ(PublicAddress("https://p@ss:w@rd@host/v1"), "https://host/v1");
  EXPECT_EQ(PublicAddress("http://host/v1/a@b"), "http://host/v1/a@b");
  EXPECT_EQ(PublicAddress("http://host?token=t"), "http://host");
  EXPECT_EQ(PublicAddress("user:pass@host/x"), "host/x");
  EXPECT_EQ(PublicAddress(""), "");
}

TEST(PublicAddress, ShowsNoPartOfAPasswordThatEndsTheHostTooEarly) {
  for (const char* url : {"http://user:pa/ss@host/v1", "https://user:p?ass@host", "https://user:pass#@host/v1"}) {
    EXPECT_EQ(PublicAddress(url), "(an address with a password)") << url;
    const absl::Status status = CheckRequest({.url = url});
    EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
    EXPECT_THAT(status.message(), AllOf(HasSubstr("%2F"), Not(HasSubstr("host")), Not(HasSubstr("user:"))));
  }
  // Nothing that only looks like it.
  for (const char* url : {"http://host:8080/@cf/model", "http://[::1]:8080/v1/a@b", "http://user:pass@host/v1"}) {
    EXPECT_TRUE(CheckRequest({.url = url}).ok()) << url;
  }
}

TEST(CheckRequest, WantsAnHttpAddress) {
  EXPECT_TRUE(CheckRequest({.url = "http://h/v1"}).ok());
  EXPECT_TRUE(CheckRequest({.url = "HTTPS://h/v1"}).ok());
  for (const char* url : {"", "h/v1", "ftp://h/v1", "file:///etc/passwd", "http://h/ v1", "http://h/\r\nX: y"}) {
    EXPECT_EQ(CheckRequest({.url = url}).code(), absl::StatusCode::kInvalidArgument) << url;
  }
}

TEST(CheckRequest, TakesNoHeaderThatWouldBecomeTwo) {
  const absl::Status value = CheckRequest({.url = "http://h", .headers = {{"api-key", "secret\r\nX-Other: 1"}}});
  EXPECT_EQ(value.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(value.message(), HasSubstr("api-key"));
  EXPECT_THAT(value.message(), Not(HasSubstr("secret")));
  for (const char* name : {"", "a b", "a:", "a\n"}) {
    EXPECT_FALSE(CheckRequest({.url = "http://h", .headers = {{name, "v"}}}).ok()) << name;
  }
}

TEST(HttpResponse, FindsTheFirstHeaderOfAName) {
  const HttpResponse response{.status = 200, .headers = {{"a", "1"}, {"b", "2"}, {"b", "3"}}, .body = ""};
  EXPECT_EQ(response.header("b"), "2");
  EXPECT_EQ(response.header("c"), "");
}

}  // namespace
}  // namespace flair::llm
