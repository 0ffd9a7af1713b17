// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/service/furnishing_choice.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "renderer_worker/assets/asset_furniture.h"
#include "renderer_worker/assets/asset_library.h"
#include "renderer_worker/furniture/procedural_furniture.h"
#include "worker_runtime/files/files.h"

namespace flair::renderer {
namespace {

// A library, what stands in for it, and the two together.
class LibraryFurniture final : public FurnishingSource {
 public:
  explicit LibraryFurniture(std::unique_ptr<AssetLibrary> library)
      : library_(std::move(library)), assets_(*library_, procedural_) {}

  Furnishing FurnishingOf(const v1::Object& object, const v1::ObjectStyle* style,
                          std::vector<v1::Diagnostic>& diagnostics) const override {
    return assets_.FurnishingOf(object, style, diagnostics);
  }

 private:
  const std::unique_ptr<AssetLibrary> library_;
  const ProceduralFurniture procedural_;
  const AssetFurniture assets_;
};

// Of the manifest's bytes: another manifest, another picture.
std::string RevisionOf(const std::filesystem::path& folder) {
  for (const char* name : {"manifest.json", "annotations.json"}) {
    std::ifstream file(folder / name, std::ios::binary);
    if (!file) continue;
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    return "assets " + runtime::Sha256Hex(bytes).substr(0, 16);
  }
  return "";
}

}  // namespace

absl::StatusOr<FurnishingChoice> ChooseFurnishing(const std::string& asset_folder) {
  if (asset_folder.empty()) return FurnishingChoice{std::make_unique<ProceduralFurniture>(), "", {}};
  absl::StatusOr<std::unique_ptr<AssetLibrary>> library = AssetLibrary::Open(asset_folder);
  if (!library.ok()) {
    return absl::Status(library.status().code(),
                        fmt::format("folder of assets: {}", std::string(library.status().message())));
  }
  std::vector<v1::Diagnostic> diagnostics = (*library)->manifest().diagnostics;
  return FurnishingChoice{std::make_unique<LibraryFurniture>(*std::move(library)), RevisionOf(asset_folder),
                          std::move(diagnostics)};
}

}  // namespace flair::renderer
