// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/contact/hertz.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/lift.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/drive_cracks/loaded_crack.hpp"
#include "strainwave/drive_cracks/shaft_group.hpp"
#include "strainwave/drive_cracks/wall_group.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/stiffness/elastic_members.hpp"
#include "strainwave/stiffness/section_torsion.hpp"

// The numbers of the series model, each computed in one place for double and dual numbers.  The
// source files of the three members add notes, accuracies and equations.

namespace strainwave {

/// Hertz contacts of one ball with the inner and the outer race, under its share of the lobe force.
template <class Real>
struct BallContacts {
  BasicHertzContact<Real> inner;
  BasicHertzContact<Real> outer;
};

/// Output compliance per unit of compliance of one lobe, and of all lobes.
template <class Real>
struct LobeConversion {
  Real one_lobe{};
  Real all_lobes{};
};

/// Compliance that a crack adds to its member under both senses of torque, by the closed form.
template <std::size_t N, class Real>
struct AddedBothSenses {
  CrackCompliance<N, Real> positive;
  CrackCompliance<N, Real> negative;
};

template <class Solution>
[[nodiscard]] AddedBothSenses<Solution::kLoads, ScalarOf<Solution>> closed_form(
    const LoadedCrack<Solution>& crack, const QuadratureOptions& options) {
  using Added = AddedBothSenses<Solution::kLoads, ScalarOf<Solution>>;
  if constexpr (SharedByFaces<Solution>) {
    if (crack.faces.differ()) {
      const auto both = integrated_in_both_states(crack.solution,
                                                  {crack.moduli, crack.moduli.pressed()}, options);
      return crack.faces.negative == Faces::pressed ? Added{both.apart, both.pressed}
                                                    : Added{both.pressed, both.apart};
    }
  }
  const auto added_under = [&](Faces state) {
    return added_compliance(crack.with_faces(state), crack.moduli_with(state), options);
  };
  const auto positive = added_under(crack.faces.positive);
  return {positive, crack.faces.differ() ? added_under(crack.faces.negative) : positive};
}

/// The series model of one gear; it reads every number of the gear through a lift.
template <class Real>
class SeriesModel {
 public:
  using Elastic = BasicElasticConstants<Real>;

  explicit SeriesModel(const GearSet& gear, const Lift<Real>& lift = Lift<Real>(),
                       ContactEllipses* ellipses = nullptr)
      : gear_(gear), lift_(lift), loads_(gear, lift, ellipses) {}

  [[nodiscard]] const CrackLoads<Real>& loads() const { return loads_; }

  /// Compliance that a crack adds at the output, from its matrix over [lobe force] or [axial,
  /// torsion].
  [[nodiscard]] Real at_output(const SymmetricMatrix<1, Real>& added) const {
    return conversion().one_lobe * added(0, 0);
  }
  [[nodiscard]] Real at_output(const SymmetricMatrix<2, Real>& added) const {
    return added(kTorsion, kTorsion);
  }

  // --- Wave generator ---------------------------------------------------------------------------

  [[nodiscard]] BallContacts<Real> ball_contacts() const {
    const Bearing& bearing = *gear_.wave_generator->bearing;
    const BasicRaceContacts<Real> contacts = race_contacts(lift_, bearing, loads_.ring_steel());
    const Real ball_force = loads_.lobe_force() / lift_(bearing.loaded_balls);
    return {.inner = loads_.contact(contacts.inner, ball_force),
            .outer = loads_.contact(contacts.outer, ball_force)};
  }

  /// Whether the outer ring of the bearing is modelled as free between the lobes.
  [[nodiscard]] bool free_outer_ring() const {
    const auto& bearing = gear_.wave_generator->bearing;
    return bearing && bearing->outer_ring && !bearing->ball_count;
  }

  /// Radial compliance of one lobe, C_0 [m/N].
  [[nodiscard]] Real lobe_compliance() const {
    const WaveGenerator& wg = *gear_.wave_generator;
    if (wg.radial_stiffness) return 1 / lift_(*wg.radial_stiffness);
    if (wg.displacements) {
      const LobeDisplacements& d = *wg.displacements;
      return (lift_(d.bearing) + lift_(d.cam) + lift_(d.shaft)) / loads_.lobe_force();  // (ST-8)
    }
    const Bearing& bearing = *wg.bearing;
    const auto [inner, outer] = ball_contacts();
    // (ST-9): contacts in series, balls in parallel, linearised at the given load.
    Real C =
        (1 / inner.tangent_stiffness + 1 / outer.tangent_stiffness) / lift_(bearing.loaded_balls);
    if (free_outer_ring()) {
      using std::pow;
      const BearingRing& ring = *bearing.outer_ring;
      C += ring_compliance(
          gear_.drive.wave_number, lift_(ring.mean_radius),
          Real(loads_.ring_steel().E * lift_(ring.width) * pow(lift_(ring.thickness), 3.0) / 12));
    }
    return C;
  }

