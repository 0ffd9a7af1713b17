// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/assets/asset_library.h"

#include <fstream>
#include <set>
#include <system_error>
#include <utility>

#include "fmt/format.h"
#include "renderer_worker/gltf/limited_json.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {
namespace {

using Json = nlohmann::json;

constexpr int kMaxDiagnostics = 100;
constexpr size_t kMaxTextBytes = 4000;

// At most `kMaxTextBytes`, cut between characters.
std::string Shortened(std::string_view text) {
  if (text.size() <= kMaxTextBytes) return std::string(text);
  size_t end = kMaxTextBytes;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return std::string(text.substr(0, end));
}

// A word list as it is found: a text, texts, or objects with a name.
std::string WordsOf(const Json& json, const char* name) {
  const Json* found = Find(json, name);
  if (found == nullptr) return "";
  if (found->is_string()) return Shortened(found->get_ref<const std::string&>());
  std::string words;
  for (const Json& item : found->is_array() ? *found : Json::array()) {
    const std::string_view word = item.is_string() ? item.get_ref<const std::string&>() : TextOf(item, "name");
    if (word.empty() || words.size() > kMaxTextBytes) continue;
    words.append(words.empty() ? "" : " ").append(word);
  }
  return Shortened(words);
}

// Of our own manifests: three metres, all of them positive.
std::optional<Vec3> SizeOf(const Json& json, double unit, const char* width, const char* depth, const char* height) {
  const auto w = NumberOf(json, width);
  const auto d = NumberOf(json, depth);
  const auto h = NumberOf(json, height);
  constexpr double kLeast_m = 1e-3;
  constexpr double kMost_m = 100;
  for (const auto& value : {w, d, h}) {
    if (!value.has_value() || !(*value * unit >= kLeast_m) || !(*value * unit <= kMost_m)) return std::nullopt;
  }
  return Vec3{static_cast<float>(*w * unit), static_cast<float>(*d * unit), static_cast<float>(*h * unit)};
}

class Reader {
 public:
  void Add(AssetEntry entry) {
    if (entry.id.empty() || entry.id.size() > 200) return Leave(entry.id, "id must have 1 to 200 bytes");
    if (!ids_.insert(entry.id).second) return Leave(entry.id, "another entry has this id");
    if (!StaysInFolder(entry.file)) {
      return Leave(entry.id, fmt::format("file '{}' must be a path below the asset folder", Printable(entry.file)));
    }
    if (absl::Status axes = CheckAxes(entry.axes); !axes.ok()) return Leave(entry.id, std::string(axes.message()));
    if (entry.name.empty() && entry.tags.empty() && entry.text.empty()) {
      return Leave(entry.id, "one of name, tags and text must say what it is");
    }
    manifest_.entries.push_back(std::move(entry));
  }

  void Leave(const std::string& id, const std::string& why) {
    if (manifest_.diagnostics.size() >= kMaxDiagnostics) return;
    v1::Diagnostic& diagnostic = manifest_.diagnostics.emplace_back();
    diagnostic.set_severity(v1::SEVERITY_WARNING);
    diagnostic.set_code("asset_entry_unusable");
    diagnostic.set_message(fmt::format("Asset '{}' of the manifest is left out: {}.", Printable(id), why));
    diagnostic.set_subject_id(Printable(id));
  }

  Manifest Take() { return std::move(manifest_); }

 private:
  static std::string Printable(const std::string& text) {
    std::string shown = text.substr(0, 60);
    for (char& c : shown) {
      if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7E) c = '?';
    }
    return shown;
  }

  Manifest manifest_;
  std::set<std::string> ids_;
};

void ReadOwn(const Json& assets, Reader& reader) {
  for (const Json& json : assets) {
    AssetEntry entry;
    entry.id = std::string(TextOf(json, "id"));
    entry.file = std::string(TextOf(json, "file"));
    entry.name = Shortened(TextOf(json, "name"));
    entry.tags = WordsOf(json, "tags");
    entry.text = Shortened(TextOf(json, "text"));
    entry.licence = Shortened(TextOf(json, "licence").empty() ? TextOf(json, "license") : TextOf(json, "licence"));
    entry.size_m = SizeOf(json, 1, "width_m", "depth_m", "height_m");
    if (!TextOf(json, "front").empty()) entry.axes.front = std::string(TextOf(json, "front"));
    if (!TextOf(json, "up").empty()) entry.axes.up = std::string(TextOf(json, "up"));
    reader.Add(std::move(entry));
  }
}

