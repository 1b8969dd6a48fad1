// SPDX-License-Identifier: Apache-2.0
#include "strainwave/torsion/assembled_drive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "assembled_drive_contents.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/torsion/compare.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

void add_series_members(AssembledDrive::Contents& into) {
  const GearSet& gear = into.gear;
  const Flexspline& fs = *gear.flexspline;
  SeriesMembers& series = into.series;
  series = cup_members(gear, Lift<double>());
  const auto take = [&](const MemberCompliance& member) {
    for (const CrackReport& crack : member.cracks) {
      series.cracks_positive += crack.positive.at_output.value;
      series.cracks_negative += crack.negative.at_output.value;
    }
    for (const Note& note : member.notes)
      if (note.code != "crack.contact_path") into.notes.push_back(note);
    if (into.unusable_because.empty()) into.unusable_because = member.unusable_because;
  };
  if (!fs.crack.empty()) take(flexspline_compliance(gear));
  if (gear.output_shaft) {
    const MemberCompliance shaft = output_shaft_compliance(gear);
    series.output_shaft = shaft.intact;
    take(shaft);
  }
}

// The gap law is valid for teeth whose path is about one module high (TC-7).
constexpr double kLeastKappa = 0.6;
constexpr double kMostKappa = 1.3;
/// Pitch diameter of size 17, 43.18 mm, rounded down so that this size does not count as small [m].
constexpr double kSize17 = 0.043;

/// The angles of half-path flanks, which are not those of the file.
void note_half_path(const ToothGap& teeth, double mean, std::vector<Note>& notes) {
  constexpr int kSamples = 60;
  double least = teeth.contact(0.0).angle;
  double most = least;
  for (int i = 1; i <= kSamples; ++i) {
    const double angle = teeth.contact(teeth.end() * i / kSamples).angle;
    least = std::min(least, angle);
    most = std::max(most, angle);
  }
  notes.push_back({"torsion.half_path",
                   fmt::format("half-path flanks press at {:.3g} to {:.3g} degrees, and the "
                               "stiffness of a pair is that of {:.3g} degrees; mesh.flank_angle is "
                               "not used",
                               least * 180 / pi, most * 180 / pi, mean * 180 / pi),
                   "mesh.tooth.profile", "TC-29", Severity::information});
}

/// Notes on teeth as drawn.
void note_teeth(const GearSet& gear, const CoupledGeometry& g, std::vector<Note>& notes) {
  const ToothGap& teeth = *g.tooth;
  const bool half_path = gear.mesh->tooth->profile == ToothProfile::half_path;
  if (half_path) note_half_path(teeth, g.flank_angle, notes);
  if (teeth.relief() > 0)
    notes.push_back({"torsion.relieved_tips",
                     fmt::format("the tips are taken as relieved by at least {:.3g} um, so that no "
                                 "flank touches beyond {:.3g} degrees from a lobe",
                                 1e6 * teeth.relief(), teeth.end() * 180 / pi),
                     "mesh.tooth.tips", "TC-29", Severity::information});
  if (const double crossing = teeth.crossing(); crossing > 1e-9)
    notes.push_back(
        {"torsion.tips",
         fmt::format("beyond 30 degrees from a lobe the flanks would cross by up to {:.3g} um; the "
                     "model takes the tips as relieved by this amount",
                     1e6 * crossing),
         "mesh.tooth", "TC-29", Severity::care,
         half_path ? "Give a smaller mesh.coning."
                   : "Give lower addendum and spline_addendum, or a larger mesh.flank_angle."});
}

/// What the ring leaves out of a barrel and a bottom of plies.
void note_laminates(const GearSet& gear, std::vector<Note>& notes) {
  const Flexspline& fs = *gear.flexspline;
  const auto wall_of = [&](const auto& section, double thickness) {
    return wall_laminate(Lift<double>(), gear,
                         material_of(gear, material_name(fs, section), "flexspline.material"),
                         thickness);
  };
  if (wall_of(*fs.barrel, fs.barrel->wall_thickness))
    notes.push_back(
        {"torsion.laminate",
         "the barrel resists the oval rim with the stretching, shear and bending of its "
         "plies, without their coupling of bending with twist; the accuracy of the "
         "curve was found with drives of steel, none of which has such a barrel",
         "flexspline.barrel", "LA-16", Severity::care,
         "Compare the drive with a measured curve, and run strainwave laminate for the "
         "stress of the plies."});
  const auto bottom = wall_of(*fs.diaphragm, fs.diaphragm->thickness);
  if (!bottom) return;
  const double softer = 1 - softest_plate(*bottom).bending / mean_plate(*bottom).bending;
  notes.push_back({"torsion.laminate_bottom",
                   fmt::format("the bottom resists the warping of the barrel with the mean of its "
                               "bending stiffness over all directions, an upper bound; the lower "
                               "bound is {:.2g} % less, and the change over a turn is left out",
                               100 * softer),
                   "flexspline.diaphragm", "LA-17", Severity::care,
                   "Spread the directions of the plies over the thickness of the bottom."});
}

