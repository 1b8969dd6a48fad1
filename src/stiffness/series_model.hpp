// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "strainwave/contact/hertz.hpp"
#include "strainwave/core/compare.hpp"
#include "strainwave/core/lift.hpp"
#include "strainwave/model/input/crack_parameters.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/sif/member/ring_edge.hpp"
#include "strainwave/sif/member/semi_ellipse.hpp"
#include "strainwave/sif/member/shaft_annular.hpp"
#include "strainwave/sif/member/wall_through.hpp"
#include "strainwave/stiffness/elastic_members.hpp"

// The numbers of the series model, each once, for double and for dual numbers.  What is said about
// them, notes, accuracies, equations, is in the sources of the three members.

namespace strainwave {

/// Whether the faces of a crack are pulled apart by a normal stress.
///
/// Stresses below `scale` times rounding count as none: such a crack touches without pressure, and
/// is neither opened nor closed.
enum class Faces { pressed, touching, open };

inline Faces faces(double normal_stress, double scale) {
  const double negligible = 1e-12 * scale;
  if (normal_stress > negligible) return Faces::open;
  return normal_stress < -negligible ? Faces::pressed : Faces::touching;
}

/// State of a crack's faces under both senses of torque.
struct BothSenses {
  Faces positive = Faces::touching;
  Faces negative = Faces::touching;
};

/// The wall that a crack sits in.
template <class Real>
struct Wall {
  Real mean_radius{};
  Real thickness{};
};

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

/// Geometry of a ball's contacts with its races.
template <class Real>
struct BasicRaceContacts {
  BasicPointContact<Real> inner;
  BasicPointContact<Real> outer;
};

/// Contacts of a ball with races of one material; eq. (CO-1).
template <class Real>
BasicRaceContacts<Real> race_contacts_of(const Lift<Real>& lift, const Bearing& bearing,
                                         const BasicElasticConstants<Real>& steel) {
  const Real D = lift(bearing.ball_diameter);
  // Ball and races of one material: 1/E* = 2 (1 - nu^2)/E.
  const Real contact_modulus = steel.plane_strain_modulus() / 2;
  const auto contact = [&](const Real& race_curvature, const Real& conformity) {
    // (CO-1): across the groove, and along the rolling direction.
    return BasicPointContact<Real>{
        .curvature_sums = {2 / D - 1 / (conformity * D), 2 / D + race_curvature},
        .contact_modulus = contact_modulus};
  };
  return {
      .inner = contact(2 / lift(bearing.inner_raceway_diameter), lift(bearing.inner_conformity)),
      .outer = contact(-2 / lift(bearing.outer_raceway_diameter), lift(bearing.outer_conformity))};
}

/// f of (ST-5) in the scalar of a lift.
template <class Real>
Real lobe_force_per_torque_of(const Lift<Real>& lift, const Transmission& drive,
                              const WaveGenerator& wg) {
  return 2 * lift(wg.load_factor) * lift(wg.force_transmission_coefficient) /
         (drive.wave_number * lift(drive.pitch_diameter));  // (ST-5)
}

/// The series model of one gear, which reads every number of it through a lift.
template <class Real>
class SeriesModel {
 public:
  using Elastic = BasicElasticConstants<Real>;
  using Moduli = BasicCrackModuli<Real>;

  explicit SeriesModel(const GearSet& gear, const Lift<Real>& lift = Lift<Real>())
      : gear_(gear), lift_(lift) {}

  [[nodiscard]] Elastic steel(std::string_view material, std::string_view field) const {
    return elastic_constants(lift_, material_of(gear_, material, field));
  }

  static Moduli plane_strain(const Elastic& steel) {
    return {.opening = steel.plane_strain_modulus(), .shear = steel.G};
  }
  static Moduli plane_stress(const Elastic& steel) {
    return {.opening = steel.E, .shear = steel.G};
  }

