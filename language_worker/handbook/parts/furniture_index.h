// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "language_worker/handbook/handbook.h"

namespace flair::language {

// Finds the handbook's class for a name that a stranger gave: "Oak writing desks" is a "writing desk", else a "desk".
// Immutable, thread-safe; `handbook` must outlive it.
class FurnitureIndex {
 public:
  explicit FurnitureIndex(const Handbook& handbook);

  // The class whose name or synonym is the longest ending of the name's words; null when none is.
  const hb::Furniture* Find(std::string_view name) const;

  // The class of exactly this name or synonym, plurals included; null when there is none.
  const hb::Furniture* FindExact(std::string_view name) const;

 private:
  std::map<std::string, const hb::Furniture*, std::less<>> by_word_;
};

}  // namespace flair::language
