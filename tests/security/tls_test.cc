// SPDX-License-Identifier: GPL-3.0-or-later
// Who may connect: real programs, certificates of every kind.
#include <gmock/gmock.h>
#include <grpcpp/create_channel.h>
#include <grpcpp/security/credentials.h>

#include "absl/time/clock.h"
#include "flair/v1/optimizer_service.grpc.pb.h"
#include "flair/v1/worker_service.grpc.pb.h"
#include "tests/security/secure_programs.h"
#include "worker_runtime/grpc/client_call.h"

namespace flair::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

runtime::ChannelOptions With(const CertificateAuthority& believed, const Identity& shown) {
  runtime::ChannelOptions options;
  options.tls = believed.Tls(shown, false);
  return options;
}

runtime::ChannelOptions WithoutCertificate(const CertificateAuthority& believed) {
  runtime::ChannelOptions options;
  options.tls.emplace().set_authority_path(believed.path());
  return options;
}

TEST(MutualTls, OnlyThoseWithARightCertificateAreAnswered) {
  const SecureOptimizer optimizer("log_level: \"error\"");
  ASSERT_NE(optimizer.address(), "");
  const CertificateAuthority& authority = optimizer.authority();
  const CertificateAuthority other(optimizer.folder(), "other");
  const struct {
    const char* name;
    runtime::ChannelOptions caller;
  } strangers[] = {
      {"plain text", {}},
      {"no certificate", WithoutCertificate(authority)},
      {"a certificate of another authority", With(authority, other.Issue("stranger"))},
      {"a certificate that it signed itself", With(authority, SelfSigned(optimizer.folder(), "self"))},
      {"believes another authority", With(other, authority.Issue("mistrusting"))},
  };
  for (const auto& [name, caller] : strangers) {
    EXPECT_EQ(AskWho(optimizer.address(), caller).code(), absl::StatusCode::kUnavailable) << name;
    EXPECT_TRUE(AskWho(optimizer.address(), optimizer.Friend()).ok()) << "after " << name;
  }
}

// Calls with credentials that no code of ours has looked at.
grpc::Status Shows(const std::string& address, const CertificateAuthority& believed, const Identity& shown) {
  const auto credentials =
      grpc::SslCredentials({ReadAll(believed.path()), ReadAll(shown.key_path), ReadAll(shown.certificate_path)});
  const auto stub = v1::WorkerService::NewStub(grpc::CreateChannel(address, credentials));
  grpc::ClientContext context;
  context.set_deadline(absl::ToChronoTime(absl::Now() + absl::Minutes(1)));
  v1::GetWorkerResponse response;
  return stub->GetWorker(&context, v1::GetWorkerRequest(), &response);
}

TEST(MutualTls, ACertificateThatHasExpiredIsWorthNothing) {
  const SecureOptimizer optimizer("log_level: \"error\"");
  // Our own programs look at their files before they show them; others' need not.
  const Identity expired = optimizer.authority().Issue("expired", {-10, -1});
  EXPECT_THAT(std::string(AskWho(optimizer.address(), With(optimizer.authority(), expired)).message()),
              HasSubstr("the certificate expired at"));
  EXPECT_TRUE(Shows(optimizer.address(), optimizer.authority(), optimizer.authority().Issue("valid")).ok());
  EXPECT_EQ(Shows(optimizer.address(), optimizer.authority(), expired).error_code(), grpc::StatusCode::UNAVAILABLE);
}

TEST(MutualTls, AServerMustBeWhoItIsCalled) {
  const TestFolder folder;
  const CertificateAuthority authority(folder.path(), "authority");
  const Identity elsewhere = authority.Issue("server", {}, "elsewhere.example");
  ServerProgram server("flair-optimizer", RuntimeWithTls(authority.Tls(elsewhere, true), "log_level: \"error\""),
                       folder.path());
  ASSERT_NE(server.address(), "");
  const absl::Status status = AskWho(server.address(), With(authority, authority.Issue("caller")));
  EXPECT_EQ(status.code(), absl::StatusCode::kUnavailable);
  EXPECT_THAT(std::string(status.message()), HasSubstr("is for another name")) << status;
}

TEST(MutualTls, WhereNamesAreBelievedOthersOfTheAuthorityMayNotCall) {
  const TestFolder folder;
  const CertificateAuthority authority(folder.path(), "authority");
  config::v1::TlsConfig tls = authority.Tls(authority.Issue("optimizer"), true);
  tls.add_client_names("orchestrator");
  ServerProgram server("flair-optimizer", RuntimeWithTls(tls, "log_level: \"error\""), folder.path());
  const auto solve = [&](const std::string& name) {
    const auto channel = *runtime::MakeChannel(server.address(), "", With(authority, authority.Issue(name)));
    const auto stub = v1::OptimizerService::NewStub(channel);
    runtime::CallContext call;
    return runtime::UnaryRequest(*stub, &v1::OptimizerService::StubInterface::Solve, v1::SolveRequest(), call,
                                 absl::Now() + absl::Minutes(1))
        .status();
  };
  EXPECT_EQ(solve("orchestrator").code(), absl::StatusCode::kInvalidArgument) << "of the empty request";
  const absl::Status refused = solve("client");
  EXPECT_EQ(refused.code(), absl::StatusCode::kPermissionDenied);
  EXPECT_THAT(std::string(refused.message()), HasSubstr("the certificate of \"client\" is none that may call here"));
}

