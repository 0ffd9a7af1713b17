// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/sentences/places.h"

#include <algorithm>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "english/language.h"
#include "session/layouts/directions.h"

namespace flair::session {
namespace {

constexpr std::string_view kSentence = "sentence ";

// The one form of a list.
std::string FormOf(const std::string& list_name) {
  for (const auto& list : english::Language::Get().data().lists()) {
    if (list.name() == list_name && !list.words().empty()) return list.words(0);
  }
  return "";
}

void FillSlot(std::string& text, std::string_view what, const std::string& by) {
  const size_t at = text.find(what);
  if (at != std::string::npos) text.replace(at, what.size(), by);
}

// Where a place is "to" something, how one stands there.
std::string PlaceAt(const Spoken& spoken, const v1::SolvedLayout& layout, const Room& room) {
  static const WordMeanings to("places: to"), targets("target: ");
  const Tokens tokens = PlainTokens(spoken.place);
  size_t begin = 0;
  for (size_t length = 1; length <= 2 && length < tokens.size(); ++length) {
    if (to.Find(tokens, {0, length}) != nullptr) begin = length;
  }
  // "Against the opposite wall", too.
  size_t target_at = begin;
  if (begin == 0 && tokens.size() > 1) target_at = 1;
  const std::string* const kind = targets.Find(tokens, {target_at, tokens.size()});
  const v1::Placement* const at = PlaceOf(layout, spoken.what.ids.front());
  if (kind != nullptr && *kind == "opposite wall" && at != nullptr) {
    const int wall = OppositeWall(room, NearestWall(room, *at));
    if (wall >= 0) return "against " + WallName(room, room.walls[wall]);
  }
  if (begin == 0) return spoken.place;
  const std::string rest = spoken.place.substr(tokens[begin].begin);
  if (kind != nullptr) return (*kind == "middle" ? "in " : *kind == "wall" ? "against " : "near ") + rest;
  const std::string& last = tokens.back().text;
  if (last == "wall") return "against " + rest;
  if (last == "corner") return "in " + rest;
  if (tokens[begin].IsWord("left") || tokens[begin].IsWord("right")) return spoken.place;
  return (tokens.size() > begin + 1 && tokens[begin + 1].IsWord("left")) ||
                 (tokens.size() > begin + 1 && tokens[begin + 1].IsWord("right"))
             ? spoken.place
             : "next to " + rest;
}

}  // namespace

std::optional<std::vector<WishedSentence>> PlacesSaid(const Spoken& spoken, const v1::SolvedLayout& layout,
                                                      const Room& room) {
  WishedSentence wished{.said = spoken.said, .about = spoken.what.ids};
  if (spoken.act == "place") {
    if (spoken.what.is_all || spoken.what.ids.empty()) return std::nullopt;
    if (spoken.what.is_one) wished.about.resize(1);
    const char* const verb = wished.about.size() > 1 ? "are" : "is";
    wished.text = absl::StrCat("The {} ", verb, " ", PlaceAt(spoken, layout, room));
    return std::vector<WishedSentence>{wished};
  }
  if (!spoken.act.starts_with(kSentence)) return std::nullopt;
  if (spoken.what.is_one) wished.about.resize(1);
  wished.text = FormOf("edited: " + spoken.act.substr(kSentence.size()));
  FillSlot(wished.text, "{what}", "{}");
  std::string target = spoken.target.said;
  if (target.starts_with("the ")) target = target.substr(4);
  FillSlot(wished.text, "{target}", target);
  return std::vector<WishedSentence>{wished};
}

std::vector<WishedSentence> WithCorners(const WishedSentence& wished, const v1::Room& room) {
  std::string low = absl::AsciiStrToLower(wished.text);
  std::ranges::replace(low, '-', ' ');
  for (const char* const one : {"north", "south"}) {
    for (const char* const other : {"east", "west"}) {
      const auto has = [&](std::string_view name) {
        return std::ranges::any_of(room.walls(), [&](const v1::Wall& wall) { return wall.name() == name; });
      };
      if (!has(one) || !has(other)) continue;
      for (const std::string& corner :
           {absl::StrCat(one, " ", other, " corner"), absl::StrCat(one, other, " corner")}) {
        const size_t at = low.find(corner);
        if (at == std::string::npos) continue;
        // Its back is at one of them.
        WishedSentence in_corner = wished, at_one = wished, at_other = wished;
        in_corner.text = absl::StrCat(wished.text.substr(0, at), "corner", wished.text.substr(at + corner.size()));
        at_one.text = absl::StrCat("The {} is against the ", one, " wall");
        at_other.text = absl::StrCat("The {} is near the ", other, " wall");
        return {in_corner, at_one, at_other};
      }
    }
  }
  return {wished};
}

}  // namespace flair::session
