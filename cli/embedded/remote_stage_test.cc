// SPDX-License-Identifier: GPL-3.0-or-later

#include <gmock/gmock.h>
#include <grpcpp/server.h>
#include <grpcpp/server_builder.h>
#include <gtest/gtest.h>

#include "cli/embedded/embedded_services.h"
#include "flair/v1/optimizer_service.grpc.pb.h"
#include "flair/v1/translator_service.grpc.pb.h"
#include "flair/v1/worker_service.grpc.pb.h"
#include "fmt/format.h"
#include "orchestrator/testing/temporary_folder.h"
#include "tests/fixtures/bedroom.h"
#include "worker_runtime/grpc/client_call.h"

namespace flair::cli {
namespace {

using ::testing::HasSubstr;

// An optimizer that is not ours, with a catalogue without types.
class OtherOptimizer final : public v1::OptimizerService::Service {
 public:
  grpc::Status ListConstraintTypes(grpc::ServerContext*, const v1::ListConstraintTypesRequest*,
                                   v1::ListConstraintTypesResponse* response) override {
    response->mutable_catalog()->set_library("other 1");
    return grpc::Status::OK;
  }
  grpc::Status Solve(grpc::ServerContext*, const v1::SolveRequest*, v1::SolveResponse*) override {
    return {grpc::StatusCode::INVALID_ARGUMENT, "layout_graph: missing"};
  }
};

class OtherWorker final : public v1::WorkerService::Service {
 public:
  explicit OtherWorker(std::vector<std::string> protocols) : protocols_(std::move(protocols)) {}
  grpc::Status GetWorker(grpc::ServerContext*, const v1::GetWorkerRequest*, v1::GetWorkerResponse* response) override {
    response->set_program("other-optimizer");
    response->mutable_protocols()->Assign(protocols_.begin(), protocols_.end());
    return grpc::Status::OK;
  }

 private:
  const std::vector<std::string> protocols_;
};

// Services on a free port of this machine.
class TestServer {
 public:
  explicit TestServer(const std::vector<grpc::Service*>& services) {
    grpc::ServerBuilder builder;
    builder.AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port_);
    for (grpc::Service* service : services) builder.RegisterService(service);
    server_ = builder.BuildAndStart();
  }
  std::string address() const { return fmt::format("127.0.0.1:{}", port_); }

 private:
  int port_ = 0;
  std::unique_ptr<grpc::Server> server_;
};

absl::Status ConnectToOptimizer(const std::string& address) {
  return ConnectToStage(kOptimizerStage, address).status();
}

TEST(EmbeddedServices, TheStoreIsItsOwnersAlone) {
  const orchestrator::TemporaryFolder folder;
  const std::string store = folder.path() + "/store";
  ASSERT_TRUE(EmbeddedServices::Start(store).ok());
  EXPECT_EQ(std::filesystem::status(store).permissions(), std::filesystem::perms::owner_all);
}

TEST(RemoteStage, AServerThatSaysNothingAboutItselfIsTaken) {
  OtherOptimizer optimizer;
  const TestServer server({&optimizer});
  EXPECT_TRUE(ConnectToOptimizer(server.address()).ok()) << ConnectToOptimizer(server.address());
}

TEST(RemoteStage, AServerThatSpeaksOursAmongOthersIsTaken) {
  OtherOptimizer optimizer;
  OtherWorker worker({"flair.v2", "flair.v1"});
  const TestServer server({&optimizer, &worker});
  EXPECT_TRUE(ConnectToOptimizer(server.address()).ok()) << ConnectToOptimizer(server.address());
}

TEST(RemoteStage, AServerOfAnotherVersionIsRefusedInASentence) {
  OtherOptimizer optimizer;
  OtherWorker worker({"flair.v2", "flair.v3"});
  const TestServer server({&optimizer, &worker});
  const absl::Status status = ConnectToOptimizer(server.address());
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_EQ(status.message(), "--optimizer " + server.address() +
                                  ": other-optimizer speaks flair.v2, flair.v3, this program flair.v1; use a version "
                                  "of it that does");
}

TEST(RemoteStage, ThePortOfAnotherStageIsRefused) {
  OtherOptimizer optimizer;
  const TestServer server({&optimizer});
  const absl::Status status = ConnectToStage(kRendererStage, server.address()).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(status.message()),
              HasSubstr("--renderer " + server.address() + ": the server there is not a flair.v1.RendererService"));
}

TEST(RemoteStage, SilenceNamesFlagAddressAndService) {
  const absl::Status status = ConnectToOptimizer("127.0.0.1:1");
  EXPECT_EQ(status.code(), absl::StatusCode::kUnavailable);
  EXPECT_THAT(std::string(status.message()),
              HasSubstr("--optimizer 127.0.0.1:1: no flair.v1.OptimizerService answers there"));
  EXPECT_EQ(ConnectToOptimizer("nowhere").code(), absl::StatusCode::kInvalidArgument);
}

TEST(RemoteStage, TheOwnTranslatorTakesTheCatalogueOfTheOptimizerThatIsUsed) {
  OtherOptimizer optimizer;
  const TestServer server({&optimizer});
  StageChoice remote;
  remote.addresses.set_optimizer(server.address());
  const auto services = EmbeddedServices::StartStages(std::nullopt, remote);
  ASSERT_TRUE(services.ok()) << services.status();
  v1::TranslateRequest request;
  request.set_request_id("r1");
  *request.mutable_room() = testing::BedroomRoom();
  *request.mutable_zone_plan() = testing::BedroomZones();
  *request.mutable_object_list()->add_objects() = testing::BedroomBed();
  *request.mutable_constraint_list()->add_sentences() = testing::BedroomSentence();
  const auto stub = v1::TranslatorService::NewStub((*services)->stages().translator.channel);
  runtime::CallContext call;
  const auto answer = runtime::UnaryRequest(*stub, &v1::TranslatorService::StubInterface::Translate, request, call);
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_EQ(answer->layout_graph().catalog_library(), "other 1");
  EXPECT_EQ(answer->layout_graph().edges_size(), 0);
}

}  // namespace
}  // namespace flair::cli
