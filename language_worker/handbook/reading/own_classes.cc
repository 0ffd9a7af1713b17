// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/own_classes.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "english/words.h"
#include "language_worker/handbook/reading/other_words.h"
#include "language_worker/handbook/reading/piece_words.h"
#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {
namespace {

constexpr std::size_t kMostOfAPhrase = 8;  // of a noun phrase
constexpr std::size_t kMostNameWords = 3;  // of a name
constexpr std::size_t kMostClasses = 40;

void Scale(double factor, hb::Extent& extent) {
  extent.set_typical(extent.typical() * factor);
  extent.clear_min();
  extent.clear_max();
}

// The class without what it needs where it usually is, carried by something else.
hb::Furniture CarriedBy(hb::FurnitureKind kind, hb::Furniture furniture) {
  constexpr double kOnTopM = 0.32, kHighOnTopM = 0.45, kOnWallM = 0.3, kMiddleM = 1.1;
  const bool from_floor = IsOnTheFloor(furniture);
  furniture.set_kind(kind);
  for (const char* field : {"relations", "hosts", "companions", "makes_zone", "smaller", "back", "clear_front_m",
                            "clear_sides_m", "clear_back_m", "elevation_m", "gap_above_target_m"}) {
    furniture.GetReflection()->ClearField(&furniture, furniture.GetDescriptor()->FindFieldByName(field));
  }
  if (kind == hb::FURNITURE_KIND_SURFACE) {
    const double side_m = std::max(furniture.width_m().typical(), furniture.depth_m().typical());
    const double factor = std::min({1.0, kOnTopM / side_m, kHighOnTopM / furniture.height_m().typical()});
    for (hb::Extent* extent : {furniture.mutable_width_m(), furniture.mutable_depth_m(), furniture.mutable_height_m()})
      if (from_floor) Scale(factor, *extent);
  }
  if (kind == hb::FURNITURE_KIND_WALL) {
    furniture.mutable_depth_m()->set_typical(std::min(furniture.depth_m().typical(), kOnWallM));
    furniture.set_elevation_m(std::max(0.5, kMiddleM - furniture.height_m().typical() / 2));
    furniture.set_gap_above_target_m(0.2);
  }
  if (kind == hb::FURNITURE_KIND_FLOOR) furniture.set_back(hb::BACK_RULE_PREFERS_WALL);
  return furniture;
}

// Tokens [begin, end) of a noun phrase without its article.
struct NounPhrase {
  std::size_t begin = 0;
  std::size_t end = 0;
};

class OwnFinder {
 public:
  OwnFinder(const Handbook& handbook, const std::vector<Token>& tokens, const std::vector<Mention>& mentions,
            const std::vector<bool>& used)
      : handbook_(handbook), tokens_(tokens), text_(tokens), used_(used), mention_at_(tokens.size(), nullptr) {
    for (const Mention& mention : mentions) {
      for (std::size_t i = mention.begin; i < mention.end; ++i) mention_at_[i] = &mention;
    }
  }

  std::vector<OwnClass> Find() {
    bool named_before = false;  // in the sentence
    std::size_t listed_to = 0;  // behind the last thing on a top, which others may follow without an article
    for (std::size_t i = 0; i < tokens_.size() && found_.size() < kMostClasses; ++i) {
      if (const Mention* mention = mention_at_[i]; mention != nullptr && i == mention->begin) {
        if (mention->furniture->named_as_said()) NameAsSaid(*mention);
        if (PhraseBefore("wall_mounted", tokens_, i)) HangUp(*mention->furniture);
        if (mention->furniture->kind() == hb::FURNITURE_KIND_SURFACE) listed_to = mention->end;
      }
      named_before = (named_before || mention_at_[i] != nullptr) && !text_.EndsSentence(i);
      const std::optional<NounPhrase> phrase = PhraseAt(i, listed_to, named_before);
      if (!phrase || !IsLeftOver(*phrase)) continue;
      Add(*phrase);
      listed_to = phrase->end;
      i = phrase->end - 1;
    }
    return std::move(found_);
  }

 private:
  bool Continues(std::size_t i) const {
    if (text_.IsHyphen(i)) return true;
    return (text_.IsWord(i) && !text_.Is(i, "thing_ends")) || (text_.IsNumber(i) && tokens_[i].glued);
  }

