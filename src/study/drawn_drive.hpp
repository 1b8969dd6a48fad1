// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/model/input/gear_set.hpp"

namespace strainwave {

/// A drive in which the numbers at some paths are drawn repeatedly; each thread has its own.
///
/// The ranges, scatters, correlations and the inspection of the drive are removed, because they do
/// not limit the draws and checking them is slow.
class DrawnDrive {
 public:
  /// @param inputs  paths of numbers, or ranges or scatters, each with the path of a number
  /// @throws InputError  if a path names no number, or one of a range, a scatter or a correlation
  template <class Inputs>
  DrawnDrive(const GearSet& gear, const Inputs& inputs) : gear_(gear), numbers_(inputs.size()) {
    gear_.range.clear();
    gear_.scatter.clear();
    gear_.correlation.clear();
    gear_.inspection.reset();
    for_each_number(gear_, [&](const FieldPath& path, const Field&, double& number) {
      const std::string text = path.text();
      for (std::size_t i = 0; i < inputs.size(); ++i)
        if (path_of(inputs[i]) == text) numbers_[i] = &number;
    });
    for (std::size_t i = 0; i < inputs.size(); ++i)
      if (numbers_[i] == nullptr)
        throw InputError(path_of(inputs[i]),
                         "is not a number of the drive that can be drawn; name a "
                         "number outside of range, scatter and correlation");
  }
  DrawnDrive(const DrawnDrive&) = delete;  // it holds pointers into itself
  DrawnDrive& operator=(const DrawnDrive&) = delete;

  [[nodiscard]] const GearSet& gear() const { return gear_; }
  /// The number at the path of the input with this index.
  [[nodiscard]] double& number(std::size_t input) { return *numbers_[input]; }

 private:
  static const std::string& path_of(const std::string& path) { return path; }
  template <class Input>
  static const std::string& path_of(const Input& input) {
    return input.path;
  }

  GearSet gear_;
  std::vector<double*> numbers_;
};

}  // namespace strainwave
