// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "strainwave/model/input/gear_set.hpp"

namespace strainwave {

/// A drive in which the numbers at some paths are drawn repeatedly; each thread has its own.
///
/// The ranges and scatters of the drive are removed, because they do not limit the draws and
/// checking them is slow.
class DrawnDrive {
 public:
  /// @param inputs  ranges or scatters of the gear, each with the path of a number
  template <class Inputs>
  DrawnDrive(const GearSet& gear, const Inputs& inputs) : gear_(gear), numbers_(inputs.size()) {
    gear_.range.clear();
    gear_.scatter.clear();
    for_each_number(gear_, [&](const FieldPath& path, const Field&, double& number) {
      const std::string& text = path.text();
      for (std::size_t i = 0; i < inputs.size(); ++i)
        if (inputs[i].path == text) numbers_[i] = &number;
    });
  }
  DrawnDrive(const DrawnDrive&) = delete;  // it holds pointers into itself
  DrawnDrive& operator=(const DrawnDrive&) = delete;

  [[nodiscard]] const GearSet& gear() const { return gear_; }
  /// The number at the path of the input with this index.
  [[nodiscard]] double& number(std::size_t input) { return *numbers_[input]; }

 private:
  GearSet gear_;
  std::vector<double*> numbers_;
};

/// A drawn value of a number that scatters (SN-8).
/// @param centre  the value in the file
/// @param normal  drawn from the standard normal distribution
[[nodiscard]] inline double scattered(const InputScatter& scatter, double centre, double normal) {
  const double s = scatter.relative_standard_deviation;
  return scatter.distribution == ScatterDistribution::lognormal
             ? centre * std::exp(std::sqrt(std::log1p(s * s)) * normal)
             : centre * (1 + s * normal);
}

}  // namespace strainwave
