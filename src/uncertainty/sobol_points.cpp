// SPDX-License-Identifier: Apache-2.0
#include "strainwave/uncertainty/sobol_points.hpp"

#include <boost/random/sobol.hpp>

#include "strainwave/core/counter_random.hpp"

namespace strainwave {

SobolPoints::SobolPoints(std::size_t dimensions, std::size_t points)
    : dimensions_(dimensions), points_(points), plain_(dimensions * points) {
  boost::random::sobol_engine<std::uint32_t, 32> engine(dimensions);
  // The engine leaves out the first point, 0, without which 2^k points are not balanced.
  for (std::size_t n = dimensions; n < plain_.size(); ++n)
    plain_[n] = static_cast<std::uint32_t>(engine());
}

double SobolPoints::at(std::size_t point, std::size_t dimension, std::uint64_t scrambling) const {
  constexpr int kBits = 32;
  const std::uint32_t plain = plain_[point * dimensions_ + dimension];
  const std::uint64_t key = splitmix64(scrambling, dimension);
  std::uint32_t scrambled = plain;
  for (int bit = 0; bit < kBits; ++bit) {
    // (UQ-1): a bit is flipped or not by all higher bits, which select its place in the tree.
    const std::uint64_t higher = bit == 0 ? 0 : plain >> (kBits - bit);
    const std::uint64_t branch = (std::uint64_t{1} << bit) | higher;
    scrambled ^= static_cast<std::uint32_t>(splitmix64(key, branch) >> 63U) << (kBits - 1 - bit);
  }
  return (static_cast<double>(scrambled) + 0.5) * 0x1p-32;
}

}  // namespace strainwave