TEST(MutualTls, NewCertificatesAreUsedWithoutARestart) {
  const SecureOptimizer optimizer("log_level: \"error\"");
  const CertificateAuthority successor(optimizer.folder(), "successor");
  runtime::ChannelOptions believer = WithoutCertificate(successor);
  believer.tls = successor.Tls(optimizer.authority().Issue("caller"), false);
  ASSERT_EQ(AskWho(optimizer.address(), believer).code(), absl::StatusCode::kUnavailable);
  // The same files, of another authority: whoever believes that one is answered soon.
  successor.Issue("optimizer");
  const absl::Time patience = absl::Now() + absl::Minutes(1);
  absl::Status status = AskWho(optimizer.address(), believer);
  while (!status.ok() && absl::Now() < patience) status = AskWho(optimizer.address(), believer);
  EXPECT_TRUE(status.ok()) << status;
}

// What a program says that does not start.
std::string Refusal(const std::string& program, const std::string& config, const TestFolder& folder) {
  WriteAll(folder / "config.textproto", config);
  Process process(ProgramPath(program), {(folder / "config.textproto").string()});
  const Finished finished = process.Wait();
  EXPECT_EQ(finished.exit_code, 2) << finished.err;
  return finished.err;
}

TEST(Exposure, NobodyServesOthersInsecurelyByMistake) {
  const TestFolder folder;
  for (const std::string stage : {"language", "translator", "optimizer", "renderer"}) {
    EXPECT_THAT(Refusal("flair-" + stage, "runtime { listen_address: \"0.0.0.0:0\" }\n", folder),
                AllOf(HasSubstr(":1: runtime.listen_address: \"0.0.0.0:0\" can be reached from other machines"),
                      HasSubstr("runtime.allow_insecure")));
  }
  const std::string rest = "store_path: \"" + (folder / "store").string() +
                           "\"\nstages { language: \"unix:l\" translator: \"unix:t\" optimizer: \"unix:o\" renderer: "
                           "\"unix:r\" }\n";
  EXPECT_THAT(Refusal("flair-orchestrator", "runtime { listen_address: \"[::]:0\" }\n" + rest, folder),
              AllOf(HasSubstr("plain text"), HasSubstr("tokens_path")));
  const CertificateAuthority authority(folder.path(), "authority");
  const std::string tls = RuntimeWithTls(authority.Tls(authority.Issue("server"), false));
  const size_t local = tls.find("127.0.0.1:0");
  EXPECT_THAT(Refusal("flair-orchestrator", std::string(tls).replace(local, 11, "0.0.0.0:0") + rest, folder),
              HasSubstr("anybody may call"));
  EXPECT_THAT(Refusal("flair-optimizer", "runtime { metrics_address: \"0.0.0.0:0\" }\n", folder),
              HasSubstr("runtime.metrics_address: \"0.0.0.0:0\" can be reached"));
}

TEST(Exposure, WhoMeansItMay) {
  const TestFolder folder;
  ServerProgram server("flair-optimizer",
                       "runtime { listen_address: \"0.0.0.0:0\" allow_insecure: true log_level: \"error\" }\n",
                       folder.path());
  const std::string port = server.address().substr(server.address().rfind(':'));
  EXPECT_TRUE(AskWho("127.0.0.1" + port, {}).ok());
}

TEST(Exposure, CallsLeaveTheMachineEncryptedOrNotAtAll) {
  const TestFolder folder;
  EXPECT_THAT(Refusal("flair-optimizer", "runtime {}\npeer_addresses: \"10.1.2.3:50055\"\n", folder),
              AllOf(HasSubstr("peer_addresses[0]"), HasSubstr("plain text"), HasSubstr("allow_insecure")));
}

TEST(TlsFiles, AreLookedAtBeforeAnythingIsServed) {
  const TestFolder folder;
  const CertificateAuthority authority(folder.path(), "authority");
  const Identity good = authority.Issue("good");
  config::v1::TlsConfig mixed = authority.Tls(good, true);
  mixed.set_key_path(authority.Issue("other").key_path);
  EXPECT_THAT(Refusal("flair-optimizer", RuntimeWithTls(mixed), folder),
              HasSubstr("runtime.tls.key_path: " + mixed.key_path() + ": is not the key of the certificate"));
  EXPECT_THAT(Refusal("flair-optimizer", RuntimeWithTls(authority.Tls(authority.Issue("old", {-9, -2}), true)), folder),
              HasSubstr("the certificate expired at"));
  EXPECT_THAT(Refusal("flair-optimizer", "runtime {\n  tls {\n    require_client_certificate: true\n  }\n}\n", folder),
              AllOf(HasSubstr("runtime.tls.certificate_path: missing"), HasSubstr("runtime.tls.key_path: missing"),
                    HasSubstr("runtime.tls.authority_path: missing")));
}

}  // namespace
}  // namespace flair::testing
