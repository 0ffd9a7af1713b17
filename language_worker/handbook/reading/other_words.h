// SPDX-License-Identifier: GPL-3.0-or-later
// What a brief says besides rooms, pieces and places: how many people it is for, what nobody understood, and in which
// language it is.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {

// How many a room is for: "for forty readers", "seats twelve", "a family of five", "twenty students and a teacher".
// Marks the tokens that it has used; `used` ones have another meaning ("a table for eight"). Nothing when the text does
// not say.
std::optional<int> ReadPeople(const std::vector<Token>& tokens, std::vector<bool>& used);

// People who sit together, in what no piece is said of: "in groups of four", "at tables of six", "in pairs".
struct PeopleInGroups {
  int each = 0;  // 0 when it is not said
  bool rows = false;
};
PeopleInGroups ReadPeopleInGroups(const std::vector<Token>& tokens, std::vector<bool>& used);

// The time that a brief sets the room in: "around 1750", "the 1920s", "an 18th-century study"; none for today.
std::optional<int> ReadYear(const std::vector<Token>& tokens, std::vector<bool>& used);

// Whether "six WORD" counts those whom the room is for: people, guests, children ...
bool CountsPeople(std::string_view word);

// Whether at least one word is of the kind that no longer English sentence is without ("the", "with", "and" ...). Short
// texts pass: names of rooms and sizes are alike in many languages.
bool ReadsAsEnglish(const std::vector<Token>& tokens);

// Whether a text has words for rooms, or small words, of another language and none of the small words of English.
bool IsForeign(const std::vector<Token>& tokens);

// The clauses of which nobody has used a word, or not one that asks for something: what names a piece, a room or a
// colour, things, materials, directions, numbers; in the order of the text, eight at most.
std::vector<std::string> UnheardClauses(const std::vector<Token>& tokens, const std::vector<bool>& used,
                                        const Vocabulary& vocabulary);

}  // namespace flair::language