void note_geometry(const GearSet& gear, const CoupledGeometry& g, std::vector<Note>& notes) {
  const double kappa = g.radial_displacement / g.module;
  if (!g.tooth && (kappa < kLeastKappa || kappa > kMostKappa))
    notes.push_back(
        {"torsion.deflection",
         fmt::format("w_0 is {:.3g} modules, but the gap law is for about one module", kappa),
         "drive.radial_displacement", "TC-7", Severity::care, "Check drive.radial_displacement."});
  if (g.tooth) note_teeth(gear, g, notes);
  if (const double least = least_flank_angle(kappa); !g.tooth && g.flank_angle < least)
    notes.push_back({"torsion.flank_angle",
                     fmt::format("w_0 of {:.3g} modules needs a flank angle of at least {:.3g} "
                                 "degrees, because otherwise the tooth path crosses the flank",
                                 kappa, least * 180 / pi),
                     "mesh.flank_angle", "TC-25", Severity::care,
                     "Check mesh.flank_angle and drive.radial_displacement."});
  if (gear.drive.ratio < 50)
    notes.push_back({"torsion.low_ratio",
                     "compared with catalogues, the model is too stiff below ratio 50, by a factor "
                     "of up to 2.0 at ratio 30",
                     "drive.ratio", "TC-14", Severity::care,
                     "Calibrate the drive with a measured curve."});
  if (gear.drive.pitch_diameter < kSize17)
    notes.push_back({"torsion.small_size",
                     "makers' drives below size 17 are not similar to larger drives, and typical "
                     "proportions miss their stiffness by 20 to 60 %",
                     "drive.pitch_diameter", "TC-14", Severity::care,
                     "Calibrate the drive with a measured curve or a catalogue."});
  note_laminates(gear, notes);
  if (gear.circular_spline == std::nullopt)
    notes.push_back({"torsion.rigid_spline",
                     "the file gives no circular spline, so a rigid one is assumed, which makes "
                     "the drive 13 to 36 % too stiff",
                     "circular_spline", "TC-10", Severity::care,
                     "Give the table circular_spline."});
}

std::string no_assembly(const CoupledDrive& drive) {
  const CoupledGeometry& g = drive.geometry();
  const Equilibrium& state = drive.assembled();
  return state.converged
             ? fmt::format(
                   "the drive does not assemble: no cam amplitude lifts the lobes by w_0 = "
                   "{:.4g} mm with a flank gap of {:.4g} um and a bearing clearance of "
                   "{:.4g} um",
                   1e3 * g.radial_displacement, 1e6 * g.lobe_gap, 1e6 * g.clearance)
             : fmt::format(
                   "the solver did not find the assembled state: after {1} steps the residual is "
                   "{0:.2g} of the largest contact force",
                   state.residual, state.iterations);
}

/// Notes flanks that press on each other without torque.
void note_interference(const CoupledDrive& drive, std::vector<Note>& notes) {
  const double jam = drive.largest_flank_force(drive.assembled());
  if (!(jam > 0)) return;
  const double lobe_gap = drive.geometry().lobe_gap;
  notes.push_back(
      {"torsion.interference",
       fmt::format("the flanks press on each other without torque, with up to {:.3g} N: {}", jam,
                   lobe_gap < 0
                       ? fmt::format("the lobe gap of {:.4g} um is an interference", 1e6 * lobe_gap)
                       : std::string("the assembled ring bulges beside the lobes; see clearance, "
                                     "cam_flattening, ball_count, flank_angle")),
       "mesh.lobe_gap", "TC-6", Severity::care, "Check mesh.lobe_gap and the fields named here."});
}

