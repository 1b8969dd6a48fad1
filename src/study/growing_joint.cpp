// SPDX-License-Identifier: Apache-2.0
#include "growing_joint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "strainwave/core/error.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/drive_cracks/drive_cracks.hpp"
#include "strainwave/drive_growth/longest_duty.hpp"
#include "strainwave/motion/spring.hpp"

namespace strainwave {
namespace {

constexpr int kRows = 200;           // of the growth
constexpr double kNearest = 1e-9;    // distance of two rows, of the motion [-]
constexpr double kOneHour = 3600.0;  // [s]

bool ends_life(DriveEnd end) {
  return end == DriveEnd::breaks || end == DriveEnd::assessment || end == DriveEnd::severed ||
         end == DriveEnd::range;
}

/// Whether a sense of the torque opens a crack.
bool opens(const BreathingCrack& crack, OpeningSense sense) {
  return !crack.sense || *crack.sense == sense;
}

/// Compliance of the cracks of one path, fully open, under a sense of the torque [rad/(N*m)].
double compliance_of(const std::vector<BreathingCrack>& cracks, const std::string& path,
                     OpeningSense sense) {
  double sum = 0.0;
  for (const BreathingCrack& crack : cracks)
    if (crack.path == path && opens(crack, sense)) sum += crack.compliance;
  return sum;
}

/// Compliance of a crack at a time [rad/(N*m)].
double at_time(const BreathingCrack& crack, double time) {
  return crack.growth ? crack.growth->at(time) : crack.compliance;
}

/// Size of the crack of a path [m].
double size_of(const std::vector<DriveCrack>& cracks, const std::string& path) {
  const auto found = std::ranges::find(cracks, path, &DriveCrack::path);
  return found == cracks.end() ? 0.0 : found->size.size;
}

/// The answer of the growth as the end of a sentence.
std::string ending(const GrowthReport& growth) {
  std::string words = growth.sentence;
  if (words.ends_with('.')) words.pop_back();
  return words;
}

/// Stiffness of a joint without load, with the cracks that open under the softer sense of the
/// torque fully open [N*m/rad].
double stiffness_at(const Joint& joint, double time) {
  const double sound = joint.table ? joint.table->at(0.0).at_torque(0.0).compliance
                                   : 1 / tangent_stiffness(joint.spring, 0.0);
  double softest = 0.0;
  for (const OpeningSense sense : {OpeningSense::positive, OpeningSense::negative}) {
    double sum = 0.0;
    for (const BreathingCrack& crack : joint.cracks)
      if (opens(crack, sense)) sum += at_time(crack, time);
    softest = std::max(softest, sum);
  }
  return 1 / (sound + softest);
}

}  // namespace

GrowingJoint::GrowingJoint(const GearSet& gear, DriveJoint& made, double duty, double duration,
                           const Progress& progress)
    : duty_(duty),
      duration_(duration),
      end_(duration),
      computed_(made.springs == SpringModel::computed_curve) {
  require(duty > 0 && duty <= kLongestDuty, "--growth", duty, "s", "> 0 and <= a million years");
  GrowthOptions options;
  options.stop.time = duty;
  options.points = kRows;
  growth_ = grow_cracks(gear, options, progress);
  if (ends_life(growth_.end)) end_ = std::min(duration, growth_.time / duty * duration);
  if (!(end_ > 0))
    throw InputError(
        "--growth", fmt::format("leaves no time for a motion, because the growth ends at the sizes "
                                "of the file: {} Leave it out, or make the crack smaller",
                                growth_.sentence));
  give_compliances(made);
}

void GrowingJoint::give_compliances(DriveJoint& made) {
  std::vector<double> times;
  std::vector<std::vector<BreathingCrack>> rows;
  for (std::size_t n = 0; n < growth_.drives.size(); ++n) {
    // A crack that goes through its wall jumps, which becomes a steep line.
    const double time = growth_.stiffness[n].time / duty_ * duration_;
    times.push_back(n == 0 ? 0.0 : std::max(time, times.back() + kNearest * duration_));
    rows.push_back(joint_cracks(growth_.drives[n]));
  }
  if (rows.size() < 2) return;
  std::vector<BreathingCrack> grown;
  const auto known = [&](const std::string& path) {
    return std::ranges::find(grown, path, &BreathingCrack::path) != grown.end();
  };
  for (const std::vector<BreathingCrack>& row : rows)
    for (const BreathingCrack& of : row) {
      if (known(of.path)) continue;
      const auto over_time = [&](OpeningSense sense) {
        std::vector<double> values;
        for (const std::vector<BreathingCrack>& at : rows) {
          const double value = compliance_of(at, of.path, sense);
          // No crack heals, although the fit of a solution may fall by its error (MO-50).
          values.push_back(values.empty() ? value : std::max(value, values.back()));
        }
        return values;
      };
      const auto add = [&](std::vector<double> values, std::optional<OpeningSense> sense) {
        if (!(values.back() > 0)) return;
        BreathingCrack crack{
            .path = of.path, .compliance = values.front(), .sense = sense, .opening = of.opening};
        if (values.back() > values.front())
          crack.growth = Profile{.time = times, .value = std::move(values)};
        grown.push_back(std::move(crack));
      };
      std::vector<double> positive = over_time(OpeningSense::positive);
      std::vector<double> negative = over_time(OpeningSense::negative);
      if (positive == negative) {
        add(std::move(positive), {});
        continue;
      }
      add(std::move(positive), OpeningSense::positive);
      add(std::move(negative), OpeningSense::negative);
    }
  made.joint.cracks = std::move(grown);
}

MotionGrowth GrowingJoint::result(const Joint& joint) const {
  MotionGrowth made{.time = duty_,
                    .pace = duty_ / duration_,
                    .time_at_end = std::min(end_ / duration_ * duty_, growth_.time),
                    .sentence = growth_.sentence,
                    .first_stiffness = stiffness_at(joint, 0.0),
                    .last_stiffness = stiffness_at(joint, end_)};
  if (growth_.drives.empty()) return made;
  const std::vector<DriveCrack> first = drive_cracks(growth_.drives.front());
  const std::vector<DriveCrack> last = drive_cracks(growth_.drives.back());
  for (const BreathingCrack& crack : joint.cracks) {
    if (!crack.growth) continue;
    made.cracks.push_back({.path = crack.path,
                           .sense = crack.sense ? std::string(enum_name(*crack.sense)) : "both",
                           .first_size = size_of(first, crack.path),
                           .last_size = size_of(last, crack.path),
                           .first_compliance = at_time(crack, 0.0),
                           .last_compliance = at_time(crack, end_)});
  }
  return made;
}

std::vector<Note> GrowingJoint::notes() const {
  std::vector<Note> made = growth_.notes;
  if (ends_early())
    made.push_back(
        {.code = "motion.growth_ends",
         .text = fmt::format("the motion ends at {}, after {} h of duty, where the growth of the "
                             "cracks ends: {}",
                             shown_quantity(end_, "s", 4), shown_number(growth_.time / kOneHour, 4),
                             ending(growth_)),
         .path = growth_.governing,
         .equation = "MO-50",
         .severity = Severity::care,
         .next_step =
             "Give fewer hours with --growth for a motion up to the end of [[manoeuvre]]."});
  else if (growth_.end == DriveEnd::arrested || growth_.end == DriveEnd::not_known)
    made.push_back({.code = "motion.growth_stands",
                    .text = fmt::format("the cracks keep their sizes from {} h of duty on: {}",
                                        shown_number(growth_.time / kOneHour, 4), ending(growth_)),
                    .path = "duty",
                    .equation = "MO-50",
                    .severity = Severity::information});
  if (!computed_ || growth_.drives.empty()) return made;
  const std::vector<DriveCrack> last = drive_cracks(growth_.drives.back());
  const std::vector<BreathingCrack> moved = joint_cracks(growth_.drives.back());
  for (const DriveCrack& crack : drive_cracks(growth_.drives.front()))
    if (size_of(last, crack.path) > crack.size.size &&
        std::ranges::find(moved, crack.path, &BreathingCrack::path) == moved.end())
      made.push_back(
          {.code = "motion.keeps_size",
           .text = fmt::format("the crack grows from {} to {} mm over the duty, but keeps its size "
                               "in the motion, because the table of the computed curve is that of "
                               "the file",
                               shown_number(1e3 * crack.size.size, 4),
                               shown_number(1e3 * size_of(last, crack.path), 4)),
           .path = crack.path,
           .equation = "MO-50",
           .severity = Severity::care,
           .next_step = "Repeat the motion without --growth and with the size at the end."});
  return made;
}

}  // namespace strainwave
