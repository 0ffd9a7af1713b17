// SPDX-License-Identifier: GPL-3.0-or-later
#include "flair/v1/optimizer_service.grpc.pb.h"
#include "optimizer_worker/fanout/fan_out.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::optimizer {
namespace {

// Restarts take milliseconds; a peer that needs longer than this is as good as dead.
constexpr absl::Duration kPatience = absl::Minutes(1);

class GrpcPeer final : public PeerOptimizer {
 public:
  GrpcPeer(std::string address, std::string producer, const std::shared_ptr<grpc::Channel>& channel,
           const runtime::Clock& clock)
      : address_(std::move(address)),
        producer_(std::move(producer)),
        stub_(v1::OptimizerService::NewStub(channel)),
        clock_(clock) {}

  const std::string& name() const override { return address_; }

  absl::StatusOr<v1::SolveRestartsResponse> SolveRestarts(const v1::SolveRestartsRequest& request,
                                                          runtime::Cancellation& cancellation) override {
    grpc::ClientContext context;
    context.set_deadline(absl::ToChronoTime(clock_.Now() + kPatience));
    v1::SolveRestartsResponse response;
    grpc::Status status;
    {
      const runtime::OnCancel guard(cancellation, [&context] { context.TryCancel(); });
      status = stub_->SolveRestarts(&context, request, &response);
    }
    if (!status.ok()) return runtime::FromGrpcStatus(status);
    const auto& metadata = context.GetServerInitialMetadata();
    const auto producer = metadata.find(kProducerMetadata);
    const std::string theirs = producer == metadata.end()
                                   ? "no Flair optimizer"
                                   : std::string(producer->second.data(), producer->second.size());
    if (theirs != producer_) {
      return FailedPrecondition("it is {}; this optimizer is {}. Run the same build on both", theirs, producer_);
    }
    return response;
  }

 private:
  const std::string address_;
  const std::string producer_;
  const std::unique_ptr<v1::OptimizerService::Stub> stub_;
  const runtime::Clock& clock_;
};

}  // namespace

absl::StatusOr<std::unique_ptr<PeerOptimizer>> MakeGrpcPeer(const std::string& address, const std::string& producer,
                                                            const runtime::Clock& clock,
                                                            const runtime::ChannelOptions& options) {
  ASSIGN_OR_RETURN(const std::shared_ptr<grpc::Channel> channel,
                   runtime::MakeChannel(address, v1::OptimizerService::service_full_name(), options));
  return std::make_unique<GrpcPeer>(address, producer, channel, clock);
}

}  // namespace flair::optimizer