  /// What a crack adds by the table that it names, (FE-41).
  template <class Crack>
  [[nodiscard]] TabulatedCompliance<Real> tabulated(const Crack& crack) const {
    return tabulated_compliance(gear_.compliance_tables.at(*crack.compliance_table),
                                crack_parameters(lift_, gear_, crack));
  }

  // --- Wave generator ---------------------------------------------------------------------------

  [[nodiscard]] Real lobe_force() const {
    using std::abs;
    return lobe_force_per_torque_of(lift_, gear_.drive, *gear_.wave_generator) *
           abs(lift_(gear_.load.torque));
  }

  [[nodiscard]] BallContacts<Real> ball_contacts(const Elastic& steel,
                                                 const Real& lobe_force) const {
    const Bearing& bearing = *gear_.wave_generator->bearing;
    const BasicRaceContacts<Real> contacts = race_contacts_of(lift_, bearing, steel);
    const Real ball_force = lobe_force / lift_(bearing.loaded_balls);
    return {.inner = hertz_contact(contacts.inner, ball_force),
            .outer = hertz_contact(contacts.outer, ball_force)};
  }

  /// Whether the outer ring of the bearing is taken as free between the lobes.
  [[nodiscard]] bool free_outer_ring() const {
    const auto& bearing = gear_.wave_generator->bearing;
    return bearing && bearing->outer_ring && !bearing->ball_count;
  }

  /// Radial compliance of one lobe, C_0 [m/N].
  [[nodiscard]] Real lobe_compliance(const Elastic& steel, const Real& lobe_force) const {
    const WaveGenerator& wg = *gear_.wave_generator;
    if (wg.radial_stiffness) return 1 / lift_(*wg.radial_stiffness);
    if (wg.displacements) {
      const LobeDisplacements& d = *wg.displacements;
      return (lift_(d.bearing) + lift_(d.cam) + lift_(d.shaft)) / lobe_force;  // (ST-8)
    }
    const Bearing& bearing = *wg.bearing;
    const auto [inner, outer] = ball_contacts(steel, lobe_force);
    // (ST-9): contacts in series, balls in parallel, linearised at the given load.
    Real C =
        (1 / inner.tangent_stiffness + 1 / outer.tangent_stiffness) / lift_(bearing.loaded_balls);
    if (free_outer_ring()) {
      using std::pow;
      const BearingRing& ring = *bearing.outer_ring;
      C +=
          ring_compliance(gear_.drive.wave_number, lift_(ring.mean_radius),
                          Real(steel.E * lift_(ring.width) * pow(lift_(ring.thickness), 3.0) / 12));
    }
    return C;
  }

  [[nodiscard]] LobeConversion<Real> conversion() const {
    const WaveGenerator& wg = *gear_.wave_generator;
    const Transmission& drive = gear_.drive;
    const int U = drive.wave_number;
    if (wg.conversion == Conversion::cam) {
      // (ST-7): the article's, where one compliance stands for the whole wave generator.
      const Real cam = lift_(wg.force_transmission_coefficient) * std::numbers::pi /
                       (2 * lift_(drive.pitch_diameter) * U * lift_(drive.radial_displacement) *
                        lift_(drive.ratio));
      return {cam, cam};
    }
    const Real f = lobe_force_per_torque_of(lift_, drive, wg);
    return {.one_lobe = f * f, .all_lobes = U * f * f};  // (ST-6)
  }

