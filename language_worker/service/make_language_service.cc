// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/service/make_language_service.h"

#include <filesystem>
#include <utility>

#include "flair/v1/language_service.grpc.pb.h"
#include "flair/v1/worker_service.pb.h"
#include "language_worker/handbook/cleaning/clean_constraints.h"
#include "language_worker/handbook/completion/complete_constraints.h"
#include "language_worker/handbook/loading/load_handbook.h"
#include "language_worker/handbook/objects/list_objects.h"
#include "language_worker/handbook/parts/brief_parts.h"
#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/handbook/styling/choose_style.h"
#include "room/validation/validate.h"
#include "worker_runtime/grpc/server_call.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {
namespace {

class Service final : public runtime::Service {
 public:
  Service(runtime::WorkerContext& worker, std::unique_ptr<const Handbook> handbook,
          std::unique_ptr<const LanguageHandlers> handlers)
      : runtime::Service(worker, v1::LanguageService::service_full_name()),
        handbook_(std::move(handbook)),
        handlers_(std::move(handlers)) {
    Unary<v1::DescribeRoomRequest>("DescribeRoom", *handlers_);
    Unary<v1::PlanZonesRequest>("PlanZones", *handlers_);
    Unary<v1::ListObjectsRequest>("ListObjects", *handlers_);
    Unary<v1::ChooseStyleRequest>("ChooseStyle", *handlers_);
    Unary<v1::ListConstraintsRequest>("ListConstraints", *handlers_);
    Unary<v1::CleanConstraintsRequest>("CleanConstraints", *handlers_);
    Unary<v1::CompleteConstraintsRequest>("CompleteConstraints", *handlers_);
  }

 private:
  const std::unique_ptr<const Handbook> handbook_;
  const std::unique_ptr<const LanguageHandlers> handlers_;
};

absl::StatusOr<std::unique_ptr<const Handbook>> ReadHandbook(const config::v1::LanguageWorkerConfig& config) {
  const std::string& path = config.handbook_path();
  return LoadHandbook(path.empty() ? DefaultHandbookFolder() : std::filesystem::path(path),
                      {config.handbook_overlay_paths().begin(), config.handbook_overlay_paths().end()});
}

// What the brief brings, as it is.
template <typename Response, typename Part, typename Artifact>
Response FromBrief(Part part, const Artifact& artifact) {
  Response response = AnsweredBy<Response>("brief");
  *(response.*part)() = artifact;
  return response;
}

}  // namespace

absl::StatusOr<std::unique_ptr<grpc::Service>> MakeLanguageService(const config::v1::LanguageWorkerConfig& config,
                                                                   runtime::WorkerContext& worker,
                                                                   const ModelHandlersMaker& with_model) {
  ASSIGN_OR_RETURN(std::unique_ptr<const Handbook> handbook, ReadHandbook(config));
  worker.revision = handbook->version();
  std::unique_ptr<const LanguageHandlers> handlers;
  if (!config.has_llm()) {
    worker.capabilities = {v1::CAPABILITY_DETERMINISTIC};
    handlers = std::make_unique<LanguageHandlers>(*handbook);
  } else if (with_model == nullptr) {
    return absl::InvalidArgumentError("llm: this program asks no language model; flair and flair-language do");
  } else {
    ASSIGN_OR_RETURN(handlers, with_model(config, *handbook, worker));
  }
  return std::make_unique<Service>(worker, std::move(handbook), std::move(handlers));
}

absl::StatusOr<v1::DescribeRoomResponse> LanguageHandlers::Handle(const v1::DescribeRoomRequest& request,
                                                                  runtime::CallContext& call) const {
  RETURN_IF_ERROR(Validate(request));
  const v1::Brief& brief = request.brief();
  if (brief.has_room()) {
    return FromBrief<v1::DescribeRoomResponse>(&v1::DescribeRoomResponse::mutable_room, brief.room());
  }
  return Answer(request, call);
}

absl::StatusOr<v1::PlanZonesResponse> LanguageHandlers::Handle(const v1::PlanZonesRequest& request,
                                                               runtime::CallContext& call) const {
  RETURN_IF_ERROR(Validate(request));
  const v1::Brief& brief = request.brief();
  if (brief.has_zone_plan()) {
    return FromBrief<v1::PlanZonesResponse>(&v1::PlanZonesResponse::mutable_zone_plan, brief.zone_plan());
  }
  return Answer(request, call);
}

absl::StatusOr<v1::ListObjectsResponse> LanguageHandlers::Handle(const v1::ListObjectsRequest& request,
                                                                 runtime::CallContext& call) const {
  RETURN_IF_ERROR(Validate(request));
  const v1::Brief& brief = request.brief();
  if (!brief.has_object_list()) return Answer(request, call);
  RETURN_IF_ERROR(Validate(brief.object_list(), request.zone_plan(), "brief.object_list"));
  return FromBrief<v1::ListObjectsResponse>(&v1::ListObjectsResponse::mutable_object_list, brief.object_list());
}