/// Adds a note for each crack of a ring whose faces the assembly presses together.
void note_pressed(const AssembledDrive::Contents& contents, std::vector<Note>& notes) {
  for (const RingHinge& hinge : contents.cracks.hinges)
    if (pressed_by_assembly(contents.sound, hinge))
      notes.push_back(
          {"crack.pressed_ring",
           fmt::format("at {:.4g} degrees from the lobe the assembly presses the faces of this "
                       "crack together, so the crack changes nothing at this angle",
                       hinge.position * 180 / pi),
           hinge.path, "TC-22", Severity::information, "Look at the softest values over a turn."});
}

/// Adds the cracks to the sound drive on its cam, if the sound drive assembles.
void crack(AssembledDrive::Contents& into) {
  into.drive = into.sound;
  into.fails_because = into.sound_fails_because;
  if (!into.fails_because.empty()) return;
  const ContactCracks cracks = acting(into.sound, into.cracks);
  if (cracks.teeth.empty() && cracks.hinges.empty() && cracks.balls.empty()) return;
  into.drive = into.sound.cracked(cracks);
  if (!into.drive.assemble_on(into.sound.cam_amplitude(), &into.sound.assembled()))
    into.fails_because = "the cracked drive does not assemble on the cam of the sound one";
}

std::vector<std::string> equations_of(const GearSet& gear, const CoupledGeometry& geometry) {
  std::vector<std::string> equations = {"TC-1", "TC-2", "TC-4", "TC-5", "TC-6"};
  // Drawn teeth have their own gap and stiffness.
  const auto of_teeth = geometry.tooth ? std::array{"TC-29", "TC-30"} : std::array{"TC-7", "TC-9"};
  equations.insert(equations.end(), of_teeth.begin(), of_teeth.end());
  for (const char* const tag : {"TC-8", "TC-11", "TC-12", "TC-13", "TC-14", "TC-15"})
    equations.emplace_back(tag);
  if (geometry.support > 0) equations.emplace_back("TC-10");
  if (geometry.neighbours) equations.emplace_back("TC-31");
  const Flexspline& fs = *gear.flexspline;
  const auto is_laminate = [&](const auto& section) {
    return material_of(gear, material_name(fs, section), "flexspline.material").is_laminate();
  };
  if (is_laminate(*fs.barrel)) equations.insert(equations.end(), {"LA-5", "LA-16"});
  if (is_laminate(*fs.diaphragm)) equations.insert(equations.end(), {"LA-10", "LA-17"});
  return equations;
}

/// Depth over thickness from which a cracked rim or outer ring is no hinge any more (TC-22) [-].
constexpr double kDeepestHinge = 0.5;

/// Reason why the model does not hold for the depth of a crack; empty if it holds for all.
std::string too_deep(const ContactCracks& cracks, const CoupledGeometry& g) {
  for (const RingHinge& hinge : cracks.hinges) {
    if (hinge.ring == RingHinge::Ring::spline) continue;
    const double share =
        hinge.depth / (hinge.ring == RingHinge::Ring::rim ? g.rim_thickness : g.outer_thickness);
    if (share > kDeepestHinge * (1 + 1e-9))
      return fmt::format(
          "{} goes through {:.4g} % of the ring; beyond 50 % the ring tears open instead of acting "
          "as a hinge that the other ring bridges (TC-22), so the coupled drive has no answer; "
          "give a depth of at most half of the "
          "thickness, or assess the crack by finite elements",
          hinge.path, 100 * share);
  }
  return "";
}

/// Contents without the cracks that act in the contacts.
AssembledDrive::Contents sound_contents(const GearSet& gear, const CoupledOptions& options,
                                        const CoupledGeometry& geometry,
                                        const CoupledDrive& sound) {
  AssembledDrive::Contents contents{.gear = gear,
                                    .options = options,
                                    .deviations = {},
                                    .geometry = geometry,
                                    .sound = sound,
                                    .cracks = {},
                                    .drive = sound,
                                    .series = {},
                                    .notes = {},
                                    .equations = equations_of(gear, geometry),
                                    .sound_fails_because = {},
                                    .fails_because = {},
                                    .unusable_because = {}};
  note_geometry(gear, geometry, contents.notes);
  add_series_members(contents);
  return contents;
}

