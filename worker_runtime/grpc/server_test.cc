// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/grpc/server.h"

#include <gmock/gmock.h>
#include <grpcpp/create_channel.h>
#include <grpcpp/generic/generic_stub.h>
#include <grpcpp/support/byte_buffer.h>
#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <string>
#include <thread>

#include "flair/v1/optimizer_service.grpc.pb.h"
#include "flair/v1/worker_service.grpc.pb.h"
#include "grpc/health/v1/health.pb.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/grpc/in_process_server.h"
#include "worker_runtime/grpc/server_call.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/testing/fakes.h"

namespace flair::runtime {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using SolveFunction = std::function<absl::StatusOr<v1::SolveResponse>(const v1::SolveRequest&, CallContext&)>;

// An optimizer that does what a test tells it.
struct TestService final : Service {
  TestService(WorkerContext& worker, SolveFunction solve) : Service(worker, v1::OptimizerService::service_full_name()) {
    Unary<v1::SolveRequest>("Solve", std::move(solve));
  }
};

config::v1::RuntimeConfig SmallConfig() {
  config::v1::RuntimeConfig config;
  config.set_worker_thread_count(1);
  config.set_queue_limit(1);
  config.set_log_level("error");
  return config;
}

std::unique_ptr<InProcessServer> StartInProcess(SolveFunction solve) {
  auto server = InProcessServer::Start("test", SmallConfig(), v1::OptimizerService::service_full_name(),
                                       [&](WorkerContext& context) -> absl::StatusOr<std::unique_ptr<grpc::Service>> {
                                         return std::make_unique<TestService>(context, std::move(solve));
                                       });
  return *std::move(server);
}

absl::StatusOr<v1::SolveResponse> Solve(std::shared_ptr<grpc::Channel> channel, CallContext& call) {
  const auto stub = v1::OptimizerService::NewStub(channel);
  v1::SolveRequest request;
  request.set_request_id("r1");
  return UnaryRequest(*stub, &v1::OptimizerService::StubInterface::Solve, request, call);
}

// What the server answers to one message of a method, byte by byte.
absl::StatusOr<std::string> AskRaw(std::shared_ptr<grpc::Channel> channel, const char* method,
                                   const std::string& request) {
  grpc::Slice slice(request);
  grpc::ByteBuffer in(&slice, 1);
  grpc::ByteBuffer out;
  grpc::GenericStub stub(channel);
  grpc::ClientContext context;
  std::promise<grpc::Status> done;
  stub.UnaryCall(&context, method, {}, &in, &out, [&done](grpc::Status status) { done.set_value(status); });
  const grpc::Status status = done.get_future().get();
  if (!status.ok()) return FromGrpcStatus(status);
  std::vector<grpc::Slice> slices;
  (void)out.Dump(&slices);
  std::string answer;
  for (const grpc::Slice& part : slices) answer.append(reinterpret_cast<const char*>(part.begin()), part.size());
  return answer;
}

using grpc::health::v1::HealthCheckRequest;
using grpc::health::v1::HealthCheckResponse;

absl::StatusOr<int> Health(std::shared_ptr<grpc::Channel> channel, const std::string& service) {
  HealthCheckRequest request;
  request.set_service(service);
  ASSIGN_OR_RETURN(const std::string answer,
                   AskRaw(channel, "/grpc.health.v1.Health/Check", request.SerializeAsString()));
  HealthCheckResponse response;
  return response.ParseFromString(answer) ? response.status() : -1;
}

// Who watches the health of a service.
class HealthWatcher {
 public:
  HealthWatcher(std::shared_ptr<grpc::Channel> channel, const std::string& service) : stub_(channel) {
    HealthCheckRequest request;
    request.set_service(service);
    stream_ = stub_.PrepareCall(&context_, "/grpc.health.v1.Health/Watch", &queue_);
    stream_->StartCall(nullptr);
    Step();
    stream_->Write(BytesOf(request), nullptr);
    Step();
    stream_->WritesDone(nullptr);
    Step();
  }
  ~HealthWatcher() {
    context_.TryCancel();
    queue_.Shutdown();
    while (Step()) continue;
  }
  // What it is told next; -1 when that was all.
  int Next() {
    grpc::ByteBuffer bytes;
    stream_->Read(&bytes, nullptr);
    HealthCheckResponse response;
    return Step() && ParseMessage(bytes, response).ok() ? response.status() : -1;
  }

