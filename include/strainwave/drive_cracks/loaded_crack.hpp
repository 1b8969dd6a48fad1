// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "strainwave/contact/hertz.hpp"
#include "strainwave/core/compare.hpp"
#include "strainwave/core/lift.hpp"
#include "strainwave/crack_group/crack_row.hpp"
#include "strainwave/drive_cracks/faces.hpp"
#include "strainwave/drive_cracks/member_loads.hpp"
#include "strainwave/drive_cracks/wall_laminate.hpp"
#include "strainwave/fracture/crack_compliance.hpp"
#include "strainwave/model/input/crack_parameters.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/input/section_materials.hpp"
#include "strainwave/sif/member/ring_edge.hpp"
#include "strainwave/sif/member/semi_ellipse.hpp"
#include "strainwave/sif/member/shaft_annular.hpp"
#include "strainwave/sif/member/shaft_surface.hpp"
#include "strainwave/sif/member/wall_through.hpp"
#include "strainwave/sif/solution.hpp"
#include "strainwave/sif/tube/shell_row.hpp"

/// @file
/// Cracks of a drive with their solutions and loads, in the scalar `Real`: double, or DualReal for
/// the derivatives of everything.  Only this header assigns a solution to a kind of crack.  A kind
/// without an overload of `CrackLoads::numbers` does not compile.

namespace strainwave {

/// Poisson's ratio of the isotropic wall that tells at which size of a crack in a laminate the
/// curvature counts [-].
inline constexpr double kMetalPoissonsRatio = 0.3;

/// Angle [rad] and share 2 a/p [-] up to which torsion alone leaves open faces of a row open and
/// pressed ones pressed, along their whole length.
/// @{
inline constexpr double kTorsionKeepsFacesAngle = 1.2;
inline constexpr double kTorsionKeepsFaces = 1.5;
/// @}
/// Influence of the cracks of a row on each other in a curved wall over that in a flat sheet, at
/// most for cracks near each other [-]; tests/data/crack_rows.csv has 1.39.
inline constexpr double kCurvatureOfRow = 1.5;

/// Largest `CrackLoads::row_bound` at which a row of surface cracks has a usable answer [-].
inline constexpr double kLargestRowBound = 0.25;

/// The numbers that define a solution: its `Parameters`, or the whole of a plain struct.
template <class Solution>
struct ParametersOf {
  using type = Solution;  ///< the solution itself
};
/// The numbers of a solution that prepares more than its `Parameters`.
template <class Solution>
requires requires { typename Solution::Parameters; }
struct ParametersOf<Solution> {
  using type = typename Solution::Parameters;  ///< what the solution is made from
};

/// A crack with the numbers of its solution.
///
/// The loads of the solution are [axial force, torque] of a tube or shaft, or [lobe force] of a
/// ring of the wave generator.
template <SweptCrack Solution>
struct CrackNumbers {
  using Real = ScalarOf<Solution>;  ///< scalar of the solution

  /// numbers of the solution at the size in the file, with open faces
  typename ParametersOf<Solution>::type parameters;
  BasicCrackModuli<Real> moduli;  ///< E' and mu [Pa]
  /// Plane stress or plane strain ahead of the front.
  sif::Constraint constraint = sif::Constraint::plane_strain;
  BothSenses faces;      ///< state of the faces at the given load, without the assembly
  bool in_range = true;  ///< whether the closed-form compliance may be used at this size
  /// Compliance by finite elements that replaces the closed form if the crack names a table
  /// (FE-41).
  std::optional<TabulatedCompliance<Real>> table = {};
};

/// A crack with the solution of its stress intensity.
template <SweptCrack Solution>
struct LoadedCrack : CrackNumbers<Solution> {
  /// Makes the solution from the numbers.
  explicit LoadedCrack(const CrackNumbers<Solution>& numbers)
      : CrackNumbers<Solution>(numbers), solution(numbers.parameters) {}

  Solution solution;  ///< solution at the size in the file, with open faces

