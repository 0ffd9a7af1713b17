// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace flair::language {

// Values by placeholder name, without braces.
using TemplateValues = std::map<std::string, std::string, std::less<>>;

// Replaces every {name} in `text`; names without a value stay as they are. Values are not searched again.
std::string FillTemplate(std::string_view text, const TemplateValues& values);

// Names in braces that no sentence, description or summary of the handbook may use.
std::vector<std::string> UnknownPlaceholders(std::string_view text);

// "nightstand" -> "nightstands", "bookshelf" -> "bookshelves", "battery" -> "batteries".
std::string PluralOf(std::string_view noun);

// "one" to "twelve", digits above.
std::string NumberWord(int number);

// "first" to "twelfth", "13th" above.
std::string OrdinalWord(int number);

// "a" or "an", by the first letter of the next word.
std::string_view ArticleFor(std::string_view word);

// First letter in upper case.
std::string Capitalized(std::string text);

}  // namespace flair::language
