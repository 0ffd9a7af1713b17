// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <unistd.h>

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ssl.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <filesystem>

#include "fmt/format.h"
#include "studio/gateway/gateway.h"
#include "studio/gateway/testing/browser.h"
#include "studio/gateway/testing/fake_studio.h"
#include "tests/fixtures/certificates.h"

namespace flair::studio::testing {
namespace {

namespace asio = boost::asio;
namespace http = boost::beast::http;
using ::testing::HasSubstr;

class TlsTest : public ::testing::Test {
 protected:
  TlsTest() { std::filesystem::create_directories(folder_); }
  ~TlsTest() override { std::filesystem::remove_all(folder_); }

  GatewayOptions Options(const std::string& address, bool with_client = false) {
    GatewayOptions options;
    options.listen_address = address;
    options.services = {{.full_name = kService, .channel = studio_.channel(), .methods = {}, .upload_methods = {}}};
    options.token = TestToken();
    options.tls = authority_.Tls(authority_.Issue("studio"), with_client);
    return options;
  }

  // The answer to a request; status 0 when there is none.
  http::response<http::string_body> Ask(int port, const std::string& request,
                                        const ::flair::testing::Identity* client = nullptr) {
    asio::io_context context;
    asio::ssl::context tls(asio::ssl::context::tls_client);
    tls.load_verify_file(authority_.path());
    tls.set_verify_mode(asio::ssl::verify_peer);
    if (client != nullptr) {
      tls.use_certificate_chain_file(client->certificate_path);
      tls.use_private_key_file(client->key_path, asio::ssl::context::pem);
    }
    asio::ssl::stream<asio::ip::tcp::socket> stream(context, tls);
    boost::system::error_code error;
    stream.next_layer().connect({asio::ip::address_v4::loopback(), static_cast<uint16_t>(port)}, error);
    if (!error) stream.handshake(asio::ssl::stream_base::client, error);
    if (!error) asio::write(stream, asio::buffer(request), error);
    boost::beast::flat_buffer buffer;
    http::response<http::string_body> response;
    response.result(0);
    if (!error) http::read(stream, buffer, response, error);
    if (error) response.result(0);
    return response;
  }

  static std::string Post(int port, const std::string& host, const std::string& body) {
    return Browser(port).Post(
        kGetDocument, body,
        {{"Host", fmt::format("{}:{}", host, port)}, {"Origin", fmt::format("https://{}:{}", host, port)}});
  }

  const std::filesystem::path folder_ = std::filesystem::path(::testing::TempDir()) / ("flair_studio_tls_test_" + std::to_string(::getpid()));
  FakeStudio studio_;
  ::flair::testing::CertificateAuthority authority_{(std::filesystem::create_directories(folder_), folder_),
                                                    "authority"};
};

TEST_F(TlsTest, ServesOtherMachinesByNamesOfTheCertificate) {
  GatewayOptions options = Options("0.0.0.0:0");
  options.host_names = {"studio.example"};
  const auto gateway = Gateway::Start(std::move(options));
  ASSERT_TRUE(gateway.ok()) << gateway.status();
  const int port = (*gateway)->port();
  EXPECT_EQ((*gateway)->url(), fmt::format("https://studio.example:{}/?token={}", port, TestToken()));
  for (const std::string host : {"studio.example", "localhost"}) {
    const auto answer = Ask(port, Post(port, host, R"({"documentId":"a"})"));
    EXPECT_EQ(answer.result_int(), 200) << host;
    EXPECT_THAT(answer.body(), HasSubstr(R"("title":"a")"));
  }
  EXPECT_EQ(Ask(port, Post(port, "other.example", "{}")).result_int(), 403);
  const auto page = Ask(port, Browser(port).Get("/?token=" + TestToken(), {{"Cookie", ""}}));
  EXPECT_EQ(page.result_int(), 303);
  EXPECT_THAT(std::string(page[http::field::set_cookie]), HasSubstr("; SameSite=Strict; Secure"));
  // A page without TLS is another origin.
  EXPECT_EQ(Ask(port, Browser(port).Post(kGetDocument, "{}")).result_int(), 403);
}

TEST_F(TlsTest, LargeAnswersComeWhole) {
  const auto gateway = Gateway::Start(Options("127.0.0.1:0"));
  const int port = (*gateway)->port();
  std::string request = Post(port, "127.0.0.1", R"({"pageSize":900})");
  request.replace(request.find(kGetDocument), std::string(kGetDocument).size(), kListDocuments);
  EXPECT_GT(Ask(port, request).body().size(), 900'000);
}

TEST_F(TlsTest, AsksForCertificatesOfBrowsersWhenToldTo) {
  const auto gateway = Gateway::Start(Options("127.0.0.1:0", true));
  ASSERT_TRUE(gateway.ok()) << gateway.status();
  const int port = (*gateway)->port();
  EXPECT_EQ(Ask(port, Post(port, "127.0.0.1", "{}")).result_int(), 0);
  const ::flair::testing::Identity client = authority_.Issue("browser");
  EXPECT_EQ(Ask(port, Post(port, "127.0.0.1", "{}"), &client).result_int(), 200);
}

TEST_F(TlsTest, LeavesThoseWhoSpeakPlainly) {
  GatewayOptions options = Options("127.0.0.1:0");
  options.limits.header_timeout = absl::Milliseconds(50);
  const auto gateway = Gateway::Start(std::move(options));
  Browser plain(**gateway);
  EXPECT_EQ(plain.Ask(plain.Get("/")).status, 0);
  Browser silent(**gateway);
  EXPECT_EQ(silent.ReadAll(), "");
}

TEST_F(TlsTest, SaysWhatIsMissing) {
  const auto start = [](GatewayOptions options) {
    return std::string(Gateway::Start(std::move(options)).status().message());
  };
  EXPECT_THAT(start(Options("0.0.0.0:0")), HasSubstr("host_names should say what browsers call this machine"));
  EXPECT_THAT(start(Options("studio.example:0")), HasSubstr("is no IP address"));
  GatewayOptions options = Options("127.0.0.1:0");
  options.tls->set_key_path((folder_ / "nowhere.key").string());
  EXPECT_THAT(start(options), HasSubstr("tls.key_path"));
  options.tls->clear_key_path();
  EXPECT_THAT(start(options), HasSubstr("key_path are needed"));
}

}  // namespace
}  // namespace flair::studio::testing
