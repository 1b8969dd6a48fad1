// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/quantity.hpp"
#include "strainwave/model/input/method.hpp"
#include "strainwave/model/result/coupled_result.hpp"
#include "strainwave/model/result/crack_strength.hpp"
#include "strainwave/model/result/crack_turn.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/model/result/life_result.hpp"

namespace strainwave {

/// Compliances of the members at the output [rad/(N*m)].
struct Compliances {
  Quantity wave_generator;
  Quantity flexspline;
  Quantity output_shaft;
  Quantity total;

  template <class Visitor>
  static void describe(Visitor&& field) {
    constexpr std::string_view kUnit = "rad/(N*m)";
    field({"wave_generator", kUnit, "compliance of the wave generator"},
          &Compliances::wave_generator);
    field({"flexspline", kUnit, "compliance of the flexspline"}, &Compliances::flexspline);
    field({"output_shaft", kUnit, "compliance of the output shaft"}, &Compliances::output_shaft);
    field({"total", kUnit, "sum of the members"}, &Compliances::total);
  }
};

/// Sum of the members of the sound drive, without contacts.
struct IntactDrive {
  Compliances compliance;
  Quantity stiffness;  ///< K_HD of the sum at the output with locked input [N*m/rad]
  Quantity wind_up;    ///< twist at the given torque [rad]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"compliance", "", "compliances at the output"}, &IntactDrive::compliance);
    field({"stiffness", "N*m/rad", "K_HD of the sum at the output with locked input"},
          &IntactDrive::stiffness);
    field({"wind_up", "rad", "twist at the given torque"}, &IntactDrive::wind_up);
  }
};

/// Sum of the members of the cracked drive under one sense of torque, without contacts.
struct CrackedDrive {
  Compliances compliance;
  Quantity stiffness;         ///< [N*m/rad]
  Quantity stiffness_change;  ///< K/K_intact - 1 [-]; negative means softer
  Quantity wind_up;           ///< twist at the given torque [rad]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"compliance", "", "compliances at the output"}, &CrackedDrive::compliance);
    field({.name = "stiffness",
           .unit = "N*m/rad",
           .doc = "K_HD of the sum at the output with locked input",
           .headline = true},
          &CrackedDrive::stiffness);
    field({.name = "stiffness_change",
           .unit = "1",
           .doc = "K/K_intact - 1; negative means softer",
           .headline = true},
          &CrackedDrive::stiffness_change);
    field({"wind_up", "rad", "twist at the given torque"}, &CrackedDrive::wind_up);
  }
};

/// The sense of torque that, with the given axial force, opens the faces of a crack.
enum class OpensUnder { neither, positive, negative, both };
template <>
struct EnumNames<OpensUnder> {
  static constexpr std::array<std::string_view, 4> names = {"neither", "positive", "negative",
                                                            "both"};
};

/// K_I, K_II, K_III at one point of a crack front under the given load.  In the corrected method,
/// K_II and K_III have the sign of the shear; in the article's methods they are magnitudes.
struct StressIntensities {
  Quantity K_I;    ///< [Pa*m^0.5]
  Quantity K_II;   ///< [Pa*m^0.5]
  Quantity K_III;  ///< [Pa*m^0.5]

  friend bool operator==(const StressIntensities&, const StressIntensities&) = default;
  /// The mode with the largest magnitude.
  [[nodiscard]] const Quantity& largest() const {
    return *std::max({&K_I, &K_II, &K_III}, [](const Quantity* a, const Quantity* b) {
      return std::abs(a->value) < std::abs(b->value);
    });
  }

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"K_I", "Pa*m^0.5", "opening"}, &StressIntensities::K_I);
    field({"K_II", "Pa*m^0.5", "sliding"}, &StressIntensities::K_II);
    field({"K_III", "Pa*m^0.5", "tearing"}, &StressIntensities::K_III);
  }
};

/// Compliance that one crack adds under one sense of torque.
struct AddedCompliance {
  /// Contribution of the crack to the drive's compliance [rad/(N*m)].
  Quantity at_output;
  /// Symmetric matrix over [axial, torsion] for cracks in flexspline and shaft: axial-axial [m/N],
  /// axial-torsion [1/N], torsion-torsion [rad/(N*m)].
  std::optional<std::array<Quantity, 3>> axial_torsion;

  template <class Visitor>
  static void describe(Visitor&& field) {
    const auto entry = [](std::size_t index) {
      return [index](const AddedCompliance& a) {
        return a.axial_torsion ? std::optional((*a.axial_torsion)[index]) : std::nullopt;
      };
    };
    field({"at_output", "rad/(N*m)", "contribution to the drive's compliance"},
          &AddedCompliance::at_output);
    field({"axial_axial", "m/N", "extension per axial force"}, entry(0));
    field({"axial_torsion", "1/N", "twist per axial force, or extension per torque"}, entry(1));
    field({"torsion_torsion", "rad/(N*m)", "twist per torque"}, entry(2));
  }
};

