// SPDX-License-Identifier: GPL-3.0-or-later
// Which pieces of a room, or which new ones, the words of a person mean.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "session/layouts/lists.h"
#include "session/sentences/forms.h"
#include "session/sentences/piece_wishes.h"
#include "session/sentences/told_places.h"

namespace flair::session {

struct Meant {
  // In the room's order.
  ObjectIds ids = {};
  // What they were called, in the singular: "lamp".
  std::string name = {};
  // "The chair" where there are four: which one is for the act to choose.
  bool is_one = false;
  // "A chair", "two chairs", not "the chair".
  bool is_new = false;
  // "It", "the second chair", what is selected: these and no others of their name.
  bool is_chosen = false;
  // "The chair by the window": if several are meant by that, the act cannot choose.
  bool is_told = false;
  // "Everything".
  bool is_all = false;
  // Of a list what the room has not.
  std::vector<std::string> absent = {};
};

// What is to come into a room.
struct Wanted {
  v1::Object object = {};
  int count = 1;
  bool is_plural = false;
  // The piece of the room that it is like; empty for none.
  std::string like_id = {};
};

class MeantPieces {
 public:
  // `last`: what was spoken of before. All must outlive it.
  MeantPieces(const v1::SolvedLayout& layout, const IdSet& selected, const ObjectIds& last, const FindPiece& find)
      : layout_(layout), selected_(selected), last_(last), find_(find) {}

  // Nothing unless all of the span means pieces that are there.
  std::optional<Meant> Find(const Tokens& tokens, Span span) const;
  std::optional<Wanted> FindNew(const Tokens& tokens, Span span) const;
  // What a span calls a piece that is not there; empty when it cannot be one.
  std::string NameOfAbsent(const Tokens& tokens, Span span) const;

  // The names of these, each once.
  std::vector<std::string> Kinds(const ObjectIds& ids) const;

 private:
  std::optional<Meant> FindOne(const Tokens& tokens, Span span) const;
  std::optional<Meant> FindTold(const Tokens& tokens, const ToldPlace& told) const;
  ObjectIds Called(const std::string& name) const;
  void Narrow(int ordinal, const std::string& end, std::optional<int> count, Meant& meant) const;

  const v1::SolvedLayout& layout_;
  const IdSet& selected_;
  const ObjectIds& last_;
  const FindPiece& find_;
};

// A piece of the room that something of this name would be another one of: by its very name, or by the last words of
// it where no other is called so. Null when there is none.
const v1::Object* AnotherOf(const v1::LayoutGraph& graph, const std::string& name, const FindPiece& find);

}  // namespace flair::session
