// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "strainwave/core/dual.hpp"
#include "strainwave/core/lift.hpp"
#include "strainwave/crack_group/group_response.hpp"
#include "strainwave/drive_cracks/faces.hpp"
#include "strainwave/drive_cracks/loaded_crack.hpp"
#include "strainwave/fracture/crack_compliance.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/crack_strength.hpp"
#include "strainwave/sif/member/wall_through.hpp"

/// @file
/// Unlike through cracks of a section of the flexspline that have places, and their influence on
/// each other (CG-9).

namespace strainwave {

/// A value under both senses of the torque.
template <class Real>
struct UnderBothSenses {
  Real positive{1.0};  ///< under torque about +z
  Real negative{1.0};  ///< under torque about -z
};

/// What one crack of a group does in the flat sheet, with the faces of all cracks in one state.
struct GroupEffect {
  bool closed = false;  ///< whether its own faces are pressed together
  /// Work of the stress of the sound wall on the jumps of the crack, times E' and per unit of each
  /// two of [axial force, torque]: in the group, and alone [Pa^2*m^2 per units of load].
  SymmetricMatrix<2> in_group;
  SymmetricMatrix<2> alone;  ///< the same of the crack alone
  /// Stress on the plane of the crack that acts at each tip like the loads and the other cracks
  /// together, per unit of axial force and torque: behind, ahead [1/m^2, 1/m^3].
  std::array<sif::CrackPlaneStress, 2> tips{};
  /// The same per unit of the hoop stress of the assembly: normal and shear of each tip [-].
  std::array<std::array<double, 2>, 2> by_hoop{};
  /// What the given load does.
  /// @{
  double intensity = 1.0;  ///< larger K of the two tips over K alone [-]; 1 if K alone is 0
  double tip = 0.0;        ///< larger K of the two tips over K alone with open faces [-]
  double changed_compliance = 0.0;  ///< change by the others, over that alone with open faces [-]
  double changed_intensity = 0.0;   ///< largest change of a tip's K, likewise [-]
  /// Share of its jumps or stresses by which faces overlap or pull somewhere [-]
  double overlap = 0.0;
  /// @}

  /// Compliance in torsion in the group over that alone [-]; 1 if the crack alone adds nothing.
  [[nodiscard]] double ratio() const;
};

/// The through cracks of one section of the flexspline that have a position and no row of their
/// own: at least two.
///
/// Implements theory manual eq. (CG-9).  The object keeps half lengths at which it answers, because
/// cracks grow; it begins with those of the file.
class WallGroup {
 public:
  /// One crack of the group, on the wall unrolled to a sheet.
  struct Member {
    std::size_t index = 0;  ///< in `flexspline.crack`
    std::string path;       ///< "flexspline.crack[0]"
    StraightCrack place;    ///< with the half length at which the group answers
    BothSenses faces;       ///< as the loads alone leave them
  };
  /// The wall and its loads.
  struct Wall {
    std::string name;    ///< "wall", "barrel" or "rim"
    double round = 0.0;  ///< circumference [m]
    double axial = 0.0;  ///< axial stress per unit of axial force [1/m^2]
    double shear = 0.0;  ///< shear stress per unit of torque, with its nonuniformity [1/m^3]
    double poissons_ratio = 0.3;   ///< nu [-]
    double shell_parameter = 0.0;  ///< lambda of a crack per unit of its half length [1/m]
    double axial_force = 0.0;      ///< P of the file [N]
    double torque = 0.0;           ///< |T| of the file [N*m]
  };

  /// @param wall     that contains the cracks, with its loads
  /// @param members  at least two, which do not touch
  WallGroup(Wall wall, std::vector<Member> members);

  /// The wall and its loads.
  [[nodiscard]] const Wall& wall() const { return wall_; }
  /// The cracks in the order of the file.
  [[nodiscard]] const std::vector<Member>& members() const { return members_; }

  /// Sets the half length of one crack [m]; > 0.
  void set_half_length(std::size_t member, double half_length) {
    members_[member].place.half_length = half_length;
  }