  // "a tin of pencils": the thing is the tin.
  std::optional<NounPhrase> PhraseAt(std::size_t i, std::size_t listed_to, bool named_before) const {
    const bool article =
        (text_.Is(i, "thing_articles") && text_.At(i) != "the") || NumberWord(text_.At(i)) || text_.IsNumber(i);
    const bool in_a_list = named_before && text_.Is(i, "listing") && text_.IsWord(i + 1) &&
                           !text_.Is(i + 1, "thing_articles") && !NumberWord(text_.At(i + 1));
    const bool listed = in_a_list || (listed_to > 0 && (i == listed_to || i == listed_to + 1) &&
                                      text_.Is(i, "listing") && !text_.Is(i + 1, "thing_articles") &&
                                      !NumberWord(text_.At(i + 1)) && !text_.IsNumber(i + 1));
    const bool held = text_.Is(i, "holding_words") && !text_.Is(i + 1, "thing_articles");
    if (!article && !listed && !held) return std::nullopt;
    NounPhrase phrase{i + 1, i + 1};
    while (phrase.end < tokens_.size() && Continues(phrase.end)) ++phrase.end;
    // "leaning", "neatly placed": said of the thing, not its name.
    while (phrase.end > phrase.begin + 1 && IsSaidOf(phrase.end - 1)) --phrase.end;
    if (phrase.end == phrase.begin || phrase.end > phrase.begin + kMostOfAPhrase) return std::nullopt;
    return phrase;
  }

  bool IsSaidOf(std::size_t i) const {
    const std::string_view word = text_.At(i);
    return word == "-" || word.ends_with("ly") ||
           ((word.ends_with("ing") || word.ends_with("ed")) && mention_at_[i] == nullptr && !text_.EndsSentence(i + 1));
  }

  // Whether its last word was not understood, and what was before it is at most a piece: "television remote".
  bool IsLeftOver(const NounPhrase& phrase) const {
    const std::size_t last = phrase.end - 1;
    const std::string_view noun = text_.At(last);
    if (IsFormIn("not_pieces", noun)) return false;
    if (IsOtherThing(phrase)) return true;
    if (used_[last] || !text_.IsWord(last) || IsAdjective(last)) return false;
    for (std::size_t i = phrase.begin; i < phrase.end; ++i) {
      if (used_[i] && mention_at_[i] == nullptr && !IsAdjective(i)) return false;
      // "The bathtub nestles into": a verb.
      if (mention_at_[i] != nullptr && noun.ends_with('s')) return false;
    }
    return !IsFormIn("no_things", noun) && !IsFormIn("no_things", text_.At(phrase.begin)) && !CountsPeople(noun) &&
           !IsIn("openings", noun) && !IsFormIn("wall_nouns", noun) && !IsIn("unit_words", noun) &&
           LongestAt(handbook_.vocabulary().rooms, tokens_, last, true).second == 0;
  }

  // "A luggage rack": what ends in the name of a class, and is none of it.
  bool IsOtherThing(const NounPhrase& phrase) const {
    for (std::size_t i = phrase.begin; i < phrase.end; ++i) {
      const bool other = std::ranges::any_of(handbook_.vocabulary().other_things, [&](const Phrase& thing) {
        const std::size_t length = thing.MatchAt(tokens_, i);
        return length > 0 && i + length == phrase.end;
      });
      if (other) return true;
    }
    return false;
  }

  bool IsAdjective(std::size_t i) const {
    const std::string_view word = text_.At(i);
    if (text_.IsNumber(i) || text_.IsHyphen(i) || text_.IsHyphen(i + 1)) return true;
    if (text_.Is(i, "looks") || text_.Is(i, "adjectives") || text_.Is(i, "materials")) return true;
    if (LongestAt(handbook_.vocabulary().colours, tokens_, i, false).second > 0) return true;
    return !text_.Is(i, "like_adjectives") &&
           std::ranges::any_of(WordsOf("adjective_endings"), [&](const std::string& ending) {
             return word.size() > ending.size() + 2 && word.ends_with(ending);
           });
  }

  // Its last words, without what says how it looks.
  std::string NameOf(NounPhrase phrase) const {
    while (phrase.begin + 1 < phrase.end &&
           (phrase.end - phrase.begin > kMostNameWords || IsAdjective(phrase.begin) || text_.IsHyphen(phrase.begin))) {
      ++phrase.begin;
    }
    std::string name;
    for (std::size_t i = phrase.begin; i < phrase.end; ++i) {
      const bool last = i + 1 == phrase.end;
      if (text_.IsWord(i))
        name += (name.empty() ? "" : " ") + (last ? english::Singular(tokens_[i].text) : tokens_[i].text);
    }
    return name;
  }

