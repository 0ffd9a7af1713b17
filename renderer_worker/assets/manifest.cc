// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/assets/manifest.h"

#include <cmath>
#include <set>
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
    return absl::ResourceExhaustedError(
        fmt::format("the manifest has {} bytes, {} at most are read", text.size(), kMaxManifestBytes));
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

}  // namespace flair::renderer
