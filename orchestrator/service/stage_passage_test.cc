// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/service/stage_passage.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>

#include "flair/v1/optimizer_service.grpc.pb.h"
#include "flair/v1/renderer_service.grpc.pb.h"
#include "orchestrator/testing/fake_stages.h"
#include "orchestrator/testing/temporary_folder.h"
#include "worker_runtime/files/files.h"

namespace flair::orchestrator {
namespace {

// A server with the passages alone, in front of stages that answer at once.
class StagePassageTest : public ::testing::Test {
 protected:
  void Serve(const std::string& tokens_path) {
    access_ = *AccessControl::Open(tokens_path, resources_.context().clock, resources_.context().logger);
    server_ = *runtime::Server::Start({.program = "test", .listen_address = ""},
                                      MakeStagePassages(stages_, *access_, resources_.context()));
  }

  grpc::StatusCode Evaluate(const std::string& token) {
    grpc::ClientContext context;
    if (!token.empty()) context.AddMetadata("authorization", "Bearer " + token);
    v1::EvaluateResponse response;
    return v1::OptimizerService::NewStub(server_->InProcessChannel())->Evaluate(&context, {}, &response).error_code();
  }

  static config::v1::RuntimeConfig Quiet() {
    config::v1::RuntimeConfig runtime;
    runtime.set_log_level("off");
    return runtime;
  }

  TemporaryFolder folder_;
  FakeStages stages_;
  runtime::WorkerResources resources_{"test", Quiet()};
  std::unique_ptr<AccessControl> access_;
  std::unique_ptr<runtime::Server> server_;
};

TEST_F(StagePassageTest, PassesCallsOnAndSaysWhatIsNotServed) {
  Serve("");
  EXPECT_EQ(Evaluate(""), grpc::StatusCode::OK);
  EXPECT_EQ(stages_.calls("Evaluate"), 1);
  grpc::ClientContext resolve, export_scene;
  v1::ResolveResponse resolved;
  EXPECT_TRUE(v1::OptimizerService::NewStub(server_->InProcessChannel())->Resolve(&resolve, {}, &resolved).ok());
  v1::ExportSceneResponse scene;
  EXPECT_EQ(
      v1::RendererService::NewStub(server_->InProcessChannel())->ExportScene(&export_scene, {}, &scene).error_code(),
      grpc::StatusCode::UNIMPLEMENTED);
}

TEST_F(StagePassageTest, LetsInOnlyWhomTheOrchestratorLetsIn) {
  const std::string path = folder_.path() + "/tokens.textproto";
  std::ofstream(path) << "tokens { name: \"ann\" sha256: \"" << runtime::Sha256Hex("a token of ann's, long enough")
                      << "\" }";
  Serve(path);
  EXPECT_EQ(Evaluate(""), grpc::StatusCode::UNAUTHENTICATED);
  EXPECT_EQ(Evaluate("another"), grpc::StatusCode::UNAUTHENTICATED);
  EXPECT_EQ(Evaluate("a token of ann's, long enough"), grpc::StatusCode::OK);
  EXPECT_EQ(stages_.calls("Evaluate"), 1);
}

}  // namespace
}  // namespace flair::orchestrator
