// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/service/list_constraint_types_handler.h"

#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/service/placed_examples.h"

namespace flair::optimizer {

absl::StatusOr<v1::ListConstraintTypesResponse> ListConstraintTypesHandler::Handle(
    const v1::ListConstraintTypesRequest& request, runtime::CallContext&) const {
  v1::ListConstraintTypesResponse response;
  *response.mutable_catalog() = MakeCatalog();
  if (!request.with_placed_examples()) return response;
  for (v1::ConstraintType& type : *response.mutable_catalog()->mutable_types()) {
    *type.mutable_placed_examples() = PlacedExamplesOf(*FindConstraint(type.name()));
  }
  return response;
}

}  // namespace flair::optimizer