  /// The solution for a given state of the faces.
  [[nodiscard]] Solution with_faces(Faces state) const {
    return state == Faces::pressed ? solution.pressed() : solution;
  }
  /// The elastic constants for a given state of the faces.
  [[nodiscard]] auto moduli_with(Faces state) const {
    return state == Faces::pressed ? this->moduli.pressed() : this->moduli;
  }
};

/// A groove all round a diaphragm.  It thins the plate; it does not have a front that sweeps an
/// area.
struct LoadedGroove {};

/// A crack that acts through the contacts of balls and teeth.  The coupled drive models it; a sum
/// of compliances cannot.
struct ActsInCoupledDrive {};

/// Turns the cracks of one drive into loaded cracks.
///
/// The object reads every number through its lift and keeps a reference to the drive.
template <class Real>
class CrackLoads {
 public:
  using Elastic = BasicElasticConstants<Real>;  ///< E, G, nu in the scalar
  using Moduli = BasicCrackModuli<Real>;        ///< E' and mu in the scalar
  /// A crack with the numbers of a solution.
  template <class Solution>
  using Numbers = CrackNumbers<Solution>;

  /// @param gear  has passed `check`; must outlive this object
  /// @param lift  reads the numbers of the drive
  /// @param ellipses  of the contacts of balls, kept by the caller for many drives; null: none
  explicit CrackLoads(const GearSet& gear, const Lift<Real>& lift = Lift<Real>(),
                      ContactEllipses* ellipses = nullptr)
      : gear_(gear), lift_(lift), ellipses_(ellipses) {}

  /// Calls f(numbers of the crack) for one crack of any kind.
  template <class Crack, class F>
  void describe(const Crack& crack, const F& f) const {
    f(numbers(crack));
  }
  /// The same; a solid shaft and a hollow one have separate solutions.
  template <class F>
  void describe(const AnnularCrack& crack, const F& f) const {
    if (gear_.output_shaft->solid())
      f(numbers_in_solid_shaft(crack));
    else
      f(numbers_in_hollow_shaft(crack));
  }
  /// The same; a solid shaft and a hollow one have separate solutions.
  template <class F>
  void describe(const ShaftSurfaceCrack& crack, const F& f) const {
    if (gear_.output_shaft->solid())
      f(numbers_in_solid_shaft(crack));
    else
      f(numbers_in_hollow_shaft(crack));
  }

  /// Calls f(loaded crack) for one crack of any kind.
  template <class Crack, class F>
  void load(const Crack& crack, const F& f) const {
    describe(crack, [&](const auto& numbers) { f(with_solution(numbers)); });
  }
  /// A crack of a kind with one solution.
  template <class Crack>
  [[nodiscard]] auto loaded(const Crack& crack) const {
    return with_solution(numbers(crack));
  }

  /// A crack that acts through contacts has no numbers of a solution.
  template <ContactCrack Crack>
  [[nodiscard]] static ActsInCoupledDrive numbers(const Crack&) {
    return {};
  }

  // --- Wave generator ---------------------------------------------------------------------------

  /// The isotropic material of the bearing's rings, which is that of the wave generator.
  [[nodiscard]] Elastic ring_steel() const {
    return steel(gear_.wave_generator->material, "wave_generator.material");
  }

  /// Force on one lobe at the given torque [N].
  [[nodiscard]] Real lobe_force() const {
    using std::abs;
    return lobe_force_per_torque(lift_, gear_.drive, *gear_.wave_generator) *
           abs(lift_(gear_.load.torque));
  }

  /// A Hertz contact, with the ellipses that the caller keeps.
  [[nodiscard]] BasicHertzContact<Real> contact(const BasicPointContact<Real>& bodies,
                                                const Real& force) const {
    if constexpr (std::is_same_v<Real, double>)
      if (ellipses_ != nullptr) return hertz_contact(bodies, force, *ellipses_);
    return hertz_contact(bodies, force);
  }

  /// Hertz contact of one ball with the inner race, under its share of the lobe force.
  [[nodiscard]] BasicHertzContact<Real> inner_contact() const {
    const Bearing& bearing = *gear_.wave_generator->bearing;
    return contact(race_contacts(lift_, bearing, ring_steel()).inner,
                   Real(lobe_force() / lift_(bearing.loaded_balls)));
  }

