// SPDX-License-Identifier: GPL-3.0-or-later
#include "studio/gateway/site.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "studio/gateway/gateway.h"
#include "studio/gateway/testing/browser.h"

namespace flair::studio::testing {
namespace {

using ::testing::HasSubstr;

class SiteTest : public ::testing::Test {
 protected:
  SiteTest() {
    std::filesystem::remove_all(root_);
    Write("secret.txt", "secret");
    Write("page/index.html", "<!doctype html>");
    Write("page/app-3FQ2XYZA.js", "let a;");
    Write("page/app-3FQ2XYZA.js.gz", "zipped");
    Write("page/pictures/desk.svg", "<svg/>");
    Write("page/.hidden", "hidden");
    Write("page/.git/config", "hidden");
    Write("page/empty.css", "");
    Write("page/NOTICES", "all");
    Write("page/alone.gz", "gz");
    std::filesystem::create_symlink(root_ / "secret.txt", root_ / "page/link.txt");
    std::filesystem::create_directory_symlink(root_, root_ / "page/up");
  }
  ~SiteTest() override { std::filesystem::remove_all(root_); }

  void Write(const std::string& name, const std::string& bytes) {
    std::filesystem::create_directories((root_ / name).parent_path());
    std::ofstream(root_ / name, std::ios::binary) << bytes;
  }
  Site Read() { return *Site::Read(root_ / "page"); }

