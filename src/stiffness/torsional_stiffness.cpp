// SPDX-License-Identifier: Apache-2.0
#include "strainwave/stiffness/torsional_stiffness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "member_support.hpp"
#include "strainwave/model/result/input_notes.hpp"
#include "strainwave/stiffness/accuracy.hpp"

namespace strainwave {
namespace {

constexpr std::string_view kStiffnessUnit = "N*m/rad";

/// A sum of independent contributions, each with its own uncertainty.
class Sum {
 public:
  void add(double value, double relative_uncertainty) {
    value_ += value;
    variance_ += std::pow(value * relative_uncertainty, 2);  // (ST-16)
  }
  void add(const Quantity& q) { add(q.value, q.relative_uncertainty.value_or(0.0)); }
  void add(const Sum& other) {
    value_ += other.value_;
    variance_ += other.variance_;
  }

  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] double relative_uncertainty() const {
    return value_ != 0 ? std::sqrt(variance_) / value_ : 0.0;
  }
  [[nodiscard]] Quantity quantity(std::string_view unit) const {
    return {value_, unit, relative_uncertainty()};
  }

 private:
  double value_ = 0.0;
  double variance_ = 0.0;
};

/// The three sound members, and the compliance that the cracks of each add under one sense of
/// torque.
struct Members {
  Sum wave_generator;
  Sum flexspline;
  Sum output_shaft;