absl::StatusOr<v1::ChooseStyleResponse> LanguageHandlers::Handle(const v1::ChooseStyleRequest& request,
                                                                 runtime::CallContext& call) const {
  RETURN_IF_ERROR(Validate(request));
  return Answer(request, call);
}

absl::StatusOr<v1::ListConstraintsResponse> LanguageHandlers::Handle(const v1::ListConstraintsRequest& request,
                                                                     runtime::CallContext& call) const {
  RETURN_IF_ERROR(Validate(request));
  const v1::Brief& brief = request.brief();
  if (!brief.has_constraint_list()) return Answer(request, call);
  RETURN_IF_ERROR(Validate(brief.constraint_list(), request.object_list(), "brief.constraint_list"));
  ASSIGN_OR_RETURN(const v1::ConstraintList own,
                   OwnConstraints({brief, request.room(), request.zone_plan()}, request.object_list(), handbook_));
  return FromBrief<v1::ListConstraintsResponse>(&v1::ListConstraintsResponse::mutable_constraint_list, own);
}

absl::StatusOr<v1::CleanConstraintsResponse> LanguageHandlers::Handle(const v1::CleanConstraintsRequest& request,
                                                                      runtime::CallContext& call) const {
  RETURN_IF_ERROR(Validate(request));
  return Answer(request, call);
}

absl::StatusOr<v1::CompleteConstraintsResponse> LanguageHandlers::Handle(const v1::CompleteConstraintsRequest& request,
                                                                         runtime::CallContext& call) const {
  RETURN_IF_ERROR(Validate(request));
  auto response = AnsweredBy<v1::CompleteConstraintsResponse>("handbook", handbook_.version());
  *response.mutable_constraint_list() =
      CompleteConstraints({request.brief(), request.room(), request.zone_plan()}, request.object_list(),
                          request.constraint_list(), handbook_);
  return response;
}

absl::StatusOr<v1::DescribeRoomResponse> LanguageHandlers::Answer(const v1::DescribeRoomRequest& request,
                                                                  runtime::CallContext& call) const {
  auto response = AnsweredBy<v1::DescribeRoomResponse>("handbook", handbook_.version());
  ASSIGN_OR_RETURN(*response.mutable_room(), DescribeRoom(request.brief(), handbook_));
  return response;
}

absl::StatusOr<v1::PlanZonesResponse> LanguageHandlers::Answer(const v1::PlanZonesRequest& request,
                                                               runtime::CallContext& call) const {
  auto response = AnsweredBy<v1::PlanZonesResponse>("handbook", handbook_.version());
  ASSIGN_OR_RETURN(*response.mutable_zone_plan(), PlanWantedZones(request.brief(), request.room(), handbook_));
  return response;
}

absl::StatusOr<v1::ListObjectsResponse> LanguageHandlers::Answer(const v1::ListObjectsRequest& request,
                                                                 runtime::CallContext& call) const {
  auto response = AnsweredBy<v1::ListObjectsResponse>("handbook", handbook_.version());
  ASSIGN_OR_RETURN(*response.mutable_object_list(),
                   ListObjects(request.brief(), request.room(), request.zone_plan(), handbook_));
  return response;
}

absl::StatusOr<v1::ChooseStyleResponse> LanguageHandlers::Answer(const v1::ChooseStyleRequest& request,
                                                                 runtime::CallContext& call) const {
  auto response = AnsweredBy<v1::ChooseStyleResponse>("handbook", handbook_.version());
  ASSIGN_OR_RETURN(*response.mutable_style_sheet(),
                   ChooseStyle(request.brief(), request.room(), request.object_list(), handbook_));
  return response;
}

absl::StatusOr<v1::ListConstraintsResponse> LanguageHandlers::Answer(const v1::ListConstraintsRequest& request,
                                                                     runtime::CallContext& call) const {
  auto response = AnsweredBy<v1::ListConstraintsResponse>("handbook", handbook_.version());
  ASSIGN_OR_RETURN(
      *response.mutable_constraint_list(),
      UsualConstraints({request.brief(), request.room(), request.zone_plan()}, request.object_list(), handbook_));
  return response;
}

absl::StatusOr<v1::CleanConstraintsResponse> LanguageHandlers::Answer(const v1::CleanConstraintsRequest& request,
                                                                      runtime::CallContext& call) const {
  auto response = AnsweredBy<v1::CleanConstraintsResponse>("handbook", handbook_.version());
  *response.mutable_constraint_list() = CleanConstraints(request.constraint_list());
  return response;
}

}  // namespace flair::language
