// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/piece_looks.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "fmt/format.h"
#include "language_worker/handbook/reading/meanings.h"
#include "language_worker/handbook/reading/piece_words.h"
#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {
namespace {

// Colour and material as said in tokens [begin, end).
struct Looks {
  const hb::NamedColour* colour = nullptr;
  std::string shade = {}, material = {};  // of "dark oak" the shade is "dark"
  std::size_t begin = 0, end = 0;
};

class LooksReader : Reading {
 public:
  explicit LooksReader(const Reading& reading) : Reading(reading) {}

  void Before(const hb::Furniture& furniture, std::size_t noun) {
    std::size_t begin = text.PhraseBegin(noun);
    // "An oak and steel desk".
    while (begin > 2 && text.At(begin - 1) == "and" && begin < noun && text.Is(begin - 2, "materials"))
      begin = text.PhraseBegin(begin - 2);
    Looks looks;
    for (std::size_t k = begin; k < noun; ++k) {
      const std::size_t length = used[k] ? 0 : TakeAt(k, looks);
      if (length == 0 || k + length > noun) continue;
      Use(k, k + length);
      k += length - 1;
    }
    Give(furniture, looks);
  }

  void Behind(const Mention& mention) {
    const hb::Furniture* seat = mention.seats ? SeatOf(*mention.furniture, handbook) : nullptr;
    const hb::Furniture& furniture = seat != nullptr ? *seat : *mention.furniture;
    const Looks looks = BehindAt(mention.end);
    if (looks.end == 0) return;
    Give(furniture, looks);
    Use(looks.begin, looks.end);
  }

  bool AreFronts(std::size_t i) const {
    const auto is_fitted = [&](const hb::ObjectEntry& entry) {
      const hb::Furniture* furniture = handbook.FindFurniture(entry.furniture());
      return furniture != nullptr && furniture->run() == hb::RUN_PART_WORKTOP;
    };
    if (!text.Is(i, "fronts_of_pieces") || std::ranges::none_of(facts.archetype->bands(), [&](const hb::Band& band) {
          return std::ranges::any_of(band.objects(), is_fitted);
        }))
      return false;
    bool coloured = BehindAt(i + 1).colour != nullptr;
    for (std::size_t k = text.PhraseBegin(i); k < i; ++k) {
      if (text.IsNumber(k) || NumberWord(text.At(k)) || text.Is(k, "vague_numbers")) return false;
      const Looks looks = RunAt(k);
      coloured = coloured || (looks.colour != nullptr && looks.end == i);
    }
    return coloured;
  }

  // "Matt sage fronts", "fronts in matt sage", "bottle green leather", "dark wood".
  void OfAll() {
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (used[i]) continue;
      Looks looks = RunAt(i);
      const bool fronts = text.Is(looks.end, "fronts_of_pieces");
      if (looks.colour != nullptr && fronts) {
        ++looks.end;
        GiveAll(looks, [](const hb::Furniture& one) { return HasFronts(one); });
      } else if (looks.colour != nullptr && text.Is(looks.end - 1, "upholstery") && EndsPhrase(looks.end)) {
        GiveAll(looks, [](const hb::Furniture& one) { return IsUpholstered(one); });
      } else if (text.Is(i, "fronts_of_pieces") && (looks = BehindAt(i + 1)).end > 0) {
        GiveAll(looks, [](const hb::Furniture& one) { return HasFronts(one); });
      } else if (looks = RunAt(i); IsAllOfAWood(looks)) {
        GiveAll(looks, [](const hb::Furniture& one) { return one.material_group() == "wood"; });
      } else {
        continue;
      }
      Use(looks.begin, looks.end);
      i = looks.end - 1;
    }
  }

 private:
  static bool HasFronts(const hb::Furniture& one) {
    return one.material_group() == "wood" && IsFloorPiece(one) && PlacesOn(one) == 0 &&
           !one.category().ends_with("table");
  }

  // "Dark wood, nothing modern": of no piece, and so of all.
  bool IsAllOfAWood(const Looks& looks) const {
    const std::size_t before = looks.begin - std::min<std::size_t>(looks.begin, 1);
    const bool opens = looks.begin == 0 || text.IsSign(before) || text.Is(before, "before_all_of_a_wood");
    return opens && looks.colour == nullptr && IsIn("woods", looks.material) && EndsPhrase(looks.end) &&
           !text.Says(looks.end, {"of", "for"});
  }

