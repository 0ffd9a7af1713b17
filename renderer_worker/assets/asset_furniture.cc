// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/assets/asset_furniture.h"

#include <iterator>
#include <utility>

#include "fmt/format.h"
#include "renderer_worker/assets/fit_mesh.h"

namespace flair::renderer {
namespace {

constexpr size_t kTries = 4;
constexpr size_t kMaxFitted = 4096;

void Tell(v1::Severity severity, const char* code, const v1::Object& object, std::string message,
          std::vector<v1::Diagnostic>& diagnostics) {
  v1::Diagnostic& diagnostic = diagnostics.emplace_back();
  diagnostic.set_severity(severity);
  diagnostic.set_code(code);
  diagnostic.set_message(std::move(message));
  diagnostic.set_subject_id(object.id());
}

}  // namespace

Furnishing AssetFurniture::FurnishingOf(const v1::Object& object, const v1::ObjectStyle* style,
                                        std::vector<v1::Diagnostic>& diagnostics) const {
  Furnishing furnishing = fallback_.FurnishingOf(object, style, diagnostics);
  const absl::StatusOr<std::vector<AssetMatch>> matches = library_.index().Find(object, style, kTries);
  if (!matches.ok()) {
    Tell(v1::SEVERITY_WARNING, "asset_search_failed", object,
         fmt::format("No asset was looked for: {}.", std::string(matches.status().message())), diagnostics);
    return furnishing;
  }
  for (const AssetMatch& match : *matches) {
    const AssetEntry& entry = library_.manifest().entries[match.entry];
    const absl::StatusOr<std::shared_ptr<const AssetMesh>> asset = library_.MeshOf(match.entry);
    if (!asset.ok()) {
      Tell(v1::SEVERITY_WARNING, "asset_unreadable", object,
           fmt::format("Asset '{}' fits {} but cannot be used: {}.", entry.id, object.name(),
                       std::string(asset.status().message())),
           diagnostics);
      continue;
    }
    if (!entry.size_m.has_value() && WithSize(match.score, ExtentOf((*asset)->mesh), object) < kLeastAssetScore) {
      continue;
    }
    for (const std::string& note : (*asset)->notes) {
      Tell(v1::SEVERITY_NOTE, "asset_partly_read", object, fmt::format("Asset '{}': {}.", entry.id, note), diagnostics);
    }
    furnishing.mesh = FittedMesh(match.entry, **asset, object);
    furnishing.asset_id = entry.id;
    furnishing.asset_licence = entry.licence;
    return furnishing;
  }
  return furnishing;
}

std::shared_ptr<const Mesh> AssetFurniture::FittedMesh(size_t entry, const AssetMesh& asset,
                                                       const v1::Object& object) const {
  const std::string key = fmt::format("{} {} {} {} {}", entry, object.width_m(), object.depth_m(), object.height_m(),
                                      static_cast<int>(object.kind()));
  {
    const std::lock_guard lock(mutex_);
    const auto known = fitted_.find(key);
    if (known != fitted_.end()) {
      if (auto mesh = known->second.lock()) return mesh;
    }
  }
  auto mesh = std::make_shared<const Mesh>(Fitted(asset.mesh, object));
  const std::lock_guard lock(mutex_);
  if (fitted_.size() > kMaxFitted) {
    std::erase_if(fitted_, [](const auto& item) { return item.second.expired(); });
  }
  fitted_[key] = mesh;
  return mesh;
}

}  // namespace flair::renderer
