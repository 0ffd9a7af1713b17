// SPDX-License-Identifier: GPL-3.0-or-later
// What a person asks to change, clause by clause: "remove the wall clock and make the table longer".
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "room/scene/room.h"
#include "session/sentences/pieces_meant.h"

namespace flair::session {

// What something is turned or moved towards.
struct Target {
  // "object", "window", "door", "middle", "wall" for the nearest one or `wall`, "opposite wall".
  std::string kind = {};
  // Of the room; -1 for none.
  int wall = -1;
  ObjectIds ids = {};
  // As it was called: "the window".
  std::string said = {};
};

// One clause.
struct Spoken {
  // The list of its form, such as "remove" or "resize to"; "reason" for what asks for nothing; empty for a sentence
  // that a translator is to read.
  std::string act = {};
  // Its words.
  std::string said = {};
  Meant what = {}, other = {};
  std::optional<Wanted> by = {};
  Target target = {};
  // "west", "north-east", "forward", "back"; "left", "right" and "around" for turns.
  std::string way = {};
  bool is_away = false;
  std::optional<double> length_m = {}, angle_deg = {};
  // "more long", "less high".
  std::vector<std::string> changes = {};
  // "long", "wide", "deep", "high", "big"; empty for none.
  std::string dimension = {};
  double factor = 0;
  std::vector<double> size_m = {};
  // "under the window".
  std::string place = {};
  // What the room has not and the act is about.
  std::string absent = {};
};

class SpokenReader {
 public:
  // `is_later`: whether something was said in sentences before.
  SpokenReader(const MeantPieces& pieces, const Room& room, bool is_later = false)
      : pieces_(pieces), room_(room), is_later_(is_later) {}

  // The clause at the beginning of the span; `rest` is what comes after it.
  Spoken Read(std::string_view text, const Tokens& tokens, Span span, Span& rest);

 private:
  std::optional<Spoken> ReadEdit(std::string_view text, const Tokens& tokens, Span span);
  std::optional<Spoken> ReadForm(std::string_view text, const Tokens& tokens, Span span);
  bool Fits(const Tokens& tokens, const std::string& slot, Span span);
  void Fill(const Tokens& tokens, const std::string& slot, Span span, Spoken& spoken) const;
  std::optional<Target> FindTarget(const Tokens& tokens, Span span) const;
  std::optional<Meant> Find(const Tokens& tokens, Span span);

  const MeantPieces& pieces_;
  const Room& room_;
  const bool is_later_;
  // Whether a piece that the room has not may stand where one of it belongs.
  bool is_lenient_ = false;
  // What spans of the tokens at hand mean.
  std::map<std::pair<size_t, size_t>, std::optional<Meant>> meant_;
};

// Where a clause begins behind "please" and the like.
size_t WithoutPolite(const Tokens& tokens, Span span);

// "Undo", "redo", "another layout" when that is all that is asked; empty otherwise.
std::string HistoryAsked(std::string_view text);

}  // namespace flair::session
