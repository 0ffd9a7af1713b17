// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/own_classes.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "english/wordnet.h"
#include "english/words.h"
#include "language_worker/handbook/reading/other_words.h"
#include "language_worker/handbook/reading/piece_mentions.h"
#include "language_worker/handbook/reading/piece_words.h"
#include "language_worker/handbook/reading/place_patterns.h"
#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {
namespace {

constexpr std::size_t kMostOfAPhrase = 8;  // of a noun phrase
constexpr std::size_t kMostNameWords = 3;  // of a name
constexpr std::size_t kMostClasses = 40;
constexpr std::size_t kLongestName = 48;  // ids of objects are made from it

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
  bool counted = false;  // an article or a number stands before it
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
    for (std::size_t i = 0; i < tokens_.size() && found_.size() < kMostClasses; ++i) {
      if (const Mention* mention = mention_at_[i]; mention != nullptr && i == mention->begin) {
        if (mention->furniture->named_as_said()) NameAsSaid(*mention);
        if (PhraseBefore("wall_mounted", text_, i)) HangUp(*mention->furniture);
      }
      const std::optional<NounPhrase> phrase = PhraseAt(i);
      if (!phrase) continue;
      if (IsLeftOver(*phrase)) Add(*phrase);
      // A piece within it is still to be looked at.
      i = std::max(i, phrase->begin - 1);
    }
    return std::move(found_);
  }

 private:
  bool Continues(std::size_t i) const {
    if (text_.IsHyphen(i) || (text_.At(i) == "'s" && text_.IsWord(i + 1))) return true;
    if (text_.IsNumber(i)) return tokens_[i].glued;
    return text_.IsWord(i) && !text_.Is(i, "thing_ends") && !text_.Is(i, "pronouns") && !NumberWord(text_.At(i));
  }

  // The one that begins with an article or a number at `i`, or without one behind a word that lists things.
  std::optional<NounPhrase> PhraseAt(std::size_t i) const {
    const auto opens = [&](std::size_t k) {
      return (text_.Is(k, "thing_articles") && text_.At(k) != "the") || NumberWord(text_.At(k)) || text_.IsNumber(k);
    };
    const bool bare = (text_.Is(i, "listing") || text_.Is(i, "holding_words") || text_.Is(i, "having") ||
                       text_.At(i) == ":" || (text_.EndsSentence(i) && i + 1 < tokens_.size())) &&
                      text_.IsWord(i + 1) && !opens(i + 1);
    if ((!opens(i) && !bare) || (bare && text_.Is(i + 1, "thing_verbs"))) return std::nullopt;  // "keep 1.5 m free"
    NounPhrase phrase{i + 1, i + 1, opens(i)};
    const auto goes_on = [&](std::size_t k) {
      if (!text_.IsWord(k) || !text_.IsWord(k + 1) || text_.Is(k + 1, "thing_ends")) return false;
      return k == phrase.begin && text_.At(k).ends_with("ed");  // "stacked boxes"
    };
    // "two work stands", whose last word is a verb elsewhere.
    const auto is_counted_noun = [&](std::size_t k) {
      return k > phrase.begin && NumberWord(text_.At(i)).value_or(1) > 1 && text_.IsWord(k) &&
             !english::IsPlural(text_.At(k - 1)) && english::IsPlural(text_.At(k));
    };
    // "A host stand just inside": no verb, which would be "stands"; "display stands, ...": it stands nowhere.
    const auto is_noun = [&](std::size_t k) {
      const bool before = k > phrase.begin && text_.IsWord(k - 1) && !english::IsPlural(text_.At(k - 1));
      if (!before || !IsFormIn("thing_nouns", text_.At(k))) return false;
      const bool ends = k + 1 >= tokens_.size() || (text_.IsSign(k + 1) && !text_.IsHyphen(k + 1));
      return !english::IsPlural(text_.At(k)) || ends || text_.Says(k + 1, {"and", "with", "for"});
    };
    while (phrase.end < tokens_.size() &&
           (Continues(phrase.end) || goes_on(phrase.end) || is_counted_noun(phrase.end) || is_noun(phrase.end))) {
      ++phrase.end;
    }
    // "leaning", "neatly placed": said of the thing, not its name.
    while (phrase.end > phrase.begin + 1 && IsSaidOf(phrase.end - 1)) --phrase.end;
    // "Keep it plain" asks for no keep.
    if (bare && phrase.end == phrase.begin + 1 &&
        (text_.Is(phrase.end, "pronouns") || text_.Is(phrase.end, "articles")))
      return std::nullopt;
    // "One enters".
    if (text_.At(i) == "one" && phrase.end == phrase.begin + 1 && english::IsPlural(text_.At(phrase.begin)))
      return std::nullopt;
    if (phrase.end == phrase.begin || phrase.end > phrase.begin + kMostOfAPhrase) return std::nullopt;
    return phrase;
  }

  bool IsSaidOf(std::size_t i) const {
    const std::string_view word = text_.At(i);
    return word == "-" || word.ends_with("ly") || text_.Is(i, "said_behind") ||
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
      const bool verb = mention_at_[i] != nullptr && noun.ends_with('s');
      if (verb && !handbook_.vocabulary().meanings->ThingOf(noun).is_thing) return false;
    }
    const bool holds_a_piece =
        std::any_of(mention_at_.begin() + static_cast<std::ptrdiff_t>(phrase.begin),
                    mention_at_.begin() + static_cast<std::ptrdiff_t>(last), [](auto* at) { return at != nullptr; });
    // Behind a piece a rarer sense will do: a "car lift" is no help.
    constexpr std::size_t kUsual = 3, kInACompound = 8;
    const Thing thing = handbook_.vocabulary().meanings->ThingOf(text_.Quote(phrase.begin, phrase.end),
                                                                 holds_a_piece ? kInACompound : kUsual);
    // A "toy organizer" is nobody.
    const bool for_whom = phrase.begin > 1 && text_.Says(phrase.begin - 2, {"for", "of", "by"});
    const bool for_things = last > phrase.begin && noun.ends_with("er") && !IsAdjective(last - 1) && !for_whom;
    // A "service station" sells no petrol here.
    const bool surely = phrase.counted && last > phrase.begin && IsFormIn("thing_nouns", noun);
    const bool known = thing.known && !for_things && !surely;
    if (known ? !thing.is_thing : !phrase.counted && !holds_a_piece) return false;
    return !IsFormIn("no_things", noun) && !IsFormIn("no_things", text_.At(phrase.begin)) &&
           (for_things || !CountsPeople(noun)) && !IsIn("openings", noun) && !IsFormIn("wall_nouns", noun) &&
           !IsIn("unit_words", noun) && LongestAt(handbook_.vocabulary().rooms, tokens_, last, true).second == 0;
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
    if (text_.IsNumber(i) || text_.IsHyphen(i) || text_.IsHyphen(i + 1)) return true;
    if (text_.Is(i, "looks") || text_.Is(i, "adjectives") || text_.Is(i, "materials")) return true;
    if (LongestAt(handbook_.vocabulary().colours, tokens_, i, false).second > 0) return true;
    const std::string_view word = text_.At(i);
    return english::WordNet::Get().IsAdjective(word) && !handbook_.vocabulary().meanings->ThingOf(word).is_thing;
  }

  // Its last words, without what says how it looks.
  std::string NameOf(NounPhrase phrase) const {
    while (phrase.begin + 1 < phrase.end && (phrase.end - phrase.begin > kMostNameWords || IsAdjective(phrase.begin) ||
                                             text_.IsHyphen(phrase.begin) || text_.At(phrase.begin) == "'s")) {
      ++phrase.begin;
    }
    std::string name;
    for (std::size_t i = phrase.begin; i < phrase.end; ++i) {
      const bool last = i + 1 == phrase.end;
      if (text_.IsWord(i) && text_.At(i) != "'s")
        name += (name.empty() ? "" : " ") + (last ? english::Singular(tokens_[i].text) : tokens_[i].text);
    }
    return name;
  }

  // Only where a word of the class itself was said: "the table" after a poker table is that one. "A table" says no more
  // than the class's own name.
  void NameAsSaid(const Mention& mention) {
    const std::string said = text_.Quote(mention.begin, mention.end), one = english::Singular(said);
    const auto& words = mention.furniture->synonyms();
    for (const std::string& name : {said, one}) {
      if (Includes(words, name) && !mention.furniture->name().ends_with(name))
        return AddClass(*mention.furniture, name);
    }
  }

  void HangUp(const hb::Furniture& furniture) {
    constexpr double kFlatM = 0.4;
    const bool can = furniture.kind() == hb::FURNITURE_KIND_SURFACE ||
                     (IsOnTheFloor(furniture) && furniture.depth_m().typical() < kFlatM);
    if (!can || furniture.walk_over() || !names_.insert(furniture.name()).second) return;
    found_.push_back({.furniture = CarriedBy(hb::FURNITURE_KIND_WALL, furniture)});
  }

  void Add(const NounPhrase& phrase) {
    const std::string name = NameOf(phrase);
    if (name.empty() || name.size() > kLongestName || IsRefused(text_, phrase.begin)) return;
    const bool part = text_.BehindPhrase(phrase.begin, "parts_in_two_words").has_value();
    if (part || IsBorne(text_, phrase.end - 1, /*small=*/false)) return;
    for (std::size_t i = phrase.begin; i < phrase.end; ++i) {
      const auto [kin, length] = LongestAt(handbook_.vocabulary().names, tokens_, i, /*plural=*/true);
      if (length == 0 || i + length < phrase.end || IsOtherThing(phrase)) continue;
      const std::size_t before = found_.size();
      AddClass(*kin, name);
      // Nobody eats at an "overbed table".
      if (found_.size() > before && kin->category().ends_with("table")) found_.back().furniture.clear_companions();
      return;
    }
    const hb::Furniture* const thing = PlainThing(hb::FURNITURE_KIND_FLOOR, handbook_);
    if (thing == nullptr) return;
    const std::size_t before = found_.size();
    AddClass(*thing, name);
    if (found_.size() == before) return;
    OwnClass& own = found_.back();
    own.like = handbook_.vocabulary().meanings->ThingOf(name).like;
    if (own.like == nullptr) own.like = thing;
    own.unplaced = true;
    own.plain = own.like->named_as_said();
    own.listed = IsListed(phrase);
    own.furniture.clear_category();
    own.base = own.plain ? "" : own.like->name();
  }

  // Whether it is among what the room is to have: "with a honey extractor, two kick wheels and hive boxes", not "for a
  // farm", "a slice of life" or "jars of honey and spice".
  bool IsListed(const NounPhrase& phrase) const {
    if (text_.At(phrase.end - 1).ends_with("ing")) return false;
    // "My knees are bad" asks for none.
    const bool begins = phrase.begin < 2 || text_.EndsSentence(phrase.begin - 2);
    const bool is_so = text_.Says(phrase.end, {"is", "are", "was", "were"});
    if (begins && is_so && english::WordNet::Get().IsAdjective(text_.At(phrase.end + 1))) return false;
    if (text_.At(phrase.end) == "of") {
      const hb::Furniture* like = handbook_.vocabulary().meanings->ThingOf(text_.At(phrase.end - 1)).like;
      if (like == nullptr || !IsOnTheFloor(*like)) return false;  // a slice of life, not "stands of buckets"
    }
    bool counted = phrase.counted;
    for (std::size_t i = phrase.begin - (phrase.counted ? 1 : 0); i > 0; --i) {
      const std::size_t at = i - 1;
      if (used_[at] && mention_at_[at] == nullptr && text_.IsWord(at)) continue;
      if (text_.EndsSentence(at) || text_.At(at) == ":" || text_.Is(at, "having") || text_.Is(at, "holding_words")) {
        return true;
      }
      // What is listed behind a counted thing is a thing of the room, too.
      if (text_.Is(at, "listing") && counted) return true;
      if (text_.Is(at, "listing") || text_.IsHyphen(at)) continue;
      if (text_.Is(at, "not_in_a_list") || text_.Is(at, "thing_ends")) {
        const bool article = text_.Is(at, "thing_articles");
        if (!article) return false;
        counted = true;
        continue;
      }
      if (mention_at_[at] != nullptr || NumberWord(text_.At(at))) counted = true;
    }
    return false;  // the room itself
  }

  void AddClass(const hb::Furniture& kin, const std::string& name) {
    if (!names_.insert(name).second || handbook_.FindFurniture(name) != nullptr) return;
    OwnClass own{.furniture = kin, .base = kin.name()};
    own.furniture.set_name(name);
    own.furniture.set_plural(english::Plural(name));
    own.furniture.clear_synonyms();
    own.furniture.clear_smaller();
    own.furniture.clear_named_as_said();
    own.furniture.clear_meanings();
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
      if (place == facts.places.end() && !own.listed) continue;
      own.plain = own.plain && place == facts.places.end();
      const hb::FurnitureKind kind = place == facts.places.end() ? own.like->kind() : KindOf(*place);
      const hb::Furniture* thing = kind == own.like->kind() ? own.like : PlainThing(kind, handbook);
      if (thing == nullptr) continue;
      if (thing != own.like) own.base.clear();
      const std::string name = own.furniture.name(), plural = own.furniture.plural();
      own.furniture = *thing;
      own.furniture.set_name(name);
      own.furniture.set_plural(plural);
      own.furniture.clear_named_as_said();
      own.furniture.clear_synonyms();
      own.furniture.clear_meanings();
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
    OwnClass& own = all.emplace_back(OwnClass{.furniture = CarriedBy(kind, furniture)});
    // A "floor plant" on a table is the "potted plant" of the brief.
    if (kind == hb::FURNITURE_KIND_SURFACE || furniture.name().starts_with("floor "))
      own.furniture.set_name(english::Singular(place.called));
    own.furniture.clear_plural();
    own.furniture.clear_synonyms();
    own.furniture.add_synonyms(place.called);
  }
  return all;
}

const hb::Furniture* PlainThing(hb::FurnitureKind kind, const Handbook& handbook) {
  const auto& all = handbook.contents().furniture();
  const auto thing = std::ranges::find_if(all, [&](const hb::Furniture& one) {
    return one.named_as_said() && one.synonyms().empty() && one.meanings().empty() && one.kind() == kind;
  });
  return thing == all.end() ? nullptr : &*thing;
}

}  // namespace flair::language
