// SPDX-License-Identifier: GPL-3.0-or-later
// A solve that nobody waits for any more ends on the way, and the server goes on serving.
#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "fmt/format.h"
#include "tests/contract/contract.h"

namespace flair::testing {
namespace {

using Service = v1::OptimizerService::StubInterface;

class GoneCaller : public ::testing::Test {
 protected:
  GoneCaller() : stub_(v1::OptimizerService::NewStub(*runtime::MakeChannel(server_.address(), ""))) {}

  // A minute and more on one core, nearly all of it within single restarts.
  static v1::SolveRequest LongRequest(int object_count = 240) {
    v1::SolveRequest request;
    *request.mutable_layout_graph() = BedroomGraph();
    v1::ObjectList& list = *request.mutable_layout_graph()->mutable_object_list();
    for (int i = 0; list.objects_size() < object_count; ++i) {
      v1::Object& object = *list.add_objects();
      object = list.objects(0);
      object.set_id(fmt::format("piece_{}", i));
    }
    request.mutable_options()->set_thread_count(1);
    request.mutable_options()->set_max_restart_count(1);
    return request;
  }

  // The server has one thread: it answers only when it has let go of what came before.
  void ExpectServing() {
    v1::SolveRequest request;
    *request.mutable_layout_graph() = BedroomGraph();
    const auto answer = Ask(*stub_, &Service::Solve, request);
    EXPECT_TRUE(answer.ok()) << answer.status();
  }

  TestFolder folder_;
  ServerProgram server_{"flair-optimizer",
                        "runtime { listen_address: \"127.0.0.1:0\" log_level: \"error\" worker_thread_count: 1 }",
                        folder_.path()};
  std::unique_ptr<v1::OptimizerService::Stub> stub_;
};

TEST_F(GoneCaller, ADeadlineInTheMiddleOfASolve) {
  runtime::CallContext call;
  const auto answer =
      runtime::UnaryRequest(*stub_, &Service::Solve, LongRequest(), call, absl::Now() + absl::Seconds(1));
  EXPECT_EQ(answer.status().code(), absl::StatusCode::kDeadlineExceeded) << answer.status();
  ExpectServing();
}

TEST_F(GoneCaller, ACancelInTheMiddleOfASolve) {
  runtime::CallContext call;
  absl::Status status;
  std::thread caller([&] { status = runtime::UnaryRequest(*stub_, &Service::Solve, LongRequest(), call).status(); });
  // Whether the call has arrived yet makes no difference to what must happen.
  call.cancellation().Cancel();
  caller.join();
  EXPECT_EQ(status.code(), absl::StatusCode::kCancelled) << status;
  ExpectServing();
}

TEST_F(GoneCaller, ATimeLimitGivesTheBestLayoutSoFar) {
  v1::SolveRequest request = LongRequest(60);
  request.mutable_options()->mutable_time_limit()->set_nanos(1000000);
  const auto answer = Ask(*stub_, &Service::Solve, request);
  ASSERT_TRUE(answer.ok()) << answer.status();
  EXPECT_EQ(answer->solved_layout().placements_size(), request.layout_graph().object_list().objects_size());
  const auto& diagnostics = answer->solved_layout().diagnostics();
  EXPECT_TRUE(std::any_of(diagnostics.begin(), diagnostics.end(),
                          [](const v1::Diagnostic& diagnostic) { return diagnostic.code() == "time_limit"; }));
}

}  // namespace
}  // namespace flair::testing
