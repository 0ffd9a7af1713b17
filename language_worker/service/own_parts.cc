// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/service/own_parts.h"

#include <utility>

#include "language_worker/model/placements.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {
namespace {

template <typename Response>
Response FromBrief() {
  Response response;
  response.mutable_producer()->set_program("flair-language");
  response.mutable_producer()->set_method("brief");
  return response;
}

}  // namespace

absl::StatusOr<std::optional<v1::DescribeRoomResponse>> OwnAnswer(const v1::DescribeRoomRequest& request) {
  if (!request.brief().has_room()) return std::nullopt;
  auto response = FromBrief<v1::DescribeRoomResponse>();
  *response.mutable_room() = request.brief().room();
  return response;
}

absl::StatusOr<std::optional<v1::PlanZonesResponse>> OwnAnswer(const v1::PlanZonesRequest& request) {
  if (!request.brief().has_zone_plan()) return std::nullopt;
  auto response = FromBrief<v1::PlanZonesResponse>();
  *response.mutable_zone_plan() = request.brief().zone_plan();
  return response;
}

absl::StatusOr<std::optional<v1::ListObjectsResponse>> OwnAnswer(const v1::ListObjectsRequest& request) {
  if (!request.brief().has_object_list()) return std::nullopt;
  const v1::ObjectList& list = request.brief().object_list();
  RETURN_IF_ERROR(Validate(list, request.zone_plan(), "brief.object_list"));
  auto response = FromBrief<v1::ListObjectsResponse>();
  *response.mutable_object_list() = list;
  return response;
}

absl::StatusOr<std::optional<v1::ListConstraintsResponse>> OwnAnswer(const v1::ListConstraintsRequest& request,
                                                                     const Handbook& handbook) {
  const v1::Brief& brief = request.brief();
  if (!brief.has_constraint_list()) return std::nullopt;
  absl::Status status = Validate(brief.constraint_list(), request.object_list(), "brief.constraint_list");
  if (!status.ok()) return status;
  absl::StatusOr<v1::ConstraintList> list =
      OwnConstraints({brief, request.room(), request.zone_plan()}, request.object_list(), handbook);
  if (!list.ok()) return list.status();
  auto response = FromBrief<v1::ListConstraintsResponse>();
  *response.mutable_constraint_list() = *std::move(list);
  return response;
}

}  // namespace flair::language
