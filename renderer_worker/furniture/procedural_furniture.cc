// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/furniture/procedural_furniture.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <span>
#include <utility>

#include "renderer_worker/furniture/classes.h"
#include "renderer_worker/furniture/piece.h"

namespace flair::renderer {
namespace {

float Extent(double metres) {
  const auto value = static_cast<float>(metres);
  return std::isfinite(value) ? std::clamp(value, kSmallestExtent_m, kLargestExtent_m) : kSmallestExtent_m;
}

std::string WordsOf(const v1::Object& object, const v1::ObjectStyle* style) {
  std::string words = object.name() + " | " + object.description();
  if (style != nullptr) words += " | " + style->material() + " | " + style->description();
  for (char& c : words) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return words;
}

// FNV-1a: the same on every machine.
uint32_t SeedOf(std::string_view class_name, std::string_view name) {
  uint32_t hash = 2166136261U;
  for (const std::string_view text : {class_name, name}) {
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  }
  return hash;
}

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

const PieceMaker* MakerNamed(std::string_view name) {
  static const auto& makers = *[] {
    auto* all = new std::map<std::string_view, const PieceMaker*>();
    for (const std::span<const PieceMaker> family :
         {BathroomMakers(), BedMakers(), ChairMakers(), ContainerMakers(), CraftMakers(), DecorMakers(), FigureMakers(),
          HearthMakers(), KitchenMakers(), LampMakers(), MountedMakers(), MusicMakers(), SeatingMakers(), SportMakers(),
          StorageMakers(), TableMakers(), TextileMakers()}) {
      for (const PieceMaker& maker : family) all->emplace(maker.name, &maker);
    }
    return all;
  }();
  const auto at = makers.find(name);
  return at != makers.end() ? at->second : nullptr;
}

MadePiece MakePiece(std::string_view class_name, const v1::Object& object, const v1::ObjectStyle* style) {
  const FurnitureClass& record = ClassNamed(class_name);
  Piece piece{.w = Extent(object.width_m()),
              .d = Extent(object.depth_m()),
              .h = Extent(object.height_m()),
              .is = PaletteOf(record.materials(), object, style),
              .words = WordsOf(object, style),
              .seed = SeedOf(record.name(), object.name()),
              .make = {},
              .lights = {}};
  MakerNamed(record.mesh())->make(piece);
  std::vector<Vec3> places;
  for (const LampLight& light : piece.lights) places.push_back(light.position);
  MadePiece made{piece.make.Filling(piece.w, piece.d, piece.h, places), std::move(piece.lights)};
  for (size_t i = 0; i < places.size(); ++i) made.lights[i].position = places[i];
  return made;
}

Furnishing ProceduralFurniture::FurnishingOf(const v1::Object& object, const v1::ObjectStyle* style,
                                             std::vector<v1::Diagnostic>& /*diagnostics*/) const {
  Furnishing furnishing;
  furnishing.class_name = ClassOf(object);
  const std::string key = KeyOf(furnishing.class_name, object, style);
  const std::lock_guard lock(mutex_);
  if (made_.size() > kTidyAbove) {
    absl::erase_if(made_, [](const auto& entry) { return entry.second.mesh.expired(); });
  }
  Made& made = made_[key];
  furnishing.mesh = made.mesh.lock();
  if (furnishing.mesh == nullptr) {
    MadePiece piece = MakePiece(furnishing.class_name, object, style);
    furnishing.mesh = std::make_shared<const Mesh>(std::move(piece.mesh));
    made = {furnishing.mesh, std::move(piece.lights)};
  }
  furnishing.lights = made.lights;
  return furnishing;
}

}  // namespace flair::renderer
