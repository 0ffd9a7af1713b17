// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/finishes.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "language_worker/handbook/reading/brief_facts.h"

namespace flair::language {
namespace {

using Surface = AskedFinish::Surface;

void Append(std::string_view word, std::string& words) {
  if (!words.empty()) words += ' ';
  words += word;
}

class FinishReader : Reading {
 public:
  explicit FinishReader(const Reading& reading) : Reading(reading) {}

  void Read() {
    for (std::size_t i = 0; i < tokens().size(); ++i) {
      if (used[i] || !text.IsWord(i)) continue;
      const std::optional<Surface> surface = SurfaceAt(i);
      if (!surface || Has(*surface)) continue;
      AskedFinish finish{.surface = *surface};
      // "Parquet" and "wallpaper" say by themselves what the surface is of.
      if (text.Is(i, "floor_finishes") || text.Is(i, "wall_finishes")) finish.material = text.At(i);
      std::size_t begin = i, end = i + 1;
      while (text.Is(end, "finish_materials")) Append(text.At(end++), finish.material);
      ReadBefore(BeforeUnderfoot(i), begin, finish);
      // "A Persian carpet" lies on the floor.
      if (text.Is(i, "carpets") && HasArticle(begin)) continue;
      if (finish.material.empty() && finish.colour == nullptr) ReadBehind(end, end, finish);
      if (finish.material.empty() && *surface == Surface::kFloor && IsWashedDown(i)) finish.material = "sealed tile";
      if (finish.material.empty() && finish.colour == nullptr) continue;
      Use(begin, end);
      finish.begin = begin;
      finish.end = end;
      facts.finishes.push_back(std::move(finish));
    }
  }

 private:
  // "The north wall" and "a wall" are places; all walls are a surface.
  std::optional<Surface> SurfaceAt(std::size_t i) const {
    const bool on_the_floor = text.At(i + 1) == "underfoot" || (text.At(i + 1) == "on" && text.Is(i + 3, "floors"));
    if (text.Is(i, "wall_finishes") && on_the_floor) return Surface::kFloor;
    if (text.At(i) == "walls" || text.Is(i, "wall_finishes") || text.Is(i, "paints")) return Surface::kWalls;
    const bool part = text.Says(i + 1, {"lamp", "lamps", "cushion", "cushions", "plan", "plant", "plants", "mirror",
                                        "mirrors", "space", "area", "to", "light", "lights"});
    if ((text.Is(i, "floors") && !part) || text.Is(i, "floor_finishes")) return Surface::kFloor;
    if (text.Says(i, {"ceiling", "ceilings"}) && !part) return Surface::kCeiling;
    return std::nullopt;
  }

  bool Has(Surface surface) const {
    return std::ranges::any_of(facts.finishes, [&](const AskedFinish& one) { return one.surface == surface; });
  }

  // A colour or a material at a token: how many tokens it has; 0 when neither is there.
  std::size_t TakeAt(std::size_t i, AskedFinish& finish) const {
    const auto [colour, length] = LongestAt(handbook.vocabulary().colours, tokens(), i, /*plural=*/false);
    if (length > 0) {
      if (finish.colour == nullptr) finish.colour = colour;
      return length;
    }
    const bool pattern = text.Is(i, "finish_patterns");
    if (!pattern && !text.Is(i, "materials") && !text.Is(i, "finish_materials")) return 0;
    Append(text.At(i), finish.material);
    return 1;
  }

  // Whether an article stands up to three words before.
  bool HasArticle(std::size_t i) const {
    for (std::size_t back = 1; back <= std::min<std::size_t>(3, i); ++back) {
      if (text.Says(i - back, {"a", "an"})) return true;
    }
    return false;
  }

  // "Moss for a floor" and "sand on the floor" say it before those words.
  std::size_t BeforeUnderfoot(std::size_t i) const {
    const bool said = i >= 3 && text.Says(i - 2, {"on", "for", "as"}) && text.Says(i - 1, {"the", "a"});
    return said ? i - 2 : i;
  }

  // "The floor has to be something I can hose down."
  bool IsWashedDown(std::size_t i) const {
    constexpr std::size_t kReach = 10;
    for (std::size_t k = i > 4 ? i - 4 : 0; k < std::min(i + kReach, tokens().size()); ++k) {
      if (k > i && text.At(k) == ".") break;
      if (text.Is(k, "washed_down")) return true;
    }
    return false;
  }

  // "Dark green tiled walls", "black and white checkerboard floor": the longest run of such words.
  void ReadBefore(std::size_t i, std::size_t& begin, AskedFinish& finish) const {
    constexpr std::size_t kMostBack = 6;
    for (std::size_t at = i - std::min(kMostBack, i); at < i; ++at) {
      AskedFinish before{.surface = finish.surface};
      std::size_t k = at;
      while (k < i && !used[k]) {
        const std::size_t length = TakeAt(k, before);
        const bool between = k > at && (text.IsHyphen(k) || text.At(k) == "and");
        if (length == 0 && !between && !text.Is(k, "looks")) break;
        k += std::max<std::size_t>(1, length);
      }
      if (k != i || (before.material.empty() && before.colour == nullptr)) continue;
      if (!finish.material.empty()) Append(finish.material, before.material);
      finish.material = before.material;
      if (finish.colour == nullptr) finish.colour = before.colour;
      begin = at;
      return;
    }
  }

  // "Walls covered in cork", "the floor is of pale oak", "walls: white".
  void ReadBehind(std::size_t i, std::size_t& end, AskedFinish& finish) const {
    constexpr std::size_t kMostBetween = 4;
    std::size_t k = i;
    while (k < i + kMostBetween && (text.Is(k, "finish_links") || text.Is(k, "looks"))) ++k;
    const bool at_once = k == i;
    AskedFinish behind{.surface = finish.surface};
    while (k < tokens().size() && !used[k]) {
      const std::size_t length = TakeAt(k, behind);
      AskedFinish more = behind;
      if (length == 0 && !(text.At(k) == "and" && TakeAt(k + 1, more) > 0)) break;
      k += std::max<std::size_t>(1, length);
    }
    // "Walls lined with oak bookshelves" are not of oak.
    if (LongestAt(handbook.vocabulary().names, tokens(), k, /*plural=*/true).second > 0) return;
    if (behind.material.empty() && behind.colour == nullptr) return;
    // "Walls aubergine, ...".
    if (at_once && k < tokens().size() && !text.IsSign(k)) return;
    finish = std::move(behind);
    end = k;
  }
};

}  // namespace

void ReadFinishes(const Reading& reading) { FinishReader(reading).Read(); }

}  // namespace flair::language
