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

// The handbook's artifacts.
absl::StatusOr<v1::Room> Make(const v1::DescribeRoomRequest& request, const Handbook& handbook) {
  return DescribeRoom(request.brief(), handbook);
}
absl::StatusOr<v1::ZonePlan> Make(const v1::PlanZonesRequest& request, const Handbook& handbook) {
  return PlanWantedZones(request.brief(), request.room(), handbook);
}
absl::StatusOr<v1::ObjectList> Make(const v1::ListObjectsRequest& request, const Handbook& handbook) {
  return ListObjects(request.brief(), request.room(), request.zone_plan(), handbook);
}
absl::StatusOr<v1::StyleSheet> Make(const v1::ChooseStyleRequest& request, const Handbook& handbook) {
  return ChooseStyle(request.brief(), request.room(), request.object_list(), handbook);
}
absl::StatusOr<v1::ConstraintList> Make(const v1::ListConstraintsRequest& request, const Handbook& handbook) {
  return UsualConstraints({request.brief(), request.room(), request.zone_plan()}, request.object_list(), handbook);
}
absl::StatusOr<v1::ConstraintList> Make(const v1::CleanConstraintsRequest& request, const Handbook&) {
  return CleanConstraints(request.constraint_list());
}
absl::StatusOr<v1::ConstraintList> Make(const v1::CompleteConstraintsRequest& request, const Handbook& handbook) {
  return CompleteConstraints({request.brief(), request.room(), request.zone_plan()}, request.object_list(),
                             request.constraint_list(), handbook);
}

// Takes what the brief brings, as it is; false where it brings nothing.
absl::StatusOr<bool> TakeOwn(const google::protobuf::Message&, const Handbook&, google::protobuf::Message&) {
  return false;
}
absl::StatusOr<bool> TakeOwn(const v1::DescribeRoomRequest& request, const Handbook&, v1::Room& room) {
  room = request.brief().room();
  return request.brief().has_room();
}
absl::StatusOr<bool> TakeOwn(const v1::PlanZonesRequest& request, const Handbook&, v1::ZonePlan& plan) {
  plan = request.brief().zone_plan();
  return request.brief().has_zone_plan();
}
absl::StatusOr<bool> TakeOwn(const v1::ListObjectsRequest& request, const Handbook&, v1::ObjectList& list) {
  if (!request.brief().has_object_list()) return false;
  list = request.brief().object_list();
  RETURN_IF_ERROR(Validate(list, request.zone_plan(), "brief.object_list"));
  return true;
}
absl::StatusOr<bool> TakeOwn(const v1::ListConstraintsRequest& request, const Handbook& handbook,
                             v1::ConstraintList& list) {
  const v1::Brief& brief = request.brief();
  if (!brief.has_constraint_list()) return false;
  RETURN_IF_ERROR(Validate(brief.constraint_list(), request.object_list(), "brief.constraint_list"));
  ASSIGN_OR_RETURN(list, OwnConstraints({brief, request.room(), request.zone_plan()}, request.object_list(), handbook));
  return true;
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

#define FLAIR_ANSWER(Rpc)                                                                                            \
  absl::StatusOr<v1::Rpc##Response> LanguageHandlers::Handle(const v1::Rpc##Request& request,                        \
                                                             runtime::CallContext& call) const {                     \
    RETURN_IF_ERROR(Validate(request));                                                                              \
    auto response = AnsweredBy<v1::Rpc##Response>("brief");                                                          \
    ASSIGN_OR_RETURN(const bool own, TakeOwn(request, handbook_, PartOf(response)));                                 \
    if (own) return response;                                                                                        \
    return Answer(request, call);                                                                                    \
  }                                                                                                                  \
  absl::StatusOr<v1::Rpc##Response> LanguageHandlers::Answer(const v1::Rpc##Request& request, runtime::CallContext&) \
      const {                                                                                                        \
    auto response = AnsweredBy<v1::Rpc##Response>("handbook", handbook_.version());                                  \
    ASSIGN_OR_RETURN(PartOf(response), Make(request, handbook_));                                                    \
    return response;                                                                                                 \
  }
FLAIR_ANSWER(DescribeRoom)
FLAIR_ANSWER(PlanZones)
FLAIR_ANSWER(ListObjects)
FLAIR_ANSWER(ChooseStyle)
FLAIR_ANSWER(ListConstraints)
FLAIR_ANSWER(CleanConstraints)
FLAIR_ANSWER(CompleteConstraints)
#undef FLAIR_ANSWER

}  // namespace flair::language
