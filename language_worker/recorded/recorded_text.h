// SPDX-License-Identifier: GPL-3.0-or-later
// Constraints and places of small things that a model wrote as lists in free text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "flair/v1/object_list.pb.h"
#include "language_worker/recorded/recorded_room.h"

namespace flair::language {

// Which objects a free text speaks of.

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

// A sentence with the objects that it is about.
struct RecordedSentence {
  // Indices, ascending per name; those of the heading that it stands under, else those that it names.
  std::vector<int> objects;
  std::string text;
  // It says that it must be so.
  bool must = false;
};

enum class ConstraintTextKind {
  // Under a heading for each object; the heading's first name counts.
  kIntra,
  // Under headings for pairs, zones or nothing.
  kInter,
};

// A text, and what its names mean.
struct ConstraintText {
  std::string_view name;
  std::string_view text;
  ConstraintTextKind kind = ConstraintTextKind::kIntra;
  const ObjectNames& objects;
  const std::vector<std::string>& zone_ids;
};

// The sentences in the order of the text: one of each item, several where an item has several sentences. Reads any
// bytes.
std::vector<RecordedSentence> ReadConstraintText(const ConstraintText& text, Conversion& conversion);

// Where one of the tertiaries goes.
struct RecordedPlacement {
  // One or two short sentences without the sizes; empty when the text has none for it.
  std::string text;
  // The floor objects that the place is told by, indices; empty when it names none.
  std::vector<int> hosts;
  // The item of the text that it is from; the same for several of a kind.
  int line = 0;
};

// One for each tertiary, in their order. Items are found by the words of the tertiaries' names, each once, the best
// first, but those of several equal tertiaries more often. Reads any bytes. Counts every item of the text's list.
std::vector<RecordedPlacement> ReadTertiaryText(std::string_view text, const std::vector<const v1::Object*>& tertiaries,
                                                const ObjectNames& floor_objects, Conversion& conversion);

}  // namespace flair::language
