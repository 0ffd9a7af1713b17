// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace flair::language {

// Chooses among equally good things by a seed and a key. Every choice has a key of its own ("door.wall"), so a choice
// neither depends on the order in which choices are made nor on how many there are: a changed handbook changes few
// others. The same seed and key give the same answer on every machine. Immutable, thread-safe.
class Choice {
 public:
  // `text` is the brief's: other words with the same seed choose otherwise too.
  Choice(std::int64_t seed, std::string_view text);

  // An index in [0, count); 0 when count is 0.
  std::size_t Index(std::string_view key, std::size_t count) const;

  // A number in [0, 1).
  double Unit(std::string_view key) const;

  // A number in [low, high), in steps of `step` from low.
  double Stepped(std::string_view key, double low, double high, double step) const;

  // True for the share `chance` of all seeds.
  bool Happens(std::string_view key, double chance) const { return Unit(key) < chance; }

 private:
  std::uint64_t Bits(std::string_view key) const;

  std::uint64_t seed_;
};

}  // namespace flair::language