  static bool IsUpholstered(const hb::Furniture& one) {
    return PlacesOn(one) > 0 && (one.material_group() == "upholstery" || one.material_group() == "textile");
  }

  bool EndsPhrase(std::size_t i) const { return i >= text.size() || text.IsSign(i) || text.Is(i, "thing_ends"); }

  // How many tokens the colour or material there has; 0 when there is neither.
  std::size_t TakeAt(std::size_t i, Looks& looks) const {
    const auto [colour, length] = LongestAt(handbook.vocabulary().colours, text.tokens(), i, /*plural=*/false);
    if (length > 0 && !text.Is(i, "materials")) {
      if (looks.colour == nullptr) looks.colour = colour;
      return length;
    }
    if (text.Is(i, "shades") && looks.shade.empty()) looks.shade = text.At(i);
    if (!text.Is(i, "materials")) return looks.shade == text.At(i) ? 1 : 0;
    if (looks.material.empty()) looks.material = text.At(i) == "wooden" ? "wood" : text.At(i);
    return 1;
  }

  // A run of colours and materials.
  Looks RunAt(std::size_t i) const {
    Looks looks{.begin = i, .end = i};
    while (looks.end < text.size() && !used[looks.end]) {
      const std::size_t length = TakeAt(looks.end, looks);
      Looks next;
      if (length == 0 && !(text.At(looks.end) == "and" && looks.end > i && TakeAt(looks.end + 1, next) > 0)) break;
      looks.end += std::max<std::size_t>(1, length);
    }
    return looks;
  }

  // "Chairs charcoal, ...", "in colour of sand", "are in bottle green leather"; `end` is 0 where nothing is said.
  Looks BehindAt(std::size_t i) const {
    constexpr std::size_t kMostBetween = 5;
    std::size_t k = i;
    while (k < i + kMostBetween && !used[std::min(k, text.size() - 1)] && text.Is(k, "look_links")) ++k;
    Looks looks = RunAt(k);
    const bool said = looks.end > k && EndsPhrase(looks.end);
    // "A sofa, green walls", "a shelf in oak cabinets".
    if (!said || (k == i && looks.end < text.size() && !text.IsSign(looks.end))) return {};
    looks.begin = i;
    return looks;
  }

  void Give(const hb::Furniture& furniture, const Looks& looks) {
    const auto has = [&](const auto& list) {
      return std::ranges::any_of(list, [&](const auto& one) { return one.first == &furniture; });
    };
    if (looks.colour != nullptr && !has(facts.object_colours))
      facts.object_colours.emplace_back(&furniture, looks.colour);
    const bool both = !looks.shade.empty() && !looks.material.empty();
    const std::string material = looks.shade + (both ? " " : "") + looks.material;
    if (!material.empty() && !has(facts.object_materials)) facts.object_materials.emplace_back(&furniture, material);
  }

  // To what the brief asks for and what its kind of room has.
  void GiveAll(const Looks& looks, const std::function<bool(const hb::Furniture&)>& counts) {
    for (const Wish& wish : facts.wishes) {
      if (counts(*wish.furniture)) Give(*wish.furniture, looks);
    }
    for (const hb::Band& band : facts.archetype->bands()) {
      for (const hb::ObjectEntry& entry : band.objects()) {
        const hb::Furniture* furniture = handbook.FindFurniture(entry.furniture());
        if (furniture != nullptr && counts(*furniture)) Give(*furniture, looks);
      }
    }
  }
};

// "A big table", "a long narrow desk": half the way from what is usual to the largest or least.
PieceSize SizeInWords(const BriefText& text, const Mention& mention, const std::vector<bool>& taken) {
  PieceSize size;
  const hb::Extent &width = mention.furniture->width_m(), &depth = mention.furniture->depth_m();
  const auto towards = [](const hb::Extent& extent, double bound_m) { return (extent.typical() + bound_m) / 2; };
  for (std::size_t k = text.PhraseBegin(mention.begin); k < mention.end; ++k) {
    if (taken[k] && k < mention.begin) continue;
    if (text.Is(k, "large_pieces")) size.width_m = towards(width, MostOf(width));
    if (text.Is(k, "deep_pieces")) size.depth_m = towards(depth, MostOf(depth));
    if (text.Is(k, "small_pieces") && k < mention.begin) size.width_m = towards(width, LeastOf(width));
    if (text.Is(k, "narrow_pieces") && k < mention.begin) size.depth_m = towards(depth, LeastOf(depth));
  }
  return size;
}

}  // namespace

