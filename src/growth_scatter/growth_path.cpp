// SPDX-License-Identifier: Apache-2.0
#include "strainwave/growth_scatter/growth_path.hpp"

#include <algorithm>
#include <cmath>

#include "strainwave/core/counter_random.hpp"

namespace strainwave {

GrowthPath::GrowthPath(const PathScatter& scatter, std::uint64_t seed, std::uint64_t draw,
                       double size)
    : scatter_(scatter), seed_(seed), draw_(draw), first_(size) {
  if (scatter.wander_length > 0) wander_ = scatter.wander * normal(2 * drawn_wander_++);
  if (scatter.white_step > 0) white_ = scatter.white * normal(2 * drawn_white_++ + 1);
}

double GrowthPath::normal(std::uint64_t index) const { return counter_normal(seed_, draw_, index); }

double GrowthPath::wander_end() const {
  if (!(scatter_.wander_length > 0)) return kNever;
  return first_ * std::exp(static_cast<double>(wander_cells_ + 1) * scatter_.wander_length /
                           kCells);  // (GS-13)
}

double GrowthPath::white_end() const {
  if (!(scatter_.white_step > 0)) return kNever;
  return first_ + static_cast<double>(white_cells_ + 1) * scatter_.white_step;  // (GS-13)
}

double GrowthPath::end() const { return std::min(wander_end(), white_end()); }

void GrowthPath::next() {
  const double of_wander = wander_end();
  const double of_white = white_end();
  if (of_wander <= of_white && of_wander < kNever) {
    const double kept = std::exp(-1.0 / kCells);
    wander_ = kept * wander_ + scatter_.wander * std::sqrt(1 - kept * kept) *
                                   normal(2 * drawn_wander_++);  // (GS-13)
    ++wander_cells_;
  }
  if (of_white <= of_wander && of_white < kNever) {
    white_ = scatter_.white * normal(2 * drawn_white_++ + 1);  // (GS-13)
    ++white_cells_;
  }
}

void GrowthPath::go_on(double size) {
  first_ = size;
  wander_cells_ = 0;
  white_cells_ = 0;
}

}  // namespace strainwave
