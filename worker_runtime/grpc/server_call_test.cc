// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/grpc/server_call.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>

#include "flair/v1/renderer_service.grpc.pb.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/grpc/in_process_server.h"
#include "worker_runtime/logging/log.h"
#include "worker_runtime/testing/fakes.h"

namespace flair::runtime {
namespace {

using Request = v1::ComposeContactSheetRequest;
using Response = v1::ComposeContactSheetResponse;

// What the test tells a call to do with each caption, and how many calls live.
struct Script {
  std::function<absl::Status(const std::string& caption, CallContext&)> take = [](const auto&, auto&) {
    return absl::OkStatus();
  };
  std::atomic<int> taken = 0;
  TestGate gone;
  std::string caller;
};

class Taker {
 public:
  explicit Taker(Script& script) : script_(script) {}
  ~Taker() { script_.gone.Open(); }
  absl::Status Take(const Request& request, CallContext& call) {
    ++script_.taken;
    captions_ += request.tile().caption();
    return script_.take(request.tile().caption(), call);
  }
  absl::StatusOr<Response> Finish(CallContext&) {
    Response response;
    response.mutable_sheet()->set_image(captions_);
    response.mutable_producer()->set_program("test");
    return response;
  }

 private:
  Script& script_;
  std::string captions_;
};

struct SheetService final : Service {
  SheetService(WorkerContext& worker, Script& script)
      : Service(worker, v1::RendererService::service_full_name()), script_(script) {
    ClientStream<Request>("ComposeContactSheet", [&script] { return std::make_unique<Taker>(script); });
  }
  absl::Status Admit(grpc::CallbackServerContext&, CallContext& call) override {
    call.set_caller({script_.caller, {}});
    return absl::OkStatus();
  }
  Script& script_;
};

class ClientStream : public testing::Test {
 protected:
  ClientStream() {
    config::v1::RuntimeConfig config;
    config.set_worker_thread_count(1);
    config.set_queue_limit(1);
    config.set_log_level("critical");
    server_ = *InProcessServer::Start("test", config, v1::RendererService::service_full_name(),
                                      [&](WorkerContext& context) -> absl::StatusOr<std::unique_ptr<grpc::Service>> {
                                        context.build = "build 7";
                                        worker_ = &context;
                                        executor_ = &context.executor;
                                        return std::make_unique<SheetService>(context, script_);
                                      });
    stub_ = v1::RendererService::NewStub(server_->channel());
  }

  // Sends the captions, one message each.
  absl::Status Send(const std::vector<std::string>& captions) { return SendIn(context_, captions); }
  absl::Status SendIn(grpc::ClientContext& context, const std::vector<std::string>& captions) {
    const auto writer = stub_->ComposeContactSheet(&context, &response_);
    for (const std::string& caption : captions) {
      Request request;
      request.mutable_tile()->set_caption(caption);
      if (!writer->Write(request)) break;
    }
    writer->WritesDone();
    return FromGrpcStatus(writer->Finish());
  }

  Script script_;
  WorkerContext* worker_ = nullptr;
  BoundedExecutor* executor_ = nullptr;
  std::unique_ptr<InProcessServer> server_;
  std::unique_ptr<v1::RendererService::Stub> stub_;
  grpc::ClientContext context_;
  Response response_;
};

TEST_F(ClientStream, TakesEveryMessageInOrderAndAnswersOnce) {
  ASSERT_EQ(Send({"a", "b", "c", "d"}), absl::OkStatus());
  EXPECT_EQ(response_.sheet().image(), "abcd");
  EXPECT_EQ(response_.producer().build(), "build 7");
}

TEST_F(ClientStream, TheLogNamesTheCaller) {
  script_.caller = "alice";
  worker_->logger = MakeLogger("test", "info");
  testing::internal::CaptureStderr();
  EXPECT_EQ(Send({"a"}), absl::OkStatus());
  EXPECT_THAT(testing::internal::GetCapturedStderr(), testing::HasSubstr(" caller=alice "));
}

TEST_F(ClientStream, AnswersAStreamOfNothing) {
  ASSERT_EQ(Send({}), absl::OkStatus());
  EXPECT_EQ(response_.sheet().image(), "");
}

TEST_F(ClientStream, EndsAtTheFirstError) {
  script_.take = [](const std::string& caption, CallContext&) {
    return caption == "b" ? absl::InvalidArgumentError("tile: is bad") : absl::OkStatus();
  };
  EXPECT_EQ(Send({"a", "b", "c", "d"}), absl::InvalidArgumentError("tile: is bad"));
  EXPECT_EQ(script_.taken, 2);
}

TEST_F(ClientStream, TellsARunningStepThatTheCallerHasGoneAndForgetsTheCall) {
  TestGate running;
  script_.take = [&](const std::string&, CallContext& call) {
    TestGate cancelled;
    OnCancel guard(call.cancellation(), [&] { cancelled.Open(); });
    running.Open();
    cancelled.Wait();
    return call.CheckAlive();
  };
  const auto writer = stub_->ComposeContactSheet(&context_, &response_);
  ASSERT_TRUE(writer->Write(Request()));
  running.Wait();
  context_.TryCancel();
  EXPECT_EQ(writer->Finish().error_code(), grpc::StatusCode::CANCELLED);
  script_.gone.Wait();
}

TEST_F(ClientStream, ACallerWhoGoesBetweenMessagesIsForgotten) {
  TestGate taken;
  script_.take = [&](const std::string&, CallContext&) {
    taken.Open();
    return absl::OkStatus();
  };
  const auto writer = stub_->ComposeContactSheet(&context_, &response_);
  ASSERT_TRUE(writer->Write(Request()));
  taken.Wait();
  context_.TryCancel();
  EXPECT_EQ(writer->Finish().error_code(), grpc::StatusCode::CANCELLED);
  script_.gone.Wait();
}

TEST_F(ClientStream, AFullQueueTurnsTheMessageAway) {
  TestGate running, release;
  ASSERT_TRUE(executor_->TrySubmit([&] {
    running.Open();
    release.Wait();
  }));
  running.Wait();
  ASSERT_TRUE(executor_->TrySubmit([] {}));  // the one place in the queue
  EXPECT_EQ(Send({"a", "b"}).code(), absl::StatusCode::kResourceExhausted);
  EXPECT_EQ(script_.taken, 0);
  release.Open();
  // Its thread lets go of the gates before they go.
  server_.reset();
}

TEST_F(ClientStream, LargeMessagesBesideOthersAreTurnedAway) {
  EXPECT_EQ(Send({std::string(31 << 20, 'x')}), absl::OkStatus()) << "alone";
  EXPECT_EQ(*worker_->unfolded_bytes, 0);
  *worker_->unfolded_bytes = 150 << 20;
  grpc::ClientContext second;
  const absl::Status status = SendIn(second, {"a", std::string(4 << 20, 'x')});
  EXPECT_TRUE(TurnedAway(status)) << status;
  EXPECT_EQ(script_.taken, 2) << "small ones are not counted";
}

}  // namespace
}  // namespace flair::runtime
