// SPDX-License-Identifier: GPL-3.0-or-later
// Translates labelled rooms and scores what comes out.
#pragma once

#include <functional>

#include "absl/status/statusor.h"
#include "cli/bench/bench_translate_score.h"
#include "flair/v1/constraint_catalog.pb.h"

namespace flair::cli {

// Any form of TranslatorService.Translate.
using TranslateCall = std::function<absl::StatusOr<v1::TranslateResponse>(const v1::TranslateRequest&)>;

// The types of `catalog` that the reference library knows by their name or an alias: labels speak of no others.
v1::ConstraintCatalog TypesOfTheReference(const v1::ConstraintCatalog& catalog);

// Sends every room as one request with `catalog`, in the order of the labels; the first error ends it, with the room's
// name.
absl::StatusOr<TranslateScore> MeasureTranslation(const std::vector<LabelledRoom>& rooms,
                                                  const v1::ConstraintCatalog& catalog, const TranslateCall& translate);

}  // namespace flair::cli
