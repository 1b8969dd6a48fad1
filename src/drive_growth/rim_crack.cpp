// SPDX-License-Identifier: Apache-2.0
#include "rim_crack.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "strainwave/sif/member/ring_edge.hpp"
#include "strainwave/torsion/assembled_drive.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

namespace strainwave {
namespace {

constexpr int kPositions = 360;  // of a turn at which the stress is taken

/// Hoop stress of the rim at one place of the turn, as parts over its thickness [Pa].
struct RimStress {
  double membrane = 0.0;
  double bending = 0.0;  ///< at the tooth roots
};

/// K over a turn as its mean and half of its range.
FrontIntensity over_turn(const std::vector<RimStress>& turn, double depth, double thickness) {
  const double alpha = depth / thickness;
  const double tension = sif::edge_crack_factor(sif::StripLoading::tension, alpha);
  const double bending = sif::edge_crack_factor(sif::StripLoading::bending, alpha);
  const auto stress = [&](const RimStress& at) {
    return tension * at.membrane + bending * at.bending;  // (GR-29)
  };
  const auto [least, most] = std::ranges::minmax_element(turn, {}, stress);
  const double root = std::sqrt(std::numbers::pi * depth);
  FrontIntensity front;
  front.constant[0] = root * (stress(*most) + stress(*least)) / 2;
  front.assembly[0] = root * (stress(*most) - stress(*least)) / 2;
  return front;
}

/// All but K.
DriveCrack crack_of_rim(const GearSet& gear, const std::string& path, const RimAxialCrack& crack) {
  const double thickness = gear.flexspline->rim->wall_thickness;
  DriveCrack made;
  made.path = path;
  made.kind = RimAxialCrack::kKind;
  made.material = gear.flexspline->material;
  made.size_name = "depth";
  made.size = {.size = crack.depth};
  made.ligament = thickness - crack.depth;
  made.turning = TurningLoad::wave;
  made.wave_number = gear.drive.wave_number;
  made.range_end = sif::kUsableDepthRatio * thickness;
  made.range_text = "0.9 of the rim, the range of the edge crack";
  return made;
}

}  // namespace

DriveCrack tabulated_rim_crack(const GearSet& gear, const std::string& path,
                               const RimAxialCrack& crack) {
  DriveCrack made = crack_of_rim(gear, path, crack);
  take_turn_table(made, gear.turn_tables.at(*crack.turn_table));
  return made;
}

RimCrack rim_crack(const GearSet& gear, const std::string& path, const RimAxialCrack& crack,
                   const DutyHistory& history) {
  const double thickness = gear.flexspline->rim->wall_thickness;
  DriveCrack made = crack_of_rim(gear, path, crack);
  made.unknown =
      "the concentration of the stress at the tooth root is left out, which matters for a crack "
      "that "
      "is short compared with the root's radius";
  made.next_step = "Read the growth as that of a crack deeper than the root's radius.";
  const AssembledDrive drive = AssembledDrive(gear).without_cracks();
  RimCrack rim{.crack = made, .at_torque = {}};
  for (const double torque : torques_of(history, false)) {
    auto turn = std::make_shared<std::vector<RimStress>>();
    for (const RimState& state : rim_states(drive, torque, kPositions))
      turn->push_back({.membrane = (state.rim_outside_stress + state.rim_inside_stress) / 2,
                       .bending = (state.rim_outside_stress - state.rim_inside_stress) / 2});
    made.front = [turn, thickness](const CrackSize& size, Faces) {
      return std::vector<FrontIntensity>{over_turn(*turn, size.size, thickness)};
    };
    rim.at_torque.emplace_back(torque, made);
  }
  rim.crack.front = rim.at_torque.back().second.front;
  return rim;
}

}  // namespace strainwave
