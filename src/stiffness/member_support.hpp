// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "series_model.hpp"
#include "strainwave/core/compare.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/fracture/crack_compliance.hpp"
#include "strainwave/sif/member/ring_edge.hpp"
#include "strainwave/sif/member/semi_ellipse.hpp"
#include "strainwave/stiffness/accuracy.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"

// Reporting of cracks, shared by the three members.

namespace strainwave {

inline constexpr std::string_view kComplianceUnit = "rad/(N*m)";
inline constexpr std::string_view kStressIntensityUnit = "Pa*m^0.5";

/// Adds tags unless they are there already.
template <class Tags = std::initializer_list<std::string_view>>
void use_equations(std::vector<std::string>& equations, const Tags& tags) {
  for (const std::string_view tag : tags) {
    // Most tags differ in the last digit, so few of them are compared as a whole.
    const auto same = [tag](const std::string& known) {
      return known.back() == tag.back() && known == tag;
    };
    if (std::ranges::none_of(equations, same)) equations.emplace_back(tag);
  }
}

/// Records the basis of an uncertainty.
inline void rest_on(MemberCompliance& member, std::string_view path,
                    const ModelAccuracy& accuracy) {
  member.accuracies.push_back({std::string(path), accuracy, std::string(accuracy.source)});
}

inline OpensUnder opens_under(Faces positive, Faces negative) {
  const bool p = positive == Faces::open;
  const bool n = negative == Faces::open;
  return p ? (n ? OpensUnder::both : OpensUnder::positive)
           : (n ? OpensUnder::negative : OpensUnder::neither);
}

/// K of all modes at one point, at the given loads.
template <std::size_t N>
std::array<double, 3> intensity(const UnitStressIntensity<N>& k,
                                const std::array<double, N>& load) {
  std::array<double, 3> K{};
  for (std::size_t i = 0; i < N; ++i) {
    K[0] += k.I[i] * load[i];
    K[1] += k.II[i] * load[i];
    K[2] += k.III[i] * load[i];
  }
  return K;
}

/// Relative uncertainties of K_I, K_II, K_III.
using ModeUncertainties = std::array<double, 3>;

inline ModeUncertainties all_modes(double uncertainty) {
  return {uncertainty, uncertainty, uncertainty};
}

inline StressIntensities stress_intensities(const std::array<double, 3>& K,
                                            const ModeUncertainties& u) {
  const auto quantity = [&](std::size_t m) { return Quantity{K[m], kStressIntensityUnit, u[m]}; };
  return {quantity(0), quantity(1), quantity(2)};
}

/// Fills in the stress intensities at the given load: at the deepest point and along the front.
template <SweptCrack Crack>
void report_intensities(CrackReport& report, const Crack& crack,
                        const std::array<double, Crack::kLoads>& load,
                        const ModeUncertainties& uncertainties) {
  std::array<double, 3> largest{};
  std::array<double, 3> deepest{};  // the last point of the front
  const auto take = [&](const UnitStressIntensity<Crack::kLoads>& k) {
    deepest = intensity(k, load);
    for (std::size_t m = 0; m < 3; ++m)
      if (std::abs(deepest[m]) > std::abs(largest[m])) largest[m] = deepest[m];
  };
  const auto [begin, end] = crack.front();
  if constexpr (LinearFront<Crack>) {  // largest at one of the ends
    const auto k = crack.family().linear_stress_intensity(crack.size());
    for (const double s : {begin, end}) take(k.at(s));
  } else {
    constexpr int kFrontPoints = 33;  // points on half of a front; K varies slowly along it
    const int n = begin == end ? 1 : kFrontPoints;
    for (int i = 0; i < n; ++i)
      take(crack.stress_intensity(crack.size(),
                                  n == 1 ? begin : begin + (end - begin) * i / (n - 1)));
  }
  report.deepest = stress_intensities(deepest, uncertainties);
  report.largest = stress_intensities(largest, uncertainties);
  report.intensity_uncertainty = std::ranges::max(uncertainties);
}

/// Marks the answer as not usable if a crack of depth a leaves almost nothing of the thickness t.
inline void demand_ligament(MemberCompliance& member, const std::string& path, double depth,
                            double thickness) {
  if (!clearly_less(sif::kUsableDepthRatio * thickness, depth)) return;
  member.unusable_because = fmt::format(
      "{}: the depth is {:.4g} of the thickness; beyond {:g} too little is left for the stress "
      "intensity of a surface crack or an edge crack",
      path, depth / thickness, sif::kUsableDepthRatio);
}

/// Accuracy of Newman and Raju's fit for a surface crack, with a note outside its range.
inline ModelAccuracy surface_crack_fit(MemberCompliance& member, const std::string& path,
                                       double depth, double aspect_ratio, double thickness) {
  ModelAccuracy fit = accuracy::kSurfaceCrack;
  demand_ligament(member, path, depth, thickness);
  if (clearly_less(sif::kFittedDepthRatio * thickness, depth) ||
      clearly_less(aspect_ratio, sif::kFittedAspectRatio)) {
    fit = accuracy::kSurfaceCrackExtrapolated;
    member.notes.push_back(
        {.code = "crack.surface_range",
         .text = fmt::format(
             "a/t = {:.3g} and a/c = {:.3g}: the stress intensity was fitted to a/t "
             "<= {:g} and a/c >= {:g}, and is extrapolated",
             depth / thickness, aspect_ratio, sif::kFittedDepthRatio, sif::kFittedAspectRatio),
         .path = path,
         .equation = "FR-4",
         .severity = Severity::care});
  } else if (clearly_less(0.7 * thickness, depth)) {
    fit = accuracy::kSurfaceCrackDeep;
  }
  rest_on(member, path, fit);
  return fit;
}

/// Matrix over [axial, torsion] as quantities; `axial` is the uncertainty of entries with the
/// axial force, `torsion` of the torsional one.
inline std::array<Quantity, 3> axial_torsion(const SymmetricMatrix<2>& matrix, double axial,
                                             double torsion) {
  return {Quantity{matrix(kAxial, kAxial), "m/N", axial},
          Quantity{matrix(kAxial, kTorsion), "1/N", std::max(axial, torsion)},
          Quantity{matrix(kTorsion, kTorsion), kComplianceUnit, torsion}};
}

/// Added compliances of a crack by its table of finite elements, under both senses of torque with
/// their errors, and the note that names the table.
template <class Crack>
void take_from_table(CrackReport& report, MemberCompliance& member, const GearSet& gear,
                     const Crack& crack, const TabulatedCompliance<double>& added) {
  const ComplianceTable& table = gear.compliance_tables.at(*crack.compliance_table);
  const auto quantity = [&](const TabulatedValue<double>& value, std::string_view unit) {
    // (FE-42): error of the table's points and of the interpolation between them.
    return Quantity{value.value, unit,
                    accuracy::combined(table.point_error, value.relative_error)};  // (FE-42)
  };
  report.positive.at_output = quantity(added.positive, kComplianceUnit);
  report.negative.at_output = quantity(added.negative, kComplianceUnit);
  if (!table.axial.values.empty()) {
    const std::array<Quantity, 3> matrix = {quantity(added.axial, "m/N"), Quantity{0.0, "1/N", 0.0},
                                            report.positive.at_output};
    report.positive.axial_torsion = matrix;
    report.negative.axial_torsion = matrix;
  }
  use_equations(member.equations, {"FE-41", "FE-42", "FE-43"});
  const double between = std::max(added.positive.relative_error, added.negative.relative_error);
  const double error = accuracy::combined(table.point_error, between);
  member.accuracies.push_back(
      {report.path, error,
       fmt::format("{}: points {:.2g} %, between them {:.2g} %", shown(*crack.compliance_table),
                   100 * table.point_error, 100 * between)});
  member.notes.push_back(
      {.code = "crack.compliance_table",
       .text = fmt::format(
           "compliance by finite elements, interpolated from {} ({}), within {:.2g} %{}; "
           "stress intensity and strength remain those of the closed form",
           shown(*crack.compliance_table), shown(table.made_by), 100 * error,
           table.negative.scale == TableValues::Scale::nothing
               ? "; under negative torque it adds nothing"
           : table.positive.scale == TableValues::Scale::nothing
               ? "; under positive torque it adds nothing"
               : ""),
       .path = report.path,
       .equation = "FE-41",
       .severity = Severity::information});
}

/// Base of the classes that add the cracks of one member; each derived class has an `add` for each
/// kind.
struct CrackAdder {
  void use(std::initializer_list<std::string_view> tags) { use_equations(member.equations, tags); }

