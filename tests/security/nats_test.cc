// SPDX-License-Identifier: GPL-3.0-or-later
// Between the orchestrator and NATS: who is believed, who is let in, and what is said of it.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "orchestrator/jetstream/open.h"
#include "tests/fixtures/nats_server.h"
#include "tests/security/attacks.h"
#include "tests/security/secure_programs.h"
#include "worker_runtime/clock/clock.h"

namespace flair::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// Why a queue of these servers cannot be had; OK when it can.
absl::Status OpenQueue(const std::string& address, const config::v1::TlsConfig* tls = nullptr,
                       const std::string& credentials = "") {
  config::v1::QueueConfig config;
  config.set_address(address);
  config.set_credentials_path(credentials);
  return orchestrator::OpenJetStreamQueue(config, tls, runtime::SystemClock()).status();
}

std::string Message(const absl::Status& status) { return std::string(status.message()); }

std::string OfAddress(std::string address, const std::string& scheme, const std::string& user = "") {
  return address.replace(0, std::string("nats://").size(), scheme + user);
}

// A server that takes only those whom the authority knows.
class NatsWithTls : public ::testing::Test {
 protected:
  void Serve(const Identity& identity) {
    servers_ = std::make_unique<NatsServers>(
        1, NatsOptions{
               .config = fmt::format("tls {{ cert_file: \"{}\"\n key_file: \"{}\"\n ca_file: \"{}\"\n verify: true }}",
                                     identity.certificate_path, identity.key_path, authority_.path())});
    ASSERT_TRUE(servers_->ok()) << servers_->Log();
  }
  std::string address() const { return OfAddress(servers_->address(), "tls://"); }
  config::v1::TlsConfig Friend() const { return authority_.Tls(authority_.Issue("friend"), false); }

  TestFolder folder_;
  CertificateAuthority authority_{folder_.path(), "authority"};
  std::unique_ptr<NatsServers> servers_;
};

TEST_F(NatsWithTls, AnOrchestratorWithItsCertificateKeepsItsJobsThere) {
  Serve(authority_.Issue("nats"));
  const std::string config = fmt::format(
      "{}stages {{ language: \"127.0.0.1:1\" translator: \"127.0.0.1:1\" optimizer: \"127.0.0.1:1\" renderer: "
      "\"127.0.0.1:1\" }}\ntakes_no_jobs: true\nqueue {{ address: \"{}\" }}\n",
      RuntimeWithTls(authority_.Tls(authority_.Issue("orchestrator"), true)), address());
  runtime::ChannelOptions options;
  options.tls = Friend();
  std::string job_id;
  for (int start = 0; start < 2; ++start) {
    ServerProgram program("flair-orchestrator", config, folder_.path());
    ASSERT_NE(program.address(), "") << program.process().Wait().err;
    OrchestratorCaller caller(program.address(), options);
    const auto job = caller.CreateJob("A bedroom that is 3m x 4m.", "r1");
    ASSERT_TRUE(job.ok()) << job.status();
    if (start == 0) job_id = job->id();
    EXPECT_EQ(job->id(), job_id);
  }
}

TEST_F(NatsWithTls, AServerOfAnotherAuthorityIsNotBelieved) {
  Serve(authority_.Issue("nats"));
  const CertificateAuthority other(folder_.path(), "other");
  config::v1::TlsConfig tls = Friend();
  tls.set_authority_path(other.path());
  const absl::Status status = OpenQueue(address(), &tls);
  EXPECT_TRUE(absl::IsUnauthenticated(status)) << status;
  EXPECT_THAT(Message(status), AllOf(HasSubstr(address()), HasSubstr("runtime.tls.authority_path")));
}

TEST_F(NatsWithTls, AServerOfAnotherNameIsNotBelieved) {
  Serve(authority_.Issue("nats", {}, "elsewhere.example"));
  const config::v1::TlsConfig tls = Friend();
  const absl::Status status = OpenQueue(address(), &tls);
  EXPECT_TRUE(absl::IsUnauthenticated(status)) << status;
  EXPECT_THAT(Message(status), AllOf(HasSubstr(address()), HasSubstr("name")));
}