/// One crack and its evidence.
struct CrackReport {
  std::string path = {};                         ///< "output_shaft.crack[0]"
  std::string kind = {};                         ///< kind of the crack in the file: "annular"
  OpensUnder opens_under = OpensUnder::neither;  ///< sense of torque that opens the faces
  AddedCompliance positive = {};                 ///< what the crack adds under torque about +z
  AddedCompliance negative = {};                 ///< what the crack adds under torque about -z
  /// Stress intensities at the deepest point of the front, or at the tip if the front has no
  /// deepest point.
  std::optional<StressIntensities> deepest = {};
  /// Largest magnitude of each mode along the front.
  std::optional<StressIntensities> largest = {};
  /// Relative uncertainty of the largest K along the front [-]; absent without K.
  std::optional<double> intensity_uncertainty = {};
  /// K_I over a turn of the wave generator at the given torque, at the place of the front where its
  /// range is largest; absent if it was not computed.
  std::optional<TurnRange> at_work = {};
};

/// A value for each sense of torque.
template <class T>
struct BySense {
  T positive;  ///< torque about +z
  T negative;  ///< torque about -z

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"positive", "", "torque about +z"}, &BySense::positive);
    field({"negative", "", "torque about -z"}, &BySense::negative);
  }
};

/// Stress intensities along a front.
struct FrontIntensities {
  std::optional<StressIntensities> deepest;
  std::optional<StressIntensities> largest;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"deepest", "", "values at the deepest point, or at the tip"},
          &FrontIntensities::deepest);
    field({"largest", "", "largest magnitude of each mode along the front"},
          &FrontIntensities::largest);
  }
};

/// All outputs of one crack: its report by the stiffness model, its strength, or both.
struct CrackOutputs {
  const CrackReport* report = nullptr;      ///< null: the stiffness model has no report
  const CrackStrength* strength = nullptr;  ///< null: no strength was computed

  template <class Visitor>
  static void describe(Visitor&& field) {
    using C = CrackOutputs;
    field({"path", "", "field of the input"},
          [](const C& c) { return c.report != nullptr ? c.report->path : c.strength->path; });
    field({"kind", "", "kind of the crack"},
          [](const C& c) { return c.report != nullptr ? c.report->kind : c.strength->kind; });
    const auto of_report = [&](const Field& what, auto value) {
      field(what, [value](const C& c) {
        using Value = std::invoke_result_t<decltype(value), const CrackReport&>;
        return c.report != nullptr ? std::optional<Value>(value(*c.report)) : std::nullopt;
      });
    };
    of_report({"opens_under", "", "sense of torque that opens the faces"},
              [](const CrackReport& r) { return r.opens_under; });
    of_report({"added_compliance", "", "compliance that the crack adds"}, [](const CrackReport& r) {
      return BySense<AddedCompliance>{r.positive, r.negative};
    });
    of_report({"stress_intensity", "", "stress intensities at the given load"},
              [](const CrackReport& r) {
                return FrontIntensities{r.deepest, r.largest};
              });
    field({"at_work", "",
           "K_I over a turn of the wave generator at the given torque, where its range is largest"},
          [](const C& c) { return c.report != nullptr ? c.report->at_work : std::nullopt; });
    field({"strength", "", "strength at the given load"}, [](const C& c) {
      return c.strength != nullptr ? std::optional(*c.strength) : std::nullopt;
    });
  }
};

/// Relative uncertainties of the compliances of the sum by the errors of its members alone (ST-16)
/// [-].
struct MemberUncertainty {
  double intact = 0.0;    ///< sound drive
  double positive = 0.0;  ///< cracked, torque about +z
  double negative = 0.0;  ///< cracked, torque about -z
};

/// Torsional stiffness of a drive, sound and cracked, by one method, with its evidence.
struct StiffnessResult {
  Method method = Method::corrected;
  std::optional<CurveResult> curve;  ///< results of the coupled drive, if it is solved
  std::optional<LifeResult> life;    ///< life over the duty, if the file gives one
  IntactDrive intact;                ///< sum of the members
  CrackedDrive positive;             ///< sum of the members, torque about +z
  CrackedDrive negative;             ///< sum of the members, torque about -z
  std::vector<CrackReport> cracks;   ///< cracks of the stiffness model
  /// Strength of all cracks, if a material gives toughness or yield strength; corrected method
  /// only.
  std::vector<CrackStrength> strength;
  std::vector<Note> notes;                ///< on the validity of the answer
  std::vector<AccuracyBasis> accuracies;  ///< origin of the uncertainties
  /// Present if the sum leaves out contacts, so that the uncertainties of its outputs contain their
  /// effect (ST-18) besides that of the members.
  std::optional<MemberUncertainty> members_alone;
  std::vector<std::string> equations;  ///< tags of the equations used, in order of first use
  /// Reason why the answer must not be used, one sentence; empty if usable.
  std::string unusable_because;

  /// Whether the answer may be used.
  [[nodiscard]] bool usable() const { return unusable_because.empty(); }
  /// The cracks in the order of their reports, then the cracks that have only a strength.
  [[nodiscard]] std::vector<CrackOutputs> crack_outputs() const;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = StiffnessResult;
    field({"method", "", "as-printed, repaired or corrected"}, &R::method);
    field({"curve", "", "the coupled drive: the maker's stiffnesses and the wind-up"}, &R::curve);
    field({"life", "", "life over the duty, without cracks"}, &R::life);
    field({"intact", "", "sum of the members without contacts, sound"}, &R::intact);
    field({"cracked", "", "sum of the members without contacts, with cracks"}, [](const R& r) {
      return BySense<CrackedDrive>{r.positive, r.negative};
    });
    field({"cracks", "", "outputs of each crack"}, &R::crack_outputs);
  }
};

}  // namespace strainwave
