// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/embedded/remote_stage.h"

#include "absl/time/clock.h"
#include "cli/input/service_flags.h"
#include "flair/v1/language_service.grpc.pb.h"
#include "flair/v1/optimizer_service.grpc.pb.h"
#include "flair/v1/renderer_service.grpc.pb.h"
#include "flair/v1/translator_service.grpc.pb.h"
#include "flair/v1/worker_service.grpc.pb.h"
#include "fmt/format.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

constexpr absl::Duration kStageAnswersWithin = absl::Seconds(20);

template <typename Service, auto kMethod, typename Request>
absl::Status AskNothing(const std::shared_ptr<grpc::Channel>& channel) {
  const std::unique_ptr<typename Service::Stub> stub = Service::NewStub(channel);
  runtime::CallContext call;
  return runtime::UnaryRequest(*stub, kMethod, Request(), call, absl::Now() + kStageAnswersWithin).status();
}

// As UNAVAILABLE, when nobody answered or not in time; OK otherwise, also for errors.
absl::Status Silence(const absl::Status& status) {
  if (!absl::IsUnavailable(status) && !absl::IsDeadlineExceeded(status)) return absl::OkStatus();
  return absl::UnavailableError(status.message());
}

absl::Status CheckProtocols(const StageName& stage, const std::string& address,
                            const std::shared_ptr<grpc::Channel>& channel) {
  const std::unique_ptr<v1::WorkerService::Stub> stub = v1::WorkerService::NewStub(channel);
  runtime::CallContext call;
  const absl::StatusOr<v1::GetWorkerResponse> worker =
      runtime::UnaryRequest(*stub, &v1::WorkerService::StubInterface::GetWorker, v1::GetWorkerRequest(), call,
                            absl::Now() + kStageAnswersWithin);
  if (absl::Status silence = Silence(worker.status()); !silence.ok()) return InWords(stage, address, silence);
  const std::string fault = worker.ok() ? runtime::ProtocolFault(*worker) : "";
  if (fault.empty()) return absl::OkStatus();
  return absl::InvalidArgumentError(
      fmt::format("{} {}: {}; use a version of it that does", stage.flag, address, fault));
}

}  // namespace

const StageName kLanguageStage = {
    "--language", v1::LanguageService::service_full_name(),
    &AskNothing<v1::LanguageService, &v1::LanguageService::StubInterface::DescribeRoom, v1::DescribeRoomRequest>};
const StageName kTranslatorStage = {
    "--translator", v1::TranslatorService::service_full_name(),
    &AskNothing<v1::TranslatorService, &v1::TranslatorService::StubInterface::Translate, v1::TranslateRequest>};
const StageName kOptimizerStage = {
    "--optimizer", v1::OptimizerService::service_full_name(),
    &AskNothing<v1::OptimizerService, &v1::OptimizerService::StubInterface::Solve, v1::SolveRequest>};
const StageName kRendererStage = {
    "--renderer", v1::RendererService::service_full_name(),
    &AskNothing<v1::RendererService, &v1::RendererService::StubInterface::Render, v1::RenderRequest>};

absl::Status InWords(const StageName& stage, const std::string& address, const absl::Status& status) {
  if (!absl::IsUnavailable(status)) return status;
  return absl::UnavailableError(
      fmt::format("{} {}: no {} answers there: {}; is the program running, and is this its port?", stage.flag, address,
                  stage.service, std::string(status.message())));
}

absl::StatusOr<std::shared_ptr<grpc::Channel>> ConnectToStage(const StageName& stage, const std::string& address,
                                                              int max_message_mib) {
  ASSIGN_OR_RETURN(runtime::ChannelOptions options, StageConnection());
  options.max_message_mib = max_message_mib;
  absl::StatusOr<std::shared_ptr<grpc::Channel>> channel = runtime::MakeChannel(address, stage.service, options);
  if (!channel.ok()) {
    return absl::InvalidArgumentError(fmt::format("{}: {}", stage.flag, std::string(channel.status().message())));
  }
  RETURN_IF_ERROR(CheckProtocols(stage, address, *channel));
  const absl::Status answer = stage.ask_nothing(*channel);
  if (absl::IsUnimplemented(answer)) {
    return absl::InvalidArgumentError(fmt::format(
        "{} {}: the server there is no {}; is this the port of another stage?", stage.flag, address, stage.service));
  }
  if (absl::Status silence = Silence(answer); !silence.ok()) return InWords(stage, address, silence);
  return channel;
}

}  // namespace flair::cli