AssembledDrive::Contents assembled(const GearSet& gear, const CoupledOptions& options) {
  const CoupledGeometry geometry = coupled_geometry(gear, options);
  CoupledOptions at_lobe = options;
  at_lobe.cage_phase = 0;
  AssembledDrive::Contents contents =
      sound_contents(gear, options, geometry, CoupledDrive(gear, geometry, at_lobe));
  CoupledDrive& sound = contents.sound;
  bool assembles = sound.assemble();
  if (assembles && options.cage_phase != 0) {  // the cam is made for a ball at the lobe (TC-12)
    CoupledDrive moved(gear, geometry, options);
    assembles = moved.assemble_on(sound.cam_amplitude());
    sound = std::move(moved);
  }
  if (!assembles) {
    contents.sound_fails_because = no_assembly(sound);
    crack(contents);
    return contents;
  }
  const double T2 = makers_torques(gear).T2;
  const BallForce ball_force = [&](double position) {
    return worst_of_ball(sound, T2, position).force[sound.ball_nearest_to(position)];
  };
  contents.cracks = contact_cracks(gear, Lift<double>(), geometry, ball_force, contents.notes);
  if (const std::string deep = too_deep(contents.cracks, geometry);
      contents.unusable_because.empty())
    contents.unusable_because = deep;
  if (!contents.cracks.teeth.empty()) contents.equations.emplace_back("TC-21");
  if (!contents.cracks.hinges.empty()) contents.equations.emplace_back("TC-22");
  if (!contents.cracks.balls.empty()) contents.equations.emplace_back("TC-23");
  crack(contents);
  return contents;
}

}  // namespace

Equilibrium worst_of_ball(const CoupledDrive& sound, double torque, double position) {
  const int ball = sound.ball_nearest_to(position);
  Equilibrium worst = sound.solve(torque, sound.assembled());
  Equilibrium other = sound.solve(-torque, sound.assembled());
  return other.force[ball] > worst.force[ball] ? other : worst;
}

AssembledDrive::AssembledDrive(const GearSet& gear, const CoupledOptions& options)
    : contents_(std::make_shared<const Contents>(assembled(gear, options))) {}

AssembledDrive::AssembledDrive(std::shared_ptr<const Contents> contents)
    : contents_(std::move(contents)) {}

AssembledDrive AssembledDrive::without_cracks() const {
  Contents contents = sound_contents(strainwave::without_cracks(gear()), contents_->options,
                                     contents_->geometry, contents_->sound);
  contents.deviations = contents_->deviations;
  contents.sound_fails_because = contents_->sound_fails_because;
  crack(contents);
  return AssembledDrive(std::make_shared<const Contents>(std::move(contents)));
}

AssembledDrive AssembledDrive::turned(double angle) const {
  return moved(flexspline_turn(gear().drive, angle), angle);
}

AssembledDrive AssembledDrive::moved(double flexspline, double spline) const {
  Contents contents = *contents_;
  contents.gear = after_moves(gear(), flexspline, spline);
  for (RingHinge& hinge : contents.cracks.hinges)
    hinge.position = turned_position(hinge.position,
                                     hinge.ring == RingHinge::Ring::spline ? spline : flexspline);
  for (SoftTooth& tooth : contents.cracks.teeth)
    tooth.position = turned_position(tooth.position, flexspline);
  crack(contents);
  return AssembledDrive(std::make_shared<const Contents>(std::move(contents)));
}

AssembledDrive AssembledDrive::with_deviations(const Deviations& deviations) const {
  check_deviations(deviations, gear());
  if (deviations.empty() && contents_->deviations.empty()) return *this;
  Contents contents = *contents_;
  contents.deviations = deviations;
  if (contents.sound_fails_because.empty()) {
    contents.sound = contents_->sound.deviating(deviations);
    if (!contents.sound.assemble_on(contents_->sound.cam_amplitude()))
      contents.sound_fails_because = no_assembly(contents.sound);
  }
  crack(contents);
  return AssembledDrive(std::make_shared<const Contents>(std::move(contents)));
}

const GearSet& AssembledDrive::gear() const { return contents_->gear; }
const CoupledOptions& AssembledDrive::options() const { return contents_->options; }
const Deviations& AssembledDrive::deviations() const { return contents_->deviations; }
std::vector<Note> AssembledDrive::notes() const {
  std::vector<Note> notes = contents_->notes;
  if (!contents_->fails_because.empty()) return notes;
  note_interference(contents_->drive, notes);
  note_pressed(*contents_, notes);
  return notes;
}
const std::vector<std::string>& AssembledDrive::equations() const { return contents_->equations; }
const std::string& AssembledDrive::fails_because() const { return contents_->fails_because; }
double AssembledDrive::cam_amplitude() const { return contents_->drive.cam_amplitude(); }

}  // namespace strainwave
