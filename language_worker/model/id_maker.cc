// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/model/id_maker.h"

#include <fmt/format.h>

#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/model/furniture_index.h"

namespace flair::language {
namespace {

// Leaves room for a number behind it: ids have at most 64 characters.
constexpr size_t kLongestBase = 50;

std::string BaseOf(std::string_view name, std::string_view fallback) {
  std::string base = IdOf(PlainName(name));
  if (base == "unnamed") base = std::string(fallback);
  if (base.size() > kLongestBase) base.resize(kLongestBase);
  while (base.size() > 1 && base.back() == '_') base.pop_back();
  return base;
}

}  // namespace

std::string IdMaker::Make(std::string_view name, std::string_view fallback) { return MakeLike(BaseOf(name, fallback)); }

std::string IdMaker::MakeLike(const std::string& id) {
  if (taken_.insert(id).second) return id;
  for (int number = 2;; ++number) {
    std::string numbered = fmt::format("{}_{}", id, number);
    if (taken_.insert(numbered).second) return numbered;
  }
}

std::vector<std::string> IdMaker::MakeSeveral(std::string_view name, int count, std::string_view fallback) {
  if (count == 1) return {Make(name, fallback)};
  std::vector<std::string> ids;
  const std::string base = BaseOf(name, fallback);
  for (int number = 1; static_cast<int>(ids.size()) < count; ++number) {
    std::string id = fmt::format("{}_{}", base, number);
    if (taken_.insert(id).second) ids.push_back(std::move(id));
  }
  return ids;
}

}  // namespace flair::language
