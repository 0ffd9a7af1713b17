// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/opening_looks.h"

#include "language_worker/handbook/reading/opening_places.h"
#include "language_worker/handbook/reading/opening_words.h"

namespace flair::language {
namespace {

constexpr double kLarge = 1.5, kSmall = 0.6;

}  // namespace

void Describe(std::string_view word, OpeningWish& wish) {
  if (IsAmong("large larger big bigger huge wide wider generous panoramic picture massive enormous", word)) {
    wish.width_factor = kLarge;
  } else if (IsAmong("small smaller little tiny narrow slit", word)) {
    wish.width_factor = kSmall;
  }
  if (!wish.door) {
    if (IsAmong(kCompassWords, word) && wish.side.empty()) wish.side = word;
    if (IsAmong("clerestory", word)) wish.sill_m = 1.9;
    if (word == "bay" || word == "bow" || word == "oriel") {
      wish.kind = std::string(word) + " window";
      wish.width_factor = kLarge;
    }
    if (word == "corner") wish.along.at = AlongWall::At::kEnd;
    return;
  }
  if (IsAmong("sliding pocket barn shoji", word)) wish.swing = v1::DOOR_SWING_SLIDING;
  if (IsAmong("folding bifold concertina accordion", word)) {
    wish.swing = v1::DOOR_SWING_SLIDING;
    wish.width_m = wish.width_m.value_or(2.4);
  }
  if (word == "double") wish.width_m = wish.width_m.value_or(1.5);
  if (word == "garage") wish.width_m = wish.width_m.value_or(2.4);
  if (IsAmong(kOpenAir, word) || word == "french") {
    wish.outside = true;
    if (word != "balcony") wish.width_m = wish.width_m.value_or(word == "patio" ? 1.8 : 1.5);
    if (word == "patio") wish.swing = v1::DOOR_SWING_SLIDING;
    if (word != "french") wish.leads_to = word;
  } else if (IsAmong(kInnerRooms, word)) {
    wish.leads_to = std::string(word) + (wish.leads_to.empty() ? "" : " " + wish.leads_to);
  }
}

}  // namespace flair::language
