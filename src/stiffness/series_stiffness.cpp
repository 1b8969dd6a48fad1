// SPDX-License-Identifier: Apache-2.0
#include "strainwave/stiffness/series_stiffness.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "series_model.hpp"
#include "strainwave/crack_tables/crack_derivatives.hpp"
#include "strainwave/drive_cracks/drive_cracks.hpp"

namespace strainwave {
namespace {

/// The engine of the added compliance, as the source of every crack.
struct ByEngine {
  const SeriesModel<double>& model;
  const QuadratureOptions& options;
  bool converged = true;

  /// Calls add(compliance at the output under positive torque, the same under negative torque).
  template <class Solution, class Add>
  void operator()(std::size_t, const CrackNumbers<Solution>& numbers, const Add& add) {
    const auto added = closed_form(LoadedCrack<Solution>(numbers), options);
    converged = converged && added.positive.converged && added.negative.converged;
    add(model.at_output(added.positive.matrix), model.at_output(added.negative.matrix));
  }
};

/// Tables of similar cracks, and the engine for what they do not contain.
struct ByTables {
  ByEngine engine;
  CrackTables::Reader& tables;

  template <class Solution, class Add>
  void operator()(std::size_t index, const CrackNumbers<Solution>& numbers, const Add& add) {
    const std::optional<UnderBothSenses<double>> added = tables(index, numbers);
    if (!added) {
      engine(index, numbers, add);
      return;
    }
    const auto at_output = [&](double of) {
      using Matrix = SymmetricMatrix<Solution::kLoads>;
      return engine.model.at_output(Matrix(of));
    };
    add(at_output(added->positive), at_output(added->negative));
  }
};

/// Compliance of the cracks of one member under each sense of torque.
template <class Real, class Source>
class CrackSum {
 public:
  using Ratios = std::vector<UnderBothSenses<Real>>;

  /// @param ratios  of each crack in its group over its compliance alone; empty: no groups
  CrackSum(const SeriesModel<Real>& model, Source& source, std::size_t& index, Ratios ratios)
      : model_(model), source_(source), index_(index), ratios_(std::move(ratios)) {}

  /// Adds the next crack of the member.
  template <class Crack, class Numbers>
  void operator()(const Crack& crack, const Numbers& numbers) {
    take(crack, numbers);
    ++of_member_;
  }

  Real positive{};
  Real negative{};
  bool usable = true;

 private:
  template <class Crack, class Solution>
  void take(const Crack&, const CrackNumbers<Solution>& crack) {
    const std::size_t index = index_++;
    if (crack.table) {
      add(crack.table->positive.value, crack.table->negative.value);
      return;
    }
    usable = usable && crack.in_range;
    source_(index, crack, [this](const Real& under_positive, const Real& under_negative) {
      add(under_positive, under_negative);
    });
  }
  void take(const DiaphragmGroove& groove, const LoadedGroove&) {
    ++index_;
    const Real added = model_.groove(groove);
    add(added, added);
  }
  template <class Crack>
  void take(const Crack&, const ActsInCoupledDrive&) {
    ++index_;
  }
  void add(const Real& under_positive, const Real& under_negative) {
    if (ratios_.empty()) {
      positive += under_positive;
      negative += under_negative;
      return;
    }
    const UnderBothSenses<Real>& ratio = ratios_[of_member_];
    positive += under_positive * ratio.positive;
    negative += under_negative * ratio.negative;
  }

