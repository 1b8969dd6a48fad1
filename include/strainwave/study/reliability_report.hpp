// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/progress.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/study/require.hpp"
#include "strainwave/study/table_evidence.hpp"

/// @file
/// Probability that a drive whose inputs scatter does not meet a requirement.

namespace strainwave {

/// The road to a probability that can be trusted most.
enum class ReliabilityRoad {
  monte_carlo,          ///< plain draws
  importance_sampling,  ///< draws about the design point, or about all centres of failures
  none,                 ///< only limits can be stated
};
template <>
struct EnumNames<ReliabilityRoad> {
  static constexpr std::array<std::string_view, 3> names = {"monte-carlo", "importance-sampling",
                                                            "none"};
};

/// One input at the design point.
struct DesignPointInput {
  std::string path;
  std::string_view unit;
  double value = 0.0;       ///< in the file
  double at_design = 0.0;   ///< where failure is most likely
  double deviations = 0.0;  ///< distance between the two in standard deviations, z* [-]
  double importance = 0.0;  ///< share in the variance of the margin at the design point [-]; (UQ-9)

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    using I = DesignPointInput;
    field({"path", "", "field of the input"}, &I::path);
    field({"unit", "", "SI unit of the field"}, &I::unit);
    field({"value", kUnitBeside, "value in the file"}, &I::value);
    field({"at_design", kUnitBeside, "value at the design point"}, &I::at_design);
    field({"deviations", "1", "standard normal deviate at the design point"}, &I::deviations);
    field({"importance", "1", "share in the variance of the margin at the design point"},
          &I::importance);
  }
};

/// First-order reliability, (UQ-4).
struct FirstOrderReliability {
  bool converged = false;
  double reliability_index = 0.0;        ///< beta [-]
  double probability = 0.0;              ///< Phi(-beta) [-]
  int iterations = 0;                    ///< of the search
  std::string reason;                    ///< why the search found no design point
  std::vector<DesignPointInput> inputs;  ///< the most important first; empty without a point

  template <class Visitor>
  static void describe(Visitor&& field) {
    using F = FirstOrderReliability;
    field({"converged", "", "whether the design point was found"}, &F::converged);
    field({"reliability_index", "1", "distance of the design point from the inputs of the file"},
          &F::reliability_index);
    field({"probability", "1", "probability, first order"}, &F::probability);
    field({"iterations", "", "steps of the search"}, &F::iterations);
    field({"reason", "", "why no design point was found; empty if it was"}, &F::reason);
    field({"inputs", "", "the design point, the most important input first"}, &F::inputs);
  }
};

/// Second-order reliability, (UQ-5).
struct SecondOrderReliability {
  std::optional<double> probability;
  std::vector<double> curvatures;  ///< principal curvatures of the limit [-]
  std::string reason;              ///< reason for an absent probability

  template <class Visitor>
  static void describe(Visitor&& field) {
    using S = SecondOrderReliability;
    field({"probability", "1", "probability, second order"}, &S::probability);
    field({"curvatures", "1", "principal curvatures of the limit at the design point"},
          &S::curvatures);
    field({"reason", "", "reason for an absent probability; empty if the probability is given"},
          &S::reason);
  }
};

/// A probability from draws, (UQ-6), (UQ-7).
struct DrawnReliability {
  int draws = 0;
  int failures = 0;
  int without_value = 0;        ///< draws without a usable drive
  double probability = 0.0;     ///< [-]
  double standard_error = 0.0;  ///< [-]
  double low = 0.0;             ///< of the 95 % interval [-]
  double high = 1.0;            ///< the same; draws without a drive count as failures here [-]

  template <class Visitor>
  static void describe(Visitor&& field) {
    using D = DrawnReliability;
    field({"draws", "", "evaluated drives"}, &D::draws);
    field({"failures", "", "drives that do not meet the requirement"}, &D::failures);
    field({"without_value", "", "draws that lead to no usable drive"}, &D::without_value);
    field({"probability", "1", "estimate"}, &D::probability);
    field({"standard_error", "1", "standard error of the estimate"}, &D::standard_error);
    field({"low", "1", "lower end of the 95 % interval"}, &D::low);
    field({"high", "1", "upper end of it; draws without a usable drive count as failures"},
          &D::high);
  }
};