  [[nodiscard]] Sum total() const {
    Sum sum;
    for (const Sum& member : {wave_generator, flexspline, output_shaft}) sum.add(member);
    return sum;
  }
  [[nodiscard]] Compliances compliances() const {
    return {wave_generator.quantity(kComplianceUnit), flexspline.quantity(kComplianceUnit),
            output_shaft.quantity(kComplianceUnit), total().quantity(kComplianceUnit)};
  }
  [[nodiscard]] Members plus(const Members& other) const {
    Members sum = *this;
    sum.wave_generator.add(other.wave_generator);
    sum.flexspline.add(other.flexspline);
    sum.output_shaft.add(other.output_shaft);
    return sum;
  }
};

Quantity stiffness_of(const Sum& total) {
  return {1 / total.value(), kStiffnessUnit, total.relative_uncertainty()};  // (ST-1)
}

Quantity wind_up_of(const Sum& total, double torque) {
  return {total.value() * std::abs(torque), "rad", total.relative_uncertainty()};  // (ST-14)
}

CrackedDrive cracked_drive(const Members& intact, const Members& added, double torque) {
  const Members cracked = intact.plus(added);
  const Sum total = cracked.total();
  const Sum extra = added.total();
  CrackedDrive drive;
  drive.compliance = cracked.compliances();
  drive.stiffness = stiffness_of(total);
  drive.wind_up = wind_up_of(total, torque);
  // (ST-15): K/K_intact - 1 without the difference of nearly equal numbers.  The logarithm of -x/(y
  // + x) has the differential (d ln x - d ln y) y/(x + y), so a large loss has a smaller relative
  // uncertainty if x and y are independent.
  const double sound_share = intact.total().value() / total.value();
  drive.stiffness_change = {
      extra.value() == 0 ? 0.0 : -extra.value() / total.value(), "1",
      sound_share *
          accuracy::combined(extra.relative_uncertainty(), intact.total().relative_uncertainty())};
  return drive;
}

/// The largest distances of the drive's quantities from those of the sum, relative to the sum
/// (ST-18), because of what the sum leaves out.
struct LeftOut {
  double compliance = 0.0;
  double stiffness = 0.0;
  double wind_up = 0.0;
  std::optional<double> change = 0.0;  ///< absent if it cannot be stated
};

/// The distances estimated from catalogues, as a multiple of the compliance of the members that the
/// mesh connects.
LeftOut left_out_of(const GearSet& gear, const Members& intact, const Quantity& compliance) {
  if (!gear.wave_generator || !gear.flexspline)
    return {};  // without both members, there is no mesh
  const double left =
      accuracy::kContactsLeftOut * (intact.wave_generator.value() + intact.flexspline.value());
  const double of_drive = left / (compliance.value + left);
  return {.compliance = left / compliance.value,
          .stiffness = of_drive,
          .wind_up = left / compliance.value,
          .change = of_drive};  // (ST-18)
}

/// The distances to the far ends of the intervals of the coupled drive.
LeftOut left_out_of(const CurveStiffness& coupled, const Quantity& compliance,
                    const Quantity& wind_up) {
  const auto far_end = [](double ratio, const Quantity& of) {
    return std::abs(ratio - 1) + ratio * of.relative_uncertainty.value_or(0.0);  // (ST-18)
  };
  LeftOut left;
  for (const Quantity& K : {coupled.K1, coupled.K2, coupled.K3}) {
    const double ratio = K.value * compliance.value;
    left.compliance = std::max(left.compliance, far_end(1 / ratio, K));
    left.stiffness = std::max(left.stiffness, far_end(ratio, K));
  }
  left.wind_up = left.compliance;
  if (coupled.wind_up && wind_up.value > 0)
    left.wind_up = far_end(coupled.wind_up->value / wind_up.value, *coupled.wind_up);
  return left;
}

std::optional<double> left_out_of(const CurveChange& coupled, const Quantity& change) {
  double largest = 0.0;
  for (const Quantity& K : {coupled.K1, coupled.K2, coupled.K3}) {
    if (change.value == 0 && K.value != 0) return std::nullopt;
    if (change.value != 0) largest = std::max(largest, std::abs(K.value / change.value - 1));
  }
  return largest;
}

void widen(Quantity& quantity, std::optional<double> left_out) {
  if (left_out && quantity.relative_uncertainty)
    quantity.relative_uncertainty = accuracy::combined(*quantity.relative_uncertainty, *left_out);
  else
    quantity.relative_uncertainty.reset();
}

template <class Drive>
void widen(Drive& drive, const LeftOut& left_out) {
  widen(drive.compliance.total, left_out.compliance);
  widen(drive.stiffness, left_out.stiffness);
  widen(drive.wind_up, left_out.wind_up);
  if constexpr (requires { drive.stiffness_change; })
    widen(drive.stiffness_change, left_out.change);
}

/// Adds the uncertainty of what the sum leaves out to the accuracies of the sum, with a note.
void contain_left_out(StiffnessResult& result, const GearSet& gear, const Members& intact,
                      const CurveResult* coupled) {
  const auto of = [&](const auto& drive, auto curve) {
    LeftOut left = coupled == nullptr
                       ? left_out_of(gear, intact, drive.compliance.total)
                       : left_out_of(coupled->*curve, drive.compliance.total, drive.wind_up);
    if constexpr (requires { drive.stiffness_change; })
      if (coupled != nullptr)
        left.change = left_out_of((coupled->*curve).change, drive.stiffness_change);
    return left;
  };
  const LeftOut sound = of(result.intact, &CurveResult::intact);
  const auto by_members = [](const auto& drive) {
    return drive.compliance.total.relative_uncertainty.value_or(0.0);
  };
  const MemberUncertainty members_alone{.intact = by_members(result.intact),
                                        .positive = by_members(result.positive),
                                        .negative = by_members(result.negative)};
  widen(result.positive, of(result.positive, &CurveResult::positive));
  widen(result.negative, of(result.negative, &CurveResult::negative));
  widen(result.intact, sound);
  if (sound.compliance == 0) return;
  result.members_alone = members_alone;
  result.accuracies.push_back(
      {"total", sound.compliance,
       std::string(coupled == nullptr ? accuracy::kContactsLeftOut.source
                                      : "contacts, rings and coning are left out; this is the "
                                        "difference from the coupled drive and its accuracy")});
  use_equations(result.equations, {"ST-18"});
  result.notes.push_back(
      {.code = "sum.left_out",
       .text = fmt::format(
           "the sum of the members leaves out the contacts of balls and teeth, the rings and the "
           "coning of the cup, so the drive is softer apart from the errors of the members; the "
           "accuracy of the sum contains this effect; it acts to the softer side. {}",
           coupled == nullptr ? "Catalogues show that without a shaft the sum is 2 to 5 times too "
                                "stiff"
                              : "The coupled drive is the answer"),
       .path = "",
       .equation = "ST-18",
       .severity = coupled == nullptr ? Severity::care : Severity::information,
       .next_step = coupled == nullptr ? "Give the fields that the coupled drive needs." : ""});
}

/// From this contradiction on, the text gives a multiple [-].
constexpr double kManifold = 9.0;

void note_materials(const GearSet& gear, std::vector<Note>& notes) {
  for (const auto& [name, material] : gear.material) {
    const double contradiction = elastic_contradiction(material);
    if (std::abs(contradiction) > 0.005)
      notes.push_back({.code = "material.contradiction",
                       .text = fmt::format("E, G and nu contradict each other: G is {} "
                                           "E/(2(1+nu)); each is used as given",
                                           std::abs(contradiction) < kManifold
                                               ? fmt::format("{:+.2f} % off", 100 * contradiction)
                                               : fmt::format("{:.3g} times", 1 + contradiction)),
                       .path = "material." + name,
                       .equation = "FR-18",
                       .severity = Severity::care,
                       .next_step = "Give two of the three."});
    if (!material.origin.empty())
      notes.push_back(
          {.code = "material.library",
           .text = material.origin,
           .path = "material." + name,
           .equation = "",
           .severity = material.verified ? Severity::information : Severity::care,
           .next_step = material.verified
                            ? ""
                            : "Give the values of your own steel for the unverified numbers."});
  }
}

}  // namespace

