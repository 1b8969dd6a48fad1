// SPDX-License-Identifier: Apache-2.0
#include "coupled_crack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "notes.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/life/tooth_root.hpp"
#include "strainwave/sif/gradient/notch_edge.hpp"
#include "strainwave/sif/member/ring_edge.hpp"
#include "strainwave/torsion/assembled_drive.hpp"
#include "strainwave/torsion/compare.hpp"
#include "strainwave/torsion/ring_states.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr int kPositions = 360;  // of a turn at which the stress is taken

/// Hoop stress of a ring at one place of the turn [Pa].
struct HoopStress {
  double outside = 0.0;
  double inside = 0.0;
};

std::vector<HoopStress> of_rim(const AssembledDrive& drive, double torque) {
  std::vector<HoopStress> turn;
  for (const RimState& at : rim_states(drive, torque, kPositions))
    turn.push_back({.outside = at.rim_outside_stress, .inside = at.rim_inside_stress});
  return turn;
}

template <BendingRing ring>
std::vector<HoopStress> of_ring(const AssembledDrive& drive, double torque) {
  std::vector<HoopStress> turn;
  for (const RingState& at : ring_states(drive, ring, torque, kPositions))
    turn.push_back({.outside = at.outside_stress, .inside = at.inside_stress});
  return turn;
}

double rim_thickness(const GearSet& gear) { return gear.flexspline->rim->wall_thickness; }
double outer_ring_thickness(const GearSet& gear) {
  return gear.wave_generator->bearing->outer_ring->thickness;
}
double spline_thickness(const GearSet& gear) {
  return (gear.circular_spline->outer_diameter - gear.circular_spline->inner_diameter) / 2;
}

/// What the cracks of one ring have in common.
struct CrackedRing {
  CrackedPart part;
  TurningLoad turning;
  double (*thickness)(const GearSet& gear);
  std::vector<HoopStress> (*over_turn)(const AssembledDrive& drive, double torque);
  const char* range_text;
  const char* unknown;
  const char* next_step;
  std::array<const char*, 2> equations;
};

constexpr std::array kRings = {
    CrackedRing{.part = CrackedPart::rim,
                .turning = TurningLoad::wave,
                .thickness = rim_thickness,
                .over_turn = of_rim,
                .range_text = "0.9 of the rim, the range of the edge crack",
                .unknown = "the concentration of the stress at the tooth root is left out, which "
                           "matters for a crack that is short compared with the root's radius",
                .next_step = "Give flexspline.tooth_root, or read the growth as that of a crack "
                             "deeper than the root's radius.",
                .equations = {"TC-24", "GR-29"}},
    CrackedRing{.part = CrackedPart::outer_ring,
                .turning = TurningLoad::wave,
                .thickness = outer_ring_thickness,
                .over_turn = of_ring<BendingRing::outer_ring>,
                .range_text = "0.9 of the outer ring, the range of the edge crack",
                .unknown = "the hoop stress by the fit of the outer ring in the flexspline and the "
                           "stress of the ball contacts are left out",
                .next_step = "Read the growth as that of a ring with a sliding fit, or assess the "
                             "ring by finite elements.",
                .equations = {"TC-38", "GR-33"}},
    CrackedRing{.part = CrackedPart::circular_spline,
                .turning = TurningLoad::wave_at_spline,
                .thickness = spline_thickness,
                .over_turn = of_ring<BendingRing::circular_spline>,
                .range_text = "0.9 of the circular spline, the range of the edge crack",
                .unknown = "the concentration of the stress at the roots of the circular spline's "
                           "teeth and the stress by its fastening are left out",
                .next_step = "Read the growth as that of a crack deeper than the root's radius, or "
                             "assess the ring by finite elements.",
                .equations = {"TC-39", "GR-33"}}};

/// K of an edge crack per unit of the two parts of the stress [m^0.5].
struct EdgeFactors {
  double membrane = 0.0;
  double bending = 0.0;  ///< of the stress at the cracked surface
};

EdgeFactors factors_of_edge(double depth, double thickness) {
  const double root = std::sqrt(pi * depth);
  const double alpha = depth / thickness;
  return {.membrane = root * sif::edge_crack_factor(sif::StripLoading::tension, alpha),
          .bending = root * sif::edge_crack_factor(sif::StripLoading::bending, alpha)};
}

