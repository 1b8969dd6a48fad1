// SPDX-License-Identifier: Apache-2.0
#include "strainwave/stiffness/series_stiffness.hpp"

#include <algorithm>
#include <variant>

#include "series_model.hpp"
#include "strainwave/drive_cracks/drive_cracks.hpp"

namespace strainwave {
namespace {

/// Compliance of the cracks of one member under each sense of torque.
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
    std::visit(
        [&](const auto& crack) {
          model.loads().load(crack, [&](const auto& loaded) { sum(crack, loaded); });
        },
        any);
  return sum;
}

}  // namespace

template <class Real>
SeriesCompliance<Real> series_compliance(const GearSet& gear, const Lift<Real>& lift,
                                         const StiffnessOptions& options) {
  const SeriesModel<Real> model(gear, lift);
  SeriesCompliance<Real> total;
  const auto add = [&](const Real& intact, const auto& cracks) -> CrackSum<Real> {
    const auto sum = sum_of(cracks, model, options.quadrature);
    total.intact += intact;
    total.positive += intact + sum.positive;
    total.negative += intact + sum.negative;
    total.positive_added += sum.positive;
    total.negative_added += sum.negative;
    total.usable = total.usable && sum.usable;
    return sum;
  };
  const auto add_in_line = [&](const Real& intact, const auto& cracks) {
    const auto sum = add(intact, cracks);
    total.positive_in_line += sum.positive;
    total.negative_in_line += sum.negative;
  };
  if (gear.wave_generator)
    add(model.conversion().all_lobes * model.lobe_compliance(), gear.wave_generator->crack);
  if (gear.flexspline) add_in_line(model.sound_flexspline(), gear.flexspline->crack);
  if (gear.output_shaft) {
    total.output_shaft = model.sound_shaft();
    add_in_line(total.output_shaft, gear.output_shaft->crack);
  }
  return total;
}

std::vector<Note> smoothness_notes(const GearSet& gear) {
  std::vector<Note> notes;
  for (const DriveCrack& crack : drive_cracks(gear))
    for (const Note& kink : crack.kinks)
      if (std::ranges::find(notes, kink) == notes.end()) notes.push_back(kink);
  return notes;
}

template SeriesCompliance<double> series_compliance(const GearSet&, const Lift<double>&,
                                                    const StiffnessOptions&);
template SeriesCompliance<DualReal> series_compliance(const GearSet&, const Lift<DualReal>&,
                                                      const StiffnessOptions&);

}  // namespace strainwave