// Objaverse says name, tags, categories, description and license; Objathor category, description, materials, and sizes
// in centimetres of a model that stands as glTF asks.
void ReadAnnotations(const Json& json, Reader& reader) {
  for (const auto& [uid, annotation] : json.items()) {
    if (!annotation.is_object()) {
      reader.Leave(uid, "it must be an object");
      continue;
    }
    AssetEntry entry;
    entry.id = uid;
    entry.file = TextOf(annotation, "file").empty() ? uid + ".glb" : std::string(TextOf(annotation, "file"));
    entry.name = Shortened(TextOf(annotation, "name"));
    if (entry.name.empty()) entry.name = Shortened(TextOf(annotation, "category"));
    for (const char* member : {"tags", "categories", "category", "materials"}) {
      const std::string words = WordsOf(annotation, member);
      if (!words.empty()) entry.tags.append(entry.tags.empty() ? "" : " ").append(words);
    }
    entry.text = Shortened(TextOf(annotation, "description"));
    entry.licence = Shortened(TextOf(annotation, "license"));
    entry.size_m = SizeOf(annotation, 0.01, "width", "depth", "height");
    if (!TextOf(annotation, "front").empty()) entry.axes.front = std::string(TextOf(annotation, "front"));
    if (!TextOf(annotation, "up").empty()) entry.axes.up = std::string(TextOf(annotation, "up"));
    reader.Add(std::move(entry));
  }
}

namespace fs = std::filesystem;

// About 600 MB of positions, normals and texture coordinates.
constexpr size_t kMaxKeptVertices = size_t{16} << 20;
constexpr size_t kMaxKeptEntries = 10000;

// A plain file of at most `max_bytes`: never waits for a pipe.
absl::StatusOr<std::string> ReadFile(const fs::path& path, size_t max_bytes) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return NotFound("there is no file {}", path.string());
  if (!fs::is_regular_file(status)) return NotFound("{} is not a regular file", path.string());
  const uintmax_t size = fs::file_size(path, error);
  if (error) return NotFound("{}: {}", path.string(), error.message());
  if (size > max_bytes) {
    return ResourceExhausted("{} has {} bytes, {} at most are read", path.string(), size, max_bytes);
  }
  std::string bytes(static_cast<size_t>(size), '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file.read(bytes.data(), static_cast<std::streamsize>(size))) return NotFound("{} cannot be read", path.string());
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

bool StaysInFolder(std::string_view file) {
  if (file.empty() || file.size() > 1000 || file.front() == '/') return false;
  if (file.find_first_of(std::string_view("\0\\", 2)) != std::string_view::npos) return false;
  while (true) {
    const size_t slash = file.find('/');
    const std::string_view part = file.substr(0, slash);
    if (part.empty() || part == "." || part == "..") return false;
    if (slash == std::string_view::npos) return true;
    file.remove_prefix(slash + 1);
  }
}

absl::StatusOr<Manifest> ReadManifest(std::string_view text) {
  if (text.size() > kMaxManifestBytes) {
    return ResourceExhausted("the manifest has {} bytes, {} at most are read", text.size(), kMaxManifestBytes);
  }
  ASSIGN_OR_RETURN(Json json, ParseLimitedJson(text));
  Reader reader;
  const Json* assets = Find(json, "assets");
  if (assets != nullptr && assets->is_array()) {
    ReadOwn(*assets, reader);
  } else if (json.is_object()) {
    ReadAnnotations(json, reader);
  } else {
    return absl::InvalidArgumentError(
        "a manifest must be {\"assets\": [...]} or annotations {\"UID\": {\"name\": ...}, ...}");
  }
  return reader.Take();
}

absl::StatusOr<std::unique_ptr<AssetLibrary>> AssetLibrary::Open(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) return NotFound("the asset folder {} is not a folder", folder.string());
  fs::path file = folder / "manifest.json";
  if (!fs::exists(file, error)) file = folder / "annotations.json";
  absl::StatusOr<std::string> text = ReadFile(file, kMaxManifestBytes);
  if (absl::IsNotFound(text.status())) {
    return NotFound("the asset folder {} must hold manifest.json or annotations.json", folder.string());
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
