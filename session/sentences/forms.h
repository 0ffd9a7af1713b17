// SPDX-License-Identifier: GPL-3.0-or-later
// Forms of what people ask for, as english/data/en/editing.textproto lists them: phrases with slots.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "english/lexicon.h"
#include "english/text.h"

namespace flair::session {

using Tokens = std::vector<english::Token>;

// Tokens [begin, end).
struct Span {
  size_t begin = 0;
  size_t end = 0;
  bool empty() const { return begin >= end; }
};

// WordMeanings, numbers and those signs that tell something; spellings are British.
Tokens PlainTokens(std::string_view text);

// Lists whose names share a beginning: of "way: west", "way: east" the words mean "west" and "east".
class WordMeanings {
 public:
  explicit WordMeanings(std::string_view prefix);
  // What all of the span means; null when it means nothing.
  const std::string* Find(const Tokens& tokens, Span span) const;
  // How many tokens from `at` on are of a phrase; 0 for none.
  size_t LengthAt(const Tokens& tokens, size_t at) const { return book_.Find(tokens, at).length; }

 private:
  english::PhraseBook book_;
  std::vector<std::string> meanings_;
};

// A form that fits.
struct Form {
  // The name of its list behind "edit: ", such as "remove".
  std::string act;
  std::map<std::string, Span> slots;
};

class Forms {
 public:
  // Whether the words of a span can stand in a slot, such as "what" or "target:away".
  using Fits = std::function<bool(const std::string& slot, Span span)>;

  static const Forms& Get();

  // The first form that all of a span has, with the longest spans for its slots.
  std::optional<Form> Match(const Tokens& tokens, Span span, const Fits& fits) const;

 private:
  struct Element;
  using Sequence = std::vector<Element>;
  struct Element {
    std::string word, slot;
    std::vector<Sequence> choices;
    bool optional = false;
  };
  // The part of a sequence that is still to come, then what comes after the bracket that it stands in.
  struct Rest {
    const Sequence* sequence;
    size_t next;
    const Rest* outer;
  };
  struct Search {
    const Tokens& tokens;
    size_t end;
    const Fits& fits;
    std::map<std::string, Span> slots;
  };

  Forms();
  static Sequence Parse(std::string_view text, size_t& at);
  static bool Step(Search& search, size_t at, const Rest& rest);

  std::vector<std::pair<std::string, Sequence>> forms_;
};

}  // namespace flair::session
