// SPDX-License-Identifier: GPL-3.0-or-later
// Which objects a free text speaks of.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "flair/v1/object_list.pb.h"

namespace flair::language {

// A word of a text.
struct Word {
  size_t begin = 0;
  size_t end = 0;
  // In lower case, singular.
  std::string key;
};

// Letters and digits between other signs; "0.5m" is one word. Bytes beyond ASCII count as letters.
std::vector<Word> ReadWords(std::string_view text);

// The words of a name without blanks between them, each singular, without numbers behind them: equal for "Nightstands",
// "nightstand_2" and "night stand".
std::string NameKey(std::string_view name);

// One place of a text that names objects.
struct Mention {
  size_t begin = 0;
  size_t end = 0;
  // Indices of all objects that the name means, ascending.
  std::vector<int> objects;
};

// Finds names in texts. Immutable, thread-safe.
class ObjectNames {
 public:
  // The objects, in their order, with the names, sizes and zones that they were recorded with.
  explicit ObjectNames(const std::vector<const v1::Object*>& objects);

  // Where the text names objects, in its order: longest names first, plurals too, "TV-stand" for "tv stand". A size or
  // a number behind a name chooses among equal names: "Bookshelf (1m x 0.3m)", "Nightstand 2". `zone_id`, when not
  // empty, chooses among equal names of several zones.
  std::vector<Mention> Find(std::string_view text, std::string_view zone_id = "") const;

  // The same, or else where it uses a word of a single object's name: "Alchemical Table" for "alchemy table".
  std::vector<Mention> FindLoosely(std::string_view text, std::string_view zone_id = "") const;

 private:
  struct Name {
    std::string key;  // see NameKey
    std::vector<std::string> words;
    std::vector<int> objects;
  };

  std::vector<int> Choose(std::string_view behind, std::string_view zone_id, std::vector<int> objects) const;

  const std::vector<const v1::Object*> objects_;
  std::vector<Name> names_;
};

// The id of the zone whose name or id the text begins with or consists of, such as "Sleeping Area:"; empty when none.
std::string FindZone(std::string_view text, const std::vector<std::string>& zone_ids);

// The sentences of a line, none empty: it ends where a point, an exclamation or question mark is followed by a capital
// letter, not within parentheses and not in "e.g. ". Each at most 390 bytes, cut at a character's start.
std::vector<std::string> SplitSentences(std::string_view line);

// Share of the words of the shorter of both texts that the longer one has too, [0, 1]; 0 for texts without words.
double Likeness(std::string_view a, std::string_view b);

// Whether a text has nothing but a size: "0.3m x 0.3m (each)", "Width: 0.2m, Length: 0.2m.", or no words at all.
bool IsSize(std::string_view text);

// Whether it has a length in metres: "0.4m".
bool HasSize(std::string_view text);

// Whether one of its words, singular, is in that list of english/data.
bool HasWordOf(const char* list, std::string_view text);

}  // namespace flair::language