 private:
  bool Step() {
    void* tag = nullptr;
    bool ok = false;
    return queue_.Next(&tag, &ok) && ok;
  }

  grpc::GenericStub stub_;
  grpc::ClientContext context_;
  grpc::CompletionQueue queue_;
  std::unique_ptr<grpc::GenericClientAsyncReaderWriter> stream_;
};

TEST(Server, CarriesCodesAndMessagesOfAHandler) {
  auto server = StartInProcess([](const v1::SolveRequest& request, CallContext& call) {
    EXPECT_EQ(call.request_id(), "r1");
    return absl::InvalidArgumentError("layout_graph.room: missing");
  });
  CallContext call;
  EXPECT_EQ(Solve(server->channel(), call).status(), absl::InvalidArgumentError("layout_graph.room: missing"));
}

TEST(Server, CarriesTheAnswer) {
  auto server = StartInProcess([](const v1::SolveRequest& request, CallContext&) {
    v1::SolveResponse response;
    response.mutable_solved_layout()->set_total_cost(3);
    return response;
  });
  CallContext call;
  EXPECT_EQ(Solve(server->channel(), call)->solved_layout().total_cost(), 3);
}

TEST(Server, AnswersResourceExhaustedWhenTheQueueIsFull) {
  TestGate running;
  TestGate release;
  auto server = StartInProcess([&](const v1::SolveRequest&, CallContext&) {
    running.Open();
    release.Wait();
    return v1::SolveResponse();
  });
  auto channel = server->channel();
  const auto ask = [&] {
    CallContext call;
    return Solve(channel, call).status();
  };
  auto first = std::async(std::launch::async, ask);
  running.Wait();
  // One more waits; of two, one is turned away, whichever comes second, and at once.
  auto second = std::async(std::launch::async, ask);
  auto third = std::async(std::launch::async, ask);
  while (second.wait_for(std::chrono::milliseconds(1)) != std::future_status::ready &&
         third.wait_for(std::chrono::milliseconds(1)) != std::future_status::ready) {
  }
  release.Open();
  const absl::Status a = second.get();
  const absl::Status b = third.get();
  const absl::Status refused = a.ok() ? b : a;
  EXPECT_EQ(refused.code(), absl::StatusCode::kResourceExhausted);
  EXPECT_THAT(std::string(refused.message()), HasSubstr("queue is full"));
  EXPECT_TRUE(a.ok() || b.ok());
  EXPECT_TRUE(first.get().ok());
}

TEST(Server, ACancelledCallReachesTheHandler) {
  TestGate running;
  TestGate seen;
  auto server = StartInProcess([&](const v1::SolveRequest&, CallContext& call) -> absl::StatusOr<v1::SolveResponse> {
    OnCancel guard(call.cancellation(), [&] { seen.Open(); });
    running.Open();
    seen.Wait();
    return call.CheckAlive();
  });
  CallContext call;
  std::thread canceller([&] {
    running.Wait();
    call.cancellation().Cancel();
  });
  EXPECT_EQ(Solve(server->channel(), call).status().code(), absl::StatusCode::kCancelled);
  canceller.join();
  seen.Wait();
}

TEST(Server, ADeadlineReachesTheHandler) {
  auto server = StartInProcess([&](const v1::SolveRequest&, CallContext& call) -> absl::StatusOr<v1::SolveResponse> {
    while (!call.cancelled()) std::this_thread::yield();
    return call.CheckAlive();
  });
  CallContext call("r1", absl::Now() + absl::Milliseconds(20), SystemClock());
  EXPECT_EQ(Solve(server->channel(), call).status().code(), absl::StatusCode::kDeadlineExceeded);
}

class ListeningServer : public ::testing::Test {
 protected:
  void SetUp() override { Start("127.0.0.1:0"); }
  absl::Status Start(const std::string& address) {
    std::vector<NamedService> services;
    services.push_back({v1::OptimizerService::service_full_name(),
                        std::make_unique<TestService>(resources_.context(), [this](const auto&, CallContext& call) {
                          running_.Open();
                          release_.Wait();
                          return absl::StatusOr<v1::SolveResponse>(v1::SolveResponse());
                        })});
    ASSIGN_OR_RETURN(
        server_, Server::Start({.listen_address = address, .open_calls = resources_.context().rpc_metrics.open_calls()},
                               std::move(services)));
    channel_ = *MakeChannel(server_->address(), v1::OptimizerService::service_full_name());
    return absl::OkStatus();
  }
  TestGate running_;
  TestGate release_;
  WorkerResources resources_{"test", SmallConfig()};
  std::unique_ptr<Server> server_;
  std::shared_ptr<grpc::Channel> channel_;
};

TEST_F(ListeningServer, TakesAFreePortAndSaysWhich) {
  EXPECT_THAT(server_->address(), StartsWith("127.0.0.1:"));
  EXPECT_NE(server_->address(), "127.0.0.1:0");
}

TEST_F(ListeningServer, ReportsHealthByServiceName) {
  EXPECT_EQ(*Health(channel_, ""), HealthCheckResponse::SERVING);
  EXPECT_EQ(*Health(channel_, "flair.v1.OptimizerService"), HealthCheckResponse::SERVING);
  EXPECT_EQ(Health(channel_, "flair.v1.LanguageService").status().code(), absl::StatusCode::kNotFound);
}

TEST_F(ListeningServer, RefusesHealthRequestsThatAreLongOrNone) {
  EXPECT_EQ(Health(channel_, std::string(4000, 'x')).status().code(), absl::StatusCode::kNotFound);
  EXPECT_EQ(Health(channel_, std::string(4096, 'x')).status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_EQ(AskRaw(channel_, "/grpc.health.v1.Health/Check", "\x0a").status().code(),
            absl::StatusCode::kInvalidArgument);
}

TEST_F(ListeningServer, TellsWhoWatchesItsHealthWhenItStops) {
  HealthWatcher server(channel_, "");
  HealthWatcher service(channel_, "flair.v1.OptimizerService");
  HealthWatcher unknown(channel_, "flair.v1.LanguageService");
  EXPECT_EQ(server.Next(), HealthCheckResponse::SERVING);
  EXPECT_EQ(service.Next(), HealthCheckResponse::SERVING);
  EXPECT_EQ(unknown.Next(), HealthCheckResponse::SERVICE_UNKNOWN);
  auto stopped = std::async(std::launch::async, [&] { server_->Shutdown(absl::Minutes(1)); });
  for (HealthWatcher* watcher : {&server, &service, &unknown}) {
    EXPECT_EQ(watcher->Next(), HealthCheckResponse::NOT_SERVING);
    EXPECT_EQ(watcher->Next(), -1);
  }
  stopped.get();
}

TEST_F(ListeningServer, TellsToolsItsServicesAndTheirMessages) {
  constexpr char kAsk[] = "/grpc.reflection.v1alpha.ServerReflection/ServerReflectionInfo";
  EXPECT_THAT(*AskRaw(channel_, kAsk, "\x3a\x01*"), HasSubstr("flair.v1.OptimizerService"));
  EXPECT_THAT(*AskRaw(channel_, kAsk,
                      "\x22\x19"
                      "flair.v1.OptimizerService"),
              HasSubstr("SolveRestartsRequest"));
  EXPECT_THAT(*AskRaw(channel_, kAsk, "\x22\x01x"), HasSubstr("not found: x"));
}

TEST_F(ListeningServer, AMessageThatWouldUnfoldIsNotParsed) {
  std::string request;
  while (request.size() < 4 << 20) request += std::string("\x12\x02\x0a\0", 4);
  const absl::Status status = AskRaw(channel_, "/flair.v1.OptimizerService/Solve", request).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(status.message()), HasSubstr("MiB of memory; send fewer fields at once"));
}

TEST(Server, SaysWhichProgramAndRevisionItIs) {
  auto server = InProcessServer::Start("flair-test", SmallConfig(), v1::OptimizerService::service_full_name(),
                                       [](WorkerContext& context) -> absl::StatusOr<std::unique_ptr<grpc::Service>> {
                                         context.revision = "handbook 3";
                                         return std::make_unique<TestService>(context, nullptr);
                                       });
  CallContext call;
  const auto stub = v1::WorkerService::NewStub((*server)->channel());
  const auto answer = UnaryRequest(*stub, &v1::WorkerService::StubInterface::GetWorker, v1::GetWorkerRequest(), call);
  EXPECT_EQ(answer->program(), "flair-test");
  EXPECT_THAT(answer->revision(), ::testing::MatchesRegex("[0-9a-f]+/handbook 3"));
}

// A server whose answers come from the data of that revision; what it signs with and what it says of itself.
std::pair<v1::Producer, v1::GetWorkerResponse> SignedWith(const std::string& revision) {
  auto server = InProcessServer::Start("flair-test", SmallConfig(), v1::OptimizerService::service_full_name(),
                                       [&](WorkerContext& context) -> absl::StatusOr<std::unique_ptr<grpc::Service>> {
                                         context.revision = revision;
                                         context.build = "1-gabc";
                                         return std::make_unique<TestService>(context, [](const auto&, CallContext&) {
                                           v1::SolveResponse response;
                                           response.mutable_producer()->set_method("slsqp");
                                           return response;
                                         });
                                       });
  CallContext call;
  const auto stub = v1::WorkerService::NewStub((*server)->channel());
  return {Solve((*server)->channel(), call)->producer(),
          *UnaryRequest(*stub, &v1::WorkerService::StubInterface::GetWorker, v1::GetWorkerRequest(), call)};
}

TEST(Server, AnswersAreSignedWithBuildAndConfiguration) {
  const auto [producer, worker] = SignedWith("handbook 3");
  EXPECT_EQ(producer.method(), "slsqp");
  EXPECT_EQ(producer.build(), "1-gabc");
  EXPECT_EQ(producer.configuration_digest(), Sha256Hex("handbook 3"));
  EXPECT_EQ(worker.configuration_digest(), producer.configuration_digest());
  EXPECT_NE(SignedWith("handbook 4").first.configuration_digest(), producer.configuration_digest());
  EXPECT_EQ(SignedWith("").first.configuration_digest(), "");
}

TEST_F(ListeningServer, RefusesAPortThatIsTaken) {
  auto second = Server::Start({.listen_address = server_->address()}, {});
  EXPECT_EQ(second.status().code(), absl::StatusCode::kUnavailable);
  EXPECT_THAT(std::string(second.status().message()), HasSubstr(server_->address()));
}

TEST_F(ListeningServer, LetsRunningCallsEndWhenItDrains) {
  auto answer = std::async(std::launch::async, [&] {
    CallContext call;
    return Solve(channel_, call).status();
  });
  running_.Wait();
  auto stopped = std::async(std::launch::async, [&] { server_->Shutdown(absl::Minutes(1)); });
  release_.Open();
  EXPECT_TRUE(answer.get().ok());
  stopped.get();
}

TEST_F(ListeningServer, CanBeReachedOverAUnixSocket) {
  const std::string path = "unix:" + ::testing::TempDir() + "flair_server_" + std::to_string(::getpid()) + ".sock";
  server_->Shutdown(absl::ZeroDuration());
  ASSERT_TRUE(Start(path).ok());
  release_.Open();
  CallContext call;
  EXPECT_TRUE(Solve(channel_, call).ok());
}

TEST(Channel, RefusesAddressesOfNoKnownForm) {
  for (const std::string address : {"", "localhost", "host:", "host:abc", ":50051", "host:70000", "unix:"}) {
    EXPECT_EQ(MakeChannel(address, "x").status().code(), absl::StatusCode::kInvalidArgument) << address;
  }
}

TEST(Server, RefusesListenAddressesOfNoKnownForm) {
  for (const std::string address : {"localhost", "host:", "host:abc", "host:70000"}) {
    EXPECT_EQ(Server::Start({.listen_address = address}, {}).status().code(), absl::StatusCode::kInvalidArgument)
        << address;
  }
}

}  // namespace
}  // namespace flair::runtime