StiffnessResult torsional_stiffness(const GearSet& gear, const StiffnessOptions& options) {
  check(gear);
  return stiffness_of_checked(gear, options);
}

StiffnessResult stiffness_of_checked(const GearSet& gear, const StiffnessOptions& options) {
  StiffnessResult result;
  result.method = Method::corrected;
  result.notes = input_notes(gear);
  // Room for the notes and tags of most drives, which would move each time a list grows.
  result.notes.reserve(result.notes.size() + 16);
  result.equations.reserve(64);
  note_materials(gear, result.notes);

  Members intact;
  Members positive;
  Members negative;
  const auto add_member = [&](bool given, std::string_view name, Sum Members::*sum,
                              const auto& compliance) {
    if (!given) {
      result.notes.push_back(
          {.code = "member.absent",
           .text = "the file does not give this member, so it adds no compliance",
           .path = std::string(name),
           .equation = "ST-1",
           .severity = Severity::information});
      return;
    }
    MemberCompliance member = compliance(gear, options);
    (intact.*sum).add(member.intact, member.relative_uncertainty);
    for (CrackReport& crack : member.cracks) {
      (positive.*sum).add(crack.positive.at_output);
      (negative.*sum).add(crack.negative.at_output);
      result.cracks.push_back(std::move(crack));
    }
    for (Note& note : member.notes) result.notes.push_back(std::move(note));
    for (AccuracyBasis& basis : member.accuracies) result.accuracies.push_back(std::move(basis));
    use_equations(result.equations, member.equations);
    if (result.unusable_because.empty())
      result.unusable_because = std::move(member.unusable_because);
  };
  add_member(gear.wave_generator.has_value(), "wave_generator", &Members::wave_generator,
             wave_generator_compliance);
  add_member(gear.flexspline.has_value(), "flexspline", &Members::flexspline,
             flexspline_compliance);
  add_member(gear.output_shaft.has_value(), "output_shaft", &Members::output_shaft,
             output_shaft_compliance);
  use_equations(result.equations, {"ST-1", "ST-14", "ST-15", "ST-16"});

  const Sum total = intact.total();
  result.intact = {.compliance = intact.compliances(),
                   .stiffness = stiffness_of(total),
                   .wind_up = wind_up_of(total, gear.load.torque)};
  result.positive = cracked_drive(intact, positive, gear.load.torque);
  result.negative = cracked_drive(intact, negative, gear.load.torque);
  contain_left_out(result, gear, intact, options.coupled);
  if (gear.article)
    result.notes.push_back(
        {.code = "article.ignored",
         .text = "printed values of the article; only the method as-printed reads them",
         .path = "article",
         .equation = "",
         .severity = Severity::information});
  return result;
}

}  // namespace strainwave
