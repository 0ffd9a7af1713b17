// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/foreign_words.h"

#include <algorithm>

#include "language_worker/handbook/reading/opening_words.h"

namespace flair::language {
namespace {

constexpr std::string_view kEnglishWords =
    "the a an with and for of my our your its room should where which that two three four from this want need has is "
    "are in on by";
// German, French, Spanish, Italian, Portuguese, Dutch, Polish and Swedish; none that English has, too.
constexpr std::string_view kForeignWords =
    "wohnzimmer schlafzimmer kinderzimmer esszimmer arbeitszimmer badezimmer küche zimmer büro mit und ein eine einem "
    "für "
    "chambre cuisine salle pièce bureau séjour avec une deux pour "
    "dormitorio habitación cocina comedor sala baño con dos para "
    "soggiorno cucina camera bagno stanza due "
    "quarto cozinha banheiro escritório com uma dois "
    "woonkamer slaapkamer keuken badkamer kamer met een twee "
    "sypialnia kuchnia łazienka pokój dwa "
    "sovrum vardagsrum kök badrum och med ett två";

}  // namespace

bool IsForeign(const std::vector<Token>& tokens) {
  const auto has = [&](std::string_view words) {
    return std::ranges::any_of(
        tokens, [&](const Token& token) { return token.kind == Token::Kind::kWord && IsAmong(words, token.text); });
  };
  return has(kForeignWords) && !has(kEnglishWords);
}

}  // namespace flair::language
