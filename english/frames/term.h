// SPDX-License-Identifier: GPL-3.0-or-later
// What is left of a sentence when filler is gone, and the noun phrases in it.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "english/lexicon.h"
#include "english/text.h"

namespace flair::english {

// What a noun phrase refers to.
enum class RefKind {
  kObjects,  // objects of the list, by name
  kPronoun,  // "it", "them", or a bare side ("the front"): whatever was spoken of
  kGroup,    // a class: all, others, seating, heat
  kZone,     // "the seating area"
  kFeature,  // doors, windows, sockets
  kWall,
  kCorner,  // of the room: "the north-east corner"
  kCeiling,
  kRoom,
  kFloor,
  kAbsent,  // furniture that the room does not have
  kVague,   // paths, lighting, comfort: nothing that a layout call is about
};

// The ordinal of "the last".
inline constexpr int kLast = 99;

// One member of a noun phrase.
struct Reference {
  RefKind kind = RefKind::kPronoun;
  // For kObjects: the objects that bear the name, in list order.
  std::vector<int> candidates;
  // Those that fit less well ("chair": the armchair beside the desk chair); they count when the sentence is about them.
  std::vector<int> weak_candidates;
  // The candidates are those that are meant, whatever else bears the name.
  bool chosen = false;
  // The candidates bear just this name; the weaker ones then count only under a heading of theirs.
  bool full = false;
  // Feature kind, wall name ("wall_2|wall_4" for either), zone id, group, topic or the absent thing's name.
  std::string name;
  // A wall or corner that the room has not.
  bool missing = false;
  // Of a door or window the id of the one that is meant; empty for any. Of a corner its other wall.
  std::string opening;
  // A side word of the lexicon ("front", "long_one"...), empty when no side is named.
  std::string side;
  bool plural = false;
  bool each = false;
  // "A desk", "one of the desks": any one of those that bear the name.
  bool any = false;
  // "Its bed": the one that belongs to what is spoken of.
  bool own = false;
  // "The shower area": the place about the object.
  bool area = false;
  // "first" is 1, "last" is kLast; 0 when not numbered.
  int ordinal = 0;

  // Whether the object bears the name.
  bool Names(int object) const {
    const auto has = [&](const std::vector<int>& list) { return std::ranges::find(list, object) != list.end(); };
    return has(candidates) || has(weak_candidates);
  }
};

// A noun phrase: one reference or a list of them.
struct Mention {
  std::vector<Reference> references;
  // Joined by "or".
  bool either = false;
};

// What is left of a sentence when filler is gone: what patterns are matched against.
struct Term {
  enum class Kind {
    kWord,      // lemma of a relation word; "not"; "or"
    kMention,   // a noun phrase
    kDistance,  // a length
    kSoft,      // comma, "and", "with": may stand within a fact
    kStop,      // end of a sentence
    kPurpose,   // "for", "to": a reason follows
    kUnknown,   // a word that the grammar does not know
  };
  Kind kind = Kind::kUnknown;
  std::string lemma;
  Mention mention;
  Length distance;
  // Bytes of the sentence.
  size_t begin = 0;
  size_t end = 0;

  bool IsWord(std::string_view word) const { return kind == Kind::kWord && lemma == word; }
  bool IsSoft(std::string_view word) const { return kind == Kind::kSoft && lemma == word; }
  // Whether it is a noun phrase whose first member is of that kind.
  bool Mentions(RefKind sort) const { return kind == Kind::kMention && mention.references.front().kind == sort; }
  // "Its back", "the front": a side of what is spoken of.
  bool IsOwnSide() const { return Mentions(RefKind::kPronoun) && !mention.references.front().side.empty(); }
  bool IsAnyWord(std::initializer_list<std::string_view> words) const {
    return kind == Kind::kWord && std::ranges::find(words, lemma) != words.end();
  }
};

// Who knows the names of the things that sentences speak of: a room's objects, or the placeholders of a template.
class Names {
 public:
  struct Found {
    Reference reference;
    // Tokens covered; 0 when nothing was found.
    size_t length = 0;
    // The whole name of an object, not a part or a synonym.
    bool full = false;
  };

  virtual ~Names() = default;
  // The longest name that begins at tokens[at].
  virtual Found Find(const std::vector<Token>& tokens, size_t at) const = 0;
};

// A sentence made ready for the frames.
struct Analysis {
  std::vector<Term> terms;
  // "Ideally", "preferably", "if possible".
  bool wish = false;
  // Holds only sometimes: "if the room is small".
  bool conditional = false;
  // A clause that holds only sometimes was left out.
  bool partly_conditional = false;
};

// Reads a sentence: tokens, lengths, words, names, noun phrases. Linear in the length of the text.
Analysis Analyse(std::string_view text, const Names& names);

}  // namespace flair::english
