// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/service/list_constraint_types_handler.h"

#include "optimizer_worker/constraints/registry.h"

namespace flair::optimizer {

absl::StatusOr<v1::ListConstraintTypesResponse> ListConstraintTypesHandler::Handle(
    const v1::ListConstraintTypesRequest&, runtime::CallContext&) const {
  v1::ListConstraintTypesResponse response;
  *response.mutable_catalog() = MakeCatalog();
  return response;
}

}  // namespace flair::optimizer
