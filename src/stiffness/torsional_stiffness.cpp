// SPDX-License-Identifier: Apache-2.0
#include "strainwave/stiffness/torsional_stiffness.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "member_support.hpp"
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
  // (ST-15): K/K_intact - 1 without the difference of nearly equal numbers.  For -x/(y + x) with
  // independent x and y, d ln = (d ln x - d ln y) y/(x + y), so a large loss has a smaller relative
  // uncertainty.
  const double sound_share = intact.total().value() / total.value();
  drive.stiffness_change = {
      extra.value() == 0 ? 0.0 : -extra.value() / total.value(), "1",
      sound_share *
          accuracy::combined(extra.relative_uncertainty(), intact.total().relative_uncertainty())};
  return drive;
}

void note_materials(const GearSet& gear, std::vector<Note>& notes) {
  for (const auto& [name, material] : gear.material) {
    const double contradiction = elastic_contradiction(material);
    if (std::abs(contradiction) > 0.005)
      notes.push_back({.code = "material.contradiction",
                       .text = fmt::format("E, G and nu contradict each other: G is {:+.2f} % off "
                                           "E/(2(1+nu)); each is used as given",
                                           100 * contradiction),
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
           .next_step = material.verified ? "" : "Give the unverified numbers of your own steel."});
  }
}

}  // namespace

StiffnessResult torsional_stiffness(const GearSet& gear, const StiffnessOptions& options) {
  check(gear);
  StiffnessResult result;
  result.method = Method::corrected;
  note_materials(gear, result.notes);

  Members intact;
  Members positive;
  Members negative;
  const auto add_member = [&](bool given, std::string_view name, Sum Members::*sum,
                              const auto& compliance) {
    if (!given) {
      result.notes.push_back({.code = "member.absent",
                              .text = "not in the file: it adds no compliance",
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