/// The root of a tooth from which a crack of the rim starts; absent if the file does not give it,
/// or if it is so round that it concentrates nothing.
std::optional<sif::NotchEdgeCrack> tooth_root(const GearSet& gear, double depth) {
  const Flexspline& fs = *gear.flexspline;
  if (!fs.tooth_root) return std::nullopt;
  const double pitch = pi * fs.rim->outer_diameter / (gear.drive.wave_number * gear.drive.ratio);
  const double radius = fs.tooth_root->root_radius;
  const double concentration = groove_concentration(pitch, radius).hoop;
  if (!(concentration > 1)) return std::nullopt;
  return sif::NotchEdgeCrack{.depth = depth,
                             .thickness = fs.rim->wall_thickness,
                             .width = fs.rim->length,
                             .root_radius = radius,
                             .concentration = concentration};
}

EdgeFactors factors_of_notch(const sif::NotchEdgeCrack& notch, double depth) {
  const auto K = notch.stress_intensity(depth, 0.0).I;
  return {.membrane = K[0], .bending = K[1]};  // (GR-38)
}

/// The factors of a crack at a size, computed once for the fronts of all torques.
class FactorsOfSize {
 public:
  FactorsOfSize(double thickness, const std::optional<sif::NotchEdgeCrack>& root)
      : thickness_(thickness), root_(root) {}

  [[nodiscard]] const EdgeFactors& at(double depth) {
    if (depth != depth_) {
      factors_ = root_ ? factors_of_notch(*root_, depth) : factors_of_edge(depth, thickness_);
      depth_ = depth;
    }
    return factors_;
  }

 private:
  double thickness_;
  std::optional<sif::NotchEdgeCrack> root_;
  double depth_ = 0.0;
  EdgeFactors factors_;
};

/// The concentration at a tooth root, and the limits of its solution.
Note root_note(const std::string& path, const sif::NotchEdgeCrack& notch) {
  std::string outside;
  notch.validity([&](bool within, const char* limit) {
    if (!within) outside += (outside.empty() ? "; outside its range: " : ", ") + std::string(limit);
  });
  return {
      .code = "growth.tooth_root",
      .text = fmt::format(
          "the concentration of the stress at the tooth root, K_t = {:.3g}, is an estimate for a "
          "row of deep grooves, which neither finite elements nor tests confirm{}",
          notch.concentration, outside),
      .path = path,
      .equation = "GR-38",
      .severity = Severity::care,
      .next_step =
          "Compare with the growth without flexspline.tooth_root, which leaves the "
          "concentration out."};
}

/// Parts of the hoop stress at one place of a turn [Pa].
struct StressParts {
  double membrane = 0.0;
  double bending = 0.0;  ///< at the cracked surface
};

/// The places of a turn at which some K of positive factors may have its largest or least value:
/// the corners of the convex hull of the two parts.
std::vector<StressParts> corners(const std::vector<HoopStress>& turn, bool inside) {
  std::vector<StressParts> points;
  for (const HoopStress& at : turn)
    points.push_back({.membrane = (at.outside + at.inside) / 2,
                      .bending = (inside ? at.inside - at.outside : at.outside - at.inside) / 2});
  std::ranges::sort(points, [](const StressParts& a, const StressParts& b) {
    return std::pair(a.membrane, a.bending) < std::pair(b.membrane, b.bending);
  });
  std::vector<StressParts> hull;
  const auto add = [&](const StressParts& point, std::size_t least) {
    const auto turns_back = [&] {
      const StressParts& a = hull[hull.size() - 2];
      const StressParts& b = hull.back();
      return (b.membrane - a.membrane) * (point.bending - a.bending) <=
             (b.bending - a.bending) * (point.membrane - a.membrane);
    };
    while (hull.size() >= least + 2 && turns_back()) hull.pop_back();
    hull.push_back(point);
  };
  for (const StressParts& point : points) add(point, 0);
  const std::size_t lower = hull.size() - 1;
  for (std::size_t i = points.size(); i-- > 0;) add(points[i], lower);
  return hull;
}

/// K over a turn as its mean and half of its range.
FrontIntensity over_turn(const std::vector<StressParts>& turn, const EdgeFactors& of) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const StressParts& at : turn) {
    const double K = of.membrane * at.membrane + of.bending * at.bending;  // (GR-29), (GR-33)
    least = std::min(least, K);
    most = std::max(most, K);
  }
  FrontIntensity front;
  front.constant[0] = (most + least) / 2;
  front.assembly[0] = (most - least) / 2;
  return front;
}

CrackPlace place_of(const GearSet& gear, const std::string& path) {
  CrackPlace place;
  for_each_crack(gear, [&](const std::string& at, const auto& crack) {
    if (at == path) place = crack.place();
  });
  return place;
}

