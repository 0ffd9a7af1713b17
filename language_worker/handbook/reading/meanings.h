// SPDX-License-Identifier: GPL-3.0-or-later
// What the nouns of a brief are that the handbook has no entry for, by WordNet: things, and which class they are made
// like; kinds of room, and as which they are furnished; people.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "english/wordnet.h"
#include "flair/handbook/v1/handbook.pb.h"

namespace flair::language {

namespace hb = ::flair::handbook::v1;

// What a noun names.
struct Thing {
  bool known = false;     // WordNet has the noun
  bool is_thing = false;  // in one of its usual senses it is something that may stand in a room
  // The class that it is made like; null where the handbook has none of its kind.
  const hb::Furniture* like = nullptr;
};

// Made once for a handbook, which must outlive it. Immutable and thread-safe. Nouns are lower case, in the singular or
// plural; of a compound the longest end that WordNet has is looked up: of "honey extractor" the extractor.
class Meanings {
 public:
  explicit Meanings(const hb::Handbook& handbook);

  // Looks at the `usual` most frequent senses.
  Thing ThingOf(std::string_view noun, std::size_t usual = 3) const;

  // The kind of room that such a room is furnished as; null when it is no room.
  const hb::Archetype* RoomOf(std::string_view noun) const;
  // The kind that serves what the noun means: of "breakfast" the one for meals. Null when none does.
  const hb::Archetype* RoomFor(std::string_view noun) const;

 private:
  // A class that stands for the kinds of a sense.
  template <typename Entry>
  struct Anchor {
    const Entry* entry = nullptr;  // null: what is a kind of it is nothing that could be made
    int most_steps = 0;            // how far below it
  };
  template <typename Entry>
  using Anchors = std::unordered_map<std::uint32_t, Anchor<Entry>>;

  template <typename Entry>
  static void Add(std::string_view text, const Entry* entry, int most_steps, Anchors<Entry>& anchors);

  // That of the first `most` senses which count by what they are kinds of.
  const hb::Archetype* RoomAmong(std::string_view noun, std::size_t most,
                                 const std::function<bool(const std::vector<english::Kind>&)>& counts) const;

  Anchors<hb::Furniture> things_;
  Anchors<hb::Archetype> rooms_;
};

// Whether two nouns share a sense: "couch" and "sofa".
bool MeanTheSame(std::string_view a, std::string_view b);

// Whether a thing of that name is a kind of what the noun names: a settee is a sofa.
bool IsKindOf(std::string_view name, std::string_view noun);

// Whether the noun means people first of all: "gardeners", "guests".
bool MeansPeople(std::string_view noun);

}  // namespace flair::language