  const SeriesModel<Real>& model_;
  Source& source_;
  std::size_t& index_;
  std::size_t of_member_ = 0;  ///< index of the crack in its member
  Ratios ratios_;
};

template <class Real, class Source>
SeriesCompliance<Real> sum_of_members(const GearSet& gear, const SeriesModel<Real>& model,
                                      Source& source) {
  SeriesCompliance<Real> total;
  std::size_t index = 0;
  const auto add = [&](const Real& intact, const auto& cracks,
                       std::vector<UnderBothSenses<Real>> ratios = {}) {
    CrackSum<Real, Source> sum(model, source, index, std::move(ratios));
    for (const auto& any : cracks)
      std::visit(
          [&](const auto& crack) {
            model.loads().describe(crack, [&](const auto& numbers) { sum(crack, numbers); });
          },
          any);
    total.intact += intact;
    total.positive += intact + sum.positive;
    total.negative += intact + sum.negative;
    total.positive_added += sum.positive;
    total.negative_added += sum.negative;
    total.usable = total.usable && sum.usable;
    return sum;
  };
  const auto add_in_line = [&](const Real& intact, const auto& cracks,
                               std::vector<UnderBothSenses<Real>> ratios = {}) {
    const auto sum = add(intact, cracks, std::move(ratios));
    total.positive_in_line += sum.positive;
    total.negative_in_line += sum.negative;
  };
  if (gear.wave_generator)
    add(model.conversion().all_lobes * model.lobe_compliance(), gear.wave_generator->crack);
  if (gear.flexspline) {
    auto neighbours = model.neighbours();
    total.usable = total.usable && neighbours.usable;
    add_in_line(model.sound_flexspline(), gear.flexspline->crack, std::move(neighbours.ratio));
  }
  if (gear.output_shaft) {
    total.output_shaft = model.sound_shaft();
    add_in_line(total.output_shaft, gear.output_shaft->crack, model.shaft_neighbours());
  }
  return total;
}

}  // namespace

struct SeriesDerivatives::Cracks {
  /// By index; filled when first read.
  std::vector<OfAnySolution<DualReal, CrackDerivatives>> of;
};

namespace {

/// Derivatives of the cracks with respect to their own arguments, kept for all inputs.
struct ByDerivatives {
  const SeriesModel<DualReal>& model;
  const QuadratureOptions& options;
  SeriesDerivatives::Cracks& cracks;
  bool converged = true;

  template <class Solution, class Add>
  void operator()(std::size_t index, const CrackNumbers<Solution>& numbers, const Add& add) {
    if (index >= cracks.of.size()) cracks.of.resize(index + 1);
    auto& any = cracks.of[index];
    if (std::holds_alternative<std::monostate>(any))
      any.template emplace<CrackDerivatives<Solution>>(numbers, options);
    const auto& derivatives = std::get<CrackDerivatives<Solution>>(any);
    converged = converged && derivatives.converged();
    using Matrix = SymmetricMatrix<Solution::kLoads, DualReal>;
    const UnderBothSenses<DualReal> added = derivatives(numbers);
    const DualReal positive = model.at_output(Matrix(added.positive));
    add(positive, numbers.faces.differ() ? model.at_output(Matrix(added.negative)) : positive);
  }
};

}  // namespace

SeriesDerivatives::SeriesDerivatives(const GearSet& gear, const StiffnessOptions& options)
    : gear_(gear), options_(options.quadrature), cracks_(std::make_unique<Cracks>()) {}

SeriesDerivatives::~SeriesDerivatives() = default;

SeriesCompliance<DualReal> SeriesDerivatives::of(const Lift<DualReal>& lift) {
  const SeriesModel<DualReal> model(gear_, lift);
  ByDerivatives source{model, options_, *cracks_};
  SeriesCompliance<DualReal> total = sum_of_members(gear_, model, source);
  total.usable = total.usable && source.converged;
  return total;
}

template <>
SeriesCompliance<double> series_compliance(const GearSet& gear, const Lift<double>& lift,
                                           const StiffnessOptions& options) {
  const SeriesModel<double> model(gear, lift);
  ByEngine engine{model, options.quadrature};
  SeriesCompliance<double> total = sum_of_members(gear, model, engine);
  total.usable = total.usable && engine.converged;
  return total;
}

template <>
SeriesCompliance<DualReal> series_compliance(const GearSet& gear, const Lift<DualReal>& lift,
                                             const StiffnessOptions& options) {
  return SeriesDerivatives(gear, options).of(lift);
}

SeriesCompliance<double> series_compliance(const GearSet& gear, CrackTables::Reader& tables) {
  const SeriesModel<double> model(gear, {}, &tables.ellipses());
  const QuadratureOptions options;
  ByTables source{{model, options}, tables};
  SeriesCompliance<double> total = sum_of_members(gear, model, source);
  total.usable = total.usable && source.engine.converged;
  return total;
}

}  // namespace strainwave