  /// Hoop stress at a race crack per unit of lobe force, at the given torque [1/m^2].
  template <class Crack>
  [[nodiscard]] Real unit_stress(const Crack& crack) const {
    const WaveGenerator& wg = *gear_.wave_generator;
    switch (crack.stress_driver) {
      case StressDriver::orthogonal_shear: {
        const auto [a, b] = semi_axes();
        const Real beta = crack.contact_factor ? Real(lift_(*crack.contact_factor))
                                               : orthogonal_shear_factor(Real(b / a));
        return beta / 2 * pressure_per_force(a, b);  // (ST-12)
      }
      case StressDriver::contact_edge: {
        const auto [a, b] = semi_axes();
        return edge_tension(Real(b / a), ring_steel().nu).minor_end * pressure_per_force(a, b);
      }
      case StressDriver::ring_bending: {
        const Real t = lift_(*wg.inner_ring_thickness);
        return 6 * ring_moment_factor(gear_.drive.wave_number) * lift_(*wg.inner_ring_mean_radius) /
               (lift_(*wg.inner_ring_width) * t * t);  // (ST-13)
      }
      case StressDriver::given:
        break;
    }
    return lift_(*crack.stress) / lobe_force();
  }

  /// A surface crack of the inner ring, per unit of lobe force.
  [[nodiscard]] Numbers<sif::SurfaceCrack<1, Real>> numbers(const RaceSurfaceCrack& crack) const {
    const Elastic steel = ring_steel();
    const Real stress = unit_stress(crack);
    const WaveGenerator& wg = *gear_.wave_generator;
    const double& thickness = *wg.inner_ring_thickness;
    std::optional<Real> half_width;
    if (wg.inner_ring_width) half_width = lift_(*wg.inner_ring_width) / 2;
    return {.parameters = {.depth = lift_(crack.depth),
                           .aspect_ratio = lift_(crack.aspect_ratio),
                           .thickness = lift_(thickness),
                           .half_width = half_width,
                           .poissons_ratio = steel.nu,
                           .normal_stress = {stress},
                           .loading = race_loading(crack)},
            .moduli = plane_strain(steel),
            .faces = race_faces(stress),
            .in_range = not_too_deep(crack.depth, thickness)};
  }
  /// A crack over the width of the inner ring, per unit of lobe force.
  [[nodiscard]] Numbers<sif::BasicEdgeCrack<Real>> numbers(const RaceEdgeCrack& crack) const {
    const WaveGenerator& wg = *gear_.wave_generator;
    const Real stress = unit_stress(crack);
    return {.parameters = {.depth = lift_(crack.depth),
                           .thickness = lift_(*wg.inner_ring_thickness),
                           .width = lift_(*wg.inner_ring_width),
                           .unit_stress = stress,
                           .loading = race_loading(crack)},
            .moduli = plane_strain(ring_steel()),
            .faces = race_faces(stress),
            .in_range = not_too_deep(crack.depth, *wg.inner_ring_thickness)};
  }

  // --- Flexspline -------------------------------------------------------------------------------

  /// The isotropic material of the wall that contains a crack.
  [[nodiscard]] Elastic wall_steel(WallSection section) const {
    return steel(material_name(*gear_.flexspline, section), "flexspline.material");
  }
  /// The isotropic material of the diaphragm.
  [[nodiscard]] Elastic diaphragm_steel() const {
    const Flexspline& fs = *gear_.flexspline;
    return steel(material_name(fs, *fs.diaphragm), "flexspline.diaphragm.material");
  }

  /// The wall that contains a crack.
  [[nodiscard]] Wall<Real> wall_of(WallSection section) const {
    const Flexspline& fs = *gear_.flexspline;
    if (fs.crack_free == CrackFree::factor) return tooth_ring(lift_, gear_);
    const TubeSection& given = section == WallSection::rim ? *fs.rim : *fs.barrel;
    const Real t = lift_(given.wall_thickness);
    return {(lift_(given.outer_diameter) - t) / 2, t};  // (ST-11)
  }

  /// Stress on the plane of a wall crack per unit of axial force and torque [1/m^2, 1/m^3].
  template <class Crack>
  [[nodiscard]] sif::BasicCrackPlaneStress<Real> plane_of(const Crack& crack) const {
    const Wall<Real> wall = wall_of(crack.section);
    return sif::crack_plane_stress(wall.mean_radius, wall.thickness, Real(lift_(crack.angle)),
                                   Real(lift_(gear_.flexspline->stress_nonuniformity)));
  }

