// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/vocabulary.h"

#include <utility>

namespace flair::language {

Vocabulary::Vocabulary(const Handbook& handbook) : speller(handbook.contents()) {
  for (const hb::Noun& noun : handbook.contents().nouns()) {
    Head head{.noun = &noun, .words = {}, .options = {}, .modifiers = {}};
    for (const std::string& word : noun.words()) head.words.emplace_back(word);
    for (const hb::NounOption& option : noun.options()) {
      const hb::Furniture* furniture = handbook.FindFurniture(option.furniture());
      if (furniture == nullptr) continue;
      const bool only_modified = !option.modifiers().empty() && option.rooms().empty();
      if (!only_modified) AddSayings("", noun.words(), *furniture, names);
      head.options.push_back(furniture);
      for (const std::string& words : option.modifiers()) head.modifiers.push_back({Phrase(words), furniture});
    }
    if (!head.words.empty()) heads.push_back(std::move(head));
  }
  for (const hb::Furniture& furniture : handbook.contents().furniture()) {
    AddSayings(furniture.name(), furniture.synonyms(), furniture, names);
  }
  for (const std::string& words : handbook.contents().other_things()) other_things.emplace_back(words);
}

}  // namespace flair::language
