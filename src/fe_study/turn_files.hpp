// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>

#include "strainwave/fe_study/output_files.hpp"
#include "strainwave/fe_study/turn_run.hpp"

namespace strainwave::fe_study {

/// Stem of the files of one size: "flexspline_crack_0", and with several sizes also "_size_1".
inline std::string size_stem(const TurnRun& run, std::size_t size) {
  const std::string stem = file_stem(run.path);
  return run.sizes.size() == 1 ? stem : fmt::format("{}_size_{}", stem, size);
}

/// Stem of the files of one torque; the torques ascend.
inline std::string torque_stem(const std::string& size_stem, std::size_t torque) {
  return fmt::format("{}_torque_{}", size_stem, torque);
}

}  // namespace strainwave::fe_study
