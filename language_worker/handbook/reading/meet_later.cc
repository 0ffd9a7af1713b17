// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/meet_later.h"

#include <algorithm>

namespace flair::language {

void MeetLater(const BriefText& text, BriefFacts& facts, std::vector<Mention>& mentions) {
  for (std::size_t i = 0; i < facts.wishes.size(); ++i) {
    const hb::Furniture* vague = facts.wishes[i].furniture;
    const auto mention = std::ranges::find(mentions, vague, &Mention::furniture);
    const bool by_noun = facts.wishes[i].noun != nullptr && mention != mentions.end() &&
                         mention->end == mention->begin + 1 && mention->begin > 0;
    const bool the = by_noun && text.At(mention->begin - 1) == "the" && facts.wishes[i].count == 1;
    // "Separate beds now. Two twin beds with ..."
    const bool plural = by_noun && !facts.wishes[i].counted && facts.wishes[i].seats == 0;
    if (!(the || plural) || vague->category() == "box") continue;
    const auto later = std::ranges::find_if(
        facts.wishes.begin() + static_cast<std::ptrdiff_t>(i) + 1, facts.wishes.end(), [&](const Wish& wish) {
          return wish.furniture->category() == vague->category() && (the || (wish.counted && wish.count > 1));
        });
    if (later == facts.wishes.end()) continue;
    for (Mention& one : mentions) {
      if (one.furniture == vague) one.furniture = later->furniture;
    }
    facts.wishes.erase(facts.wishes.begin() + static_cast<std::ptrdiff_t>(i--));
  }
}

const Wish* NamedAgain(const BriefText& text, std::size_t i, const hb::Furniture* named, const BriefFacts& facts,
                       const Handbook& handbook) {
  if (named == nullptr || i == 0 || text.At(i - 1) != "the" || named->category() == "box") return nullptr;
  const auto own = std::ranges::find_if(facts.wishes, [&](const Wish& wish) {
    return wish.furniture != named && handbook.IsOwn(*wish.furniture) && !named->category().empty() &&
           wish.furniture->category() == named->category();
  });
  return own == facts.wishes.end() ? nullptr : &*own;
}

}  // namespace flair::language
