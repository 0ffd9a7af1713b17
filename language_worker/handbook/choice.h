// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
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
  Choice(std::int64_t seed, std::string_view text) : seed_(Mix(Mix(static_cast<std::uint64_t>(seed)) ^ Hash(text))) {}

  // An index in [0, count); 0 when count is 0.
  std::size_t Index(std::string_view key, std::size_t count) const {
    return count == 0 ? 0 : static_cast<std::size_t>(Bits(key) % count);
  }

  // A number in [0, 1).
  double Unit(std::string_view key) const { return static_cast<double>(Bits(key) >> 11) * 0x1.0p-53; }

  // A number in [low, high), in steps of `step` from low.
  double Stepped(std::string_view key, double low, double high, double step) const {
    const auto count = static_cast<std::size_t>(std::floor((high - low) / step + 1e-9)) + 1;
    return high <= low ? low : low + step * static_cast<double>(Index(key, count));
  }

  // True for the share `chance` of all seeds.
  bool Happens(std::string_view key, double chance) const { return Unit(key) < chance; }

 private:
  // The finaliser of splitmix64: every input bit moves every output bit.
  static std::uint64_t Mix(std::uint64_t bits) {
    bits += 0x9e3779b97f4a7c15ULL;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9ULL;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebULL;
    return bits ^ (bits >> 31);
  }

  // FNV-1a.
  static std::uint64_t Hash(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    return hash;
  }

  std::uint64_t Bits(std::string_view key) const { return Mix(seed_ ^ Hash(key)); }

  std::uint64_t seed_;
};

}  // namespace flair::language