/// Why the coupled drive gives no stress for a ring of this drive, with what to do; absent if it
/// gives one.
std::optional<Note> obstacle(const GearSet& gear, const CrackedRing& ring,
                             const std::string& path) {
  if (const std::string missing = missing_for_torsion_curve(gear); !missing.empty())
    return coupled_crack_note(path, "the coupled drive that gives it lacks an input: " + missing,
                              "Give these fields, or assess the crack by finite elements.");
  if (ring.part == CrackedPart::circular_spline && !bends(gear, BendingRing::circular_spline))
    return coupled_crack_note(path,
                              "circular_spline.support is 0, and a circular spline that is held "
                              "rigidly does not bend",
                              "Give circular_spline.support above 0, or assess the crack by finite "
                              "elements.");
  return std::nullopt;
}

/// The crack in the form of all cracks, without K and what limits it.
DriveCrack crack_of_ring(const DriveCrack& crack, const CrackPlace& place, const CrackedRing& ring,
                         double thickness) {
  DriveCrack made = crack;
  made.acts_in_coupled_drive = false;
  made.size_name = "depth";
  made.size = {.size = place.depth};
  made.ligament = thickness - place.depth;
  made.turning = ring.turning;
  made.range_end = sif::kUsableDepthRatio * thickness;
  made.range_text = ring.range_text;
  return made;
}

/// The crack with its table of K over a turn (GR-30), which needs no coupled drive.
CoupledCrack tabulated_crack(const GearSet& gear, const DriveCrack& crack, const CrackPlace& place,
                             const CrackedRing& ring) {
  CoupledCrack known{.known = true,
                     .crack = crack_of_ring(crack, place, ring, ring.thickness(gear)),
                     .at_torque = {},
                     .notes = {}};
  take_turn_table(known.crack, crack.turn_table);
  return known;
}

CoupledCrack known_crack(const GearSet& gear, const DriveCrack& crack, const CrackPlace& place,
                         const CrackedRing& ring, const DutyHistory& history) {
  const double thickness = ring.thickness(gear);
  CoupledCrack known{.known = true,
                     .crack = crack_of_ring(crack, place, ring, thickness),
                     .at_torque = {},
                     .notes = {}};
  DriveCrack& made = known.crack;
  made.unknown = ring.unknown;
  made.next_step = ring.next_step;
  made.equations.assign(ring.equations.begin(), ring.equations.end());
  if (gear.duty->resonance) known.notes.push_back(not_amplified_note(made.path));
  std::optional<sif::NotchEdgeCrack> root;
  if (place.part == CrackedPart::rim) root = tooth_root(gear, place.depth);
  if (root) {
    known.notes.push_back(root_note(made.path, *root));
    made.equations.insert(made.equations.end(), {"GR-38", "LI-42", "SW-10", "SW-11"});
  }
  if (root || (place.part == CrackedPart::rim && gear.flexspline->tooth_root)) {
    made.unknown.clear();
    made.next_step.clear();
  }
  const AssembledDrive drive(without_cracks(gear));
  const std::vector<double> torques = torques_of(history, false);
  (void)twists(drive, torques);  // throws if the flanks do not hold
  // All torques have the same factors at a size.
  const auto factors = std::make_shared<FactorsOfSize>(thickness, root);
  for (const double torque : torques) {
    const auto turn = std::make_shared<std::vector<StressParts>>(
        corners(ring.over_turn(drive, torque), place.from_inside));
    made.front = [turn, factors](const CrackSize& size, Faces) {
      return std::vector<FrontIntensity>{over_turn(*turn, factors->at(size.size))};
    };
    known.at_torque.emplace_back(torque, made);
  }
  made.front = known.at_torque.back().second.front;
  return known;
}

}  // namespace

CoupledCrack coupled_crack(const GearSet& gear, const DriveCrack& crack,
                           const DutyHistory& history) {
  CoupledCrack unknown;
  const CrackPlace place = place_of(gear, crack.path);
  const auto* const ring = std::ranges::find(kRings, place.part, &CrackedRing::part);
  if (ring == kRings.end()) {
    unknown.notes.push_back(tooth_crack_note(crack.path));
    return unknown;
  }
  if (crack.turn_table) return tabulated_crack(gear, crack, place, *ring);
  if (const auto note = obstacle(gear, *ring, crack.path)) {
    unknown.notes.push_back(*note);
    return unknown;
  }
  try {
    return known_crack(gear, crack, place, *ring, history);
  } catch (const Error& error) {
    unknown.notes.push_back(coupled_crack_note(
        crack.path,
        fmt::format("the coupled drive has no solution at a torque of the duty: {}", error.what()),
        "Check the torques of the duty, or assess the crack by finite elements."));
    return unknown;
  }
}

}  // namespace strainwave