  [[nodiscard]] LobeConversion<Real> conversion() const {
    const WaveGenerator& wg = *gear_.wave_generator;
    const Transmission& drive = gear_.drive;
    const int U = drive.wave_number;
    if (wg.conversion == Conversion::cam) {
      // (ST-7): the article's conversion, in which one compliance represents the whole wave
      // generator.
      const Real cam = lift_(wg.force_transmission_coefficient) * std::numbers::pi /
                       (2 * lift_(drive.pitch_diameter) * U * lift_(drive.radial_displacement) *
                        lift_(drive.ratio));
      return {cam, cam};
    }
    const Real f = lobe_force_per_torque(lift_, drive, wg);
    return {.one_lobe = f * f, .all_lobes = U * f * f};  // (ST-6)
  }

  // --- Flexspline -------------------------------------------------------------------------------

  /// Shape factor k of (ST-4).
  [[nodiscard]] Real shape_factor() const {
    const Flexspline& fs = *gear_.flexspline;
    if (fs.shape_factor) return lift_(*fs.shape_factor);
    return fs.shape == FlexsplineShape::cup ? 0.83 : 1.0;
  }

  /// Compliance of the sound flexspline [rad/(N*m)].
  [[nodiscard]] Real sound_flexspline() const {
    const Flexspline& fs = *gear_.flexspline;
    if (fs.crack_free == CrackFree::factor) {
      const Real D = lift_(gear_.drive.pitch_diameter);
      return shape_factor() *
             torsional_compliance(
                 BasicTube<Real>{.outer_diameter = D,
                                 .inner_diameter = D - 2 * lift_(*fs.wall_thickness),
                                 .length = lift_(*fs.length)},
                 elastic_constants(lift_, part(fs.material)).G);  // (ST-4)
    }
    const Material& base = part(fs.material);
    const auto twist_of = [&](const auto& section) {
      return twist(section, section.material ? part(*section.material) : base);
    };
    Real sum = twist_of(*fs.barrel);
    if (fs.rim) sum += twist_of(*fs.rim);
    if (fs.boss) sum += twist_of(*fs.boss);
    if (fs.diaphragm) sum += twist_of(*fs.diaphragm);
    return sum + lift_(fs.joint_compliance) + lift_(fs.flange_compliance);
  }

  /// What the cracks of groups change of each other's compliance in torsion.
  struct Neighbours {
    /// Of each crack of the flexspline, over its compliance alone [-]; empty: there is no group.
    std::vector<UnderBothSenses<Real>> ratio;
    bool usable = true;  ///< whether all groups have a usable answer
  };
  [[nodiscard]] Neighbours neighbours() const {
    Neighbours result;
    for (const WallGroup& group : wall_groups(gear_, CrackLoads<double>(gear_))) {
      result.ratio.resize(gear_.flexspline->crack.size());
      result.usable = result.usable && group.fault().empty();
      const auto ratios = group.ratios(places_of(group, gear_, lift_, loads_));
      for (std::size_t j = 0; j < ratios.size(); ++j)
        result.ratio[group.members()[j].index] = ratios[j];  // (CG-9)
    }
    return result;
  }

  /// Of each crack of the output shaft over its compliance alone [-]; empty: there is no group.
  [[nodiscard]] std::vector<UnderBothSenses<Real>> shaft_neighbours() const {
    std::vector<UnderBothSenses<Real>> result;
    for (const Real& ratio : shaft_ratios(gear_, lift_)) result.push_back({ratio, ratio});
    return result;
  }

  [[nodiscard]] Real groove(const DiaphragmGroove& groove) const {
    return groove_compliance(lift_, *gear_.flexspline->diaphragm, groove,
                             loads_.diaphragm_steel().G);
  }

  // --- Output shaft -----------------------------------------------------------------------------

  [[nodiscard]] Real sound_shaft() const {
    const OutputShaft& shaft = *gear_.output_shaft;
    return torsional_compliance(BasicTube<Real>{.outer_diameter = lift_(shaft.outer_diameter),
                                                .inner_diameter = lift_(shaft.inner_diameter),
                                                .length = lift_(shaft.length)},
                                loads_.shaft_steel().G);
  }

 private:
  [[nodiscard]] const Material& part(std::string_view material) const {
    return material_of(gear_, material, "flexspline.material");
  }

  [[nodiscard]] Real twist(const TubeSection& section, const Material& of) const {
    return section_twist(lift_, gear_, section, of, Real(lift_(section.length)));
  }
  [[nodiscard]] Real twist(const Diaphragm& diaphragm, const Material& of) const {
    return section_twist(lift_, gear_, diaphragm, of);
  }

  const GearSet& gear_;
  Lift<Real> lift_;
  CrackLoads<Real> loads_;
};

/// Largest shell parameter of a through crack with a usable stiffness.
inline constexpr double kMaxShellParameter = sif::ThroughCrackInTube::kMaxShellParameter;
/// Largest shell parameter with close agreement of finite elements; see accuracy::kThroughCrack.
inline constexpr double kCloseShellParameter = 2.0;

}  // namespace strainwave
