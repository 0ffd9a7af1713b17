// SPDX-License-Identifier: GPL-3.0-or-later
// A constraint catalogue for people.
#pragma once

#include <string>

#include "flair/v1/constraint_catalog.pb.h"

namespace flair::cli {

// All types by family: formula, parameters with range and default, sentences with the calls they mean.
// docs/constraints.md is this text.
std::string CatalogMarkdown(const v1::ConstraintCatalog& catalog);
// One type for the terminal.
std::string TypeText(const v1::ConstraintType& type);
// A line per type that a translator may call: name and summary.
std::string CatalogOverview(const v1::ConstraintCatalog& catalog);

}  // namespace flair::cli
