// SPDX-License-Identifier: Apache-2.0
#include "strainwave/life/tooth_root.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

void require_positive(const char* name, double value) {
  require(value > 0 && std::isfinite(value), name, value, "m", "> 0");
}

void require_section(const RootSection& root) {
  require_positive("thickness", root.thickness);
  require_positive("lever", root.lever);
  require_positive("root_radius", root.root_radius);
  require_positive("face_width", root.face_width);
}

}  // namespace

double notch_parameter(const RootSection& root) {
  require_section(root);
  return root.thickness / (2 * root.root_radius);
}

double stress_correction(const RootSection& root) {
  const double q = notch_parameter(root);
  const double L = root.thickness / root.lever;
  return (1.2 + 0.13 * L) * std::pow(q, 1 / (1.21 + 2.3 / L));  // (LI-41)
}

double root_bending_stress(const RootSection& root, double force) {
  require(std::isfinite(force), "force", force, "N", "a finite number");
  return stress_correction(root) * 6 * force * root.lever /
         (root.face_width * root.thickness * root.thickness);  // (LI-41)
}

double notch_support(double root_radius, double tensile_strength) {
  require_positive("root_radius", root_radius);
  require(tensile_strength > 0 && std::isfinite(tensile_strength), "ultimate_strength",
          tensile_strength, "Pa", "> 0");
  constexpr double kA = 0.5;
  constexpr double kB = 2700e6;
  const double gradient = 2 * 1e-3 / root_radius;  // relative, per millimetre
  const double root = gradient <= 0.1 ? std::sqrt(10.0) * gradient
                      : gradient <= 1 ? std::sqrt(gradient)
                                      : std::pow(gradient, 0.25);
  return 1 + root * std::pow(10.0, -(kA + tensile_strength / kB));  // (LI-43)
}

GrooveConcentration groove_concentration(double pitch, double root_radius) {
  require_positive("pitch", pitch);
  require_positive("root_radius", root_radius);
  const double shear = std::sqrt(pitch / (std::numbers::pi * root_radius));  // (LI-42)
  return {.hoop = std::max(1.0, std::numbers::sqrt2 * shear), .shear = std::max(1.0, shear)};
}

}  // namespace strainwave
