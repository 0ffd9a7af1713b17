// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "absl/status/statusor.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// A part that juts out of a rectangle: "the leg on the north east is 2.5 by 2.5", "an alcove, 1.5 x 0.8 m, in the west
// wall".
struct RoomLeg {
  double width_m = 0, depth_m = 0;  // along x and y
  std::string wall, end;            // compass words; empty for any
  bool of_an_l = false;             // at an end of its wall, not in the middle
};

// What a brief says about the room's size. Everything in metres; unset where it says nothing.
struct SizeRequest {
  std::optional<double> width_m;  // west to east
  std::optional<double> depth_m;  // south to north
  std::optional<double> area_m2;
  std::optional<double> height_m;
  double area_factor = 1;            // of words such as "small"
  std::optional<double> side_ratio;  // shorter by longer side, of words such as "narrow"

  std::optional<RoomLeg> leg;

  bool in_numbers() const { return width_m || depth_m || area_m2; }
};

// What a brief says of the size of one piece, metres.
struct PieceSize {
  std::optional<double> width_m, depth_m, height_m;
  std::optional<double> long_m, short_m;  // of its sides, whichever they are
  std::size_t begin = 0, end = 0;         // the tokens that say it

  bool any() const { return width_m || depth_m || height_m || long_m; }
  // With `long_m` and `short_m` as width and depth of a class.
  PieceSize For(const hb::Furniture& furniture) const;
};

// Reads the size of the piece that tokens [begin, end) name: "a 1.6 m x 0.8 m oak desk", "a ten-foot table", "a sofa,
// 2 m long", "a desk (160 x 80 cm)". Tokens in `taken` belong to something else.
PieceSize ReadPieceSize(const std::vector<Token>& tokens, std::size_t begin, std::size_t end,
                        const std::vector<bool>& taken);

// Reads sizes as people write them: "4m x 5m", "12ft by 10ft", "12'6\" x 14'", "20 square metres", "5 m square",
// "small", "2.7m ceiling". INVALID_ARGUMENT with the value and what would be right for sides outside [1, 100] m, areas
// outside [1.5, 2000] m2 and ceilings outside [1.7, 12] m. Marks the tokens that it has used.
absl::StatusOr<SizeRequest> ReadSize(const std::vector<Token>& tokens, const Handbook& handbook,
                                     std::vector<bool>& used);

}  // namespace flair::language
