// SPDX-License-Identifier: GPL-3.0-or-later
// Forms of single words: singular and plural, verb forms, spellings. Words are lower case.
#pragma once

#include <string>
#include <string_view>

namespace flair::english {

// "Stoves" is "stove", "shelves" is "shelf", "boxes" is "box"; words that are singular stay as they are ("glass").
std::string Singular(std::string_view word);
// "Shelf" is "shelves", "box" is "boxes", "bookcase" is "bookcases".
std::string Plural(std::string_view word);
// Whether the word is a plural, of another word.
bool IsPlural(std::string_view word);

// The word without the ending of its form: "overlapping", "overlaps" and "overlap" share one. Empty for words too short
// to have one that tells them apart.
std::string Stem(std::string_view word);

// Whether the two are forms of one noun, in either spelling: "grey" and "gray", "shelf" and "shelves". A `base` that
// ends in '*' stands for any ending: "paint*".
bool IsFormOf(std::string_view word, std::string_view base);

// The British spelling of a word that has another: "gray" is "grey".
std::string British(std::string_view word);

// Whether one word begins like the other: "prep" and "preparation", "alchemical" and "alchemy".
bool BeginAlike(std::string_view a, std::string_view b);

}  // namespace flair::english