  /// Why the group has no usable answer at the present sizes, in a sentence that begins with the
  /// path of a crack; empty if it has one.
  [[nodiscard]] std::string fault() const;
  /// The part of `fault` that does not depend on the faces: number of cracks, gaps.
  [[nodiscard]] std::string fault_of_places() const;

  /// The cracks under the given load with one sense of the torque.  The group must have no fault of
  /// places.
  [[nodiscard]] std::vector<GroupEffect> under(TorqueSense sense) const;
  /// The same with all faces apart, as growth counts them.
  [[nodiscard]] std::vector<GroupEffect> apart() const;

  /// Uncertainty of the influence as a share of it, because the curvature between the cracks is
  /// left out [-].
  [[nodiscard]] double uncertainty() const;

  /// Places with which the ratios of compliance are differentiated.
  template <class Real>
  struct Places {
    /// Of one crack.
    struct Place {
      Real round{};        ///< x round the axis [m]
      Real along{};        ///< y along the axis [m]
      Real half_length{};  ///< a [m]
      Real angle{};        ///< beta [rad]
    };
    std::vector<Place> cracks;  ///< in the order of the members
    Real round{};               ///< circumference [m]
  };
  /// Compliance of each crack in torsion over that of the crack alone, under both senses of the
  /// torque; 1 if the group has a fault.
  /// @{
  [[nodiscard]] std::vector<UnderBothSenses<double>> ratios(const Places<double>& places) const;
  /// With derivatives, by differences of the group along each input (CG-9).
  [[nodiscard]] std::vector<UnderBothSenses<DualReal>> ratios(const Places<DualReal>& places) const;
  /// @}

 private:
  [[nodiscard]] std::vector<StraightCrack> places() const;
  [[nodiscard]] std::vector<bool> closed_under(TorqueSense sense) const;
  [[nodiscard]] std::vector<GroupEffect> effects(const std::vector<bool>& closed,
                                                 std::array<double, 2> load) const;
  [[nodiscard]] std::array<double, 2> load(TorqueSense sense) const;

  Wall wall_;
  std::vector<Member> members_;
};

/// While it lives, groups of two cracks answer from tables over the half lengths (CG-15) in this
/// thread, which keeps them for later: for many lives, which pass the same sizes.  An answer does
/// not depend on the lives before it.
class TabulatedPairs {
 public:
  TabulatedPairs();
  ~TabulatedPairs();
  TabulatedPairs(const TabulatedPairs&) = delete;
  TabulatedPairs& operator=(const TabulatedPairs&) = delete;

 private:
  bool before_;
};

/// The groups of a drive: of the barrel or the whole wall, and of the rim.  A section of a laminate
/// has none, because the solution is that of an isotropic sheet.
/// @param gear   has passed `check`
/// @param loads  of the drive
[[nodiscard]] std::vector<WallGroup> wall_groups(const GearSet& gear,
                                                 const CrackLoads<double>& loads);

/// The places of a group as numbers of the drive.
/// @param group  of the drive
/// @param gear   the drive of the group
/// @param lift   reads its numbers
/// @param loads  with the same lift
template <class Real>
[[nodiscard]] WallGroup::Places<Real> places_of(const WallGroup& group, const GearSet& gear,
                                                const Lift<Real>& lift,
                                                const CrackLoads<Real>& loads) {
  const Flexspline& fs = *gear.flexspline;
  WallGroup::Places<Real> places;
  for (const WallGroup::Member& member : group.members()) {
    const auto& crack = std::get<WallThroughCrack>(fs.crack[member.index]);
    const Real radius = loads.wall_of(crack.section).mean_radius;
    const double& length = fs.crack_free != CrackFree::sections ? *fs.length
                           : crack.section == WallSection::rim  ? fs.rim->length
                                                                : fs.barrel->length;
    places.cracks.push_back(
        {.round = radius * lift(*crack.position),
         .along = crack.distance ? Real(lift(*crack.distance)) : Real(lift(length) / 2),
         .half_length = lift(crack.half_length),
         .angle = lift(crack.angle)});
    places.round = 2 * std::numbers::pi * radius;
  }
  return places;
}

}  // namespace strainwave