/// One requirement and the probability that it is not met.
struct RequirementReliability {
  Requirement requirement;  ///< the requirement whose failure is counted
  Quantity value = {};      ///< output at the inputs of the file
  FirstOrderReliability first_order = {};
  std::optional<SecondOrderReliability> second_order = {};
  std::optional<DrawnReliability> importance_sampling = {};
  DrawnReliability monte_carlo = {};
  ReliabilityRoad trusted = ReliabilityRoad::none;  ///< the road that gives `probability`
  std::optional<double> probability = {};           ///< by the trusted road [-]; absent without one
  double low = 0.0;   ///< limits that contain it with 95 % confidence [-]
  double high = 1.0;  ///< upper limit [-]; draws without a usable drive count as failures
  std::optional<TableEvidence> tables = {};  ///< absent if the engine computed all draws

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = RequirementReliability;
    const auto shown = [](std::string_view name, std::string_view unit, std::string_view doc) {
      return Field{.name = name, .unit = unit, .doc = doc, .headline = true};
    };
    field(shown("output", "", "name of the output"),
          [](const R& r) { return r.requirement.output; });
    field(shown("comparison", "", "how the output must compare with the bound"),
          [](const R& r) { return r.requirement.comparison; });
    field(shown("bound", kUnitBeside, "the bound"), [](const R& r) {
      return Quantity{r.requirement.bound, r.requirement.unit};
    });
    field(shown("value", kUnitBeside, "the output at the inputs of the file"), &R::value);
    field(shown("probability", "1", "probability that the requirement is not met"),
          &R::probability);
    field(shown("low", "1", "lower end of its 95 % interval"), &R::low);
    field(shown("high", "1", "upper end of its 95 % interval"), &R::high);
    field(shown("trusted", "", "where the probability comes from"), &R::trusted);
    field({"first_order", "", "by the nearest failure"}, &R::first_order);
    field({"second_order", "", "with the curvature of the limit"}, &R::second_order);
    field({"importance_sampling", "",
           "by draws about the nearest failure, or about each cause of failures"},
          &R::importance_sampling);
    field({"monte_carlo", "", "by plain draws"}, &R::monte_carlo);
    field(
        {"tables", "", "error of the tables that the draws read; absent: the engine computed all"},
        &R::tables);
  }
};

/// Probabilities of a drive whose inputs scatter.
struct ReliabilityReport {
  std::vector<RequirementReliability> answers;
  std::uint64_t seed = 0;
  std::vector<Note> notes;  ///< remarks on the validity of the probabilities

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"requirements", "", "each requirement and its probability"},
          &ReliabilityReport::answers);
    field({"seed", "", "seed of the draws"}, &ReliabilityReport::seed);
  }
};

/// The notes of a report.
[[nodiscard]] ResultEvidence evidence_of(const ReliabilityReport& report);

/// Largest number of plain draws.
inline constexpr int kMaxReliabilityDraws = 10'000'000;

/// Draws of a study of reliability.
struct ReliabilitySettings {
  /// Plain draws; absent: 200000 for outputs of the sum of the members, 20000 for strength margins,
  /// 2000 for others.
  std::optional<int> draws = {};
  std::uint64_t seed = 1;  ///< of the draws
  int threads = 0;         ///< 0: as many as the machine runs; the answer does not depend on it
};

/// Probability that each requirement is not met, by four roads.
///
/// Implements theory manual eqs. (UQ-4) to (UQ-7), and (UQ-10), (UQ-11) for failures by several
/// causes.  First and second order describe the limit at the design point; draws about the failures
/// and plain draws judge both.  The answer says which road to trust.  The uncertainty of the
/// model's form is not part of the probability.
///
/// @throws InputError  if the file gives no scatter, or a setting is out of range
[[nodiscard]] ReliabilityReport reliability_of(const GearSet& gear,
                                               const std::vector<Requirement>& requirements,
                                               const ReliabilitySettings& settings = {},
                                               const Progress& progress = {});

/// Reads requirements on the outputs of a drive.
/// @param gear   the drive; evaluated for its outputs and their units
/// @param texts  as in `require_outputs`
/// @throws InputError  if there is none, a text cannot be read, or does not name an output
[[nodiscard]] std::vector<Requirement> requirements_on(const GearSet& gear,
                                                       const std::vector<std::string>& texts);

}  // namespace strainwave