  /// Hoop stress at a race crack per unit of lobe force [1/m^2].
  template <class Crack>
  [[nodiscard]] Real unit_stress(const Crack& crack, const Elastic& steel,
                                 const Real& lobe_force) const {
    const WaveGenerator& wg = *gear_.wave_generator;
    switch (crack.stress_driver) {
      case StressDriver::orthogonal_shear: {
        const auto [a, b] = semi_axes(steel, lobe_force);
        const Real beta = crack.contact_factor ? Real(lift_(*crack.contact_factor))
                                               : orthogonal_shear_factor(Real(b / a));
        return beta / 2 * pressure_per_force(a, b);  // (ST-12)
      }
      case StressDriver::contact_edge: {
        const auto [a, b] = semi_axes(steel, lobe_force);
        return edge_tension(Real(b / a), steel.nu).minor_end * pressure_per_force(a, b);
      }
      case StressDriver::ring_bending: {
        const Real t = lift_(*wg.inner_ring_thickness);
        return 6 * ring_moment_factor(gear_.drive.wave_number) * lift_(*wg.inner_ring_mean_radius) /
               (lift_(*wg.inner_ring_width) * t * t);  // (ST-13)
      }
      case StressDriver::given:
        break;
    }
    return lift_(*crack.stress) / lobe_force;
  }

  /// A crack of the inner race under a hoop stress per unit of lobe force; a pressed one is closed.
  [[nodiscard]] sif::SurfaceCrack<1, Real> race_crack(const RaceSurfaceCrack& crack,
                                                      const Elastic& steel,
                                                      const Real& stress) const {
    return sif::SurfaceCrack<1, Real>(
        {.depth = lift_(crack.depth),
         .aspect_ratio = lift_(crack.aspect_ratio),
         .thickness = lift_(*gear_.wave_generator->inner_ring_thickness),
         .poissons_ratio = steel.nu,
         .normal_stress = {stress},
         .open = stress >= 0});
  }
  [[nodiscard]] sif::BasicEdgeCrack<Real> race_crack(const RaceEdgeCrack& crack, const Elastic&,
                                                     const Real& stress) const {
    const bool bending = crack.stress_driver == StressDriver::ring_bending;
    return {.depth = lift_(crack.depth),
            .thickness = lift_(*gear_.wave_generator->inner_ring_thickness),
            .width = lift_(*gear_.wave_generator->inner_ring_width),
            .unit_stress = stress,
            .loading = bending ? sif::StripLoading::bending : sif::StripLoading::tension,
            .open = stress >= 0};
  }

  // --- Flexspline -------------------------------------------------------------------------------

  /// The wall under the teeth, where the wave generator deflects it.
  [[nodiscard]] Wall<Real> tooth_ring() const {
    const Real delta = lift_(gear_.flexspline->wall_thickness);
    return {(lift_(gear_.drive.pitch_diameter) - delta) / 2, delta};  // (ST-11)
  }

  [[nodiscard]] Wall<Real> wall_of(WallSection section) const {
    const Flexspline& fs = *gear_.flexspline;
    if (fs.crack_free == CrackFree::factor) return tooth_ring();
    const TubeSection& given = section == WallSection::rim ? *fs.rim : *fs.barrel;
    const Real t = lift_(given.wall_thickness);
    return {(lift_(given.outer_diameter) - t) / 2, t};  // (ST-11)
  }

  /// k of (ST-4).
  [[nodiscard]] Real shape_factor() const {
    const Flexspline& fs = *gear_.flexspline;
    if (fs.shape_factor) return lift_(*fs.shape_factor);
    return fs.shape == FlexsplineShape::cup ? 0.83 : 1.0;
  }

  /// Compliance of the sound flexspline [rad/(N*m)].
  [[nodiscard]] Real sound_flexspline(const Elastic& steel) const {
    const Flexspline& fs = *gear_.flexspline;
    if (fs.crack_free == CrackFree::factor) {
      const Real D = lift_(gear_.drive.pitch_diameter);
      return shape_factor() *
             torsional_compliance(
                 BasicTube<Real>{.outer_diameter = D,
                                 .inner_diameter = D - 2 * lift_(fs.wall_thickness),
                                 .length = lift_(fs.length)},
                 steel.G);  // (ST-4)
    }
    Real sum = torsional_compliance(tube(*fs.barrel), steel.G);
    if (fs.rim) sum += torsional_compliance(tube(*fs.rim), steel.G);
    if (fs.boss) sum += torsional_compliance(tube(*fs.boss), steel.G);
    if (fs.diaphragm) sum += torsional_compliance(lift_, *fs.diaphragm, steel.G);
    return sum + lift_(fs.flange_compliance);
  }

