// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/channel.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/constraint_catalog.pb.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::translator {

// Where the optimizer's catalogue comes from when a request brings none. Thread-safe.
class CatalogSource {
 public:
  virtual ~CatalogSource() = default;

  // FAILED_PRECONDITION when there is none to be had; UNAVAILABLE when it may be had later.
  virtual absl::StatusOr<v1::ConstraintCatalog> Get(runtime::CallContext& call) = 0;
};

// No optimizer is configured.
class NoCatalogSource final : public CatalogSource {
 public:
  absl::StatusOr<v1::ConstraintCatalog> Get(runtime::CallContext&) override {
    return absl::FailedPreconditionError(
        "catalog: the request brings none and no optimizer_address is configured to ask for one");
  }
};

// Asks an optimizer by ListConstraintTypes and keeps the first good answer. A failed attempt is not kept.
std::unique_ptr<CatalogSource> MakeRemoteCatalogSource(const std::shared_ptr<grpc::Channel>& channel);

// Looks types up and checks calls against them. Borrows the catalogue.
class CatalogIndex {
 public:
  explicit CatalogIndex(const v1::ConstraintCatalog& catalog);

  // The type of that name or alias that translators may call; null when there is none.
  const v1::ConstraintType* Find(const std::string& name) const;

  // Makes the arguments fit the type: drops optional ones that it does not know, clamps numbers to their range and adds
  // a remark for each to `remarks`. INVALID_ARGUMENT when a required argument is missing or one has the wrong form.
  static absl::Status Fit(const v1::ConstraintType& type, std::vector<v1::Argument>& arguments,
                          std::vector<std::string>& remarks);

 private:
  std::map<std::string, const v1::ConstraintType*> types_;
};

}  // namespace flair::translator