  const std::filesystem::path root_ = std::filesystem::path(::testing::TempDir()) / ("flair_site_test_" + std::to_string(::getpid()));
};

std::string HeaderIn(const Reply& reply, std::string_view name) {
  for (const auto& [key, value] : reply.headers) {
    if (key == name) return value;
  }
  return "";
}

TEST_F(SiteTest, GivesFilesTheirTypesAndAges) {
  const Site site = Read();
  struct Row {
    std::string path, type, content;
    bool for_good;
  };
  for (const Row& row : {Row{"/", "text/html; charset=utf-8", "<!doctype html>", false},
                         Row{"/index.html", "text/html; charset=utf-8", "<!doctype html>", false},
                         Row{"/app-3FQ2XYZA.js", "text/javascript; charset=utf-8", "let a;", true},
                         Row{"/pictures/desk.svg", "image/svg+xml", "<svg/>", false},
                         Row{"/empty.css", "text/css; charset=utf-8", "", false},
                         Row{"/NOTICES", "text/plain; charset=utf-8", "all", false},
                         Row{"/alone.gz", "application/octet-stream", "gz", false}}) {
    const Reply reply = site.Get(row.path, "", "");
    EXPECT_EQ(reply.status, 200) << row.path;
    EXPECT_EQ(HeaderIn(reply, "Content-Type"), row.type);
    EXPECT_EQ(reply.content(), row.content);
    EXPECT_EQ(HeaderIn(reply, "Cache-Control"),
              row.for_good ? "private, max-age=31536000, immutable" : "private, no-cache");
  }
}

TEST_F(SiteTest, HasNoOtherNames) {
  const Site site = Read();
  for (const std::string path : {"",
                                 "/nothing",
                                 "//",
                                 "/../secret.txt",
                                 "/page/../../secret.txt",
                                 "/%2e%2e/secret.txt",
                                 "/..%2fsecret.txt",
                                 "/pictures",
                                 "/pictures/",
                                 "/pictures/../index.html",
                                 "/.hidden",
                                 "/.git/config",
                                 "/link.txt",
                                 "/up/secret.txt",
                                 "/app-3FQ2XYZA.js.gz",
                                 "/INDEX.HTML",
                                 "/index.html/",
                                 "/index.html%00",
                                 "index.html",
                                 "\\index.html"}) {
    const Reply reply = site.Get(path, "gzip", "");
    EXPECT_EQ(reply.status, 404) << path;
    EXPECT_EQ(reply.content(), "Not found.\n");
  }
  EXPECT_EQ(site.Get(std::string("/index.html\0", 12), "", "").status, 404);
}

TEST_F(SiteTest, SendsTheZippedFormToBrowsersThatTakeIt) {
  const Site site = Read();
  for (const std::string taken : {"gzip", "deflate, gzip", "br;q=1.0, gzip;q=0.8", "gzip; q=0.5,*"}) {
    const Reply reply = site.Get("/app-3FQ2XYZA.js", taken, "");
    EXPECT_EQ(HeaderIn(reply, "Content-Encoding"), "gzip") << taken;
    EXPECT_EQ(reply.content(), "zipped");
    EXPECT_EQ(HeaderIn(reply, "Vary"), "Accept-Encoding");
  }
  for (const std::string refused : {"", "identity", "gzip;q=0", "gzip; q=0.0", "xgzip", "br"}) {
    const Reply reply = site.Get("/app-3FQ2XYZA.js", refused, "");
    EXPECT_EQ(HeaderIn(reply, "Content-Encoding"), "") << refused;
    EXPECT_EQ(reply.content(), "let a;");
  }
  EXPECT_EQ(HeaderIn(site.Get("/", "gzip", ""), "Content-Encoding"), "");
}

TEST_F(SiteTest, SendsNothingThatTheBrowserHas) {
  const Site site = Read();
  const std::string plain = HeaderIn(site.Get("/app-3FQ2XYZA.js", "", ""), "ETag");
  const std::string zipped = HeaderIn(site.Get("/app-3FQ2XYZA.js", "gzip", ""), "ETag");
  EXPECT_NE(plain, zipped);
  for (const std::string& known : {plain, "W/" + plain, "\"x\", " + plain, std::string("*")}) {
    const Reply reply = site.Get("/app-3FQ2XYZA.js", "", known);
    EXPECT_EQ(reply.status, 304) << known;
    EXPECT_EQ(reply.content(), "");
    EXPECT_EQ(HeaderIn(reply, "ETag"), plain);
  }
  EXPECT_EQ(site.Get("/app-3FQ2XYZA.js", "", zipped).status, 200);
  EXPECT_EQ(site.Get("/app-3FQ2XYZA.js", "gzip", zipped).status, 304);
  Write("page/app-3FQ2XYZA.js", "let b;");
  EXPECT_EQ(site.Get("/app-3FQ2XYZA.js", "", "").content(), "let a;");
  EXPECT_EQ(Read().Get("/app-3FQ2XYZA.js", "", plain).status, 200);
}

TEST_F(SiteTest, SaysHowToBuildThePageWhenThereIsNone) {
  for (const std::filesystem::path& folder : {root_ / "nowhere", root_ / "secret.txt", std::filesystem::path()}) {
    const absl::StatusOr<Site> site = Site::Read(folder);
    ASSERT_TRUE(site.ok()) << folder;
    const Reply reply = site->Get("/", "", "");
    EXPECT_EQ(reply.status, 503);
    EXPECT_THAT(std::string(reply.content()), HasSubstr("./flair studio builds it"));
    EXPECT_EQ(site->Get("/app.js", "", "").status, 404);
  }
}

TEST_F(SiteTest, IsServedOverHttp) {
  GatewayOptions options;
  options.page_folder = root_ / "page";
  options.token = TestToken();
  const auto gateway = Gateway::Start(std::move(options));
  ASSERT_TRUE(gateway.ok()) << gateway.status();
  Browser browser(**gateway);
  const Answer page = browser.Ask(browser.Get("/"));
  EXPECT_EQ(page.status, 200);
  EXPECT_EQ(page.body, "<!doctype html>");
  const Answer known = browser.Ask(browser.Get("/", {{"If-None-Match", page.headers.at("etag")}}));
  EXPECT_EQ(known.status, 304);
  EXPECT_FALSE(known.headers.contains("content-length"));
  browser.Say("HEAD" + browser.Get("/app-3FQ2XYZA.js", {{"Accept-Encoding", "gzip"}}).substr(3));
  const Answer head = browser.Read(true);
  EXPECT_EQ(head.status, 200);
  EXPECT_EQ(head.headers.at("content-length"), "6");
  EXPECT_EQ(head.headers.at("content-encoding"), "gzip");
  EXPECT_EQ(browser.Ask(browser.Get("/app-3FQ2XYZA.js?v=1")).body, "let a;");
  for (const std::string path : {"/../secret.txt", "/pictures/../../secret.txt", "/%2e%2e/secret.txt"}) {
    EXPECT_EQ(browser.Ask(browser.Get(path)).status, 404) << path;
  }
  // Two at once: one after the other.
  browser.Say(browser.Get("/pictures/desk.svg") + browser.Get("/"));
  EXPECT_EQ(browser.Read().body, "<svg/>");
  EXPECT_EQ(browser.Read().body, "<!doctype html>");
}

}  // namespace
}  // namespace flair::studio::testing
