// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/core/progress.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/coupled_result.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/torsion/assembled_drive.hpp"

/// @file
/// The torsion curve phi(T) of a drive solved as one system: an elastic ring on one-sided contacts
/// of balls and flanks.

namespace strainwave {

/// Members that contribute to the tangent compliance, in the order of `CurvePoint::share`.
enum class CurveMember {
  balls,
  rim_bending,
  outer_ring_bending,
  barrel_warping,
  diaphragm_warping,
  rim_extension,
  teeth,
  circular_spline,
  barrel,
  diaphragm,
  rim_shear,
  boss_and_flange,
  series_cracks,
  output_shaft,
};
template <>
struct EnumNames<CurveMember> {
  static constexpr std::array<std::string_view, 14> names = {
      "balls",          "rim_bending",       "outer_ring_bending",
      "barrel_warping", "diaphragm_warping", "rim_extension",
      "teeth",          "circular_spline",   "barrel",
      "diaphragm",      "rim_shear",         "boss_and_flange",
      "series_cracks",  "output_shaft"};
};
/// Number of the members that have a share.
inline constexpr std::size_t kCurveMembers = EnumNames<CurveMember>::names.size();

/// Shares of the members in the tangent compliance [-]; the sum is 1.
struct MemberShares : std::array<double, kCurveMembers> {
  template <class Visitor>
  static void describe(Visitor&& field) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (field({EnumNames<CurveMember>::names[I], "1", "share in the tangent compliance"},
             [](const MemberShares& share) { return share[I]; }),
       ...);
    }
    (std::make_index_sequence<kCurveMembers>{});
  }
};

/// Force of one contact.
struct ContactForce {
  double position = 0.0;  ///< angle from the major axis, toward +theta [rad]
  double force = 0.0;     ///< [N]
  double tangent = 0.0;   ///< dQ/dT [1/m]

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"position", "rad", "angle from the major axis, toward +theta"}, &ContactForce::position);
    field({"force", "N", "force of the contact"}, &ContactForce::force);
    field({"tangent", "1/m", "change of the force with the torque"}, &ContactForce::tangent);
  }
};

/// The drive in equilibrium at one torque.
struct CurvePoint {
  double torque = 0.0;              ///< T at the output [N*m]
  double twist = 0.0;               ///< twist phi of the output with locked input [rad]
  double ring_rotation = 0.0;       ///< part of the twist from contacts and rings [rad]
  double tangent_compliance = 0.0;  ///< d phi/dT [rad/(N*m)]; infinite while no flank touches
  MemberShares share{};
  std::vector<ContactForce> balls;         ///< all balls
  std::vector<ContactForce> drive_flanks;  ///< drive flanks in contact
  std::vector<ContactForce> coast_flanks;  ///< coast flanks in contact
  int balls_in_contact = 0;
  int teeth_in_contact = 0;
  double residual = 0.0;  ///< residual of the contact forces, relative to the largest [-]
  int iterations = 0;     ///< Newton steps

  /// Secant stiffness T/phi [N*m/rad].
  [[nodiscard]] double secant_stiffness() const { return torque / twist; }
  /// Tangent stiffness dT/d phi [N*m/rad]; 0 while no flank touches.
  [[nodiscard]] double tangent_stiffness() const { return 1 / tangent_compliance; }

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"torque", "N*m", "T, torque at the output"}, &CurvePoint::torque);
    field({"twist", "rad", "twist phi of the output with locked input"}, &CurvePoint::twist);
    field({"tangent_stiffness", "N*m/rad", "dT/d phi"}, &CurvePoint::tangent_stiffness);
    field({"secant_stiffness", "N*m/rad", "T/phi"}, &CurvePoint::secant_stiffness);
    field({"teeth_in_contact", "1", "teeth that touch on either flank"},
          &CurvePoint::teeth_in_contact);
    field({"balls_in_contact", "1", "balls that carry load"}, &CurvePoint::balls_in_contact);
    field({"share", "", "shares of the members in the tangent compliance"}, &CurvePoint::share);
    field({"balls", "", "all balls"}, &CurvePoint::balls);
    field({"drive_flanks", "", "drive flanks in contact"}, &CurvePoint::drive_flanks);
    field({"coast_flanks", "", "coast flanks in contact"}, &CurvePoint::coast_flanks);
    field({"residual", "1", "residual of the contact forces, relative to the largest"},
          &CurvePoint::residual);
    field({"iterations", "", "steps of the solver"}, &CurvePoint::iterations);
  }
};

