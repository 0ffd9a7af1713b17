// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace flair::language {

// Makes ids of names that strangers gave: short, of a-z, 0-9 and "_", none twice.
class IdMaker {
 public:
  // An id for one thing: "desk", or "desk_2" when that is taken; `fallback` for names without a letter of ours.
  std::string Make(std::string_view name, std::string_view fallback);

  // Ids for `count` equal things: "dining_chair_1" and so on, or as Make for a single one.
  std::vector<std::string> MakeSeveral(std::string_view name, int count, std::string_view fallback);

  // This id, made elsewhere, or one like it when it is taken.
  std::string MakeLike(const std::string& id);

  // For an id that was made elsewhere.
  void Take(const std::string& id) { taken_.insert(id); }

 private:
  std::set<std::string, std::less<>> taken_;
};

}  // namespace flair::language
