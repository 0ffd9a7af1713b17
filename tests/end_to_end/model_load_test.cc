// SPDX-License-Identifier: GPL-3.0-or-later
// One worker with many calls that wait for the model.
#include <gmock/gmock.h>
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <condition_variable>
#include <fstream>
#include <list>
#include <mutex>
#include <vector>

#include "flair/v1/language_service.grpc.pb.h"
#include "fmt/format.h"
#include "tests/fixtures/programs.h"
#include "tests/fixtures/scripted_model.h"

namespace flair::testing {
namespace {

constexpr int kCalls = 500;
#ifdef __SANITIZE_ADDRESS__
constexpr double kMostResidentMb = 2000;  // with the sanitizer's own memory, which keeps what was freed
#else
constexpr double kMostResidentMb = 200;
#endif

// Resident memory of a process now; negative when it is gone.
double ResidentMb(pid_t pid) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  std::string word;
  double kilobytes = 0;
  while (status >> word) {
    if (word == "VmRSS:" && status >> kilobytes) return kilobytes / 1024;
  }
  return -1;
}

// Calls of one client, waited for together.
class Calls {
 public:
  explicit Calls(const std::string& address)
      : stub_(v1::LanguageService::NewStub(grpc::CreateChannel(address, grpc::InsecureChannelCredentials()))) {}

  void Start(const std::string& id) {
    Call& call = calls_.emplace_back();
    call.request.set_request_id(id);
    call.request.mutable_brief()->set_text(kModelBrief);
    call.context.set_deadline(std::chrono::system_clock::now() + std::chrono::minutes(5));
    stub_->async()->DescribeRoom(&call.context, &call.request, &call.response, [this](const grpc::Status& status) {
      const std::lock_guard lock(mutex_);
      ++ended_;
      if (status.ok()) ++answered_;
      if (!status.ok()) error_ = status.error_message();
      changed_.notify_all();
    });
  }
  void WaitForAll() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return ended_ == static_cast<int>(calls_.size()); });
  }
  int answered() const { return answered_; }
  const std::string& error() const { return error_; }

 private:
  struct Call {
    grpc::ClientContext context;
    v1::DescribeRoomRequest request;
    v1::DescribeRoomResponse response;
  };

  const std::unique_ptr<v1::LanguageService::Stub> stub_;
  std::list<Call> calls_;
  std::mutex mutex_;
  std::condition_variable changed_;
  int ended_ = 0;
  int answered_ = 0;
  std::string error_;
};

// Answers the room when the gate opens, however often it is asked.
Script GatedRoom() {
  Script script = DesignScript();
  Exchange room = ExchangeOf("room", script);
  room.gate = "all are there";
  script.exchanges = {room};
  script.repeat_last = true;
  return script;
}

std::string Config(const ScriptedServer& server, int calls, const std::string& runtime, const std::string& llm) {
  return fmt::format(
      "runtime {{ listen_address: \"127.0.0.1:0\" log_level: \"error\" worker_thread_count: {0} {1} }} "
      "llm {{ {2} in_flight_limit: {0} }}",
      calls, runtime, LlmConfigText(server, llm));
}

// Holds kCalls at the server, looks at the worker, lets them go.
void ExpectSmall(ScriptedServer& server, const std::string& llm, const TestFolder& folder) {
  ServerProgram language("flair-language", Config(server, kCalls, "", llm), folder.path());
  ASSERT_NE(language.address(), "");
  const double before_mb = ResidentMb(language.process().pid());
  Calls calls(language.address());
  for (int i = 0; i < kCalls; ++i) calls.Start(fmt::format("call-{}", i));
  server.WaitForRequests(kCalls);
  const double during_mb = ResidentMb(language.process().pid());
  server.OpenGate("all are there");
  calls.WaitForAll();
  EXPECT_EQ(calls.answered(), kCalls) << calls.error();
  EXPECT_GT(before_mb, 0);
  EXPECT_LT(during_mb, kMostResidentMb) << "of these " << before_mb << " MB without calls";
  fmt::print("resident: {:.1f} MB idle, {:.1f} MB with {} calls in flight\n", before_mb, during_mb, kCalls);
}

TEST(ModelLoad, FiveHundredCallsInFlightOnOneWorkerTakeLessThanTwoHundredMegabytes) {
  const TestFolder folder;
  ScriptedServer server(GatedRoom());
  ExpectSmall(server, "", folder);
}

TEST(ModelLoad, SoDoFiveHundredStreamsOverTls) {
  const TestFolder folder;
  const TestCertificate certificate = MakeTestCertificate();
  WriteAll(folder / "ca.pem", certificate.certificate_pem);
  ScriptedServer server(GatedRoom(), certificate);
  ExpectSmall(server, "stream: true ca_path: \"" + (folder / "ca.pem").string() + "\"", folder);
}

TEST(ModelLoad, AWorkerThatIsStoppedWhileTheModelThinksEndsAndClosesItsConnections) {
  constexpr int kFew = 20;
  ScriptedServer server(GatedRoom());
  const TestFolder folder;
  ServerProgram language("flair-language", Config(server, kFew, "drain_seconds: 0", ""), folder.path());
  ASSERT_NE(language.address(), "");
  Calls calls(language.address());
  for (int i = 0; i < kFew; ++i) calls.Start(fmt::format("call-{}", i));
  server.WaitForRequests(kFew);
  language.process().Signal(SIGTERM);
  EXPECT_EQ(language.process().Wait().exit_code, 0);
  server.WaitForClosedByClient(kFew);
  calls.WaitForAll();
  EXPECT_EQ(calls.answered(), 0);
}

}  // namespace
}  // namespace flair::testing
