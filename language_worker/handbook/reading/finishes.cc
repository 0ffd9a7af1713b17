// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/finishes.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {
namespace {

using Surface = AskedFinish::Surface;

class FinishReader {
 public:
  FinishReader(const Handbook& handbook, const std::vector<Token>& tokens, std::vector<bool>& used)
      : handbook_(handbook), tokens_(tokens), text_(tokens), used_(used) {}

  std::vector<AskedFinish> Read() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (used_[i] || !text_.IsWord(i)) continue;
      const std::optional<Surface> surface = SurfaceAt(i);
      if (!surface || Has(*surface)) continue;
      AskedFinish finish{.surface = *surface};
      // "Parquet" and "wallpaper" say by themselves what the surface is of.
      if (text_.Is(i, "floor_finishes") || text_.Is(i, "wall_finishes")) finish.material = text_.At(i);
      std::size_t begin = i, end = i + 1;
      if (text_.Is(end, "finish_materials") && finish.material.empty()) finish.material = text_.At(end++);  // "floor tiles"
      ReadBefore(i, begin, finish);
      if (finish.material.empty() && finish.colour == nullptr) ReadBehind(end, end, finish);
      if (finish.material.empty() && finish.colour == nullptr) continue;
      std::fill(used_.begin() + static_cast<std::ptrdiff_t>(begin), used_.begin() + static_cast<std::ptrdiff_t>(end),
                true);
      found_.push_back(std::move(finish));
    }
    return std::move(found_);
  }

 private:
  // "The north wall" and "a wall" are places; all walls are a surface.
  std::optional<Surface> SurfaceAt(std::size_t i) const {
    if (text_.At(i) == "walls" || text_.Is(i, "wall_finishes")) return Surface::kWalls;
    const bool part = text_.Says(i + 1, {"lamp", "cushion", "plan", "plant", "mirror", "space", "area", "to", "light"});
    if ((text_.Is(i, "floors") && !part) || text_.Is(i, "floor_finishes")) return Surface::kFloor;
    if (text_.Says(i, {"ceiling", "ceilings"}) && !part) return Surface::kCeiling;
    return std::nullopt;
  }

  bool Has(Surface surface) const {
    return std::ranges::any_of(found_, [&](const AskedFinish& one) { return one.surface == surface; });
  }

  // A colour or a material at a token: how many tokens it has; 0 when neither is there.
  std::size_t TakeAt(std::size_t i, AskedFinish& finish) const {
    const auto [colour, length] = LongestAt(handbook_.vocabulary().colours, tokens_, i, /*plural=*/false);
    if (length > 0) {
      if (finish.colour == nullptr) finish.colour = colour;
      return length;
    }
    if (!text_.Is(i, "materials") && !text_.Is(i, "finish_materials")) return 0;
    if (finish.material.empty()) finish.material = text_.At(i);
    return 1;
  }

  // "Dark green tiled walls".
  void ReadBefore(std::size_t i, std::size_t& begin, AskedFinish& finish) const {
    constexpr std::size_t kMostBack = 5;
    for (std::size_t back = std::min(kMostBack, i); back >= 1; --back) {
      const std::size_t at = i - back;
      std::size_t k = at;
      AskedFinish tried = finish;
      while (k < i && !used_[k]) {
        const std::size_t length = TakeAt(k, tried);
        const bool between = text_.IsHyphen(k) || text_.Is(k, "looks") || text_.Is(k, "finish_patterns") ||
                             (text_.At(k) == "and" && k > at);
        if (length == 0 && !between) break;
        k += std::max<std::size_t>(1, length);
      }
      if (k != i || (tried.material == finish.material && tried.colour == finish.colour)) continue;
      finish = std::move(tried);
      begin = at;
      return;
    }
  }

  // "Walls covered in cork", "the floor is of pale oak", "walls: white".
  void ReadBehind(std::size_t i, std::size_t& end, AskedFinish& finish) const {
    constexpr std::size_t kMostBetween = 4;
    std::size_t k = i;
    while (k < i + kMostBetween && (text_.Is(k, "finish_links") || text_.Is(k, "looks"))) ++k;
    if (k == i) return;
    while (k < tokens_.size() && !used_[k]) {
      const std::size_t length = TakeAt(k, finish);
      if (length == 0) break;
      end = k += length;
    }
  }

  const Handbook& handbook_;
  const std::vector<Token>& tokens_;
  const BriefText text_;
  std::vector<bool>& used_;
  std::vector<AskedFinish> found_;
};

}  // namespace

std::vector<AskedFinish> ReadFinishes(const Handbook& handbook, const std::vector<Token>& tokens,
                                      std::vector<bool>& used) {
  return FinishReader(handbook, tokens, used).Read();
}

}  // namespace flair::language