/// Torsion curve of a drive with its evidence.
struct TorsionCurve {
  std::vector<CurvePoint> points;
  int teeth = 0;                     ///< teeth of the flexspline, z
  double cam_amplitude = 0.0;        ///< cam amplitude A that lifts the lobe to w_0 [m]
  double assembly_ball_force = 0.0;  ///< largest ball force without torque [N]
  /// largest flank force without torque [N]; 0 if no flanks press on each other
  double assembly_flank_force = 0.0;
  double series_compliance = 0.0;      ///< compliance of the members outside the ring [rad/(N*m)]
  std::vector<Note> notes;             ///< remarks on the validity of the curve
  std::vector<std::string> equations;  ///< tags of the theory manual
  std::string unusable_because;        ///< reason why the answer must not be used; empty if usable

  /// Whether the curve may be used.
  [[nodiscard]] bool usable() const { return unusable_because.empty(); }

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"teeth", "", "z, teeth of the flexspline"}, &TorsionCurve::teeth);
    field({"cam_amplitude", "m", "cam amplitude A that lifts the lobe to w_0"},
          &TorsionCurve::cam_amplitude);
    field({"assembly_ball_force", "N", "largest ball force without torque"},
          &TorsionCurve::assembly_ball_force);
    field({"assembly_flank_force", "N", "largest flank force without torque"},
          &TorsionCurve::assembly_flank_force);
    field({"series_compliance", "rad/(N*m)", "compliance of the members outside the ring"},
          &TorsionCurve::series_compliance);
    field({"points", "", "the drive in equilibrium at each torque"}, &TorsionCurve::points);
  }
};

/// The fields that a drive lacks for a torsion curve, which needs a bearing with balls and outer
/// ring, a cup by sections, and a tooth mesh.  Empty if the drive is complete; else one sentence
/// that names the missing fields.
[[nodiscard]] std::string missing_for_torsion_curve(const GearSet& gear);

/// Twist of the output as a function of the torque, from the assembled state, with locked input.
///
/// Implements theory manual eqs. (TC-1) to (TC-15).  The model is one system: a ring of rim and
/// bearing outer ring in Fourier modes on barrel and diaphragm, balls by Hertz on a fixed cam,
/// straight flanks with the gap of the wave's kinematics and the tilt of the cup, a circular spline
/// held by its housing, and barrel, diaphragm, rim, boss and flange in series.  Cracks act inside
/// this system, under the sense of the torque.
///
/// The model is for cups with two lobes.  Geometry alone predicts catalogue stiffness within about
/// 40 % for ratios of 50 and more.  At ratio 30 the model is too stiff by a factor of up to 2.0
/// (theory manual, chapter CV).
///
/// @param drive     the assembled drive, with its cracks and deviations
/// @param torques   torque T at the output [N*m], finite; each is solved starting from the state
///                  before it, the first from the assembly
/// @param progress  receives the share done, 0 to 1, and may stop the run; {}: neither
/// @throws InputError  if a torque is not finite
/// @throws Stopped     if the caller requests a stop
[[nodiscard]] TorsionCurve torsion_curve(const AssembledDrive& drive,
                                         std::span<const double> torques,
                                         const Progress& progress = {});
/// Torsion curve of a drive that is not assembled yet.
/// @throws InputError  also if a rule is broken or this model lacks an input
[[nodiscard]] inline TorsionCurve torsion_curve(const GearSet& gear,
                                                std::span<const double> torques,
                                                const CoupledOptions& options = {},
                                                const Progress& progress = {}) {
  return torsion_curve(AssembledDrive(gear, options), torques, progress);
}

/// The twists of `torsion_curve` alone [rad], at a third of its cost.
/// @throws SolverError  if the curve is not usable; the message states the reason
[[nodiscard]] std::vector<double> twists(const AssembledDrive& drive,
                                         std::span<const double> torques,
                                         const Progress& progress = {});

/// The twist at one torque [rad]; absent, with one note `curve.no_wind_up`, if the drive does not
/// reach it.
/// @param drive   the assembled drive, with its cracks and deviations
/// @param torque  torque T at the output [N*m], finite
/// @param notes   gets the note, unless it has one with this code
/// @throws InputError  if the torque is not finite
[[nodiscard]] std::optional<double> reached_twist(const AssembledDrive& drive, double torque,
                                                  std::vector<Note>& notes);