  /// Which senses of torque open a wall crack.
  /// @param crack     of the wall
  /// @param by_shear  part of the shear stress that opens the crack like a normal stress
  ///                  (`opening_by_shear`) [-]
  template <class Crack>
  [[nodiscard]] BothSenses faces_of(const Crack& crack, double by_shear = 0.0) const {
    const sif::BasicCrackPlaneStress<Real> stress = plane_of(crack);
    const double P = gear_.load.axial_force;
    const double T = std::abs(gear_.load.torque);
    const auto opening = [&](std::size_t load) {
      return value_of(stress.normal[load]) + by_shear * value_of(stress.shear[load]);
    };
    const double from_P = opening(kAxial) * P;
    const double from_T = opening(kTorsion) * T;
    const double scale = std::abs(from_P) + std::abs(from_T) +
                         std::abs(value_of(stress.shear[kAxial]) * P) +
                         std::abs(value_of(stress.shear[kTorsion]) * T);
    return {faces(from_P + from_T, scale), faces(from_P - from_T, scale)};
  }

  /// A through crack of the wall; in a laminate it is that of a flat anisotropic sheet (LA-9).
  [[nodiscard]] Numbers<sif::BasicThroughCrackInTube<Real>> numbers(
      const WallThroughCrack& crack) const {
    const Wall<Real> wall = wall_of(crack.section);
    const Material& of =
        material_of(gear_, material_name(*gear_.flexspline, crack.section), "flexspline.material");
    if (const auto laminate = wall_laminate(lift_, gear_, of, wall.thickness))
      return in_laminate(crack, wall, *laminate);
    const Elastic steel = elastic_constants(lift_, of);
    Numbers<sif::BasicThroughCrackInTube<Real>> result{
        .parameters = {.half_length = lift_(crack.half_length),
                       .mean_radius = wall.mean_radius,
                       .wall_thickness = wall.thickness,
                       .angle = lift_(crack.angle),
                       .stress_nonuniformity = lift_(gear_.flexspline->stress_nonuniformity),
                       .poissons_ratio = steel.nu,
                       .shell_correction = crack.shell_correction,
                       .thin_sheet = false,
                       .count = crack.count},
        .moduli = plane_stress(steel),
        .constraint = sif::Constraint::plane_stress,
        .faces = faces_of(crack),
        .table = table_of(crack)};
    const auto& tube = result.parameters;
    result.in_range = std::sqrt(value_of(tube.shell_parameter_squared(tube.half_length))) <=
                          tube.kMaxShellParameter &&
                      row_state(crack) == RowState::holds;
    return result;
  }
  /// A surface crack of the wall.
  [[nodiscard]] Numbers<sif::SurfaceCrack<2, Real>> numbers(const WallSurfaceCrack& crack) const {
    const Elastic steel = wall_steel(crack.section);
    const sif::BasicCrackPlaneStress<Real> stress = plane_of(crack);
    const Real thickness = wall_of(crack.section).thickness;
    return {.parameters = {.depth = lift_(crack.depth),
                           .aspect_ratio = lift_(crack.depth) / lift_(crack.half_length),
                           .thickness = thickness,
                           .poissons_ratio = steel.nu,
                           .normal_stress = stress.normal,
                           .shear_stress = stress.shear,
                           .count = crack.count},
            .moduli = plane_strain(steel),
            .faces = faces_of(crack),
            .in_range = not_too_deep(crack.depth, value_of(thickness)) &&
                        row_bound(crack) <= kLargestRowBound};
  }
  /// An arc crack of the diaphragm slides under torque, so it is a through crack of a flat plate in
  /// pure mode II.
  [[nodiscard]] Numbers<sif::BasicThroughCrackInTube<Real>> numbers(
      const DiaphragmArcCrack& crack) const {
    const Elastic steel = diaphragm_steel();
    const Real r = arc_radius(crack);
    // The shear T/(2 pi r^2 h) along the arc equals that along the generator of a tube with the
    // radius of the arc.
    return {.parameters = {.half_length = lift_(crack.half_length),
                           .mean_radius = r,
                           .wall_thickness =
                               diaphragm_thickness(lift_, *gear_.flexspline->diaphragm, r),
                           .angle = Real(0.0),
                           .poissons_ratio = steel.nu,
                           .shell_correction = false,
                           .count = crack.count,
                           .in_line = true},
            .moduli = plane_stress(steel),
            .constraint = sif::Constraint::plane_stress,
            .faces = {},
            .in_range = row_gap_of(crack, value_of(r), std::numbers::pi / 2) >= kLeastRowGap};
  }
  /// What is known of a row of through cracks (CG-7), (CG-8).
  enum class RowState {
    holds,         ///< the crack is alone, or its row is known
    too_close,     ///< the gaps are too narrow
    beyond_table,  ///< the curvature between the cracks is not tabulated
    faces,         ///< the neighbours open or press faces that the load alone presses or opens
  };
  /// Whether the solution of a crack's row holds (CG-7), (CG-8).
  [[nodiscard]] RowState row_state(const WallThroughCrack& crack) const {
    if (crack.count == 1) return RowState::holds;
    const double r = value_of(wall_of(crack.section).mean_radius);
    if (row_gap_of(crack, r, crack.angle) < kLeastRowGap) return RowState::too_close;
    const double share = crack.half_length * crack.count / (std::numbers::pi * r);
    if (crack.shell_correction && share > sif::largest_tabulated_share(crack.angle))
      return RowState::beyond_table;
    if (share <= kTorsionKeepsFaces && std::abs(crack.angle) <= kTorsionKeepsFacesAngle &&
        gear_.load.axial_force == 0)
      return RowState::holds;
    return neighbours_keep_faces(crack, share) ? RowState::holds : RowState::faces;
  }

