// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "cli/exit_code.h"
#include "cli/top/cluster_state.h"
#include "flair/v1/orchestrator_service.grpc.pb.h"
#include "worker_runtime/grpc/in_process_server.h"

namespace flair::cli {
namespace {

using ::testing::SizeIs;

// An orchestrator with two batches, one of which has ended.
class FakeOrchestrator final : public v1::OrchestratorService::Service {
 public:
  grpc::Status GetCluster(grpc::ServerContext*, const v1::GetClusterRequest*,
                          v1::GetClusterResponse* response) override {
    if (!refusal.ok() && refusal_count-- > 0) return refusal;
    response->set_queued_count(7);
    response->add_orchestrators()->set_id("a");
    return grpc::Status::OK;
  }
  grpc::Status ListBatches(grpc::ServerContext*, const v1::ListBatchesRequest*,
                           v1::ListBatchesResponse* response) override {
    for (const char* id : {"running", "ended"}) response->add_batches()->set_id(id);
    return grpc::Status::OK;
  }
  grpc::Status GetBatch(grpc::ServerContext*, const v1::GetBatchRequest* request,
                        v1::GetBatchResponse* response) override {
    ++get_count;
    response->mutable_batch()->set_id(request->batch_id());
    response->mutable_batch()->set_job_count(4);
    response->mutable_batch()->set_open_count(request->batch_id() == "running" ? 3 : 0);
    return grpc::Status::OK;
  }
  grpc::Status refusal;
  int refusal_count = 1;
  int get_count = 0;
};

struct Cluster {
  explicit Cluster(const grpc::Status& refusal = grpc::Status::OK) {
    auto started =
        runtime::InProcessServer::Start("fake", {}, v1::OrchestratorService::service_full_name(),
                                        [&](runtime::WorkerContext&) -> absl::StatusOr<std::unique_ptr<grpc::Service>> {
                                          auto made = std::make_unique<FakeOrchestrator>();
                                          made->refusal = refusal;
                                          service = made.get();
                                          return made;
                                        });
    server = *std::move(started);
  }
  FakeOrchestrator* service = nullptr;
  std::unique_ptr<runtime::InProcessServer> server;
};

TEST(ClusterClient, AsksForBatchesThatHaveNotEnded) {
  Cluster cluster;
  Session session(cluster.server->channel(), "the test");
  ClusterClient client(session);
  for (int look_number = 0; look_number < 3; ++look_number) {
    const absl::StatusOr<ClusterLook> look = client.Look();
    ASSERT_TRUE(look.ok()) << look.status();
    EXPECT_EQ(look->cluster.queued_count(), 7);
    ASSERT_THAT(look->batches, SizeIs(1));
    EXPECT_EQ(look->batches.front().id(), "running");
  }
  EXPECT_EQ(cluster.service->get_count, 4) << "the ended one is asked for once";
}

TEST(ClusterClient, SaysWhyItSeesNothing) {
  Cluster cluster({grpc::StatusCode::PERMISSION_DENIED, "only operators may"});
  Session session(cluster.server->channel(), "the test");
  const absl::StatusOr<ClusterLook> look = ClusterClient(session).Look();
  EXPECT_EQ(look.status().message(), "only operators may");
  EXPECT_EQ(ExitCodeOf(look.status()), kExitBadInput);
}

// The orchestrator answers: it is not to blame.
TEST(ClusterClient, SaysThatTheQueueIsSilent) {
  Cluster cluster({grpc::StatusCode::UNAVAILABLE, "the queue at nats://n does not answer"});
  Session session(cluster.server->channel(), "the test");
  const absl::StatusOr<ClusterLook> look = ClusterClient(session).Look();
  EXPECT_EQ(look.status().message(), "the queue at nats://n does not answer");
  EXPECT_EQ(ExitCodeOf(look.status()), kExitUnreachable);
}

// What gRPC says for a server that is sent more large messages than it has room for.
TEST(Session, AsksAgainWhereItWasTurnedAway) {
  for (const grpc::Status& refusal :
       {grpc::Status(grpc::StatusCode::UNAVAILABLE, "GOAWAY received"),
        grpc::Status(grpc::StatusCode::RESOURCE_EXHAUSTED, "Received RST_STREAM with error code 11")}) {
    Cluster cluster(refusal);
    Session session(cluster.server->channel(), "the test");
    const auto answer = session.GetCluster();
    EXPECT_TRUE(answer.ok()) << answer.status();
  }
}

// As a batch waits for a queue whose disk is full, longer than for an orchestrator that is not there.
TEST(Session, WaitsWhileAnOrchestratorSaysThatItsQueueIsSilent) {
  Cluster cluster({grpc::StatusCode::UNAVAILABLE, "the queue at nats://n does not answer"});
  cluster.service->refusal_count = 0;
  Session session(cluster.server->channel(), "the test");
  session.SetLimits({.patience = absl::ZeroDuration(), .outage = absl::Hours(1)});
  ASSERT_TRUE(session.GetCluster().ok());
  cluster.service->refusal_count = 1;
  EXPECT_TRUE(session.GetCluster().ok());
  session.SetLimits({.patience = absl::ZeroDuration()});
  cluster.service->refusal_count = 1;
  EXPECT_TRUE(absl::IsUnavailable(session.GetCluster().status()));
}

}  // namespace
}  // namespace flair::cli
