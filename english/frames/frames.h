// SPDX-License-Identifier: GPL-3.0-or-later
// Forms of facts: the frames of english/data.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "english/frames/term.h"
#include "flair/english/v1/language.pb.h"

namespace flair::english {

// What a form bound. Pointers into the terms; null where an optional part was left out.
struct Match {
  const Mention* a = nullptr;
  const Mention* b = nullptr;
  const Mention* c = nullptr;
  const Length* distance = nullptr;
  // How many terms were covered; 0 when the form does not match.
  size_t length = 0;
};

// The form of a fact, such as "A? not? near B ,? D?". Elements, separated by spaces:
//   A B C     a noun phrase, bound; A is what the fact moves, B and C what it is related to
//   A.wall    only one that refers to that: object (also zones and absent things), thing (no zones),
//             wall, feature, ceiling, room, floor, zone, group, vague, pronoun; side: with a side named; list: several
//             objects
//   D         a length, bound
//   ~         how much: any number of "space", "of", commas and at most one length, in any order
//   ,         a comma, "and", "with"
//   word      that lemma of the lexicon; word/word is either
//   x?        x may be left out
class Form {
 public:
  explicit Form(std::string_view text);

  // The longest match that begins at the first term.
  Match At(std::span<const Term> terms) const;
  // Whether it binds just these slots, and noun phrases like these.
  bool Takes(const Match& match) const;

 private:
  struct Element {
    char slot = 0;  // 'A', 'B', 'C', 'D', '~', ',' or 0 for a word
    std::string sort;
    std::vector<std::string> words;
    bool optional = false;
  };

  bool Fits(const Element& element, const Term& term, const Match& match) const;
  void Step(std::span<const Term> terms, size_t at, size_t element, Match match, Match& best) const;

  std::vector<Element> elements_;
};

// Whether a noun phrase refers to that: a sort of forms. And whether that is the name of the kind.
bool OfSort(const Mention& mention, std::string_view sort);
bool IsOfKind(RefKind kind, std::string_view name);

// All frames, ready to match. Immutable and thread-safe.
class FrameBook {
 public:
  // That of Language::Get(), made on first use.
  static const FrameBook& Get();

  struct Hit {
    std::string_view meaning;
    std::string_view detail;
    Match match;
  };

  // The frame that covers the most terms from the first one on; of equals the earlier in the data. Without a meaning
  // when none does.
  Hit Find(std::span<const Term> terms) const;
  // Whether a frame of that meaning and detail could have bound this.
  bool Knows(std::string_view meaning, std::string_view detail, const Match& match) const;

 private:
  FrameBook();

  struct Entry {
    Form form;
    const v1::Frame* frame;
  };
  std::vector<Entry> forms_;
};

}  // namespace flair::english
