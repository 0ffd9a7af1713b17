// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/parts/furniture_index.h"

#include "english/words.h"
#include "language_worker/handbook/parts/brief_parts.h"

namespace flair::language {

FurnitureIndex::FurnitureIndex(const Handbook& handbook) {
  for (const hb::Furniture& furniture : handbook.own()) by_word_.emplace(PlainName(furniture.name()), &furniture);
  // Names before synonyms: a word may be one class's name and another's synonym.
  for (const hb::Furniture& furniture : handbook.contents().furniture()) {
    by_word_.emplace(PlainName(furniture.name()), &furniture);
  }
  for (const hb::Furniture& furniture : handbook.contents().furniture()) {
    for (const std::string& synonym : furniture.synonyms()) by_word_.emplace(PlainName(synonym), &furniture);
  }
}

const hb::Furniture* FurnitureIndex::FindExact(std::string_view name) const {
  const std::string plain = PlainName(name);
  for (const std::string& form : {plain, english::Singular(plain)}) {
    if (const auto found = by_word_.find(form); found != by_word_.end()) return found->second;
  }
  return nullptr;
}

const hb::Furniture* FurnitureIndex::Find(std::string_view name) const {
  std::string words = PlainName(name);
  while (!words.empty()) {
    if (const hb::Furniture* found = FindExact(words)) return found;
    const size_t space = words.find(' ');
    if (space == std::string::npos) break;
    words = words.substr(space + 1);
  }
  return nullptr;
}

}  // namespace flair::language
