// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "strainwave/drive_cracks/loaded_crack.hpp"
#include "strainwave/stiffness/series_stiffness.hpp"

namespace strainwave {
namespace {

/// Notes on the kinks of a drive; each kind of crack whose compliance can have one has an overload
/// of `add`.
class Kinks {
 public:
  explicit Kinks(const GearSet& gear) : gear_(gear), loads_(gear) {}

  [[nodiscard]] std::vector<Note> all() {
    for_each_crack(gear_, [&](const CrackPath& path, const auto& crack) { add(path, crack); });
    return std::move(notes_);
  }

 private:
  void add(const CrackPath&, const AnnularCrack&) { add_solid_shaft("FR-12"); }
  void add(const CrackPath&, const ShaftSurfaceCrack&) { add_solid_shaft("SB-7"); }
  void add(const CrackPath& path, const WallThroughCrack& crack) { add_step(path, crack); }
  void add(const CrackPath& path, const WallSurfaceCrack& crack) { add_step(path, crack); }
  void add(const CrackPath& path, const DiaphragmArcCrack& crack) {
    const double r = loads_.arc_radius(crack);
    const bool at_station = std::ranges::any_of(
        gear_.flexspline->diaphragm->profile, [&](const DiaphragmStation& station) {
          return std::abs(station.radius - r) <= 1e-12 * station.radius;
        });
    if (at_station)
      note({.code = "sensitivity.kink",
            .text =
                "the arc is at a station of the diaphragm's profile, where the slope of the "
                "thickness steps, so the derivatives are those of the profile inside the station",
            .path = path,
            .equation = "TC-19",
            .severity = Severity::care});
  }
  /// The compliance of the other kinds has no kink at a single drive.
  template <class Crack>
  void add(const CrackPath&, const Crack&) {}

  void add_solid_shaft(const char* equation) {
    if (gear_.output_shaft->solid())
      note({.code = "sensitivity.solid_shaft",
            .text = "a bore of 0 is a solid shaft, whose crack has a separate solution, so the "
                    "derivative with respect to the bore is that of the sound shaft",
            .path = "output_shaft.inner_diameter",
            .equation = equation,
            .severity = Severity::care});
  }
  /// A crack that torque opens and that is exactly between open and closed.
  template <class Crack>
  void add_step(const CrackPath& path, const Crack& crack) {
    if (loads_.plane_of(crack).normal[kTorsion] == 0) return;
    const BothSenses faces = loads_.numbers(crack).faces;
    if (faces.positive == Faces::touching || faces.negative == Faces::touching)
      note({.code = "sensitivity.step",
            .text = "the crack is exactly between open and closed, where the stiffness steps, so "
                    "the derivatives are those of the open crack and valid on one side only",
            .path = path,
            .equation = "FR-17",
            .severity = Severity::care});
  }
  void note(Note note) {
    if (std::ranges::find(notes_, note) == notes_.end()) notes_.push_back(std::move(note));
  }

  const GearSet& gear_;
  CrackLoads<double> loads_;
  std::vector<Note> notes_;
};

}  // namespace

std::vector<Note> smoothness_notes(const GearSet& gear) { return Kinks(gear).all(); }

}  // namespace strainwave