/// Displacements of the rim and its stresses at the line of the tooth roots, at one torque.
struct RimState {
  double position = 0.0;            ///< angle from the major axis [rad]
  double radial = 0.0;              ///< w, outward [m]
  double tangential = 0.0;          ///< v, toward +theta [m]
  double rim_outside_stress = 0.0;  ///< hoop stress at the tooth roots [Pa]
  double rim_inside_stress = 0.0;   ///< hoop stress at the bore [Pa]
  /// hoop stress at the outer surface of the barrel's end [Pa]; absent: the plies of a laminate
  /// have stresses of their own
  std::optional<double> barrel_bending_stress = {};
  double barrel_shear_stress = 0.0;  ///< from the torque, mean over the wall [Pa]

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"position", "rad", "angle from the major axis"}, &RimState::position);
    field({"radial", "m", "w, outward"}, &RimState::radial);
    field({"tangential", "m", "v, toward +theta"}, &RimState::tangential);
    field({"rim_outside_stress", "Pa", "hoop stress at the tooth roots"},
          &RimState::rim_outside_stress);
    field({"rim_inside_stress", "Pa", "hoop stress at the bore"}, &RimState::rim_inside_stress);
    field({"barrel_bending_stress", "Pa",
           "hoop stress at the outer surface of the barrel's end; absent for a laminate"},
          &RimState::barrel_bending_stress);
    field({"barrel_shear_stress", "Pa", "shear stress from the torque in the barrel"},
          &RimState::barrel_shear_stress);
  }
};

/// States of rim and barrel over a turn of the wave generator, in which a point of the flexspline
/// passes all positions.
///
/// Implements theory manual eq. (TC-24).  Ring theory leaves out stress concentrations at tooth
/// roots and fillets.
///
/// @param drive      the assembled drive, with its cracks and deviations
/// @param torque     torque T at the output [N*m], finite
/// @param positions  number of positions, evenly over a turn; > 0
/// @throws InputError   if the torque is not finite or `positions` is not > 0
/// @throws SolverError  if there is no equilibrium
[[nodiscard]] std::vector<RimState> rim_states(const AssembledDrive& drive, double torque,
                                               int positions);
/// States of rim and barrel for a drive that is not assembled yet.
[[nodiscard]] inline std::vector<RimState> rim_states(const GearSet& gear, double torque,
                                                      int positions,
                                                      const CoupledOptions& options = {}) {
  return rim_states(AssembledDrive(gear, options), torque, positions);
}

/// The maker's three straight lines, under one sense of torque.
struct MakersLines {
  double K1 = 0.0;    ///< T1/phi(T1) [N*m/rad]
  double K2 = 0.0;    ///< (T2 - T1)/(phi(T2) - phi(T1)) [N*m/rad]
  double K3 = 0.0;    ///< (T3 - T2)/(phi(T3) - phi(T2)) [N*m/rad]
  double phi1 = 0.0;  ///< twist at T1 [rad]
  double phi2 = 0.0;  ///< twist at T2 [rad]
  double phi3 = 0.0;  ///< twist at T3 [rad]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({.name = "K1", .unit = "N*m/rad", .doc = "T1/phi(T1)", .headline = true},
          &MakersLines::K1);
    field({.name = "K2", .unit = "N*m/rad", .doc = "slope from T1 to T2", .headline = true},
          &MakersLines::K2);
    field({.name = "K3", .unit = "N*m/rad", .doc = "slope from T2 to T3", .headline = true},
          &MakersLines::K3);
    field({"phi1", "rad", "twist at T1"}, &MakersLines::phi1);
    field({"phi2", "rad", "twist at T2"}, &MakersLines::phi2);
    field({"phi3", "rad", "twist at T3"}, &MakersLines::phi3);
  }
};

/// One standard relative uncertainty of the model's form in K1, K2, K3 [-].  It is the error
/// against catalogues with typical geometry (theory manual, chapter CV).
[[nodiscard]] double curve_uncertainty(const GearSet& gear);

/// The maker's torques with their defaults filled in.
[[nodiscard]] MakersTorques makers_torques(const GearSet& gear);

/// K1, K2, K3 by eq. (TC-14), for torque of the given sense (+1 or -1).
/// @throws SolverError  if the curve is not usable; the message states the reason
[[nodiscard]] MakersLines makers_lines(const AssembledDrive& drive, int sense = +1);
/// The maker's lines of a drive that is not assembled yet.
[[nodiscard]] inline MakersLines makers_lines(const GearSet& gear, int sense = +1,
                                              const CoupledOptions& options = {}) {
  return makers_lines(AssembledDrive(gear, options), sense);
}

}  // namespace strainwave
