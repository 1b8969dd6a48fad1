// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"

/// @file
/// The laminates of a flexspline: stiffness, torsion, stress and first failure of the plies.

namespace strainwave {

/// One ply of a wall.
struct PlyState {
  static constexpr bool kTableRow = true;
  int number = 0;  ///< from the inner face of the wall, 1 first
  std::string material;
  double angle = 0.0;      ///< [rad]
  double thickness = 0.0;  ///< in the wall [m]
  /// Stress by torque and axial force in the axes of the fibres [Pa]
  double load_along = 0.0;
  double load_across = 0.0;  ///< stress across the fibres by torque and axial force [Pa]
  double load_shear = 0.0;   ///< shear stress along the fibres by torque and axial force [Pa]
  /// Largest magnitudes of the stress by the assembly over the ply and over a turn [Pa]
  double assembly_along = 0.0;
  /// largest magnitude of the stress across the fibres by the assembly [Pa]
  double assembly_across = 0.0;
  /// largest magnitude of the shear stress along the fibres by the assembly [Pa]
  double assembly_shear = 0.0;
  /// Least factors on torque and axial force at which the ply fails, both senses of torque [-]
  std::optional<double> tsai_wu = {};
  std::optional<double> largest_strain = {};
  /// Least factor on torque, axial force and assembly together, by either criterion [-]
  std::optional<double> proportional = {};
  /// Where the ply fails first: its face, the angle from a lobe [rad], the sense of torque
  std::string worst_face = {};
  double worst_angle = 0.0;
  int worst_sense = 0;  ///< +1 or -1; 0: not known
  /// Stress there by load and assembly together, at the magnitude of the load [Pa]
  double worst_along = 0.0;
  double worst_across = 0.0;  ///< across the fibres [Pa]
  double worst_shear = 0.0;   ///< in shear along the fibres [Pa]
  /// Share of the Haigh line over a turn; absent: no endurance is given [-]
  std::optional<double> haigh = {};
  /// Factor on torque and axial force at which the share is 1 [-]
  std::optional<double> haigh_factor = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    using P = PlyState;
    const auto stress = [&](std::string_view name, std::string_view doc, auto member) {
      field({.name = name, .unit = "Pa", .doc = doc}, member);
    };
    field({"number", "", "number of the ply from the inner face of the wall"}, &P::number);
    field({"material", "", "material of the ply"}, &P::material);
    field({"angle", "rad", "angle of the fibres from the axis, measured like that of a crack"},
          &P::angle);
    field({"thickness", "m", "thickness in the wall"}, &P::thickness);
    stress("load_along", "stress along the fibres by torque and axial force", &P::load_along);
    stress("load_across", "stress across the fibres by torque and axial force", &P::load_across);
    stress("load_shear", "shear stress along the fibres by torque and axial force", &P::load_shear);
    stress("assembly_along", "largest stress along the fibres by the assembly over a turn",
           &P::assembly_along);
    stress("assembly_across", "largest stress across the fibres by the assembly over a turn",
           &P::assembly_across);
    stress("assembly_shear", "largest shear stress along the fibres by the assembly over a turn",
           &P::assembly_shear);
    field({"tsai_wu", "1",
           "least factor on the loads at which the ply fails by the criterion of Tsai and Wu"},
          &P::tsai_wu);
    field({"largest_strain", "1",
           "least factor on the loads at which the ply fails by the largest strain"},
          &P::largest_strain);
    field({"proportional", "1",
           "least factor on the loads and the assembly together at which the ply fails"},
          &P::proportional);
    field({"worst_face", "", "face of the ply that fails first"}, &P::worst_face);
    field({"worst_angle", "rad", "its angle from a lobe"}, &P::worst_angle);
    field({"worst_sense", "", "sense of torque under which it fails first; 0: not known"},
          &P::worst_sense);
    stress("worst_along", "stress there along the fibres by load and assembly", &P::worst_along);
    stress("worst_across", "stress there across the fibres by load and assembly", &P::worst_across);
    stress("worst_shear", "stress there in shear by load and assembly", &P::worst_shear);
    field({"haigh", "1", "share of the Haigh line over a turn; absent: no endurance is given"},
          &P::haigh);
    field({"haigh_factor", "1", "factor on the loads at which the share is 1"}, &P::haigh_factor);
  }
};

