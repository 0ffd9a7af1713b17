// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/for_each.h"

#include <algorithm>
#include <optional>

#include "language_worker/handbook/reading/other_words.h"
#include "language_worker/handbook/reading/piece_words.h"

namespace flair::language {
namespace {

class EachReader {
 public:
  EachReader(const BriefText& text, const std::vector<bool>& used, const std::vector<Mention>& mentions,
             const std::vector<Wish>& wishes, int people)
      : text_(text), used_(used), mentions_(mentions), wishes_(wishes), people_(people) {}

  // "One nightstand and one visitor's chair per bed", "a chair at each".
  std::optional<int> Behind(std::size_t end) const {
    constexpr std::size_t kMostToPer = 9, kMostWords = 5, kMostListed = 14;
    for (std::size_t k = end; k < end + kMostToPer && !text_.EndsSentence(k) && text_.At(k) != "with"; ++k) {
      if (text_.At(k) == "per" && !text_.Is(k + 1, "unit_words")) return Of(CountsPeople(text_.At(k + 1)));
    }
    // "Three boys, a bed, a desk and a chair each": so many of all that is listed.
    bool listed = false;
    for (std::size_t k = end; k < end + (listed ? kMostListed : kMostWords) && k < text_.size(); ++k) {
      const bool joint = people_ > 1 && text_.Says(k, {",", "and"}) && text_.Is(k + 1, "thing_articles");
      listed = listed || joint;
      if (!joint && (used_[k] || text_.IsSign(k) || text_.Says(k, {"and", "with"}))) break;
      if (!IsEach(k) || !text_.Says(k, {"each", "every"})) continue;
      const bool closes = k + 1 >= text_.size() || text_.IsSign(k + 1);
      if (listed) return closes && !text_.Is(k - 1, "unit_words") ? std::optional(people_) : std::nullopt;
      const bool ends =
          text_.Says(k + 1, {"one", "of", "table", "desk", "bed", "seat"}) || closes || text_.Is(k + 1, "thing_ends");
      if (ends || CountsPeople(text_.At(k + 1))) return Of(text_.At(k - 1) == "for");
    }
    return std::nullopt;
  }

  // "Each needs his own bed, own desk and own shelf", "three guests, each with a microphone", "both want an own desk".
  std::optional<int> Before(std::size_t begin) const {
    for (std::size_t at = begin; at > 0 && !text_.EndsSentence(at - 1); --at) {
      const bool both = text_.At(at - 1) == "both";
      if (!both && !IsEach(at - 1)) continue;
      constexpr std::size_t kMostToVerb = 4;
      std::size_t verb = at;
      while (verb < at + kMostToVerb && !text_.Is(verb, "getting")) ++verb;
      if (verb == at + kMostToVerb || verb >= begin || EndsBetween(verb, begin)) return std::nullopt;
      // "We both need a sofa" is for one sofa, "both need their own desk" for two desks.
      while (both && verb < begin && text_.At(verb) != "own") ++verb;
      return verb == begin ? std::nullopt : both ? std::optional(2) : Sharers(at - 1, verb);
    }
    return std::nullopt;
  }

 private:
  bool IsEach(std::size_t i) const {
    const bool corners = text_.At(i + 1) == "of" && (text_.Is(i + 3, "corners") || text_.Is(i + 4, "corners"));
    return text_.Is(i, "each_words") && !text_.Says(i + 1, {"side", "end", "wall", "corner", "other", "way"}) &&
           !corners;
  }

  // Of the people, or of what was asked for last.
  std::optional<int> Of(bool people) const {
    if ((people || (!wishes_.empty() && wishes_.back().count == 1)) && people_ > 0) return people_;
    return wishes_.empty() ? std::nullopt : std::optional<int>(wishes_.back().count);
  }

  // Whether a list of what each has, which begins at `verb`, is over before `i`: ", with a curtain between them".
  bool EndsBetween(std::size_t verb, std::size_t i) const {
    for (std::size_t k = verb + 1; k < i; ++k) {
      if (text_.At(k) != ",") continue;
      const std::size_t next = text_.At(k + 1) == "and" ? k + 2 : k + 1;
      if (text_.At(next) == "with") return true;
      if (text_.At(verb) == "with" && !text_.Says(next, {"its", "their", "his", "her", "own"})) return true;
    }
    return false;
  }