  const GearSet& gear;
  const SeriesModel<double>& model;
  const StiffnessOptions& options;
  MemberCompliance& member;
};

/// Adds the cracks of a member, each by the overload of `adder.add` for its kind.  Cracks that act
/// through contacts, which the series model leaves out, get a note instead.
template <class Cracks, class Adder>
void add_cracks(MemberCompliance& member, const CrackLoads<double>& loads, std::string_view name,
                const Cracks& cracks, Adder adder) {
  for_each_crack(name, cracks, [&]<class Crack>(const std::string& path, const Crack& crack) {
    if constexpr (ContactCrack<Crack>)
      member.notes.push_back(
          {.code = "crack.contact_path",
           .text = "the series model has no contacts of balls and teeth, so this crack, which acts "
                   "through them, adds no compliance here",
           .path = path,
           .equation = "ST-1",
           .severity = adder.options.left_out(),
           .next_step = "Run strainwave torsion, whose coupled drive contains this crack."});
    else
      loads.load(crack, [&](const auto& loaded) {
        adder.add({.path = path, .kind = std::string(Crack::kKind)}, crack, loaded);
      });
  });
}

/// Note that cracks of one member are added without interaction.
inline void note_superposition(std::vector<Note>& notes, std::size_t n_cracks,
                               std::string_view member) {
  if (n_cracks > 1)
    notes.push_back({.code = "crack.superposed",
                     .text = "the compliances of the cracks of this member are added; the "
                             "interaction of the cracks is left out",
                     .path = std::string(member),
                     .equation = "ST-1",
                     .severity = Severity::care});
}

/// Notes that a quadrature did not reach its tolerance, and marks the answer as unusable.
inline void demand_convergence(MemberCompliance& member, const CrackReport& report,
                               double relative_error, bool converged) {
  if (converged) return;
  member.unusable_because = "the crack integral of " + report.path +
                            " did not converge: relative error " +
                            fmt::format("{:.2g}", relative_error);
}

}  // namespace strainwave
