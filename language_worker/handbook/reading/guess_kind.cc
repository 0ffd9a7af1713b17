// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/guess_kind.h"

#include <algorithm>
#include <string>

#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {

const hb::Archetype* MostHintedAt(const Handbook& handbook, const std::vector<Token>& tokens) {
  const hb::Archetype* hinted = nullptr;
  int most = 0;
  for (const hb::Archetype& archetype : handbook.contents().archetypes()) {
    int hints = 0;
    for (const std::string& hint : archetype.hints()) hints += Phrase(hint).Occurs(tokens) ? 1 : 0;
    if (hints <= most) continue;
    most = hints;
    hinted = &archetype;
  }
  return hinted;
}

const hb::Archetype& KindOfPieces(const Handbook& handbook, const std::vector<Token>& tokens) {
  constexpr int kFirst = 4, kMainPiece = 2;
  std::vector<std::string> named;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const auto [furniture, length] = LongestAt(handbook.vocabulary().names, tokens, i, /*plural=*/true);
    if (furniture == nullptr) continue;
    named.push_back(furniture->name());
    i += length - 1;
  }
  const hb::Archetype* kind = &handbook.fallback_archetype();
  int most = 0;
  for (const hb::Archetype& archetype : handbook.contents().archetypes()) {
    if (archetype.fallback() || archetype.zones().empty()) continue;
    int score = 0;
    bool any_main = false;
    for (const std::string& name : named) {
      const auto& usual = archetype.bands(archetype.bands_size() / 2).objects();
      const bool is_usual = std::ranges::find(usual, name, &hb::ObjectEntry::furniture) != usual.end();
      const int worth = Includes(archetype.zones(0).primaries(), name) ? kMainPiece : is_usual ? 1 : 0;
      any_main = any_main || worth == kMainPiece;
      score += worth * (&name == &named.front() ? kFirst : 1);
    }
    if (!any_main || score <= most) continue;
    most = score;
    kind = &archetype;
  }
  return *kind;
}

}  // namespace flair::language
