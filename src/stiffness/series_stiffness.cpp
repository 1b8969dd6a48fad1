// SPDX-License-Identifier: Apache-2.0
#include "strainwave/stiffness/series_stiffness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include "series_model.hpp"

namespace strainwave {
namespace {

/// Compliance of the cracks of one member under each sense of torque: the one loop over them.
template <class Real>
class CrackSum {
 public:
  CrackSum(const SeriesModel<Real>& model, const QuadratureOptions& options)
      : model_(model), options_(options) {}

  template <class Crack, class Solution>
  void operator()(const Crack&, const LoadedCrack<Solution>& crack) {
    if (crack.table) {
      add(crack.table->positive.value, crack.table->negative.value);
      return;
    }
    const auto added = closed_form(crack, options_);
    usable = usable && crack.in_range && added.positive.converged && added.negative.converged;
    add(model_.at_output(added.positive.matrix), model_.at_output(added.negative.matrix));
  }
  void operator()(const DiaphragmGroove& groove, const LoadedGroove&) {
    const Real added = model_.groove(groove);
    add(added, added);
  }
  template <class Crack>
  void operator()(const Crack&, const ActsInCoupledDrive&) {}

  Real positive{};
  Real negative{};
  bool usable = true;

 private:
  void add(const Real& under_positive, const Real& under_negative) {
    positive += under_positive;
    negative += under_negative;
  }

  const SeriesModel<Real>& model_;
  const QuadratureOptions& options_;
};

template <class Real, class Cracks>
CrackSum<Real> sum_of(const Cracks& cracks, const SeriesModel<Real>& model,
                      const QuadratureOptions& options) {
  CrackSum<Real> sum(model, options);
  for (const auto& any : cracks)
    model.loads().load(any, [&](const auto& crack, const auto& loaded) { sum(crack, loaded); });
  return sum;
}

/// Where a crack of the flexspline makes a derivative one-sided.
class KinksOfCracks {
 public:
  explicit KinksOfCracks(const GearSet& gear) : gear_(gear), loads_(gear) {}

  void note(std::vector<Note>& notes, const DiaphragmArcCrack& arc, const std::string& path) const {
    const double radius = loads_.arc_radius(arc);
    const bool at_station = std::ranges::any_of(
        gear_.flexspline->diaphragm->profile, [&](const DiaphragmStation& station) {
          return std::abs(station.radius - radius) <= 1e-12 * station.radius;
        });
    if (at_station)
      notes.push_back({.code = "sensitivity.kink",
                       .text =
                           "the arc is at a station of the diaphragm's profile, where the slope "
                           "of the thickness steps: its derivatives are those of the law inside "
                           "it",
                       .path = path,
                       .equation = "TC-19",
                       .severity = Severity::care});
  }
  void note(std::vector<Note>& notes, const WallThroughCrack& crack,
            const std::string& path) const {
    note_touching(notes, crack, path);
  }
  void note(std::vector<Note>& notes, const WallSurfaceCrack& crack,
            const std::string& path) const {
    note_touching(notes, crack, path);
  }
  void note(std::vector<Note>&, const DiaphragmGroove&, const std::string&) const {}
  void note(std::vector<Note>&, const RimAxialCrack&, const std::string&) const {}

 private:
  template <class Crack>
  void note_touching(std::vector<Note>& notes, const Crack& crack, const std::string& path) const {
    const BothSenses state = loads_.faces_of(crack);
    const bool touching = state.positive == Faces::touching || state.negative == Faces::touching;
    if (touching && loads_.plane_of(crack).normal[kTorsion] != 0)
      notes.push_back({.code = "sensitivity.step",
                       .text = "the crack is exactly between open and closed, where the stiffness "
                               "steps: its derivatives, those of the open crack, hold on one side",
                       .path = path,
                       .equation = "FR-17",
                       .severity = Severity::care});
  }

  const GearSet& gear_;
  CrackLoads<double> loads_;
};

}  // namespace

template <class Real>
SeriesCompliance<Real> series_compliance(const GearSet& gear, const Lift<Real>& lift,
                                         const StiffnessOptions& options) {
  const SeriesModel<Real> model(gear, lift);
  SeriesCompliance<Real> total;
  const auto add = [&](const Real& intact, const auto& cracks) {
    const auto sum = sum_of(cracks, model, options.quadrature);
    total.intact += intact;
    total.positive += intact + sum.positive;
    total.negative += intact + sum.negative;
    total.positive_added += sum.positive;
    total.negative_added += sum.negative;
    total.usable = total.usable && sum.usable;
  };
  if (gear.wave_generator)
    add(model.conversion().all_lobes * model.lobe_compliance(), gear.wave_generator->crack);
  if (gear.flexspline) add(model.sound_flexspline(), gear.flexspline->crack);
  if (gear.output_shaft) add(model.sound_shaft(), gear.output_shaft->crack);
  return total;
}

std::vector<Note> smoothness_notes(const GearSet& gear) {
  std::vector<Note> notes;
  if (gear.flexspline) {
    const KinksOfCracks kinks(gear);
    for (std::size_t i = 0; i < gear.flexspline->crack.size(); ++i)
      std::visit(
          [&](const auto& crack) {
            kinks.note(notes, crack, fmt::format("flexspline.crack[{}]", i));
          },
          gear.flexspline->crack[i]);
  }
  if (gear.output_shaft && gear.output_shaft->solid() && !gear.output_shaft->crack.empty())
    notes.push_back({.code = "sensitivity.solid_shaft",
                     .text = "a bore of 0 is a solid shaft, whose crack has a solution of its own: "
                             "the derivative to the bore is that of the sound shaft",
                     .path = "output_shaft.inner_diameter",
                     .equation = "FR-12",
                     .severity = Severity::care});
  return notes;
}

template SeriesCompliance<double> series_compliance(const GearSet&, const Lift<double>&,
                                                    const StiffnessOptions&);
template SeriesCompliance<DualReal> series_compliance(const GearSet&, const Lift<DualReal>&,
                                                      const StiffnessOptions&);

}  // namespace strainwave
