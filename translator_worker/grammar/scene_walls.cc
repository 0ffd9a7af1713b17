// SPDX-License-Identifier: GPL-3.0-or-later
// The part of SceneNames that finds walls and corners, as people call them: "the shorter south wall", "the 1.50 m north
// wall", "the far wall", "the wall with the window", "the north-east corner".
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <string_view>

#include "absl/strings/str_join.h"
#include "room/geometry/pose.h"
#include "translator_worker/grammar/scene_names.h"

namespace flair::translator {
namespace {

// Lists of words by quarter turns counter-clockwise: those of the compass from the south, others from the door's wall.
constexpr std::array kCompassTurns = {"southern_walls", "eastern_walls", "northern_walls", "western_walls"};
constexpr std::array kTurnsFromTheDoor = {"near_walls", "right_walls", "far_walls", "left_walls"};
constexpr std::array<Vec2<double>, 4> kOutward = {{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
constexpr double kSameLength_m = 0.02;

// "Northeast" as its two words.
std::vector<Token> SplitCompass(std::vector<Token> tokens) {
  constexpr size_t kFirst = 5;
  for (size_t i = 0; i < tokens.size(); ++i) {
    if (!english::IsIn("compass_corners", tokens[i])) continue;
    Token second = tokens[i];
    second.text = second.text.substr(kFirst);
    tokens[i].text.resize(kFirst);
    tokens.insert(tokens.begin() + static_cast<long>(i) + 1, second);
  }
  return tokens;
}

std::optional<int> CompassTurn(const Token& token) {
  const auto list = std::ranges::find_if(kCompassTurns, [&](const char* one) { return english::IsIn(one, token); });
  return list == kCompassTurns.end() ? std::nullopt : std::optional<int>(list - kCompassTurns.begin());
}

// The walls that are left of all, word by word.
class WallChoice {
 public:
  explicit WallChoice(const v1::Room& room) : room_(room), walls_(room.walls_size()) {
    std::iota(walls_.begin(), walls_.end(), 0);
  }

  // False for a word that tells no wall.
  bool Take(const Token& token) {
    if (token.kind == Token::Kind::kLength && token.length.exact) {
      Keep([&](int wall) { return std::abs(LengthOf(wall) - token.length.Nominal()) < kSameLength_m; });
    } else if (const std::optional<int> turn = Turn(token)) {
      turns_.push_back(*turn);
    } else if (english::IsIn("long_or_short", token)) {
      longest_ = token.text.starts_with("long");
    } else if (const bool window = token.text.starts_with("window");
               english::IsIn("openings_of_walls", token) && AnyHas(window)) {
      Keep([&](int wall) { return Has(wall, window); });
    } else if (token.IsWord("blank")) {
      Keep([&](int wall) { return !Has(wall, false) && !Has(wall, true); });
    } else {
      return false;
    }
    return true;
  }

  // Those across from what was told so far.
  void Cross() {
    const std::vector<int> told = Chosen();
    walls_ = WallChoice(room_).walls_;
    turns_.clear();
    longest_.reset();
    Keep([&](int wall) {
      return std::ranges::any_of(told, [&](int other) { return (Heading(other) + 2) % 4 == Heading(wall); });
    });
  }

  // Of equals all: "a long wall" is either.
  std::vector<int> Chosen() {
    if (turns_.size() == 1) Keep([&](int wall) { return Heading(wall) == turns_[0]; });
    if (turns_.size() > 1) Keep([&](int wall) { return Looks(wall, turns_[0]) && Looks(wall, turns_[1]); });
    double best_m = 0;
    for (const int wall : walls_) {
      const double length_m = LengthOf(wall);
      if (longest_ && (best_m == 0 || (*longest_ ? length_m > best_m : length_m < best_m))) best_m = length_m;
    }
    if (longest_) Keep([&](int wall) { return std::abs(LengthOf(wall) - best_m) < kSameLength_m; });
    return walls_;
  }

 private:
  template <typename Wanted>
  void Keep(const Wanted& wanted) {
    std::erase_if(walls_, [&](int wall) { return !wanted(wall); });
  }

  Vec2<double> Along(int wall) const {
    const auto& corners = room_.floor().vertices();
    const auto &a = corners[wall], &b = corners[(wall + 1) % corners.size()];
    return {b.x_m() - a.x_m(), b.y_m() - a.y_m()};
  }

  double LengthOf(int wall) const { return std::hypot(Along(wall).x, Along(wall).y); }

  // 0 for a wall in the south, 1 for one in the east and so on.
  int Heading(int wall) const {
    const Vec2<double> along = Along(wall);
    if (std::abs(along.x) > std::abs(along.y)) return along.x > 0 ? 0 : 2;
    return along.y > 0 ? 1 : 3;
  }

  // Whether it looks that way at least half: walls of the north-east look north and east.
  bool Looks(int wall, int turn) const {
    const Vec2<double> along = Along(wall);
    return Dot(Vec2<double>{along.y, -along.x}, kOutward[turn]) > 0.38 * LengthOf(wall);
  }

  bool AnyHas(bool window) const {
    return std::ranges::any_of(walls_, [&](int wall) { return Has(wall, window); });
  }

  bool Has(int wall, bool window) const {
    return std::ranges::any_of(room_.openings(), [&](const v1::Opening& one) {
      return one.wall() == room_.walls(wall).name() && (one.kind() == v1::OPENING_KIND_WINDOW) == window;
    });
  }

  // As on the plan, or as whoever comes in by the first door sees it.
  std::optional<int> Turn(const Token& token) const {
    if (const std::optional<int> turn = CompassTurn(token)) return turn;
    if (english::IsIn("walls_by_other_things", token)) return std::nullopt;
    int door = 0;
    while (door < room_.walls_size() && !Has(door, false)) ++door;
    for (size_t turn = 0; turn < kTurnsFromTheDoor.size(); ++turn) {
      if (english::IsIn(kTurnsFromTheDoor[turn], token))
        return (turn + (door < room_.walls_size() ? Heading(door) : 0)) % 4;
    }
    return std::nullopt;
  }

  const v1::Room& room_;
  std::vector<int> walls_;
  std::vector<int> turns_;
  std::optional<bool> longest_;
};

std::string NamesOf(const v1::Room& room, const std::vector<int>& walls) {
  return absl::StrJoin(walls, "|", [&](std::string* out, int wall) { out->append(room.walls(wall).name()); });
}

}  // namespace

SceneNames::Found SceneNames::FindWall(const std::vector<Token>& said, size_t at) const {
  Found found;
  found.reference.kind = RefKind::kWall;
  const auto word = [&](size_t i, std::string_view text) { return i < said.size() && said[i].IsWord(text); };
  for (const v1::Wall& wall : room_.walls()) {
    const std::vector<std::string> words = NameWords(wall.name());
    size_t i = 0;
    while (i < words.size() && at + i < said.size() && said[at + i].text == words[i]) ++i;
    if (words.empty() || i < words.size() || (words.front() != "wall" && !word(at + i, "wall"))) continue;
    found.reference.name = wall.name();
    found.length = i + (words.front() == "wall" ? 0 : 1);
    return found;
  }
  if (room_.walls_size() < 3 || room_.walls_size() != room_.floor().vertices_size()) return {};
  WallChoice choice(room_);
  size_t end = at;
  const auto take = [&](const Token& token) {
    const std::vector<Token> words = SplitCompass({token});
    return std::ranges::all_of(words, [&](const Token& one) { return choice.Take(one); });
  };
  while (end < said.size() && take(said[end])) ++end;
  if (!word(end, "wall")) return {};
  const bool told = end++ > at;
  // "With the window", "opposite the door".
  size_t next = end;
  const bool across = next < said.size() && english::IsIn("across_from", said[next]);
  if (across || word(next, "with")) ++next;
  if (word(next, "from")) ++next;
  const bool article = next < said.size() && IsOneOf(said[next], {"the", "a", "its"});
  next += article ? 1 : 0;
  const bool by_opening = next > end && next < said.size() && english::IsIn("openings_of_walls", said[next]);
  if (by_opening && choice.Take(said[next])) {
    if (across) choice.Cross();
    end = next + 1;
  }
  if (!told && !by_opening) return {};
  found.length = end - at;
  found.reference.name = NamesOf(room_, choice.Chosen());
  found.reference.missing = found.reference.name.empty();
  return found;
}

SceneNames::Found SceneNames::FindCorner(const std::vector<Token>& said, size_t at) const {
  Found found;
  if (room_.walls_size() < 3 || room_.walls_size() != room_.floor().vertices_size()) return found;
  std::vector<Token> turns;
  size_t end = at;
  while (end < said.size() && (CompassTurn(said[end]) || english::IsIn("compass_corners", said[end])))
    turns.push_back(said[end++]);
  turns = SplitCompass(turns);
  if (turns.empty() || turns.size() > 2 || end >= said.size() || !said[end].IsWord("corner")) return found;
  WallChoice first(room_), second(room_);
  first.Take(turns.front());
  second.Take(turns.back());
  found.length = end + 1 - at;
  found.reference.kind = RefKind::kCorner;
  found.reference.name = NamesOf(room_, first.Chosen());
  found.reference.opening = NamesOf(room_, second.Chosen());
  found.reference.missing = found.reference.name.empty() || found.reference.opening.empty();
  return found;
}

}  // namespace flair::translator
