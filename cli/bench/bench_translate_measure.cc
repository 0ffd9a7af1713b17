// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/bench_translate_measure.h"

#include <algorithm>

#include "evaluation/readers/flairgpt_functions.h"
#include "fmt/format.h"

namespace flair::cli {

v1::ConstraintCatalog TypesOfTheReference(const v1::ConstraintCatalog& catalog) {
  v1::ConstraintCatalog known = catalog;
  known.clear_types();
  for (const v1::ConstraintType& type : catalog.types()) {
    const auto known_there = [](const std::string& name) {
      return evaluation::FindFlairGptFunction(evaluation::CanonicalFlairGptName(name)) != nullptr;
    };
    const bool named =
        known_there(type.name()) || std::any_of(type.aliases().begin(), type.aliases().end(), known_there);
    if (named || type.built_in()) *known.add_types() = type;
  }
  return known;
}

absl::StatusOr<TranslateScore> MeasureTranslation(const std::vector<LabelledRoom>& rooms,
                                                  const v1::ConstraintCatalog& catalog,
                                                  const TranslateCall& translate) {
  TranslateScore score;
  for (const LabelledRoom& room : rooms) {
    v1::TranslateRequest request = room.request;
    request.set_request_id("bench-" + room.name);
    *request.mutable_catalog() = catalog;
    const absl::StatusOr<v1::TranslateResponse> response = translate(request);
    if (!response.ok()) {
      return absl::Status(response.status().code(),
                          fmt::format("{}: {}", room.name, std::string(response.status().message())));
    }
    AddToScore(room, response->layout_graph(), score);
  }
  return score;
}

}  // namespace flair::cli