  /// Estimate of the largest change of G of a surface crack by its row: that of through cracks of
  /// its length in a flat sheet under any load, with a margin for the curvature, as a share of G
  /// [-]; infinite if their row is not known.
  [[nodiscard]] double row_bound(const WallSurfaceCrack& crack) const {
    if (crack.count == 1) return 0.0;
    const double r = value_of(wall_of(crack.section).mean_radius);
    if (row_gap_of(crack, r, crack.angle) < kLeastRowGap)
      return std::numeric_limits<double>::infinity();
    const double share = crack.half_length * crack.count / (std::numbers::pi * r);
    // G over all directions of the stress: squares of the singular values of F.
    const RowFactors F = row_factors(share, crack.angle);
    const double sum =
        F.opening_by_normal * F.opening_by_normal + F.sliding_by_normal * F.sliding_by_normal +
        F.opening_by_shear * F.opening_by_shear + F.sliding_by_shear * F.sliding_by_shear;
    const double product =
        F.opening_by_normal * F.sliding_by_shear - F.opening_by_shear * F.sliding_by_normal;
    const double root = std::sqrt(std::max(0.0, sum * sum / 4 - product * product));
    const double pressed = pressed_row(share, crack.angle);
    const double largest =
        std::max({sum / 2 + root - 1, 1 - (sum / 2 - root), std::abs(pressed * pressed - 1)});
    return kCurvatureOfRow * largest;
  }

  /// A groove has no solution that sweeps an area.
  [[nodiscard]] static LoadedGroove numbers(const DiaphragmGroove&) { return {}; }

  /// Radius of an arc crack [m]; the inner radius of the diaphragm if the file gives none.
  [[nodiscard]] Real arc_radius(const DiaphragmArcCrack& crack) const {
    return crack.radius ? Real(lift_(*crack.radius))
                        : Real(lift_(gear_.flexspline->diaphragm->inner_diameter) / 2);
  }

  // --- Output shaft -----------------------------------------------------------------------------

  /// The isotropic material of the output shaft.
  [[nodiscard]] Elastic shaft_steel() const {
    return steel(gear_.output_shaft->material, "output_shaft.material");
  }

  /// a/t of a crack in a hollow shaft [-].
  [[nodiscard]] double depth_ratio(const AnnularCrack& crack) const {
    const OutputShaft& shaft = *gear_.output_shaft;
    return crack.depth / (shaft.outer_diameter / 2 - shaft.inner_diameter / 2);
  }

