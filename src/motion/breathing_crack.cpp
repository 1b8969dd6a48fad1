// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/breathing_crack.hpp"

#include <cmath>
#include <numbers>

#include "strainwave/core/error.hpp"
#include "strainwave/core/multiple_angle.hpp"

namespace strainwave {

using std::numbers::pi;

namespace {
constexpr std::size_t kSamples = 16;  // angles per coefficient at which an opening is checked
constexpr double kRounding = 1e-12;

/// A crack never heals (MO-50).
void require_growth(const Profile& growth, const FieldPath& at) {
  require_constants(growth, at.text());
  const std::vector<double>& values = growth.value;
  for (std::size_t k = 0; k < values.size(); ++k) {
    require(values[k] >= 0, at[k].text(), values[k], "rad/(N*m)", ">= 0");
    if (k > 0)
      require(values[k] >= values[k - 1], at[k].text(), values[k], "rad/(N*m)",
              "at least the value before");
  }
}

}  // namespace

AngleOpening::At AngleOpening::at(double angle) const {
  MultipleAngle multiple(order * angle - phase);
  At result{.value = coefficients[0]};
  for (std::size_t k = 1; k < coefficients.size(); ++k) {
    multiple.next();
    result.value += coefficients[k] * multiple.cosine();                                 // (MO-6)
    result.slope -= coefficients[k] * static_cast<double>(k) * order * multiple.sine();  // (MO-6)
  }
  return result;
}

std::vector<double> mayes_opening() { return {0.5, 0.5}; }

std::vector<double> gasch_opening(int terms) {
  require(terms >= 1, "terms", terms, "1", ">= 1");
  std::vector<double> coefficients{0.5};
  for (int n = 0; n < terms; ++n) {
    const int k = 2 * n + 1;
    const double smooth = 1 - k / (2.0 * terms);  // Fejér's factor
    if (k > 1) coefficients.push_back(0.0);
    coefficients.push_back((n % 2 == 0 ? 2 : -2) / (pi * k) * smooth);  // (MO-7)
  }
  return coefficients;
}

OpenCompliance open_compliance(const std::vector<BreathingCrack>& cracks, double torque_sign,
                               double input_angle, double output_angle, double time) {
  OpenCompliance sum;
  for (const BreathingCrack& crack : cracks) {
    if (crack.sense && (*crack.sense == OpeningSense::positive) != (torque_sign > 0)) continue;
    const double compliance = crack.growth ? crack.growth->at(time) : crack.compliance;
    const double rate = crack.growth ? crack.growth->slope(time) : 0.0;
    if (!crack.opening) {
      sum.value += compliance;
      sum.by_time += rate;
      continue;
    }
    const bool input = crack.opening->shaft == BreathingShaft::input;
    const AngleOpening::At b = crack.opening->at(input ? input_angle : output_angle);
    sum.value += compliance * b.value;  // (MO-5)
    (input ? sum.by_input : sum.by_output) += compliance * b.slope;
    sum.by_time += rate * b.value;  // (MO-50)
  }
  return sum;
}

void require_constants(const std::vector<BreathingCrack>& cracks) {
  const FieldPath at("crack");
  for (std::size_t i = 0; i < cracks.size(); ++i) {
    const BreathingCrack& crack = cracks[i];
    require(crack.compliance >= 0 && std::isfinite(crack.compliance), (at[i] / "compliance").text(),
            crack.compliance, "rad/(N*m)", ">= 0");
    if (crack.growth) require_growth(*crack.growth, at[i] / "growth");
    if (!crack.opening) continue;
    const auto& opening = *crack.opening;
    require(opening.order > 0 && std::isfinite(opening.order), (at[i] / "order").text(),
            opening.order, "1", "> 0");
    require(std::isfinite(opening.phase), (at[i] / "phase").text(), opening.phase, "rad",
            "a finite number");
    if (opening.coefficients.empty())
      throw InputError((at[i] / "coefficients").text(), "must have at least one value");
    for (const double c : opening.coefficients)
      require(std::isfinite(c), (at[i] / "coefficients").text(), c, "1", "a finite number");
    const auto samples = static_cast<int>(kSamples * opening.coefficients.size());
    for (int n = 0; n < samples; ++n) {
      const double b = opening.at((2 * pi * n / samples + opening.phase) / opening.order).value;
      require(b >= -kRounding && b <= 1 + kRounding, (at[i] / "coefficients").text(), b, "1",
              "an opening from 0 to 1 at every angle");
    }
  }
}

}  // namespace strainwave