/// One section of a flexspline that is of a laminate.
struct LaminateWall {
  std::string path;      ///< "flexspline.barrel"
  std::string material;  ///< of the file
  double thickness = 0.0;
  double thickness_of_plies = 0.0;  ///< as the file gives them [m]
  double E_x = 0.0;                 ///< along the axis [Pa]
  double E_y = 0.0;                 ///< round the axis [Pa]
  double G_xy = 0.0;                ///< free to lengthen and to widen [Pa]
  double nu_xy = 0.0;
  std::array<double, 6> A = {};  ///< 11, 12, 22, 16, 26, 66 [N/m]
  std::array<double, 6> B = {};  ///< [N]
  std::array<double, 6> D = {};  ///< [N*m]
  double hoop_bending = 0.0;     ///< D_y [N*m]
  bool symmetric = false;        ///< B = 0
  bool balanced = false;         ///< A16 = A26 = 0
  /// Torsion of a tube; absent for a bottom
  std::optional<double> torsional_rigidity = {};  ///< G J [N*m^2]
  std::optional<double> compliance = {};          ///< [rad/(N*m)]
  std::optional<double> axial_strain = {};        ///< by the torque of the load [-]
  std::optional<double> hoop_strain = {};         ///< by the torque of the load [-]
  /// Least factor on torque and axial force at which a ply fails, by either criterion [-]
  std::optional<double> reserve = {};
  int first_ply = 0;  ///< number of the ply that fails first; 0: not known
  /// Least factor on torque, axial force and assembly together [-]
  std::optional<double> proportional = {};
  /// Largest share of the Haigh line of the plies; absent: not known [-]
  std::optional<double> haigh = {};
  std::vector<PlyState> plies = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    using W = LaminateWall;
    field({"path", "", "section of the flexspline"}, &W::path);
    field({"material", "", "its material"}, &W::material);
    field({"thickness", "m", "thickness of the wall"}, &W::thickness);
    field({"thickness_of_plies", "m", "sum of the plies as given"}, &W::thickness_of_plies);
    field({"E_x", "Pa", "modulus along the axis"}, &W::E_x);
    field({"E_y", "Pa", "modulus round the axis"}, &W::E_y);
    field({"G_xy", "Pa", "shear modulus of a wall that may lengthen and widen"}, &W::G_xy);
    field({"nu_xy", "1", "contraction round the axis under a stress along it"}, &W::nu_xy);
    field({"A", "N/m", "stiffness of the wall in its plane: 11, 12, 22, 16, 26, 66"}, &W::A);
    field({"B", "N", "coupling with bending: 11, 12, 22, 16, 26, 66"}, &W::B);
    field({"D", "N*m", "bending stiffness: 11, 12, 22, 16, 26, 66"}, &W::D);
    field({"hoop_bending", "N*m", "stiffness against a change of the hoop curvature"},
          &W::hoop_bending);
    field({"symmetric", "", "whether the plies are the same from both faces"}, &W::symmetric);
    field({"balanced", "", "whether torque does not lengthen the wall"}, &W::balanced);
    field({"torsional_rigidity", "N*m^2", "torque over twist per length; absent for a bottom"},
          &W::torsional_rigidity);
    field({"compliance", "rad/(N*m)", "torsional compliance of the section"}, &W::compliance);
    field({"axial_strain", "1", "strain along the axis by the torque"}, &W::axial_strain);
    field({"hoop_strain", "1", "strain round the axis by the torque"}, &W::hoop_strain);
    field({"reserve", "1", "least factor on the loads at which a ply fails; absent: not known"},
          &W::reserve);
    field({"first_ply", "", "number of the ply that fails first; 0: not known"}, &W::first_ply);
    field({"proportional", "1",
           "least factor on the loads and the assembly together; absent: not known"},
          &W::proportional);
    field({"haigh", "1", "largest share of the Haigh line of the plies; absent: not known"},
          &W::haigh);
    field({"plies", "", "each ply"}, &W::plies);
  }
};

/// All laminates of a flexspline.
struct LaminateReport {
  std::string sentence;  ///< the answer in words
  std::optional<double> reserve = {};
  std::optional<double> haigh = {};
  std::vector<LaminateWall> walls;
  std::vector<Note> notes;             ///< remarks on the validity of the values
  std::vector<std::string> equations;  ///< tags of the theory manual

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = LaminateReport;
    field({.name = "sentence", .unit = "", .doc = "the answer in words", .headline = true},
          &R::sentence);
    field({.name = "reserve",
           .unit = "1",
           .doc = "least factor on the loads at which a ply fails; absent: not known",
           .headline = true},
          &R::reserve);
    field({.name = "haigh",
           .unit = "1",
           .doc = "largest share of the Haigh line of the plies; absent: not known",
           .headline = true},
          &R::haigh);
    field({"walls", "", "each section of a laminate"}, &R::walls);
  }
};

/// Whether a section of the flexspline is of a laminate.
/// @param gear  has passed `check`
[[nodiscard]] bool has_laminates(const GearSet& gear);

/// Stiffness, torsion, stress and first failure of the laminates of a flexspline.
///
/// Implements theory manual eqs. (LA-1) to (LA-6), (LA-10) to (LA-14), (LA-18) and
/// (LA-19).
/// @param gear         has passed `check`
/// @throws InputError  if no section of the flexspline is of a laminate
[[nodiscard]] LaminateReport laminate_report(const GearSet& gear);

}  // namespace strainwave
