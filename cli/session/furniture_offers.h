// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/studio_service.pb.h"
#include "language_worker/handbook/handbook.h"

namespace flair::cli {

// Furniture that can be added to a room: the models of the user's own folder, if there is one, in their sizes, then the
// handbook's classes in their usual sizes. A model is what the handbook calls by the end of its name ("rattan
// armchair"); of what is no class there, and of no size that fits into a room, there is no offer. Errors as
// renderer::AssetLibrary::Open.
absl::StatusOr<std::vector<v1::FurnitureOffer>> FurnitureOffers(const std::string& asset_folder,
                                                                const language::Handbook& handbook);

// Other words for offers than their names, each with the indexes of the offers that it means.
std::map<std::string, std::vector<int>> FurnitureWords(const language::Handbook& handbook,
                                                       const std::vector<v1::FurnitureOffer>& offers);

}  // namespace flair::cli
