// SPDX-License-Identifier: GPL-3.0-or-later
// What sentences call objects, their zones and the corners that they take.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "language_worker/handbook/sentences/sentence_writer.h"

namespace flair::language {
namespace {

constexpr std::array<const char*, 12> kOrdinals = {"first",   "second", "third", "fourth", "fifth",    "sixth",
                                                   "seventh", "eighth", "ninth", "tenth",  "eleventh", "twelfth"};

}  // namespace

bool TakesCentre(const v1::ObjectList& objects, const v1::Object& object) {
  constexpr double kFlatM = 0.03;
  if (object.kind() != v1::OBJECT_KIND_SURFACE) return false;
  if (object.height_m() <= kFlatM) return true;
  const v1::Object* largest = nullptr;
  for (const v1::Object& other : objects.objects()) {
    if (other.kind() != v1::OBJECT_KIND_SURFACE || other.host_id() != object.host_id() || other.height_m() <= kFlatM)
      continue;
    const bool larger =
        largest == nullptr || other.width_m() * other.depth_m() > largest->width_m() * largest->depth_m();
    if (larger) largest = &other;
  }
  return largest == &object;
}

std::string SentenceWriter::NameOf(const v1::Object& object) const {
  const Group& group = groups_.at(object.name());
  if (group.size() == 1) return object.name();
  const auto at = static_cast<std::size_t>(std::find(group.begin(), group.end(), &object) - group.begin());
  return at < kOrdinals.size() ? fmt::format("{} {}", kOrdinals[at], object.name())
                               : fmt::format("{} {}", object.name(), at + 1);
}

std::string SentenceWriter::NameOf(const Group& group) const {
  return group.size() == 1 ? NameOf(*group.front()) : Plural(group.front()->name());
}

std::string SentenceWriter::Plural(const std::string& name) const {
  const hb::Furniture* furniture = handbook_.FindFurniture(name);
  if (furniture != nullptr && !furniture->plural().empty()) return furniture->plural();
  const auto ends = [&](std::string_view ending) {
    return name.size() > ending.size() && name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
  };
  if (ends("shelf")) return name.substr(0, name.size() - 1) + "ves";
  if (ends("s") || ends("x") || ends("ch") || ends("sh")) return name + "es";
  if (ends("y") && !ends("ay") && !ends("ey") && !ends("oy")) return name.substr(0, name.size() - 1) + "ies";
  return name + "s";
}

bool SentenceWriter::IsPlural(const std::string& name) const {
  const hb::Furniture* furniture = handbook_.FindFurniture(name);
  return furniture != nullptr && furniture->plural() == name && name.back() == 's';
}

std::string SentenceWriter::ZoneName(const v1::Object& object) const {
  for (const v1::Zone& zone : zones_.zones()) {
    if (zone.id() == object.zone_id()) return zone.name();
  }
  return zones_.zones_size() > 0 ? zones_.zones(0).name() : "main";
}

// Corners of a host's top are taken in turn by what stands on it.
std::string SentenceWriter::CornerOf(const v1::Object& object) const {
  constexpr std::array<const char*, 4> kCorners = {"back left", "back right", "front right", "front left"};
  std::size_t before = 0;
  for (const v1::Object& other : objects_.objects()) {
    if (other.id() == object.id()) break;
    if (other.kind() == v1::OBJECT_KIND_SURFACE && other.host_id() == object.host_id() &&
        !TakesCentre(objects_, other)) {
      ++before;
    }
  }
  return kCorners[before % kCorners.size()];
}

}  // namespace flair::language