  /// An annular crack, in a shaft without and with a bore.
  /// @{
  [[nodiscard]] Numbers<sif::BasicAnnularCrackSolid<Real>> numbers_in_solid_shaft(
      const AnnularCrack& crack) const {
    return {.parameters = {.depth = lift_(crack.depth),
                           .diameter = lift_(gear_.output_shaft->outer_diameter),
                           .polynomials = crack.solution == AnnularSolution::tada
                                              ? sif::AnnularPolynomials::tada
                                              : sif::AnnularPolynomials::improved},
            .moduli = plane_strain(shaft_steel()),
            .faces = shaft_faces(),
            .table = table_of(crack)};
  }
  [[nodiscard]] Numbers<sif::BasicAnnularCrackHollow<Real>> numbers_in_hollow_shaft(
      const AnnularCrack& crack) const {
    using Hollow = sif::BasicAnnularCrackHollow<Real>;
    return {.parameters = {.depth = lift_(crack.depth),
                           .outer_radius = lift_(gear_.output_shaft->outer_diameter) / 2,
                           .inner_radius = lift_(gear_.output_shaft->inner_diameter) / 2},
            .moduli = plane_strain(shaft_steel()),
            .faces = shaft_faces(),
            .in_range = !clearly_less(Hollow::kMaxDepthRatio, depth_ratio(crack)),
            .table = table_of(crack)};
  }
  /// @}

  /// A surface crack of the shaft, without and with a bore.
  /// @{
  [[nodiscard]] Numbers<sif::BasicShaftSurfaceSolid<Real>> numbers_in_solid_shaft(
      const ShaftSurfaceCrack& crack) const {
    return {.parameters = {.depth = lift_(crack.depth),
                           .half_length = lift_(crack.half_length),
                           .diameter = lift_(gear_.output_shaft->outer_diameter)},
            .moduli = plane_strain(shaft_steel()),
            .faces = shaft_faces()};
  }
  [[nodiscard]] Numbers<sif::BasicShaftSurfaceHollow<Real>> numbers_in_hollow_shaft(
      const ShaftSurfaceCrack& crack) const {
    const OutputShaft& shaft = *gear_.output_shaft;
    const Elastic steel = shaft_steel();
    return {
        .parameters = {.depth = lift_(crack.depth),
                       .half_length = lift_(crack.half_length),
                       .outer_radius = lift_(shaft.outer_diameter) / 2,
                       .inner_radius = lift_(shaft.inner_diameter) / 2,
                       .poissons_ratio = steel.nu},
        .moduli = plane_strain(steel),
        .faces = shaft_faces(),
        .in_range = not_too_deep(crack.depth, (shaft.outer_diameter - shaft.inner_diameter) / 2)};
  }
  /// @}

 private:
  /// Stress on the plane of a crack without derivatives.
  template <class Crack>
  [[nodiscard]] sif::CrackPlaneStress value_of_plane(const Crack& crack) const {
    const Wall<Real> wall = wall_of(crack.section);
    return sif::crack_plane_stress(value_of(wall.mean_radius), value_of(wall.thickness),
                                   crack.angle, gear_.flexspline->stress_nonuniformity);
  }
  /// Whether faces that the load opens alone stay open beside their neighbours, and pressed ones
  /// pressed.
  [[nodiscard]] bool neighbours_keep_faces(const WallThroughCrack& crack, double share) const {
    const auto stress = value_of_plane(crack);
    const double P = gear_.load.axial_force;
    const double T = gear_.load.torque == 0 && P == 0 ? 1.0 : std::abs(gear_.load.torque);
    const BothSenses state = faces_of(crack);
    const RowFactors apart = row_factors(share, crack.angle);
    const PullOfRow pull = pull_of_row(share, crack.angle);
    const auto kept = [&](double torque, Faces of) {
      const double N = stress.normal[kAxial] * P + stress.normal[kTorsion] * torque;
      const double S = stress.shear[kAxial] * P + stress.shear[kTorsion] * torque;
      const double rounding = 1e-9 * (std::abs(N) + std::abs(S));
      if (of == Faces::pressed) return N + std::max(pull.least * S, pull.most * S) <= rounding;
      return apart.opening_by_normal * N + apart.opening_by_shear * S >= -rounding;
    };
    return kept(T, state.positive) && kept(-T, state.negative);
  }
  /// Gap between the neighbours of a row over the half length of a crack [-]; infinite for a crack
  /// alone.
  template <class Crack>
  [[nodiscard]] static double row_gap_of(const Crack& crack, double radius, double angle) {
    if (crack.count == 1) return std::numeric_limits<double>::infinity();
    return row_gap(crack.half_length * crack.count / (std::numbers::pi * radius), angle);
  }
  template <class Solution>
  [[nodiscard]] static LoadedCrack<Solution> with_solution(const Numbers<Solution>& numbers) {
    return LoadedCrack<Solution>(numbers);
  }
  /// For what has no solution: a groove, or a crack that acts in the coupled drive.
  template <class Other>
  [[nodiscard]] static Other with_solution(const Other& other) {
    return other;
  }

