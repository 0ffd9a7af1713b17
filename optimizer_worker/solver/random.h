// SPDX-License-Identifier: GPL-3.0-or-later
// Random and low-discrepancy numbers that are the same on every machine and library.
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>

namespace flair::optimizer {

// SplitMix64 (Steele, Lea, Flood 2014): any seed is a good seed, the state is one word.
class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}
  uint64_t Next() { return Mix(state_ += 0x9e3779b97f4a7c15ull); }
  // Uniform in [0, 1).
  double Uniform() { return static_cast<double>(Next() >> 11) * 0x1.0p-53; }
  double Uniform(double low, double high) { return low + (high - low) * Uniform(); }
  // Uniform in 0 .. count - 1; count >= 1.
  int Below(int count) { return static_cast<int>(Uniform() * count); }

  static uint64_t Mix(uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }

 private:
  uint64_t state_;
};

// One seed from several numbers; order matters.
inline uint64_t CombineSeeds(std::initializer_list<uint64_t> parts) {
  uint64_t seed = 0x243f6a8885a308d3ull;
  for (uint64_t part : parts) seed = Random::Mix(seed + 0x9e3779b97f4a7c15ull + Random::Mix(part));
  return seed;
}

// Points of the R2 sequence (Roberts 2018) in the unit square, shifted by an offset: any prefix covers it evenly.
class PlaneSequence {
 public:
  explicit PlaneSequence(Random& random) : x_(random.Uniform()), y_(random.Uniform()) {}
  void Next(double& x, double& y) {
    x_ += 0.7548776662466927;  // 1 / p and 1 / p^2 with p^3 = p + 1
    y_ += 0.5698402909980532;
    x_ -= std::floor(x_);
    y_ -= std::floor(y_);
    x = x_;
    y = y_;
  }

 private:
  double x_, y_;
};

}  // namespace flair::optimizer
