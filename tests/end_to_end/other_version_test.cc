// SPDX-License-Identifier: GPL-3.0-or-later
// Real programs that meet a server of another version of the protocol.
#include <gmock/gmock.h>
#include <grpcpp/security/server_credentials.h>
#include <grpcpp/server_builder.h>
#include <gtest/gtest.h>

#include "flair/v1/worker_service.grpc.pb.h"
#include "tests/fixtures/programs.h"

namespace flair::testing {
namespace {

using ::testing::HasSubstr;

class VersionTwo final : public v1::WorkerService::Service {
 public:
  VersionTwo() {
    grpc::ServerBuilder builder;
    builder.AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port_);
    builder.RegisterService(this);
    server_ = builder.BuildAndStart();
  }
  std::string address() const { return "127.0.0.1:" + std::to_string(port_); }
  grpc::Status GetWorker(grpc::ServerContext*, const v1::GetWorkerRequest*, v1::GetWorkerResponse* response) override {
    response->set_program("their-optimizer");
    response->add_protocols("flair.v2");
    return grpc::Status::OK;
  }

 private:
  int port_ = 0;
  std::unique_ptr<grpc::Server> server_;
};

TEST(OtherVersion, DoctorTellsIt) {
  const VersionTwo server;
  const TestFolder folder;
  const Finished run = RunProgram("flair", {"doctor", server.address()}, {{"FLAIR_HOME", folder / "home"}});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.out, HasSubstr("their-optimizer speaks flair.v2, this program flair.v1"));
  EXPECT_THAT(run.out, HasSubstr("Start a version of it there that speaks flair.v1."));
}

TEST(OtherVersion, ADesignEndsWithASentence) {
  const VersionTwo server;
  const TestFolder folder;
  std::string stages;
  for (const char* stage : {"language", "translator", "optimizer", "renderer"}) {
    stages += std::string(stage) + ": \"" + server.address() + "\" ";
  }
  const ServerProgram orchestrator("flair-orchestrator",
                                   "runtime { listen_address: \"127.0.0.1:0\" log_level: \"error\" }\nstore_path: \"" +
                                       (folder / "store").string() + "\"\nstages { " + stages + "}\n",
                                   folder.path());
  ASSERT_NE(orchestrator.address(), "");
  const Finished run = RunProgram(
      "flair", {"design", "A bedroom.", "--out", folder / "out", "--quiet", "--orchestrator", orchestrator.address()});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(run.err, "flair: language worker at " + server.address() +
                         ": their-optimizer speaks flair.v2, this program flair.v1; start a version of it that does or "
                         "fix stages.language\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

}  // namespace
}  // namespace flair::testing