  [[nodiscard]] Elastic steel(std::string_view material, std::string_view field) const {
    return elastic_constants(lift_, material_of(gear_, material, field));
  }
  /// A through crack of a laminate is that of a flat, thin, anisotropic sheet (LA-9).
  [[nodiscard]] Numbers<sif::BasicThroughCrackInTube<Real>> in_laminate(
      const WallThroughCrack& crack, const Wall<Real>& wall,
      const LaminateStiffness<Real>& laminate) const {
    const Real angle = lift_(crack.angle);
    const Moduli moduli = crack_moduli(laminate, angle);
    Numbers<sif::BasicThroughCrackInTube<Real>> result{
        .parameters = {.half_length = lift_(crack.half_length),
                       .mean_radius = wall.mean_radius,
                       .wall_thickness = wall.thickness,
                       .angle = angle,
                       .stress_nonuniformity = lift_(gear_.flexspline->stress_nonuniformity),
                       .poissons_ratio = Real(0.0),
                       .shell_correction = false,
                       .thin_sheet = true,
                       .count = crack.count},
        .moduli = moduli,
        .constraint = sif::Constraint::plane_stress,
        .faces = faces_of(crack, value_of(moduli.opening_by_shear()))};
    // The size of a crack at which the curvature counts is that of an isotropic wall.
    auto isotropic = result.parameters;
    isotropic.poissons_ratio = Real(kMetalPoissonsRatio);
    result.in_range =
        std::sqrt(value_of(isotropic.shell_parameter_squared(isotropic.half_length))) <=
        isotropic.kMaxShellParameter;
    return result;
  }
  static Moduli plane_strain(const Elastic& steel) {
    return {.opening = steel.plane_strain_modulus(), .shear = steel.G};
  }
  static Moduli plane_stress(const Elastic& steel) {
    return {.opening = steel.E, .shear = steel.G};
  }

  template <class Crack>
  [[nodiscard]] std::optional<TabulatedCompliance<Real>> table_of(const Crack& crack) const {
    if (!crack.compliance_table) return std::nullopt;
    return tabulated_compliance(gear_.compliance_tables.at(*crack.compliance_table),
                                crack_parameters(lift_, gear_, crack));
  }

  [[nodiscard]] static bool not_too_deep(double depth, double thickness) {
    return !clearly_less(sif::kUsableDepthRatio * thickness, depth);
  }
  template <class Crack>
  [[nodiscard]] static sif::StripLoading race_loading(const Crack& crack) {
    return crack.stress_driver == StressDriver::ring_bending ? sif::StripLoading::bending
                                                             : sif::StripLoading::tension;
  }
  /// The lobe force has the same sense for both senses of torque.
  static BothSenses race_faces(const Real& stress) {
    const double value = value_of(stress);
    const Faces state = faces(value, std::abs(value));
    return {state, state};
  }
  [[nodiscard]] BothSenses shaft_faces() const {
    const double P = gear_.load.axial_force;
    const Faces state = faces(P, std::abs(P));
    return {state, state};
  }

  [[nodiscard]] std::array<Real, 2> semi_axes() const {
    const WaveGenerator& wg = *gear_.wave_generator;
    if (wg.contact_semi_axes)
      return {lift_((*wg.contact_semi_axes)[0]), lift_((*wg.contact_semi_axes)[1])};
    const BasicHertzContact<Real> inner = inner_contact();
    return {inner.major_semi_axis, inner.minor_semi_axis};
  }

  /// Peak pressure per unit of lobe force, at the ball above the crack.
  [[nodiscard]] Real pressure_per_force(const Real& a, const Real& b) const {
    const WaveGenerator& wg = *gear_.wave_generator;
    const Real share = wg.bearing ? Real(1 / lift_(wg.bearing->loaded_balls)) : Real(1.0);
    return peak_pressure(share, a, b);
  }

  const GearSet& gear_;
  Lift<Real> lift_;
  ContactEllipses* ellipses_;
};

}  // namespace strainwave
