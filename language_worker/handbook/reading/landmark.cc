// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/landmark.h"

#include <algorithm>

#include "language_worker/handbook/reading/piece_mentions.h"

namespace flair::language {
namespace {

constexpr std::size_t kMostModifiers = 4;
constexpr std::size_t kMostDeterminers = 4;

bool IsOfTheRoom(Landmark::Kind kind) { return kind == Landmark::Kind::kWall || kind == Landmark::Kind::kCorner; }

}  // namespace

LandmarkReader::LandmarkReader(const std::vector<Token>& tokens, const PieceNames& names,
                               std::function<int(const hb::Furniture&)> rank)
    : tokens_(tokens), text_(tokens), names_(names), rank_(std::move(rank)), pieces_(tokens.size()) {}

Landmark LandmarkReader::Read(std::size_t start) const {
  Landmark landmark = Pronoun(start);
  if (landmark.kind != Landmark::Kind::kNone) return landmark;
  const std::size_t at = BehindDeterminers(start);
  // "The fire" is a name by itself.
  landmark = Noun(at > start && PieceAt(at - 1).second > 1 ? at - 1 : at);
  for (std::size_t i = start; i < at; ++i) {
    landmark.plural = landmark.plural || text_.At(i) == "two" || text_.At(i) == "2" || text_.At(i) == "both";
  }
  TakeSecond(landmark);
  if (IsOfTheRoom(landmark.kind)) TakeWhichOne(start, landmark);
  return landmark;
}

const LandmarkReader::Found& LandmarkReader::PieceAt(std::size_t i) const {
  if (!pieces_[i]) pieces_[i] = BestAt(names_, tokens_, i, /*plural=*/true, rank_);
  return *pieces_[i];
}

std::size_t LandmarkReader::BehindDeterminers(std::size_t i) const {
  const std::size_t start = i;
  while (i < start + kMostDeterminers && IsIn("determiners", text_.At(i))) ++i;
  return i;
}

// "them", "both of them", "the two", "each other".
Landmark LandmarkReader::Pronoun(std::size_t start) const {
  std::size_t at = start;
  while (at < start + kMostDeterminers && IsIn("before_pronouns", text_.At(at))) ++at;
  const bool each_other = (text_.At(at) == "other" && at > start && text_.At(at - 1) == "each") ||
                          (text_.At(at) == "one" && text_.At(at + 1) == "another");
  bool pronoun = each_other || IsIn("pronouns_for_things", text_.At(at));
  // "those chairs".
  if (text_.At(at).starts_with("th") && text_.At(at) != "them" && Noun(at + 1).kind != Landmark::Kind::kNone)
    pronoun = false;
  const bool counts =
      !pronoun && at > start && text_.Says(at - 1, {"two", "both", "each"}) &&
      (at == tokens_.size() || tokens_[at].kind == Token::Kind::kSign || IsIn("noun_ends", text_.At(at)));
  Landmark landmark;
  if (!pronoun && !counts) return landmark;
  landmark.kind = Landmark::Kind::kPronoun;
  landmark.plural = text_.At(at) != "it";
  landmark.each_other = each_other;
  landmark.end = counts ? at : at + (text_.At(at) == "one" ? 2 : 1);
  return landmark;
}

// The nearest noun that can be a landmark, behind words that describe it.
Landmark LandmarkReader::Noun(std::size_t start) const {
  Landmark landmark;
  for (std::size_t i = start; i < tokens_.size() && i <= start + kMostModifiers; ++i) {
    const auto& [piece, length] = PieceAt(i);
    const Landmark::Kind feature = FeatureAt(i);
    if (length > 1 || (length == 1 && feature == Landmark::Kind::kNone && FeatureAt(i + 1) == Landmark::Kind::kNone)) {
      landmark.kind = Landmark::Kind::kPiece;
      landmark.piece = piece;
      landmark.end = i + length;
      const auto any = [](const hb::Furniture&) { return 0; };
      landmark.plural = BestAt(names_, tokens_, i, /*plural=*/false, any).second < length;
      // "The desk surface", "the table's edge".
      std::size_t part = landmark.end;
      if (text_.At(part) == "'s") ++part;
      if (text_.Is(part, "parts_of_pieces")) landmark.end = part + 1;
      return landmark;
    }
    // "The window wall": the last of several nouns counts.
    if (feature != Landmark::Kind::kNone && FeatureAt(i + 1) == Landmark::Kind::kNone) {
      landmark.kind = feature;
      landmark.plural = tokens_[i].text.ends_with("s");
      landmark.end = i + 1;
      const bool itself = IsOfTheRoom(feature) || IsBehindADoor(text_, i);  // "near the closet"
      for (std::size_t k = start; k < i + (itself ? 1 : 0); ++k) {
        if (tokens_[k].kind == Token::Kind::kWord)
          landmark.side += (landmark.side.empty() ? "" : " ") + tokens_[k].text;
      }
      return landmark;
    }
    if (!Describes(i)) break;
  }
  return landmark;
}

// Whether a token may stand between an article and its noun.
bool LandmarkReader::Describes(std::size_t i) const {
  const Token& token = tokens_[i];
  if (token.kind == Token::Kind::kSign) return (token.text == "-" || token.text == "'") && token.glued;
  // "The row of desks", but not "each side of the bed".
  if (token.text == "of" && i > 0 && !IsFormIn("groups_of_pieces", text_.At(i - 1)) && !NumberWord(text_.At(i - 1)))
    return false;
  if (JoinsWalls(i)) return true;
  // "Opposite" and "near" relate, but describe walls and corners.
  return token.kind == Token::Kind::kWord &&
         (!IsIn("noun_ends", token.text) || (IsIn("told_sides", token.text) && IsOfTheRoom(FeatureAt(i + 1))));
}

// "The north and east walls".
bool LandmarkReader::JoinsWalls(std::size_t i) const {
  const std::size_t second = i + (text_.At(i + 1) == "the" ? 2 : 1);
  return text_.At(i) == "and" && i > 0 && text_.Is(i - 1, "told_sides") && text_.Is(second, "told_sides") &&
         text_.Is(second + 1, "wall_nouns") && text_.At(second + 1).ends_with('s');
}

Landmark::Kind LandmarkReader::FeatureAt(std::size_t i) const {
  if (IsIn("doors_of_the_room", text_.At(i)) || IsBehindADoor(text_, i)) return Landmark::Kind::kDoor;
  if (IsIn("windows_of_the_room", text_.At(i))) return Landmark::Kind::kWindow;
  if (IsIn("sockets_of_the_room", text_.At(i))) return Landmark::Kind::kSocket;
  if (text_.At(i) == "wall" || text_.At(i) == "walls") return Landmark::Kind::kWall;
  // "On three sides": of the room, where no piece follows.
  const bool sides = text_.At(i) == "sides" && i > 0 && text_.Says(i - 1, {"three", "four", "all"});
  if (sides && text_.At(i + 1) != "of") return Landmark::Kind::kWall;
  if (text_.At(i) == "corner" || text_.At(i) == "corners") return Landmark::Kind::kCorner;
  // "The east end", "the left hand side", "on the left", "across the back": the wall there.
  std::size_t told = i - (i > 0 ? 1 : 0);
  if (told > 1 && text_.At(told) == "hand") told -= text_.IsHyphen(told - 1) ? 2 : 1;
  const bool side =
      i > 0 && text_.Is(i, "ends_of_rooms_or_walls") && (text_.Is(told, "told_sides") || text_.At(told) == "one");
  const std::size_t the = i - (i > 1 && text_.At(i - 1) == "very" ? 2 : std::min<std::size_t>(i, 1));
  // "Facing south".
  const bool alone = i > 0 && text_.Is(i, "sides_by_themselves") && !JoinsWalls(i + 1) &&
                     (text_.Says(the, {"the", "your"}) || (text_.Is(i, "compass") && text_.Is(i - 1, "looking")));
  const bool sign = text_.IsSign(i + 1) && !text_.IsHyphen(i + 1);  // "the north-east corner"
  const bool ends = i + 1 >= tokens_.size() || sign || text_.Is(i + 1, "place_ends") ||
                    text_.Is(i + 1, "thing_articles") || text_.Is(i + 1, "pronouns") ||
                    text_.BehindPhrase(i + 1, "of_the_room") || text_.BehindPhrase(i + 1, "entering");
  return (side || alone) && ends ? Landmark::Kind::kWall : Landmark::Kind::kNone;
}

void LandmarkReader::TakeSecond(Landmark& landmark) const {
  const auto opening = [](Landmark::Kind kind) {
    return kind == Landmark::Kind::kDoor || kind == Landmark::Kind::kWindow;
  };
  if (!text_.Says(landmark.end, {"and", "from"}) ||
      (landmark.kind != Landmark::Kind::kPiece && !opening(landmark.kind)))
    return;
  const Landmark next = Noun(BehindDeterminers(landmark.end + 1));
  const bool piece = next.kind == Landmark::Kind::kPiece;
  if (!(piece || (opening(next.kind) && landmark.piece != nullptr))) return;
  landmark.beside = piece ? (landmark.piece != nullptr ? Landmark::Kind::kNone : landmark.kind) : next.kind;
  (landmark.piece != nullptr ? landmark.second : landmark.piece) = next.piece;
  landmark.second_end = next.end;
}

// Keeps of the words before it those that say which wall or corner, and reads those behind it: "the wall opposite the
// door", "the corner of the room".
void LandmarkReader::TakeWhichOne(std::size_t start, Landmark& landmark) const {
  std::string sides;
  const auto add = [&](std::string_view side) { sides += (sides.empty() ? "" : " ") + std::string(side); };
  for (const Token& word : TokensOf(landmark.side)) {
    if (word.text == "other") {
      add("opposite");
    } else if (IsIn("told_sides", word.text)) {
      add(word.text);
    } else if (IsIn("blank_walls", word.text)) {
      add("blank");
    }
  }
  // "At one end", "on one side".
  if (landmark.end > 1 && text_.At(landmark.end - 2) == "one" && text_.Is(landmark.end - 1, "ends_of_rooms_or_walls")) {
    add(text_.At(landmark.end - 1) == "end" ? "short" : "long");
  }
  const auto by = text_.BehindPhrase(landmark.end, "by_openings");
  const bool as = text_.At(landmark.end) == "as";
  if ((by || as) && sides.empty() && landmark.kind == Landmark::Kind::kWall) {
    // "The wall near the entrance" is that with it; "the same wall as the window".
    const std::size_t at = BehindDeterminers(as ? landmark.end + 1 : *by);
    const bool door = FeatureAt(at) == Landmark::Kind::kDoor;
    const bool window = as && FeatureAt(at) == Landmark::Kind::kWindow;
    if (door || window) add(door ? "door" : "window");
    if (door || window) landmark.end = at + 1;
  }
  if (landmark.kind == Landmark::Kind::kCorner) {
    for (std::size_t i = start; i < landmark.end; ++i) {
      if (text_.Is(i, "other_corners")) sides = "opposite";
      // "In one of the far corners" is one of them.
      const bool several = text_.At(i) == "corners" && !(start > 0 && text_.At(start - 1) == "of");
      const bool each = text_.Says(i, {"each", "every", "all", "four"}) || several;
      if (each && !sides.starts_with("each")) sides = sides.empty() ? "each" : "each " + sides;
    }
    // "The corner left of the door": as those see it who come in.
    const std::size_t hand = landmark.end + (text_.Says(landmark.end, {"to", "on"}) ? 2 : 0);
    if (sides.empty() && text_.Says(hand, {"left", "right"}) && text_.At(hand + 1) == "of" &&
        FeatureAt(BehindDeterminers(hand + 2)) == Landmark::Kind::kDoor) {
      sides = "near " + std::string(text_.At(hand));
      landmark.end = BehindDeterminers(hand + 2) + 1;
    }
    // "The corner by the kitchen door".
    if (by && sides.empty()) {
      for (std::size_t at = BehindDeterminers(*by), most = std::min(at + 3, tokens_.size()); at < most; ++at) {
        const Landmark::Kind feature = FeatureAt(at);
        if (feature == Landmark::Kind::kNone && Describes(at)) continue;
        if (feature == Landmark::Kind::kDoor) add("at door");
        if (feature == Landmark::Kind::kWindow) add("at window");
        if (!sides.empty()) landmark.end = at + 1;
        break;
      }
    }
  }
  const std::string_view how = text_.At(landmark.end);
  const bool two_words = text_.At(landmark.end + 1) == "from";
  const bool opposite = how == "opposite" || how == "facing" || (how == "across" && two_words);
  const bool farthest = text_.Says(landmark.end, {"far", "farthest", "furthest", "away"}) && two_words;
  if (opposite || farthest || how == "with" || how == "without") {
    const std::size_t at = BehindDeterminers(landmark.end + (two_words ? 2 : 1));
    const Landmark::Kind feature = FeatureAt(at);
    const bool door = feature == Landmark::Kind::kDoor, window = feature == Landmark::Kind::kWindow;
    if (door) add(opposite || farthest ? "far" : how == "with" ? "door" : "blank");
    if (window) add(opposite || farthest ? "across window" : how == "with" ? "window" : "blank");
    if (door || window) landmark.end = at + 1;
    // "The wall across from it", "the wall opposite the bed".
    const Landmark piece = door || window || !opposite ? Landmark() : Pronoun(at).end > 0 ? Pronoun(at) : Noun(at);
    if (piece.end > 0) add("opposite");
    landmark.end = std::max(landmark.end, piece.end);
  }
  // "The wall to the left as you walk in."
  const std::size_t told = landmark.end + 2;
  if (text_.Says(landmark.end, {"to", "on"}) && text_.Is(told - 1, "determiners") &&
      FeatureAt(told) == Landmark::Kind::kWall) {
    add(text_.At(told));
    landmark.end = told + 1;
  }
  if (const auto faced = text_.BehindPhrase(landmark.end, "faced_entering");
      faced && sides.empty() && landmark.kind == Landmark::Kind::kWall) {
    add("far");
    landmark.end = *faced;
  }
  if (const auto entering = text_.BehindPhrase(landmark.end, "entering")) landmark.end = *entering;
  // "The wall opposite", of what was spoken of before.
  if (how == "opposite" && how.data() == text_.At(landmark.end).data() &&
      (landmark.end + 1 >= text_.size() || text_.IsSign(landmark.end + 1))) {
    add("opposite");
    ++landmark.end;
  }
  landmark.end = text_.BehindPhrase(landmark.end, "of_the_room").value_or(landmark.end);
  landmark.side = sides;
}

}  // namespace flair::language
