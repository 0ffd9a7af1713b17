// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "flair/handbook/v1/handbook.pb.h"

namespace flair::language {

namespace hb = ::flair::handbook::v1;

struct Vocabulary;

// What a designer knows: the data files as one message, with look-up by name. Immutable and thread-safe once made.
// Pointers returned stay valid as long as the handbook lives.
class Handbook {
 public:
  // `contents` must have passed CheckHandbook. `version` is the digest of the files it came from.
  Handbook(hb::Handbook contents, std::string version);
  // As `base`, which must outlive it, with classes that only one brief has besides.
  Handbook(const Handbook& base, std::vector<hb::Furniture> own);
  Handbook(const Handbook&) = delete;
  Handbook& operator=(const Handbook&) = delete;

  // Without the classes of a brief's own.
  const hb::Handbook& contents() const { return *contents_; }
  const std::vector<hb::Furniture>& own() const { return own_; }
  bool IsOwn(const hb::Furniture& furniture) const {
    return std::any_of(own_.begin(), own_.end(), [&](const hb::Furniture& one) { return &one == &furniture; });
  }
  const std::string& version() const { return version_; }

  // Null when there is none of that name.
  const hb::Furniture* FindFurniture(std::string_view name) const { return Find(furniture_, name); }
  const hb::Archetype* FindArchetype(std::string_view name) const { return Find(archetypes_, name); }
  const hb::Style* FindStyle(std::string_view name) const { return Find(styles_, name); }
  const hb::NamedColour* FindColour(std::string_view name) const { return Find(colours_, name); }

  // The kind of room for briefs that name none that is known.
  const hb::Archetype& fallback_archetype() const { return *fallback_; }

  // The words for it that briefs use; see reading/vocabulary.h.
  const Vocabulary& vocabulary() const { return *vocabulary_; }

 private:
  template <typename T>
  using Index = std::map<std::string, const T*, std::less<>>;

  template <typename T>
  static const T* Find(const Index<T>& index, std::string_view name) {
    const auto found = index.find(name);
    return found == index.end() ? nullptr : found->second;
  }

  std::shared_ptr<const hb::Handbook> contents_;
  std::vector<hb::Furniture> own_;
  std::string version_;
  Index<hb::Furniture> furniture_;
  Index<hb::Archetype> archetypes_;
  Index<hb::Style> styles_;
  Index<hb::NamedColour> colours_;
  const hb::Archetype* fallback_ = nullptr;
  std::shared_ptr<const Vocabulary> vocabulary_;
};

// The band of a kind of room for a floor area: the first whose limit is above it, else the last. It has one at least.
inline const hb::Band& BandFor(const hb::Archetype& room, double area_m2) {
  for (const hb::Band& band : room.bands()) {
    if (band.max_area_m2() == 0 || area_m2 < band.max_area_m2()) return band;
  }
  return room.bands(room.bands_size() - 1);
}

// The ends of a range of sizes, metres.
inline double LeastOf(const hb::Extent& extent) { return extent.min() > 0 ? extent.min() : extent.typical(); }
inline double MostOf(const hb::Extent& extent) { return extent.max() > 0 ? extent.max() : extent.typical(); }

}  // namespace flair::language