  // How many "each" at `at` speaks of: the pieces, or groups of them, that stand right by it, else people.
  std::optional<int> Sharers(std::size_t at, std::size_t verb) const {
    constexpr std::size_t kMostBetween = 12;
    for (auto mention = mentions_.rbegin(); mention != mentions_.rend(); ++mention) {
      if (mention->begin > at && mention->begin < verb) return mention->count;
      const bool near = mention->end <= at && at - mention->end <= (text_.At(verb) == "with" ? kMostBetween : 2);
      if (!near || EndsSentenceBetween(mention->end, at) || CountsPeople(text_.At(at + 1))) continue;
      const auto wish = std::ranges::find(wishes_, mention->furniture, &Wish::furniture);
      if (wish != wishes_.end() && wish->in_each > 0 && IsInGroups(mention->begin)) return wish->count / wish->in_each;
      return mention->count;
    }
    return people_ > 1 ? std::optional<int>(people_) : std::nullopt;
  }

  bool EndsSentenceBetween(std::size_t begin, std::size_t end) const {
    while (begin < end && !text_.EndsSentence(begin)) ++begin;
    return begin < end;
  }

  // "Groups of three armchairs".
  bool IsInGroups(std::size_t noun) const {
    constexpr std::size_t kMostBack = 4;
    for (std::size_t k = noun - std::min(noun, kMostBack); k < noun; ++k) {
      if (IsFormIn("groups_of_pieces", text_.At(k))) return true;
    }
    return false;
  }

  const BriefText& text_;
  const std::vector<bool>& used_;
  const std::vector<Mention>& mentions_;
  const std::vector<Wish>& wishes_;
  const int people_;
};

// What is told of walls: how many of them, and which sides of the room they are.
struct Walls {
  int count = 0;
  bool is_long = false, is_short = false;
};

// "Along the long wall", "on three walls", "lining the walls"; pieces "on the wall" are not a row of them.
Walls WallsBehind(const BriefText& text, std::size_t end) {
  constexpr std::size_t kMostWords = 7;
  constexpr int kAll = 3;  // the fourth has the door
  Walls walls;
  bool along = false, all = false;
  int number = 0;
  for (std::size_t i = end; i < end + kMostWords && i < text.size() && !text.IsSign(i); ++i) {
    if (text.Says(i, {"and", "with", "for"})) break;
    along = along || text.Is(i, "along_walls");
    all = all || text.Says(i, {"all", "every", "each"});
    walls.is_long = walls.is_long || text.At(i) == "long";
    walls.is_short = walls.is_short || text.At(i) == "short";
    if (const auto said = NumberWord(text.At(i)); said && !text.Is(i, "articles")) number = *said;
    if (!IsFormIn("wall_nouns", text.At(i))) continue;
    const bool many = text.At(i).ends_with('s') || number > 1;
    if (!many) {
      walls.count = along ? 1 : 0;
    } else {
      walls.count = number > 0 ? std::min(number, kAll) : (all || along ? kAll : 0);
    }
    break;
  }
  return walls;
}

}  // namespace

int TimesForEach(const BriefText& text, const std::vector<bool>& used, std::size_t begin, std::size_t end,
                 const std::vector<Mention>& mentions, const std::vector<Wish>& wishes, int people) {
  const EachReader reader(text, used, mentions, wishes, people);
  const std::optional<int> behind = reader.Behind(end);
  return std::max(1, behind ? *behind : reader.Before(begin).value_or(1));
}

int CountAlongWalls(const BriefText& text, const hb::Furniture& furniture, std::size_t end, const BriefFacts& facts) {
  constexpr double kShareOfWall = 0.65, kShareOfFloor = 0.14;
  constexpr int kMostAtAWall = 6;
  if (!IsFloorPiece(furniture) || furniture.back() != hb::BACK_RULE_WALL || PlacesOn(furniture) > 0) return 0;
  const Walls walls = WallsBehind(text, end);
  if (walls.count == 0) return 0;
  const hb::Archetype& room = *facts.archetype;
  const double width_m = facts.size.width_m.value_or(room.width_m().typical());
  const double depth_m = facts.size.depth_m.value_or(room.depth_m().typical());
  const double side_m = walls.is_long    ? std::max(width_m, depth_m)
                        : walls.is_short ? std::min(width_m, depth_m)
                                         : (width_m + depth_m) / 2;
  const double piece_m = furniture.width_m().typical(), piece_m2 = piece_m * furniture.depth_m().typical();
  const int at_each = std::clamp(static_cast<int>(kShareOfWall * side_m / piece_m), 2, kMostAtAWall);
  const int most = static_cast<int>(kShareOfFloor * width_m * depth_m / piece_m2);
  return std::max(2, std::min(walls.count * at_each, most));
}

}  // namespace flair::language