void TakeLooksBefore(const Reading& reading, const hb::Furniture& furniture, std::size_t noun) {
  LooksReader(reading).Before(furniture, noun);
}

bool AreFronts(const Reading& reading, std::size_t i) { return LooksReader(reading).AreFronts(i); }

void TakeLooksBehind(const Reading& reading, const std::vector<Mention>& mentions) {
  LooksReader reader(reading);
  for (const Mention& mention : mentions) reader.Behind(mention);
  reader.OfAll();
}

void TakeSizes(const Reading& reading, const std::vector<Mention>& mentions, std::vector<bool> taken) {
  const auto& [handbook, text, used, facts] = reading;
  const std::vector<Token>& tokens = text.tokens();
  const auto fits = [](const std::optional<double>& side, const hb::Extent& extent) {
    return !side || (*side >= 0.5 * LeastOf(extent) && *side <= 1.7 * MostOf(extent));
  };
  const auto take = [&](const Mention& mention, const PieceSize& size) {
    reading.Use(size.begin, size.end);
    const hb::Furniture& furniture = *mention.furniture;
    if (!fits(size.width_m, furniture.width_m()) || !fits(size.depth_m, furniture.depth_m()) ||
        !fits(size.height_m, furniture.height_m())) {
      facts.sizes_not_had.push_back(furniture.name() + ": " + text.Quote(size.begin, size.end));
      return;
    }
    for (Wish& wish : facts.wishes) {
      if (wish.furniture == &furniture && !wish.size.any()) wish.size = size;
    }
  };
  for (std::size_t i = 0; i < taken.size(); ++i) taken[i] = taken[i] || used[i];
  for (const Mention& mention : mentions) {
    const PieceSize size = ReadPieceSize(tokens, mention.begin, mention.end, taken).For(*mention.furniture);
    if (size.any()) take(mention, size);
  }
  for (Wish& wish : facts.wishes) {
    const auto mention = std::ranges::find(mentions, wish.furniture, &Mention::furniture);
    const bool free = !wish.size.any() && wish.seats < 2 && IsFloorPiece(*wish.furniture);
    if (free && mention != mentions.end()) wish.size = SizeInWords(text, *mention, taken);
  }
  // "Two desks at the window, 140 x 70 cm each".
  constexpr std::size_t kMostOfASize = 6;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    for (std::size_t k = i - std::min(i, kMostOfASize); k < i && tokens[i].text == "each" && !used[i - 1]; ++k) {
      const PieceSize size = ReadPieceSize(tokens, k, k, taken);
      const auto last = std::find_if(mentions.rbegin(), mentions.rend(),
                                     [&](const Mention& one) { return one.end <= k && one.count > 1; });
      if (size.any() && size.begin == k && size.end == i && last != mentions.rend())
        take(*last, size.For(*last->furniture));
    }
  }
}

void NoteOtherNames(const BriefText& text, const std::vector<Mention>& mentions, BriefFacts& facts) {
  for (const Mention& mention : mentions) {
    const std::string& name = mention.furniture->name();
    const std::vector<Token> words = TokensOf(name);
    bool called_so = mention.seats || text.Is(mention.begin, "places_of_people");
    for (std::size_t i = mention.begin; i < mention.end && !called_so; ++i) {
      const std::string said(text.At(i));
      called_so = MeanTheSame(said, words.back().text) || std::ranges::any_of(words, [&](const Token& word) {
                    constexpr std::size_t kTold = 4;  // "bookcase" and "bookshelf"
                    return MatchesWord(said, word.text) || word.text.starts_with(said.substr(0, kTold));
                  });
    }
    std::string other = fmt::format("\"{}\" as {}", text.Quote(mention.begin, mention.end), name);
    if (!called_so && !Includes(facts.other_names, other)) facts.other_names.push_back(std::move(other));
  }
}

}  // namespace flair::language
