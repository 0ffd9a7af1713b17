// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/furniture/procedural_furniture.h"

#include <utility>

#include "renderer_worker/furniture/classes.h"

namespace flair::renderer {
namespace {

// Forgets what nobody holds any more once there is so much of it.
constexpr size_t kTidyAbove = 512;

void Append(std::string& key, std::string_view text) {
  key += std::to_string(text.size());
  key += ':';
  key += text;
}

// Everything that decides a mesh.
std::string KeyOf(std::string_view class_name, const v1::Object& object, const v1::ObjectStyle* style) {
  std::string key(class_name);
  for (const double extent : {object.width_m(), object.depth_m(), object.height_m()}) {
    const auto value = static_cast<float>(extent);
    key.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  Append(key, object.name()), Append(key, object.description());
  if (ClassNamed(class_name).each_differs()) Append(key, object.id());
  if (style == nullptr) return key;
  Append(key, style->material()), Append(key, style->description());
  if (!style->has_colour()) return key;
  Append(key, style->colour().name());
  for (const int channel : {style->colour().red(), style->colour().green(), style->colour().blue()}) {
    Append(key, std::to_string(channel));
  }
  return key;
}

}  // namespace

Furnishing ProceduralFurniture::FurnishingOf(const v1::Object& object, const v1::ObjectStyle* style,
                                             std::vector<v1::Diagnostic>& diagnostics) const {
  Furnishing furnishing;
  furnishing.class_name = ClassOf(object);
  const std::string key = KeyOf(furnishing.class_name, object, style);
  const std::lock_guard lock(mutex_);
  if (made_.size() > kTidyAbove) absl::erase_if(made_, [](const auto& entry) { return entry.second.mesh.expired(); });
  Made& made = made_[key];
  furnishing.mesh = made.mesh.lock();
  if (furnishing.mesh == nullptr) {
    absl::StatusOr<MadePiece> piece = MakePiece(furnishing.class_name, object, style);
    if (!piece.ok()) {
      v1::Diagnostic& diagnostic = diagnostics.emplace_back();
      diagnostic.set_severity(v1::SEVERITY_WARNING);
      diagnostic.set_code("piece_failed");
      diagnostic.set_message("Shown as a plain block: " + std::string(piece.status().message()));
      diagnostic.set_subject_id(object.id());
      furnishing.class_name = "box";
      piece = MakePiece("box", object, style);
    }
    furnishing.mesh = std::make_shared<const Mesh>(piece.ok() ? std::move(piece->mesh) : Mesh());
    made = {furnishing.mesh, piece.ok() ? std::move(piece->lights) : std::vector<LampLight>()};
  }
  furnishing.lights = made.lights;
  return furnishing;
}

}  // namespace flair::renderer