TEST_F(NatsWithTls, AServerWhoseCertificateHasExpiredIsNotBelieved) {
  Serve(authority_.Issue("nats", {.from_days = -3, .until_days = -1}));
  const config::v1::TlsConfig tls = Friend();
  const absl::Status status = OpenQueue(address(), &tls);
  EXPECT_TRUE(absl::IsUnauthenticated(status)) << status;
  EXPECT_THAT(Message(status), HasSubstr("expired"));
}

TEST_F(NatsWithTls, WhoShowsNoCertificateIsToldWhatIsMissing) {
  Serve(authority_.Issue("nats"));
  config::v1::TlsConfig tls;
  tls.set_authority_path(authority_.path());
  const absl::Status status = OpenQueue(address(), &tls);
  EXPECT_TRUE(absl::IsUnauthenticated(status)) << status;
  EXPECT_THAT(Message(status), HasSubstr("runtime.tls.certificate_path"));
}

TEST_F(NatsWithTls, WhoShowsTheCertificateOfAnotherAuthorityIsNotLetIn) {
  Serve(authority_.Issue("nats"));
  const CertificateAuthority other(folder_.path(), "other");
  config::v1::TlsConfig tls = other.Tls(other.Issue("stranger"), false);
  tls.set_authority_path(authority_.path());
  const absl::Status status = OpenQueue(address(), &tls);
  EXPECT_TRUE(absl::IsUnauthenticated(status)) << status;
  EXPECT_THAT(Message(status), HasSubstr("runtime.tls.certificate_path"));
}

TEST_F(NatsWithTls, WhoSpeaksPlainTextIsToldOfTls) {
  Serve(authority_.Issue("nats"));
  const absl::Status status = OpenQueue(servers_->address());
  EXPECT_TRUE(absl::IsUnauthenticated(status)) << status;
  EXPECT_THAT(Message(status), AllOf(HasSubstr(servers_->address()), HasSubstr("tls://")));
}

TEST_F(NatsWithTls, AServerWithoutTlsIsNotSpokenToInPlainText) {
  const NatsServers plain;
  ASSERT_TRUE(plain.ok()) << plain.Log();
  const config::v1::TlsConfig tls = Friend();
  const absl::Status status = OpenQueue(OfAddress(plain.address(), "tls://"), &tls);
  EXPECT_TRUE(absl::IsUnauthenticated(status)) << status;
  EXPECT_THAT(Message(status), HasSubstr("does not use TLS"));
}

constexpr char kSecret[] = "s3cret-Pa55";

// Nothing of it is in what is said, whatever goes wrong.
void ExpectRefused(const absl::Status& status, const std::string& shown) {
  EXPECT_TRUE(absl::IsUnauthenticated(status)) << status;
  EXPECT_THAT(Message(status), AllOf(HasSubstr("queue."), HasSubstr(shown), Not(HasSubstr(kSecret))));
}

TEST(NatsCredentials, AUserAndPasswordMayBeInTheAddress) {
  const NatsServers servers(1, {.config = fmt::format("authorization {{ user: flair, password: \"{}\" }}", kSecret)});
  ASSERT_TRUE(servers.ok()) << servers.Log();
  const absl::Status good = OpenQueue(OfAddress(servers.address(), "nats://", fmt::format("flair:{}@", kSecret)));
  EXPECT_TRUE(good.ok()) << good;
  ExpectRefused(OpenQueue(OfAddress(servers.address(), "nats://", fmt::format("flair:{}x@", kSecret))),
                servers.address());
  ExpectRefused(OpenQueue(OfAddress(servers.address(), "nats://", fmt::format("eve:{}@", kSecret))), servers.address());
  ExpectRefused(OpenQueue(servers.address()), servers.address());
}

TEST(NatsCredentials, ATokenMayBeInTheAddress) {
  const NatsServers servers(1, {.config = fmt::format("authorization {{ token: \"{}\" }}", kSecret)});
  ASSERT_TRUE(servers.ok()) << servers.Log();
  const absl::Status good = OpenQueue(OfAddress(servers.address(), "nats://", fmt::format("{}@", kSecret)));
  EXPECT_TRUE(good.ok()) << good;
  ExpectRefused(OpenQueue(OfAddress(servers.address(), "nats://", fmt::format("{}x@", kSecret))), servers.address());
}

