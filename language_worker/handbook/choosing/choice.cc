// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/choosing/choice.h"

#include <cmath>

namespace flair::language {
namespace {

// The finaliser of splitmix64: every input bit moves every output bit.
std::uint64_t Mix(std::uint64_t bits) {
  bits += 0x9e3779b97f4a7c15ULL;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9ULL;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebULL;
  return bits ^ (bits >> 31);
}

// FNV-1a.
std::uint64_t Hash(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return hash;
}

}  // namespace

Choice::Choice(std::int64_t seed, std::string_view text)
    : seed_(Mix(Mix(static_cast<std::uint64_t>(seed)) ^ Hash(text))) {}

std::uint64_t Choice::Bits(std::string_view key) const { return Mix(seed_ ^ Hash(key)); }

std::size_t Choice::Index(std::string_view key, std::size_t count) const {
  return count == 0 ? 0 : static_cast<std::size_t>(Bits(key) % count);
}

double Choice::Unit(std::string_view key) const { return static_cast<double>(Bits(key) >> 11) * 0x1.0p-53; }

double Choice::Stepped(std::string_view key, double low, double high, double step) const {
  const auto count = static_cast<std::size_t>(std::floor((high - low) / step + 1e-9)) + 1;
  return high <= low ? low : low + step * static_cast<double>(Index(key, count));
}

}  // namespace flair::language
