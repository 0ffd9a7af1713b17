// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "flair/v1/constraint_catalog.pb.h"

namespace flair::translator {

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