TEST(NatsCredentials, AFileOfCredentialsLetsIn) {
  const TestFolder folder;
  const std::filesystem::path known = FLAIR_SOURCE_DIR "/tests/security/testdata/nats";
  std::vector<std::string> seeds;
  for (const char* file : {"good.creds", "other.creds"}) {
    std::filesystem::copy_file(known / file, folder / file);
    const std::string text = ReadAll(folder / file);
    const size_t seed = text.find("\nSU");
    ASSERT_NE(seed, std::string::npos);
    seeds.push_back(text.substr(seed + 1, text.find('\n', seed + 1) - seed - 1));
  }
  WriteAll(folder / "damaged.creds", "-----BEGIN NATS USER JWT-----\n" + seeds[0] + "\n");
  const NatsServers servers(1, {.config = ReadAll(known / "operator.conf")});
  ASSERT_TRUE(servers.ok()) << servers.Log();
  const absl::Status good = OpenQueue(servers.address(), nullptr, folder / "good.creds");
  EXPECT_TRUE(good.ok()) << good;
  for (const char* file : {"other.creds", "damaged.creds", "missing.creds"}) {
    const absl::Status status = OpenQueue(servers.address(), nullptr, folder / file);
    EXPECT_FALSE(status.ok()) << file;
    EXPECT_THAT(Message(status), AllOf(HasSubstr("queue.credentials_path"), HasSubstr(folder / file),
                                       Not(HasSubstr(seeds[0])), Not(HasSubstr(seeds[1]))));
  }
}

TEST(NatsCredentials, SecretsOfAnAddressAreInNoErrorAndNoLog) {
  const TestFolder folder;
  const std::string user = fmt::format("flair:{}@", kSecret);
  const std::string addresses[] = {fmt::format("nats://{}127.0.0.1:1", user),
                                   fmt::format("tls://{}127.0.0.1:1", user),
                                   fmt::format("http://{}127.0.0.1:1", user),
                                   fmt::format("nats://{}[:", user),
                                   fmt::format("nats://127.0.0.1:1,nats://{}127.0.0.1:2", user),
                                   fmt::format("nats://{}10.1.2.3:4222", user)};
  for (const std::string& address : addresses) {
    ServerProgram program(
        "flair-orchestrator",
        fmt::format("runtime {{ listen_address: \"127.0.0.1:0\" log_level: \"debug\" }}\nstages {{ language: "
                    "\"127.0.0.1:1\" translator: \"127.0.0.1:1\" optimizer: \"127.0.0.1:1\" renderer: \"127.0.0.1:1\" "
                    "}}\nqueue {{ address: \"{}\" }}\n",
                    address),
        folder.path());
    EXPECT_EQ(program.address(), "") << address;
    const Finished end = program.process().Wait();
    EXPECT_NE(end.exit_code, 0);
    EXPECT_THAT(end.err, AllOf(HasSubstr("queue.address"), Not(HasSubstr(kSecret)))) << address;
  }
}

TEST(NatsCredentials, QueuesOfOtherMachinesAreNotSpokenToInPlainText) {
  const TestFolder folder;
  ServerProgram program("flair-orchestrator",
                        "runtime { listen_address: \"127.0.0.1:0\" }\nstages { language: \"127.0.0.1:1\" translator: "
                        "\"127.0.0.1:1\" optimizer: \"127.0.0.1:1\" renderer: \"127.0.0.1:1\" }\n"
                        "queue { address: \"nats://127.0.0.1,nats://10.1.2.3:4222\" }\n",
                        folder.path());
  EXPECT_EQ(program.address(), "");
  const Finished end = program.process().Wait();
  EXPECT_EQ(end.exit_code, 2);
  EXPECT_THAT(end.err, AllOf(HasSubstr("queue.address: \"nats://10.1.2.3:4222\""), HasSubstr("plain text"),
                             HasSubstr("tls://"), HasSubstr("runtime.allow_insecure")));
}

}  // namespace
}  // namespace flair::testing
