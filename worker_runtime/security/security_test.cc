// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/security/security.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "absl/time/clock.h"
#include "tests/fixtures/certificates.h"

namespace flair::runtime {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

TEST(LocalAddress, OnlyThisMachineCanBeMeant) {
  for (const char* address :
       {"127.0.0.1:50051", "127.9.8.7:0", "[::1]:50051", "localhost:1", "LocalHost:1", "unix:/run/flair.sock", "unix:x",
        "dns:///localhost:50051", "ipv4:127.0.0.1:1", "ipv6:[::1]:1", "[::ffff:127.0.0.1]:1"}) {
    EXPECT_TRUE(IsLocalAddress(address)) << address;
  }
  for (const char* address :
       {"0.0.0.0:50051", "[::]:50051", "10.0.0.1:1", "128.0.0.1:1", "example.org:1", "localhost.example.org:1",
        "127.0.0.1.example.org:1", "127.1:1", "127.0.0.1", "", ":1", "dns:///optimizer:50053", "ipv4:0.0.0.0:1",
        "127.0.0.1:1,10.0.0.1:1", "[::ffff:10.0.0.1]:1", "vsock:2:1", "dns:///dns:///localhost:1"}) {
    EXPECT_FALSE(IsLocalAddress(address)) << address;
  }
}

config::v1::RuntimeConfig Listening(const std::string& address) {
  config::v1::RuntimeConfig runtime;
  runtime.set_listen_address(address);
  return runtime;
}

TEST(Exposure, PlainTextIsForThisMachine) {
  EXPECT_EQ(ExposureFault(Listening(""), std::nullopt), "");
  EXPECT_EQ(ExposureFault(Listening("127.0.0.1:50051"), std::nullopt), "");
  EXPECT_EQ(ExposureFault(Listening("unix:/run/x"), false), "");
  EXPECT_THAT(ExposureFault(Listening("0.0.0.0:50051"), std::nullopt),
              AllOf(HasSubstr("\"0.0.0.0:50051\""), HasSubstr("plain text"),
                    HasSubstr("runtime.tls with require_client_certificate"), HasSubstr("runtime.allow_insecure"),
                    Not(HasSubstr("tokens_path"))));
  EXPECT_THAT(ExposureFault(Listening("[::]:50050"), true), AllOf(HasSubstr("plain text"), HasSubstr("tokens_path")));
}

TEST(Exposure, WhoServesOthersAsksWhoTheyAre) {
  config::v1::RuntimeConfig runtime = Listening("0.0.0.0:50051");
  runtime.mutable_tls()->set_certificate_path("c");
  EXPECT_THAT(ExposureFault(runtime, std::nullopt), HasSubstr("anybody may call"));
  EXPECT_THAT(ExposureFault(runtime, false), AllOf(HasSubstr("anybody may call"), HasSubstr("tokens_path")));
  EXPECT_EQ(ExposureFault(runtime, true), "");
  runtime.mutable_tls()->set_require_client_certificate(true);
  EXPECT_EQ(ExposureFault(runtime, std::nullopt), "");
  EXPECT_EQ(ExposureFault(runtime, false), "");
}

TEST(Exposure, MayBeWanted) {
  config::v1::RuntimeConfig runtime = Listening("0.0.0.0:50051");
  runtime.set_metrics_address("0.0.0.0:9090");
  EXPECT_THAT(MetricsExposureFault(runtime), HasSubstr("\"0.0.0.0:9090\""));
  runtime.set_allow_insecure(true);
  EXPECT_EQ(ExposureFault(runtime, std::nullopt), "");
  EXPECT_EQ(MetricsExposureFault(runtime), "");
}

TEST(Exposure, FiguresForOthersOpenNothingElse) {
  config::v1::RuntimeConfig runtime = Listening("0.0.0.0:50051");
  runtime.set_metrics_address("0.0.0.0:9090");
  EXPECT_THAT(MetricsExposureFault(runtime), HasSubstr("runtime.allow_insecure_metrics: true"));
  runtime.set_allow_insecure_metrics(true);
  EXPECT_EQ(MetricsExposureFault(runtime), "");
  EXPECT_THAT(ExposureFault(runtime, std::nullopt), HasSubstr("plain text"));
}

class TlsFiles : public ::testing::Test {
 protected:
  TlsFiles() { std::filesystem::create_directories(folder_); }
  ~TlsFiles() override { std::filesystem::remove_all(folder_); }
  std::string Fault(const config::v1::TlsConfig& tls, absl::Time now = absl::Now()) {
    const absl::Status status = CheckTlsFiles(tls, now);
    EXPECT_TRUE(status.ok() || absl::IsInvalidArgument(status)) << status;
    return std::string(status.message());
  }
  std::string Written(const std::string& name, const std::string& content) {
    const std::string path = folder_ / name;
    std::ofstream(path) << content;
    return path;
  }
  static std::string Content(const std::string& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  const std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) / ("flair_tls_files_" + std::to_string(::getpid()));
};

TEST_F(TlsFiles, GoodOnesAreGood) {
  std::filesystem::create_directories(folder_);
  const testing::CertificateAuthority authority(folder_, "authority");
  EXPECT_EQ(Fault(authority.Tls(authority.Issue("a"), true)), "");
  EXPECT_EQ(Fault({}), "");
}

TEST_F(TlsFiles, SayWhichIsWrongAndHow) {
  const testing::CertificateAuthority authority(folder_, "authority");
  const testing::Identity good = authority.Issue("good");
  config::v1::TlsConfig tls = authority.Tls(good, true);
  tls.set_certificate_path(folder_ / "none.pem");
  EXPECT_THAT(Fault(tls),
              AllOf(StartsWith("runtime.tls.certificate_path: "), HasSubstr("none.pem: cannot be read: No such")));
  tls.set_certificate_path(good.key_path);
  EXPECT_THAT(Fault(tls), HasSubstr("certificate_path: " + good.key_path + ": holds no certificate in PEM"));
  tls = authority.Tls(good, true);
  tls.set_key_path(good.certificate_path);
  EXPECT_THAT(Fault(tls), HasSubstr("key_path: " + good.certificate_path + ": holds no private key"));
  tls.set_key_path(authority.Issue("other").key_path);
  EXPECT_THAT(Fault(tls), AllOf(StartsWith("runtime.tls.key_path: "),
                                HasSubstr("is not the key of the certificate in " + good.certificate_path)));
  tls = authority.Tls(good, true);
  tls.set_authority_path(Written("authority.txt", "hello"));
  EXPECT_THAT(Fault(tls), StartsWith("runtime.tls.authority_path: "));
  tls.set_authority_path(folder_);
  EXPECT_THAT(Fault(tls), StartsWith("runtime.tls.authority_path: "));
}

TEST_F(TlsFiles, ADamagedChainIsNoticed) {
  const testing::CertificateAuthority authority(folder_, "authority");
  const testing::Identity good = authority.Issue("good");
  config::v1::TlsConfig tls = authority.Tls(good, true);
  const std::string whole = Content(good.certificate_path);
  tls.set_certificate_path(Written("chain.pem", whole + Content(authority.path())));
  EXPECT_EQ(Fault(tls), "");
  tls.set_certificate_path(Written("damaged.pem", whole + whole.substr(0, whole.size() / 2)));
  EXPECT_THAT(Fault(tls), HasSubstr("one of its certificates is damaged"));
}

TEST_F(TlsFiles, CertificatesHoldForATime) {
  const testing::CertificateAuthority authority(folder_, "authority");
  EXPECT_THAT(Fault(authority.Tls(authority.Issue("old", {-10, -1}), true)),
              HasSubstr("the certificate expired at 20"));
  EXPECT_THAT(Fault(authority.Tls(authority.Issue("new", {1, 10}), true)), HasSubstr("is not valid before 20"));
  const config::v1::TlsConfig tls = authority.Tls(authority.Issue("now"), true);
  EXPECT_THAT(Fault(tls, absl::Now() + absl::Hours(48)), HasSubstr("expired"));
}

TEST_F(TlsFiles, AKeyWithAPassphraseIsNotAskedFor) {
  const testing::CertificateAuthority authority(folder_, "authority");
  const testing::Identity good = authority.Issue("good");
  const std::string locked = folder_ / "locked.key";
  ASSERT_EQ(std::system(("openssl pkey -aes256 -passout pass:secret -in " + good.key_path + " -out " + locked).c_str()),
            0);
  config::v1::TlsConfig tls = authority.Tls(good, true);
  tls.set_key_path(locked);
  EXPECT_THAT(Fault(tls), HasSubstr("the key has a passphrase"));
}

}  // namespace
}  // namespace flair::runtime