  /// Stress on the plane of a wall crack per unit of axial force and torque.
  template <class Crack>
  [[nodiscard]] sif::BasicCrackPlaneStress<Real> plane_of(const Crack& crack) const {
    const Wall<Real> wall = wall_of(crack.section);
    return sif::crack_plane_stress(wall.mean_radius, wall.thickness, Real(lift_(crack.angle)),
                                   Real(lift_(gear_.flexspline->stress_nonuniformity)));
  }

  /// Which senses of torque open a wall crack.
  template <class Crack>
  requires requires(const Crack& crack) { crack.angle; }
  [[nodiscard]] BothSenses faces_of(const Crack& crack) const {
    const sif::BasicCrackPlaneStress<Real> stress = plane_of(crack);
    const double P = gear_.load.axial_force;
    const double T = std::abs(gear_.load.torque);
    const double from_P = value_of(stress.normal[kAxial]) * P;
    const double from_T = value_of(stress.normal[kTorsion]) * T;
    const double scale = std::abs(from_P) + std::abs(from_T) +
                         std::abs(value_of(stress.shear[kAxial]) * P) +
                         std::abs(value_of(stress.shear[kTorsion]) * T);
    return {faces(from_P + from_T, scale), faces(from_P - from_T, scale)};
  }
  [[nodiscard]] BothSenses faces_of(const DiaphragmArcCrack&) const { return {}; }

  [[nodiscard]] sif::BasicThroughCrackInTube<Real> wall_crack(const WallThroughCrack& crack,
                                                              const Elastic& steel,
                                                              bool open) const {
    const Wall<Real> wall = wall_of(crack.section);
    return {.half_length = lift_(crack.half_length),
            .mean_radius = wall.mean_radius,
            .wall_thickness = wall.thickness,
            .angle = lift_(crack.angle),
            .stress_nonuniformity = lift_(gear_.flexspline->stress_nonuniformity),
            .poissons_ratio = steel.nu,
            .shell_correction = crack.shell_correction,
            .thin_sheet = false,
            .open = open};
  }
  [[nodiscard]] sif::SurfaceCrack<2, Real> wall_crack(const WallSurfaceCrack& crack,
                                                      const Elastic& steel, bool open) const {
    const sif::BasicCrackPlaneStress<Real> stress = plane_of(crack);
    return sif::SurfaceCrack<2, Real>(
        {.depth = lift_(crack.depth),
         .aspect_ratio = lift_(crack.depth) / lift_(crack.half_length),
         .thickness = wall_of(crack.section).thickness,
         .poissons_ratio = steel.nu,
         .normal_stress = stress.normal,
         .shear_stress = stress.shear,
         .open = open});
  }
  /// An arc crack of the diaphragm slides under torque: a flat through crack in pure mode II.
  [[nodiscard]] sif::BasicThroughCrackInTube<Real> wall_crack(const DiaphragmArcCrack& crack,
                                                              const Elastic& steel,
                                                              bool open) const {
    const Diaphragm& diaphragm = *gear_.flexspline->diaphragm;
    const Real r = arc_radius(crack);
    // The shear T/(2 pi r^2 h) along the arc is that along the generator of a tube of its radius.
    return {.half_length = lift_(crack.half_length),
            .mean_radius = r,
            .wall_thickness = diaphragm_thickness(lift_, diaphragm, r),
            .angle = Real(0.0),
            .poissons_ratio = steel.nu,
            .shell_correction = false,
            .open = open};
  }
  static Moduli wall_moduli(const WallThroughCrack&, const Elastic& steel) {
    return plane_stress(steel);
  }
  static Moduli wall_moduli(const WallSurfaceCrack&, const Elastic& steel) {
    return plane_strain(steel);
  }
  static Moduli wall_moduli(const DiaphragmArcCrack&, const Elastic& steel) {
    return plane_stress(steel);
  }

