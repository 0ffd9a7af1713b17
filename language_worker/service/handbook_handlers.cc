// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/service/handbook_handlers.h"

#include "language_worker/handbook/cleaning/clean_constraints.h"
#include "language_worker/handbook/objects/list_objects.h"
#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/handbook/styling/choose_style.h"
#include "language_worker/model/placements.h"
#include "language_worker/model/zones_step.h"
#include "language_worker/service/own_parts.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {

v1::Producer HandbookHandlers::Producer() const {
  v1::Producer producer;
  producer.set_program("flair-language");
  producer.set_method("handbook");
  producer.set_version(handbook_.version());
  return producer;
}

absl::StatusOr<v1::DescribeRoomResponse> HandbookHandlers::Handle(const v1::DescribeRoomRequest& request,
                                                                  runtime::CallContext&) const {
  RETURN_IF_ERROR(Validate(request));
  ASSIGN_OR_RETURN(auto own, OwnAnswer(request));
  if (own) return *std::move(own);
  ASSIGN_OR_RETURN(v1::Room room, DescribeRoom(request.brief(), handbook_));
  v1::DescribeRoomResponse response;
  *response.mutable_room() = std::move(room);
  *response.mutable_producer() = Producer();
  return response;
}

absl::StatusOr<v1::PlanZonesResponse> HandbookHandlers::Handle(const v1::PlanZonesRequest& request,
                                                               runtime::CallContext&) const {
  RETURN_IF_ERROR(Validate(request));
  ASSIGN_OR_RETURN(auto own, OwnAnswer(request));
  if (own) return *std::move(own);
  ASSIGN_OR_RETURN(v1::ZonePlan plan, PlanWantedZones(request.brief(), request.room(), handbook_));
  v1::PlanZonesResponse response;
  *response.mutable_zone_plan() = std::move(plan);
  *response.mutable_producer() = Producer();
  return response;
}

absl::StatusOr<v1::ListObjectsResponse> HandbookHandlers::Handle(const v1::ListObjectsRequest& request,
                                                                 runtime::CallContext&) const {
  RETURN_IF_ERROR(Validate(request));
  ASSIGN_OR_RETURN(auto own, OwnAnswer(request));
  if (own) return *std::move(own);
  ASSIGN_OR_RETURN(v1::ObjectList list, ListObjects(request.brief(), request.room(), request.zone_plan(), handbook_));
  v1::ListObjectsResponse response;
  *response.mutable_object_list() = std::move(list);
  *response.mutable_producer() = Producer();
  return response;
}

absl::StatusOr<v1::ChooseStyleResponse> HandbookHandlers::Handle(const v1::ChooseStyleRequest& request,
                                                                 runtime::CallContext&) const {
  RETURN_IF_ERROR(Validate(request));
  ASSIGN_OR_RETURN(v1::StyleSheet sheet,
                   ChooseStyle(request.brief(), request.room(), request.object_list(), handbook_));
  v1::ChooseStyleResponse response;
  *response.mutable_style_sheet() = std::move(sheet);
  *response.mutable_producer() = Producer();
  return response;
}

absl::StatusOr<v1::ListConstraintsResponse> HandbookHandlers::Handle(const v1::ListConstraintsRequest& request,
                                                                     runtime::CallContext&) const {
  RETURN_IF_ERROR(Validate(request));
  ASSIGN_OR_RETURN(auto own, OwnAnswer(request, handbook_));
  if (own) return *std::move(own);
  absl::StatusOr<v1::ConstraintList> list =
      UsualConstraints({request.brief(), request.room(), request.zone_plan()}, request.object_list(), handbook_);
  if (!list.ok()) return list.status();
  v1::ListConstraintsResponse response;
  *response.mutable_constraint_list() = *std::move(list);
  *response.mutable_producer() = Producer();
  return response;
}

absl::StatusOr<v1::CleanConstraintsResponse> HandbookHandlers::Handle(const v1::CleanConstraintsRequest& request,
                                                                      runtime::CallContext&) const {
  RETURN_IF_ERROR(Validate(request));
  v1::CleanConstraintsResponse response;
  *response.mutable_constraint_list() = CleanConstraints(request.constraint_list());
  *response.mutable_producer() = Producer();
  return response;
}

}  // namespace flair::language
