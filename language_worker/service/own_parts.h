// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "absl/status/statusor.h"
#include "flair/v1/language_service.pb.h"
#include "language_worker/handbook/handbook.h"

namespace flair::language {

// The answer that the brief itself brings to a request: the user's own room, zones, objects or constraints, as they
// are, by the method "brief". Nothing when it brings none. INVALID_ARGUMENT when they do not go with what they belong
// to: the objects' zones with the request's plan, the constraints' objects with its list. The request has been
// validated.
absl::StatusOr<std::optional<v1::DescribeRoomResponse>> OwnAnswer(const v1::DescribeRoomRequest& request);
absl::StatusOr<std::optional<v1::PlanZonesResponse>> OwnAnswer(const v1::PlanZonesRequest& request);
absl::StatusOr<std::optional<v1::ListObjectsResponse>> OwnAnswer(const v1::ListObjectsRequest& request);
absl::StatusOr<std::optional<v1::ListConstraintsResponse>> OwnAnswer(const v1::ListConstraintsRequest& request,
                                                                     const Handbook& handbook);

}  // namespace flair::language
