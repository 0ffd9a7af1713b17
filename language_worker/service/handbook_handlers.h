// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/statusor.h"
#include "flair/v1/language_service.pb.h"
#include "language_worker/handbook/handbook.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::language {

// Answers the six requests of the language phase from the handbook, which must outlive it. Each validates its request,
// returns what the brief itself brings, else asks one function of the handbook's rooms, and says who answered.
// Thread-safe.
class HandbookHandlers {
 public:
  explicit HandbookHandlers(const Handbook& handbook) : handbook_(handbook) {}

  absl::StatusOr<v1::DescribeRoomResponse> Handle(const v1::DescribeRoomRequest& request,
                                                  runtime::CallContext& call) const;
  absl::StatusOr<v1::PlanZonesResponse> Handle(const v1::PlanZonesRequest& request, runtime::CallContext& call) const;
  absl::StatusOr<v1::ListObjectsResponse> Handle(const v1::ListObjectsRequest& request,
                                                 runtime::CallContext& call) const;
  absl::StatusOr<v1::ChooseStyleResponse> Handle(const v1::ChooseStyleRequest& request,
                                                 runtime::CallContext& call) const;
  absl::StatusOr<v1::ListConstraintsResponse> Handle(const v1::ListConstraintsRequest& request,
                                                     runtime::CallContext& call) const;
  absl::StatusOr<v1::CleanConstraintsResponse> Handle(const v1::CleanConstraintsRequest& request,
                                                      runtime::CallContext& call) const;

 private:
  v1::Producer Producer() const;

  const Handbook& handbook_;
};

}  // namespace flair::language
