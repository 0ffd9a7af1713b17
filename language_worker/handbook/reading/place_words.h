// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// Between a piece and the words for its place.
inline constexpr std::array<std::string_view, 58> kPlaceFillers = {
    "is",      "are",  "be",     "being",  "should",   "must",       "shall",   "will",     "can",    "could",
    "would",   "to",   "stand",  "stands", "standing", "sit",        "sits",    "sitting",  "placed", "positioned",
    "located", "set",  "put",    "goes",   "go",       "which",      "that",    "just",     "right",  "directly",
    "lie",     "lies", "hang",   "hangs",  "hanging",  "hung",       "mounted", "arranged", "pushed", "tucked",
    "needs",   "need", "please", "also",   "always",   "preferably", "ideally", "either",   "up",     "somewhere",
    "has",     "its",  "face",   "m",      "cm",       "wide",       "long",    "situated"};

inline bool EndsSentence(const Token& token) {
  return token.kind == Token::Kind::kSign &&
         (token.text == "." || token.text == ";" || token.text == "!" || token.text == "?");
}

// Whether the sentence of a place speaks of that slot: "{target}".
inline bool AskedNames(const hb::AskedPlace& asked, std::string_view slot) {
  return asked.relation().text().find(slot) != std::string::npos;
}

}  // namespace flair::language
