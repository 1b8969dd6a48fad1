// SPDX-License-Identifier: Apache-2.0
#include "strainwave/growth/rainflow.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstring>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

constexpr std::size_t kGroup = 64;  // one bit of a word for each value
constexpr std::size_t kAhead = 512;

/// What the differences of neighbours say about a group of values.
struct Signs {
  std::uint64_t falls = 0;  ///< bit j: value j is less than the one before it
  bool simple = false;      ///< all values are finite, and neighbours differ
};

// Two numbers that a processor treats at once.
using Pair = double __attribute__((vector_size(16)));
using Words = std::uint64_t __attribute__((vector_size(16)));
constexpr std::size_t kPairs = 4;  // independent of each other, so that they need not wait
constexpr std::size_t kRow = 2 * kPairs;

/// @param x  x[-1] to x[kGroup - 1] are read
Signs signs_of_group(const double* x) {
  Pair sum[kPairs] = {};
  Pair least[kPairs] = {{1, 1}, {1, 1}, {1, 1}, {1, 1}};
  Words signs[kPairs] = {};
  for (std::size_t row = kGroup; row > 0;) {
    row -= kRow;
    for (std::size_t i = 0; i < kPairs; ++i) {
      Pair at;
      Pair before;
      std::memcpy(&at, x + row + 2 * i, sizeof at);
      std::memcpy(&before, x + row + 2 * i - 1, sizeof before);
      const auto difference = std::bit_cast<Words>(at - before);
      const auto size = std::bit_cast<Pair>(difference << 1 >> 1);
      sum[i] += size;  // once infinite or NaN, it stays so
      least[i] = size < least[i] ? size : least[i];
      signs[i] = signs[i] << kRow | difference >> 63;
    }
  }
  Signs found;
  double total = 0.0;
  double smallest = 1.0;
  for (std::size_t i = 0; i < kRow; ++i) {
    found.falls |= signs[i / 2][i % 2] << i;
    total += sum[i / 2][i % 2];
    smallest = std::min(smallest, least[i / 2][i % 2]);
  }
  found.simple = std::isfinite(total) && smallest > 0;
  return found;
}

/// Starts to load the values after a group.  Reading is what limits a history with few reversals.
void load_ahead(std::span<const double> values, std::size_t i) {
  constexpr std::size_t kLine = 8;  // 64 bytes
  if (values.size() - i < kAhead + kGroup) return;
  for (std::size_t j = 0; j < kGroup; j += kLine) __builtin_prefetch(&values[i + kAhead + j]);
}

}  // namespace

std::size_t ReversalFinder::take_carefully(std::span<const double> block, Reversal* found) {
  std::size_t number = 0;
  for (const double value : block) {
    if (!std::isfinite(value))
      throw InputError("history",
                       fmt::format("value {} is {}; give finite numbers only", places_ + 1, value));
    if (turns(value)) found[number++] = last_;
    go({.value = value, .place = places_});
    ++places_;
  }
  return number;
}

std::size_t ReversalFinder::take(std::span<const double> values, std::size_t from, Found& found) {
  const std::size_t end = from + std::min(values.size() - from, kBlock);
  std::size_t number = 0;
  for (std::size_t i = from; i < end;) {
    const double* const x = values.data() + i;
    // A group needs a direction and the value before it.
    Signs signs;
    if (end - i >= kGroup && moved_ && i > 0) {
      load_ahead(values, i);
      signs = signs_of_group(x);
    }
    if (!signs.simple) {
      const std::size_t size = i == 0 ? 1 : std::min(end - i, kGroup);
      number += take_carefully({x, size}, found.data() + number);
      i += size;
      continue;
    }
    // Bit j: the value before value j is a reversal.
    std::uint64_t turned = signs.falls ^ (signs.falls << 1 | (rises_ ? 0U : 1U));
    if ((turned & 1U) != 0) {
      found[number++] = last_;  // equal values may precede
      turned ^= 1U;
    }
    for (; turned != 0; turned &= turned - 1) {
      const auto before = static_cast<std::size_t>(std::countr_zero(turned)) - 1;
      found[number++] = {.value = x[before], .place = places_ + before};
    }
    places_ += kGroup;
    rises_ = signs.falls >> (kGroup - 1) == 0;
    last_ = {.value = x[kGroup - 1], .place = places_ - 1};
    i += kGroup;
  }
  return number;
}

}  // namespace strainwave
