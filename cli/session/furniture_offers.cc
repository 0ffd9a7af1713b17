// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/session/furniture_offers.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/str_replace.h"
#include "cli/output/text.h"
#include "renderer_worker/assets/asset_library.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

constexpr char kOwnModels[] = "own models";
// Models whose size is only in their files, which are large.
constexpr int kMostMeasured = 200;

v1::ObjectKind KindOf(language::hb::FurnitureKind kind) {
  switch (kind) {
    case language::hb::FURNITURE_KIND_WALL:
      return v1::OBJECT_KIND_WALL;
    case language::hb::FURNITURE_KIND_CEILING:
      return v1::OBJECT_KIND_CEILING;
    case language::hb::FURNITURE_KIND_SURFACE:
      return v1::OBJECT_KIND_SURFACE;
    default:
      return v1::OBJECT_KIND_FLOOR;
  }
}

// The handbook's classes, in their usual sizes.
std::vector<v1::FurnitureOffer> OfHandbook(const language::Handbook& handbook) {
  std::vector<v1::FurnitureOffer> offers;
  for (const language::hb::Furniture& furniture : handbook.contents().furniture()) {
    v1::FurnitureOffer& offer = offers.emplace_back();
    offer.set_group(absl::StrReplaceAll(furniture.category(), {{"_", " "}}));
    v1::Object& object = *offer.mutable_object();
    object.set_name(furniture.name());
    object.set_category(furniture.category());
    object.set_kind(KindOf(furniture.kind()));
    object.set_role(object.kind() == v1::OBJECT_KIND_FLOOR && !furniture.walk_over() ? v1::OBJECT_ROLE_SECONDARY
                                                                                     : v1::OBJECT_ROLE_TERTIARY);
    object.set_width_m(furniture.width_m().typical());
    object.set_depth_m(furniture.depth_m().typical());
    object.set_height_m(furniture.height_m().typical());
    object.set_elevation_m(furniture.elevation_m());
    object.set_walk_over(furniture.walk_over());
    object.set_round(furniture.round());
    object.set_sat_at(furniture.sat_at());
    object.set_seat(furniture.has_seat_height_m());
  }
  // What most kinds of rooms have is what people look for first, and what stands on the floor before the rest.
  std::map<std::string, int> rooms;
  for (const language::hb::Archetype& room : handbook.contents().archetypes()) {
    std::set<std::string> pieces;
    for (const language::hb::Band& band : room.bands()) {
      for (const language::hb::ObjectEntry& entry : band.objects()) pieces.insert(entry.furniture());
    }
    for (const std::string& piece : pieces) ++rooms[piece];
  }
  std::ranges::stable_sort(offers, {}, [&](const v1::FurnitureOffer& offer) {
    const v1::Object& object = offer.object();
    return std::tuple(object.walk_over(), object.kind(), -rooms[object.name()]);
  });
  return offers;
}

// The class that a name ends with, the longest of them: an armchair is no chair.
const v1::Object* ClassOf(const std::string& name, const std::vector<v1::FurnitureOffer>& known) {
  const std::string low = absl::AsciiStrToLower(name);
  const v1::Object* best = nullptr;
  for (const v1::FurnitureOffer& offer : known) {
    const std::string& end = offer.object().name();
    const bool fits = low == end || low.ends_with(" " + end);
    if (fits && (best == nullptr || best->name().size() < end.size())) best = &offer.object();
  }
  return best;
}

bool IsUsable(v1::Object object) {
  object.set_id("model");
  object.set_zone_id("room");
  return Validate(object, "object").ok();
}

absl::StatusOr<std::vector<v1::FurnitureOffer>> OfFolder(const std::string& folder,
                                                         const std::vector<v1::FurnitureOffer>& known) {
  std::vector<v1::FurnitureOffer> offers;
  ASSIGN_OR_RETURN(const auto library, renderer::AssetLibrary::Open(folder));
  const std::vector<renderer::AssetEntry>& entries = library->manifest().entries;
  int measured = 0;
  for (size_t i = 0; i < entries.size(); ++i) {
    const renderer::AssetEntry& entry = entries[i];
    std::optional<renderer::Vec3> size = entry.size_m;
    if (!size.has_value() && measured++ < kMostMeasured) {
      const auto mesh = library->MeshOf(i);
      if (mesh.ok()) size = renderer::ExtentOf((*mesh)->mesh);
    }
    if (!size.has_value()) continue;
    v1::FurnitureOffer offer;
    offer.set_group(kOwnModels);
    v1::Object& object = *offer.mutable_object();
    object.set_kind(v1::OBJECT_KIND_FLOOR);
    object.set_role(v1::OBJECT_ROLE_SECONDARY);
    if (const v1::Object* of_class = ClassOf(entry.name, known); of_class != nullptr) object = *of_class;
    object.set_name(Shortened(entry.name.empty() ? entry.id : entry.name, 100));
    object.set_description(entry.text);
    object.set_width_m(size->x);
    object.set_depth_m(size->y);
    object.set_height_m(size->z);
    if (IsUsable(object)) offers.push_back(std::move(offer));
  }
  return offers;
}

}  // namespace

absl::StatusOr<std::vector<v1::FurnitureOffer>> FurnitureOffers(const std::string& asset_folder,
                                                                const language::Handbook& handbook) {
  const std::vector<v1::FurnitureOffer> of_handbook = OfHandbook(handbook);
  if (asset_folder.empty()) return of_handbook;
  ASSIGN_OR_RETURN(std::vector<v1::FurnitureOffer> offers, OfFolder(asset_folder, of_handbook));
  offers.insert(offers.end(), of_handbook.begin(), of_handbook.end());
  return offers;
}

std::map<std::string, std::vector<int>> FurnitureWords(const language::Handbook& handbook,
                                                       const std::vector<v1::FurnitureOffer>& offers) {
  std::map<std::string, const language::hb::Furniture*> classes;
  for (const language::hb::Furniture& furniture : handbook.contents().furniture()) {
    classes.emplace(furniture.name(), &furniture);
  }
  std::map<std::string, std::vector<int>> words;
  for (size_t i = 0; i < offers.size(); ++i) {
    const auto of_class = classes.find(offers[i].object().name());
    if (of_class == classes.end() || offers[i].group() == kOwnModels) continue;
    for (const std::string& word : of_class->second->synonyms()) {
      words[absl::AsciiStrToLower(word)].push_back(static_cast<int>(i));
    }
  }
  return words;
}

}  // namespace flair::cli