  [[nodiscard]] Real arc_radius(const DiaphragmArcCrack& crack) const {
    return crack.radius ? Real(lift_(*crack.radius))
                        : Real(lift_(gear_.flexspline->diaphragm->inner_diameter) / 2);
  }

  [[nodiscard]] Real groove(const DiaphragmGroove& groove, const Elastic& steel) const {
    return groove_compliance(lift_, *gear_.flexspline->diaphragm, groove, steel.G);
  }

  // --- Output shaft -----------------------------------------------------------------------------

  [[nodiscard]] Real sound_shaft(const Elastic& steel) const {
    const OutputShaft& shaft = *gear_.output_shaft;
    return torsional_compliance(BasicTube<Real>{.outer_diameter = lift_(shaft.outer_diameter),
                                                .inner_diameter = lift_(shaft.inner_diameter),
                                                .length = lift_(shaft.length)},
                                steel.G);
  }

  [[nodiscard]] bool annular_open() const { return gear_.load.axial_force >= 0; }

  [[nodiscard]] sif::BasicAnnularCrackSolid<Real> solid_shaft_crack(
      const AnnularCrack& crack) const {
    return {.depth = lift_(crack.depth),
            .diameter = lift_(gear_.output_shaft->outer_diameter),
            .polynomials = crack.solution == AnnularSolution::tada
                               ? sif::AnnularPolynomials::tada
                               : sif::AnnularPolynomials::improved,
            .open = annular_open()};
  }
  [[nodiscard]] sif::BasicAnnularCrackHollow<Real> hollow_shaft_crack(
      const AnnularCrack& crack) const {
    return sif::BasicAnnularCrackHollow<Real>(
        {.depth = lift_(crack.depth),
         .outer_radius = lift_(gear_.output_shaft->outer_diameter) / 2,
         .inner_radius = lift_(gear_.output_shaft->inner_diameter) / 2,
         .open = annular_open()});
  }
  /// a/t of a crack in a hollow shaft.
  [[nodiscard]] double depth_ratio(const AnnularCrack& crack) const {
    const OutputShaft& shaft = *gear_.output_shaft;
    return crack.depth / (shaft.outer_diameter / 2 - shaft.inner_diameter / 2);
  }

 private:
  [[nodiscard]] BasicTube<Real> tube(const TubeSection& section) const {
    const Real D = lift_(section.outer_diameter);
    return {.outer_diameter = D,
            .inner_diameter = D - 2 * lift_(section.wall_thickness),
            .length = lift_(section.length)};
  }

  [[nodiscard]] std::array<Real, 2> semi_axes(const Elastic& steel, const Real& lobe_force) const {
    const WaveGenerator& wg = *gear_.wave_generator;
    if (wg.contact_semi_axes)
      return {lift_((*wg.contact_semi_axes)[0]), lift_((*wg.contact_semi_axes)[1])};
    const BasicHertzContact<Real> inner = ball_contacts(steel, lobe_force).inner;
    return {inner.major_semi_axis, inner.minor_semi_axis};
  }

  /// Peak pressure per unit of lobe force, of the ball that carries the crack.
  [[nodiscard]] Real pressure_per_force(const Real& a, const Real& b) const {
    const WaveGenerator& wg = *gear_.wave_generator;
    const Real share = wg.bearing ? Real(1 / lift_(wg.bearing->loaded_balls)) : Real(1.0);
    return peak_pressure(share, a, b);
  }

  const GearSet& gear_;
  Lift<Real> lift_;
};

/// Shell parameter of a through crack beyond which its stiffness is not used.
inline constexpr double kMaxShellParameter = sif::ThroughCrackInTube::kMaxShellParameter;
/// Up to here finite elements agree closely; see accuracy::kThroughCrack.
inline constexpr double kCloseShellParameter = 2.0;

}  // namespace strainwave