  // Only where a word of the class itself was said: "the table" after a poker table is that one.
  void NameAsSaid(const Mention& mention) {
    const std::string said = text_.Quote(mention.begin, mention.end), one = english::Singular(said);
    const auto& words = mention.furniture->synonyms();
    for (const std::string& name : {said, one}) {
      if (Includes(words, name)) return AddClass(*mention.furniture, name, false);
    }
  }

  void HangUp(const hb::Furniture& furniture) {
    constexpr double kFlatM = 0.4;
    const bool can = furniture.kind() == hb::FURNITURE_KIND_SURFACE ||
                     (IsOnTheFloor(furniture) && furniture.depth_m().typical() < kFlatM);
    if (!can || furniture.walk_over() || !names_.insert(furniture.name()).second) return;
    found_.push_back({CarriedBy(hb::FURNITURE_KIND_WALL, furniture), "", false});
  }

  void Add(const NounPhrase& phrase) {
    const std::string name = NameOf(phrase);
    if (name.empty()) return;
    for (std::size_t i = phrase.begin; i < phrase.end; ++i) {
      const auto [kin, length] = LongestAt(handbook_.vocabulary().names, tokens_, i, /*plural=*/true);
      if (length > 0 && i + length == phrase.end && !IsOtherThing(phrase)) return AddClass(*kin, name, false);
    }
    const hb::Furniture* const thing = PlainThing(hb::FURNITURE_KIND_FLOOR, handbook_);
    if (thing == nullptr) return;
    const std::size_t before = found_.size();
    AddClass(*thing, name, true);
    if (found_.size() > before) found_.back().listed = IsListed(phrase);
  }

  // "With a honey extractor, two kick wheels": not "for a farm", "a slice of life", "a piano we love" or "3 metres".
  bool IsListed(const NounPhrase& phrase) const {
    const auto known = mention_at_.begin() + static_cast<std::ptrdiff_t>(phrase.begin);
    const bool holds_a_piece =
        std::any_of(known, mention_at_.begin() + static_cast<std::ptrdiff_t>(phrase.end), [](auto* at) { return at; });
    const std::string_view noun = text_.At(phrase.end - 1);
    return phrase.begin >= 2 && text_.Is(phrase.begin - 2, "listing") && text_.At(phrase.end) != "of" &&
           !holds_a_piece && !IsFormIn("unit_words", noun) && !noun.ends_with("ing");
  }

  void AddClass(const hb::Furniture& kin, const std::string& name, bool unplaced) {
    if (!names_.insert(name).second || handbook_.FindFurniture(name) != nullptr) return;
    OwnClass own{kin, unplaced ? "" : kin.name(), unplaced};
    own.furniture.set_name(name);
    own.furniture.set_plural(english::Plural(name));
    own.furniture.clear_synonyms();
    own.furniture.clear_smaller();
    own.furniture.clear_named_as_said();
    if (unplaced) own.furniture.clear_category();
    found_.push_back(std::move(own));
  }

  const Handbook& handbook_;
  const std::vector<Token>& tokens_;
  const BriefText text_;
  const std::vector<bool>& used_;
  std::vector<const Mention*> mention_at_;  // of a token; null for none
  std::set<std::string> names_;
  std::vector<OwnClass> found_;
};

bool IsOneOfKinds(const hb::AskedPlace& asked, hb::FurnitureKind kind) {
  return std::ranges::find(asked.kinds(), static_cast<int>(kind)) != asked.kinds().end();
}

// What carries a thing that is placed so.
hb::FurnitureKind KindOf(const Place& place) {
  const hb::Furniture* target = place.target;
  const hb::AskedPlace& asked = *place.asked;
  const bool along = asked.carried() == hb::CARRIED_ALONG;
  if (asked.carried() != hb::CARRIED_UNSPECIFIED && !along) {
    return target != nullptr && target->walk_over() ? hb::FURNITURE_KIND_FLOOR : hb::FURNITURE_KIND_SURFACE;
  }
  if (!IsOneOfKinds(asked, hb::FURNITURE_KIND_FLOOR)) {
    if (IsOneOfKinds(asked, hb::FURNITURE_KIND_WALL)) return hb::FURNITURE_KIND_WALL;
    if (IsOneOfKinds(asked, hb::FURNITURE_KIND_CEILING)) return hb::FURNITURE_KIND_CEILING;
  }
  return target != nullptr && target->kind() == hb::FURNITURE_KIND_SURFACE ? hb::FURNITURE_KIND_SURFACE
                                                                           : hb::FURNITURE_KIND_FLOOR;
}

}  // namespace

