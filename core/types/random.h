// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace hydrabench {

/// Counter-based random numbers: value i of a stream is a pure function of (seed, stream, i), so
/// that parallel loops need no shared state and give the same numbers for any thread count. The
/// mixer is SplitMix64's finaliser (Steele et al., OOPSLA 2014).
constexpr std::uint64_t mixBits(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}
constexpr std::uint64_t hashSeed(std::uint64_t a, std::uint64_t b) {
  return mixBits(mixBits(a) ^ (b + 0x632be59bd9b4e019ull));
}

/// A stream of numbers; cheap to make, copy and fork.
class Random {
 public:
  explicit constexpr Random(std::uint64_t seed) : state_(mixBits(seed)) {}
  constexpr Random(std::uint64_t seed, std::uint64_t stream) : state_(hashSeed(seed, stream)) {}

  constexpr std::uint64_t bits() { return mixBits(state_ += 0x9e3779b97f4a7c15ull); }
  constexpr double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }  ///< [0, 1)
  constexpr double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// [0, count), unbiased to 2^-32.
  constexpr std::uint32_t index(std::uint32_t count) {
    return static_cast<std::uint32_t>(((bits() >> 32) * count) >> 32);
  }
  constexpr bool chance(double probability) { return uniform() < probability; }
  /// Mean 0, deviation 1 (Box and Muller; one of the pair is thrown away).
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }
  /// An independent stream for a part of the work.
  constexpr Random fork(std::uint64_t stream) const { return Random(state_, stream); }

 private:
  std::uint64_t state_;
};

}  // namespace hydrabench
