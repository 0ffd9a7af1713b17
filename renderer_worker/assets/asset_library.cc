// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/assets/asset_library.h"

#include <fstream>
#include <string>
#include <system_error>
#include <utility>

#include "fmt/format.h"
#include "renderer_worker/gltf/limited_json.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {
namespace {

namespace fs = std::filesystem;

// About 600 MB of positions, normals and texture coordinates.
constexpr size_t kMaxKeptVertices = size_t{16} << 20;
constexpr size_t kMaxKeptEntries = 10000;

// A plain file of at most `max_bytes`: never waits for a pipe.
absl::StatusOr<std::string> ReadFile(const fs::path& path, size_t max_bytes) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return absl::NotFoundError(fmt::format("there is no file {}", path.string()));
  if (!fs::is_regular_file(status)) return absl::NotFoundError(fmt::format("{} is no plain file", path.string()));
  const uintmax_t size = fs::file_size(path, error);
  if (error) return absl::NotFoundError(fmt::format("{}: {}", path.string(), error.message()));
  if (size > max_bytes) {
    return absl::ResourceExhaustedError(
        fmt::format("{} has {} bytes, {} at most are read", path.string(), size, max_bytes));
  }
  std::string bytes(static_cast<size_t>(size), '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file.read(bytes.data(), static_cast<std::streamsize>(size))) {
    return absl::NotFoundError(fmt::format("{} cannot be read", path.string()));
  }
  return bytes;
}

// Objaverse tells the files of its annotations apart: {uid: "glbs/000-023/uid.glb"}.
void TakePaths(const fs::path& folder, Manifest& manifest) {
  absl::StatusOr<std::string> text = ReadFile(folder / "object-paths.json", kMaxManifestBytes);
  if (!text.ok()) return;
  const absl::StatusOr<nlohmann::json> paths = ParseLimitedJson(*text);
  if (!paths.ok()) return;
  for (AssetEntry& entry : manifest.entries) {
    const std::string_view path = TextOf(*paths, entry.id.c_str());
    if (StaysInFolder(path)) entry.file = std::string(path);
  }
}

size_t VerticesOf(const absl::StatusOr<std::shared_ptr<const AssetMesh>>& loaded) {
  size_t count = 0;
  if (!loaded.ok()) return count;
  for (const MeshPart& part : (*loaded)->mesh.parts) count += part.positions.size();
  return count;
}

}  // namespace

absl::StatusOr<std::unique_ptr<AssetLibrary>> AssetLibrary::Open(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    return absl::NotFoundError(fmt::format("the asset folder {} is no folder", folder.string()));
  }
  fs::path file = folder / "manifest.json";
  if (!fs::exists(file, error)) file = folder / "annotations.json";
  absl::StatusOr<std::string> text = ReadFile(file, kMaxManifestBytes);
  if (absl::IsNotFound(text.status())) {
    return absl::NotFoundError(
        fmt::format("the asset folder {} must hold manifest.json or annotations.json", folder.string()));
  }
  if (!text.ok()) return text.status();
  absl::StatusOr<Manifest> manifest = ReadManifest(*text);
  if (!manifest.ok()) {
    return absl::Status(manifest.status().code(),
                        fmt::format("{}: {}", file.string(), std::string(manifest.status().message())));
  }
  auto library = std::make_unique<AssetLibrary>();
  library->folder_ = folder;
  library->manifest_ = *std::move(manifest);
  if (file.filename() == "annotations.json") TakePaths(folder, library->manifest_);
  ASSIGN_OR_RETURN(library->index_, AssetIndex::Make(library->manifest_.entries));
  return library;
}

AssetLibrary::Loaded AssetLibrary::Load(const AssetEntry& entry) const {
  absl::StatusOr<std::string> bytes = ReadFile(folder_ / entry.file, kMaxAssetBytes);
  // Objathor keeps each model in a folder of its own.
  if (absl::IsNotFound(bytes.status()) && StaysInFolder(entry.id)) {
    absl::StatusOr<std::string> own = ReadFile(folder_ / entry.id / (entry.id + ".glb"), kMaxAssetBytes);
    if (own.ok()) bytes = std::move(own);
  }
  if (!bytes.ok()) return bytes.status();
  ASSIGN_OR_RETURN(AssetMesh mesh, ReadAsset(*bytes, entry.axes));
  return std::make_shared<const AssetMesh>(std::move(mesh));
}

AssetLibrary::Loaded AssetLibrary::MeshOf(size_t entry) const {
  {
    const std::lock_guard lock(mutex_);
    const auto known = kept_.find(entry);
    if (known != kept_.end()) {
      used_.splice(used_.begin(), used_, known->second.used);
      return known->second.mesh;
    }
  }
  Loaded loaded = Load(manifest_.entries.at(entry));
  const size_t vertex_count = VerticesOf(loaded);
  const std::lock_guard lock(mutex_);
  if (kept_.contains(entry)) return kept_.at(entry).mesh;  // another thread was faster
  used_.push_front(entry);
  kept_.emplace(entry, Kept{loaded, vertex_count, used_.begin()});
  kept_vertex_count_ += vertex_count;
  while (used_.size() > 1 && (kept_vertex_count_ > kMaxKeptVertices || used_.size() > kMaxKeptEntries)) {
    kept_vertex_count_ -= kept_.at(used_.back()).vertex_count;
    kept_.erase(used_.back());
    used_.pop_back();
  }
  return loaded;
}

}  // namespace flair::renderer