std::vector<OwnClass> OwnClassesOf(const Handbook& handbook, const std::vector<Token>& tokens,
                                   const std::vector<Mention>& mentions, const std::vector<bool>& used) {
  return OwnFinder(handbook, tokens, mentions, used).Find();
}

std::vector<OwnClass> Placed(std::vector<OwnClass> classes, const BriefFacts& facts, const Handbook& handbook) {
  std::vector<OwnClass> placed;
  for (OwnClass& own : classes) {
    if (own.unplaced) {
      const auto place = std::ranges::find_if(
          facts.places, [&](const Place& one) { return one.furniture->name() == own.furniture.name(); });
      own.plain = place == facts.places.end();
      if (own.plain && !own.listed) continue;
      const hb::Furniture* thing = PlainThing(own.plain ? hb::FURNITURE_KIND_FLOOR : KindOf(*place), handbook);
      if (thing == nullptr) continue;
      const std::string name = own.furniture.name(), plural = own.furniture.plural();
      own.furniture = *thing;
      own.furniture.set_name(name);
      own.furniture.set_plural(plural);
      own.furniture.clear_named_as_said();
    }
    placed.push_back(std::move(own));
  }
  return placed;
}

std::vector<OwnClass> OtherwiseCarried(const BriefFacts& facts) {
  std::vector<OwnClass> all;
  std::set<std::string> names;
  for (const Place& place : facts.places) {
    const hb::Furniture& furniture = *place.furniture;
    const hb::FurnitureKind kind = KindOf(place);
    const bool same = IsOnTheFloor(furniture) ? kind == hb::FURNITURE_KIND_FLOOR : kind == furniture.kind();
    const bool has_its_own = std::ranges::any_of(facts.places, [&](const Place& other) {
      return other.furniture == &furniture && other.asked->carried() != hb::CARRIED_UNSPECIFIED && &other != &place &&
             KindOf(other) == furniture.kind();
    });
    if (has_its_own) continue;
    if (same || IsOfAnyKind(furniture) || !MayBeCarriedOtherwise(furniture, *place.asked)) continue;
    if (!names.insert(furniture.name()).second) continue;
    OwnClass& own = all.emplace_back(OwnClass{CarriedBy(kind, furniture), "", false});
    // A "floor plant" on a table is the "potted plant" of the brief.
    if (kind == hb::FURNITURE_KIND_SURFACE || furniture.name().starts_with("floor "))
      own.furniture.set_name(english::Singular(place.called));
    own.furniture.clear_plural();
    own.furniture.clear_synonyms();
    own.furniture.add_synonyms(place.called);
  }
  return all;
}

bool MayBeCarriedOtherwise(const hb::Furniture& furniture, const hb::AskedPlace& asked) {
  constexpr double kSmallM2 = 0.3, kHangsM2 = 0.7, kFlatM = 0.4;
  const double area_m2 = furniture.width_m().typical() * furniture.depth_m().typical();
  const bool floor = IsOnTheFloor(furniture);
  if (furniture.walk_over() || furniture.kind() == hb::FURNITURE_KIND_CEILING) return false;
  if (asked.carried() == hb::CARRIED_ON || asked.carried() == hb::CARRIED_IN) {
    return area_m2 <= kSmallM2;
  }
  const auto& text = asked.relation().text();
  const bool by_piece = text.find("{target}") != std::string::npos || text.find("{first}") != std::string::npos;
  if (by_piece || asked.carried() != hb::CARRIED_UNSPECIFIED) return false;
  if (asked.kinds().empty() || IsOneOfKinds(asked, hb::FURNITURE_KIND_FLOOR)) {
    return furniture.kind() == hb::FURNITURE_KIND_SURFACE && furniture.companions().empty();
  }
  if (IsOneOfKinds(asked, hb::FURNITURE_KIND_CEILING)) return area_m2 <= kHangsM2;
  return !floor || furniture.depth_m().typical() < kFlatM;
}

const hb::Furniture* PlainThing(hb::FurnitureKind kind, const Handbook& handbook) {
  const auto& all = handbook.contents().furniture();
  const auto thing = std::ranges::find_if(all, [&](const hb::Furniture& one) {
    return one.named_as_said() && one.synonyms().empty() && one.kind() == kind;
  });
  return thing == all.end() ? nullptr : &*thing;
}

}  // namespace flair::language
