// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/cleaning/stance.h"

#include <string_view>
#include <utility>

#include "language_worker/handbook/reading/words.h"

namespace flair::language {
namespace {

using Kind = Stance::Kind;

// Distances of words without a number, as the optimizer takes them.
constexpr double kNearFeatureM = 0.5;
constexpr double kNearObjectM = 3;
constexpr double kAwayM = 2;

bool Says(const std::vector<Token>& tokens, std::string_view phrase) { return Phrase(phrase).Occurs(tokens); }

bool SaysAny(const std::vector<Token>& tokens, std::initializer_list<std::string_view> phrases) {
  for (const std::string_view phrase : phrases) {
    if (Says(tokens, phrase)) return true;
  }
  return false;
}

// A feature or wall that the sentence names; "wall" for walls in general.
std::string FeatureOf(const std::vector<Token>& tokens) {
  for (const std::string_view wall : {"north wall", "south wall", "east wall", "west wall"}) {
    if (Says(tokens, wall)) return std::string(wall);
  }
  for (const std::string_view feature : {"window", "door", "socket", "wall"}) {
    if (Says(tokens, feature)) return std::string(feature);
  }
  return "";
}

double FirstNumber(const std::vector<Token>& tokens, double otherwise) {
  for (const Token& token : tokens) {
    if (token.kind == Token::Kind::kNumber) return token.number;
  }
  return otherwise;
}

Kind KindOf(const std::vector<Token>& tokens, const std::string& feature) {
  const bool denied = SaysAny(tokens, {"not", "never", "avoid"});
  const bool of_walls = feature.size() >= 4 && feature.compare(feature.size() - 4, 4, "wall") == 0;
  if (SaysAny(tokens, {"centre of the room", "center of the room", "middle of the room", "centrally"}))
    return Kind::kCentral;
  if (SaysAny(tokens, {"in a corner", "in the corner"})) return denied ? Kind::kNone : Kind::kInCorner;
  if (of_walls && Says(tokens, "against")) return denied ? Kind::kOffWalls : Kind::kAtWall;
  if (SaysAny(tokens, {"away from", "far from"}))
    return denied ? Kind::kNone : of_walls ? Kind::kOffWalls : Kind::kAway;
  if (of_walls) return Kind::kNone;
  if (SaysAny(tokens, {"near", "close to", "next to", "beside", "within", "under the window", "under a window"})) {
    return denied ? Kind::kAway : Kind::kNear;
  }
  if (SaysAny(tokens, {"faces", "face", "facing"})) return denied ? Kind::kNotFacing : Kind::kFacing;
  return Kind::kNone;
}

bool OffTheWalls(Kind kind) { return kind == Kind::kCentral || kind == Kind::kOffWalls; }
bool AtTheWalls(Kind kind) { return kind == Kind::kAtWall || kind == Kind::kInCorner; }

}  // namespace

Stance StanceOf(const v1::Sentence& sentence) {
  const std::vector<Token> tokens = Tokenize(sentence.text());
  const std::string feature = FeatureOf(tokens);
  Stance stance;
  stance.kind = KindOf(tokens, feature);
  if (sentence.subject_ids_size() == 0 || stance.kind == Kind::kNone) return Stance();
  stance.subject = sentence.subject_ids(0);
  stance.partner = sentence.subject_ids_size() > 1 ? sentence.subject_ids(1) : feature;
  const bool pair = sentence.subject_ids_size() > 1;
  if (stance.kind == Kind::kNear) stance.distance_m = FirstNumber(tokens, pair ? kNearObjectM : kNearFeatureM);
  if (stance.kind == Kind::kAway) stance.distance_m = FirstNumber(tokens, kAwayM);
  return stance;
}

bool Contradict(const Stance& a, const Stance& b) {
  if (a.kind == Kind::kNone || b.kind == Kind::kNone || a.subject != b.subject) return false;
  if ((AtTheWalls(a.kind) && OffTheWalls(b.kind)) || (AtTheWalls(b.kind) && OffTheWalls(a.kind))) return true;
  const bool named = a.partner != "wall" && b.partner != "wall";
  if (a.kind == Kind::kAtWall && b.kind == Kind::kAtWall) return named && a.partner != b.partner;
  if (a.partner != b.partner || a.partner.empty()) return false;
  const auto either = [&](Kind first, Kind second) {
    return (a.kind == first && b.kind == second) || (a.kind == second && b.kind == first);
  };
  if (either(Kind::kFacing, Kind::kNotFacing)) return true;
  if (!either(Kind::kNear, Kind::kAway)) return false;
  const double most_m = a.kind == Kind::kNear ? a.distance_m : b.distance_m;
  const double least_m = a.kind == Kind::kAway ? a.distance_m : b.distance_m;
  return least_m > most_m;
}

}  // namespace flair::language
