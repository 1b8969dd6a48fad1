// SPDX-License-Identifier: Apache-2.0
#include "strainwave/stiffness/series_stiffness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <variant>

#include "series_model.hpp"

namespace strainwave {
namespace {

/// Compliance of one member: sound, and what its cracks add under each sense of torque.
template <class Real>
struct Member {
  Real intact{};
  Real positive{};
  Real negative{};
  bool usable = true;

  void add(const Real& under_positive, const Real& under_negative) {
    positive += under_positive;
    negative += under_negative;
  }
};

template <class Real>
Member<Real> wave_generator(const GearSet& gear, const Lift<Real>& lift,
                            const StiffnessOptions& options) {
  const WaveGenerator& wg = *gear.wave_generator;
  const SeriesModel<Real> model(gear, lift);
  const auto steel = model.steel(wg.material, "wave_generator.material");
  const Real lobe_force = model.lobe_force();
  const LobeConversion<Real> conversion = model.conversion();
  Member<Real> member;
  member.intact = conversion.all_lobes * model.lobe_compliance(steel, lobe_force);
  for (const WaveGeneratorCrack& any : wg.crack)
    std::visit(
        [&](const auto& crack) {
          if constexpr (requires { crack.stress_driver; }) {
            const Real stress = model.unit_stress(crack, steel, lobe_force);
            const auto added = added_compliance(model.race_crack(crack, steel, stress),
                                                model.plane_strain(steel), options.quadrature);
            member.usable = member.usable && added.converged;
            const Real at_output = conversion.one_lobe * added.matrix(0, 0);
            member.add(at_output, at_output);
          }
        },
        any);
  return member;
}

template <class Real>
Member<Real> flexspline(const GearSet& gear, const Lift<Real>& lift,
                        const StiffnessOptions& options) {
  const Flexspline& fs = *gear.flexspline;
  const SeriesModel<Real> model(gear, lift);
  const auto steel = model.steel(fs.material, "flexspline.material");
  Member<Real> member;
  member.intact = model.sound_flexspline(steel);
  const auto add_wall_crack = [&](const auto& crack) {
    const auto added_under = [&](Faces sense) {
      const auto added = added_compliance(model.wall_crack(crack, steel, sense != Faces::pressed),
                                          model.wall_moduli(crack, steel), options.quadrature);
      member.usable = member.usable && added.converged;
      return Real(added.matrix(kTorsion, kTorsion));
    };
    const BothSenses state = model.faces_of(crack);
    const Real positive = added_under(state.positive);
    const bool same = (state.negative == Faces::pressed) == (state.positive == Faces::pressed);
    member.add(positive, same ? positive : added_under(state.negative));
  };
  for (const FlexsplineCrack& any : fs.crack)
    std::visit(
        [&](const auto& crack) {
          using Crack = std::decay_t<decltype(crack)>;
          if constexpr (std::is_same_v<Crack, DiaphragmGroove>) {
            const Real added = model.groove(crack, steel);
            member.add(added, added);
          } else if constexpr (!std::is_same_v<Crack, RimAxialCrack>) {
            if constexpr (requires { crack.compliance_table; })
              if (crack.compliance_table) {
                const TabulatedCompliance<Real> added = model.tabulated(crack);
                member.add(added.positive.value, added.negative.value);
                return;
              }
            add_wall_crack(crack);
            if constexpr (std::is_same_v<Crack, WallThroughCrack>) {
              const auto open = model.wall_crack(crack, steel, true);
              const double lambda =
                  std::sqrt(value_of(open.shell_parameter_squared(open.half_length)));
              member.usable = member.usable && lambda <= kMaxShellParameter;
            }
          }
        },
        any);
  return member;
}

template <class Real>
Member<Real> output_shaft(const GearSet& gear, const Lift<Real>& lift,
                          const StiffnessOptions& options) {
  const OutputShaft& shaft = *gear.output_shaft;
  const SeriesModel<Real> model(gear, lift);
  const auto steel = model.steel(shaft.material, "output_shaft.material");
  Member<Real> member;
  member.intact = model.sound_shaft(steel);
  const auto add = [&](const auto& crack) {
    const auto added = added_compliance(crack, model.plane_strain(steel), options.quadrature);
    member.usable = member.usable && added.converged;
    const Real at_output = added.matrix(kTorsion, kTorsion);
    member.add(at_output, at_output);
  };
  for (const OutputShaftCrack& any : shaft.crack) {
    const auto& crack = std::get<AnnularCrack>(any);
    if (crack.compliance_table) {
      const TabulatedCompliance<Real> added = model.tabulated(crack);
      member.add(added.positive.value, added.negative.value);
    } else if (shaft.solid()) {
      add(model.solid_shaft_crack(crack));
    } else {
      add(model.hollow_shaft_crack(crack));
      member.usable = member.usable && !clearly_less(sif::AnnularCrackHollow::kMaxDepthRatio,
                                                     model.depth_ratio(crack));
    }
  }
  return member;
}

}  // namespace

template <class Real>
SeriesCompliance<Real> series_compliance(const GearSet& gear, const Lift<Real>& lift,
                                         const StiffnessOptions& options) {
  SeriesCompliance<Real> total;
  const auto add = [&](const Member<Real>& member) {
    total.intact += member.intact;
    total.positive += member.intact + member.positive;
    total.negative += member.intact + member.negative;
    total.positive_added += member.positive;
    total.negative_added += member.negative;
    total.usable = total.usable && member.usable;
  };
  if (gear.wave_generator) add(wave_generator(gear, lift, options));
  if (gear.flexspline) add(flexspline(gear, lift, options));
  if (gear.output_shaft) add(output_shaft(gear, lift, options));
  return total;
}

std::vector<Note> smoothness_notes(const GearSet& gear) {
  std::vector<Note> notes;
  const SeriesModel<double> model(gear);
  if (gear.flexspline) {
    const Flexspline& fs = *gear.flexspline;
    const auto at = [](std::size_t i) { return fmt::format("flexspline.crack[{}]", i); };
    for (std::size_t i = 0; i < fs.crack.size(); ++i) {
      const auto* const arc = std::get_if<DiaphragmArcCrack>(&fs.crack[i]);
      if (arc != nullptr &&
          std::ranges::any_of(fs.diaphragm->profile, [&](const DiaphragmStation& station) {
            return std::abs(station.radius - model.arc_radius(*arc)) <= 1e-12 * station.radius;
          }))
        notes.push_back({"sensitivity.kink",
                         "the arc is at a station of the diaphragm's profile, where the slope of "
                         "the thickness steps: its derivatives are those of the law inside it",
                         at(i), "TC-19"});
      std::visit(
          [&](const auto& crack) {
            if constexpr (requires { crack.angle; }) {
              const BothSenses state = model.faces_of(crack);
              const double normal = model.plane_of(crack).normal[kTorsion];
              const bool touching =
                  state.positive == Faces::touching || state.negative == Faces::touching;
              if (touching && normal != 0)
                notes.push_back({"sensitivity.step",
                                 "the crack is exactly between open and closed, where the "
                                 "stiffness steps: its derivatives, those of the open crack, hold "
                                 "on one side",
                                 at(i), "FR-17"});
            }
          },
          fs.crack[i]);
    }
  }
  if (gear.output_shaft && gear.output_shaft->solid() && !gear.output_shaft->crack.empty())
    notes.push_back({"sensitivity.solid_shaft",
                     "a bore of 0 is a solid shaft, whose crack has a solution of its own: the "
                     "derivative to the bore is that of the sound shaft",
                     "output_shaft.inner_diameter", "FR-12"});
  return notes;
}

template SeriesCompliance<double> series_compliance(const GearSet&, const Lift<double>&,
                                                    const StiffnessOptions&);
template SeriesCompliance<DualReal> series_compliance(const GearSet&, const Lift<DualReal>&,
                                                      const StiffnessOptions&);

}  // namespace strainwave
