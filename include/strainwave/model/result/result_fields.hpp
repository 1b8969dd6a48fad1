// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>

#include "strainwave/model/result/stiffness_result.hpp"

namespace strainwave {

/// Walks the numbers of a crack's strength, of its worst state under either sense of torque:
/// `f(path, quantity)`, path such as "cracks[0].strength.reserve".
template <class F>
void for_each_strength(const CrackStrength& strength, const std::string& path, const F& f) {
  const StrengthState* const worst = strength.worst();
  if (worst == nullptr) return;
  const auto quantity = [&](const char* name, const std::optional<double>& value,
                            std::string_view unit,
                            const std::optional<double>& uncertainty = std::nullopt) {
    if (value) f(path + name, Quantity{*value, unit, uncertainty});
  };
  quantity(".K", worst->K, "Pa*m^0.5", worst->relative_uncertainty);
  quantity(".utilisation", worst->utilisation, "1", worst->relative_uncertainty);
  quantity(".L_r", worst->L_r, "1");
  quantity(".K_r", worst->K_r, "1");
  quantity(".line", worst->line, "1");
  quantity(".reserve", strength.least_reserve(), "1");
  if (worst->brittle_size) quantity(".brittle_size", worst->brittle_size->size, "m");
  if (worst->critical_size) quantity(".critical_size", worst->critical_size->size, "m");
  quantity(".plastic_zone", worst->plastic_zone, "m");
  quantity(".ligament", strength.ligament, "m");
}

/// Walks all quantities of a result in the order of the JSON output:
/// `f(path, quantity)`, path such as "cracked.positive.stiffness".  JSON, CSV, sweep and solve name
/// their outputs by this walk.
template <class F>
void for_each_quantity(const StiffnessResult& result, const F& f) {
  const auto compliances = [&](const std::string& path, const Compliances& c) {
    f(path + ".compliance.wave_generator", c.wave_generator);
    f(path + ".compliance.flexspline", c.flexspline);
    f(path + ".compliance.output_shaft", c.output_shaft);
    f(path + ".compliance.total", c.total);
  };
  compliances("intact", result.intact.compliance);
  f("intact.stiffness", result.intact.stiffness);
  f("intact.wind_up", result.intact.wind_up);
  const auto cracked = [&](const std::string& path, const CrackedDrive& drive) {
    compliances(path, drive.compliance);
    f(path + ".stiffness", drive.stiffness);
    f(path + ".stiffness_change", drive.stiffness_change);
    f(path + ".wind_up", drive.wind_up);
  };
  cracked("cracked.positive", result.positive);
  cracked("cracked.negative", result.negative);

  if (result.curve) {
    const auto lines = [&](const std::string& path, const CurveStiffness& curve) {
      f(path + ".K1", curve.K1);
      f(path + ".K2", curve.K2);
      f(path + ".K3", curve.K3);
    };
    lines("curve.intact", result.curve->intact);
    lines("curve.positive", result.curve->positive);
    lines("curve.negative", result.curve->negative);
  }

  const auto added = [&](const std::string& path, const AddedCompliance& a) {
    f(path + ".at_output", a.at_output);
    if (!a.axial_torsion) return;
    f(path + ".axial_axial", (*a.axial_torsion)[0]);
    f(path + ".axial_torsion", (*a.axial_torsion)[1]);
    f(path + ".torsion_torsion", (*a.axial_torsion)[2]);
  };
  const auto intensities = [&](const std::string& path, const StressIntensities& K) {
    f(path + ".K_I", K.K_I);
    f(path + ".K_II", K.K_II);
    f(path + ".K_III", K.K_III);
  };
  for (std::size_t i = 0; i < result.cracks.size(); ++i) {
    const CrackReport& crack = result.cracks[i];
    const std::string path = "cracks[" + std::to_string(i) + "]";
    added(path + ".added_compliance.positive", crack.positive);
    added(path + ".added_compliance.negative", crack.negative);
    if (crack.deepest) intensities(path + ".stress_intensity.deepest", *crack.deepest);
    if (crack.largest) intensities(path + ".stress_intensity.largest", *crack.largest);
    const auto strength = std::ranges::find(result.strength, crack.path, &CrackStrength::path);
    if (strength != result.strength.end()) for_each_strength(*strength, path + ".strength", f);
  }
}

}  // namespace strainwave
