// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/computed_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>
#include <vector>

#include "number_text.hpp"
#include "strainwave/core/counter_random.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/parallel.hpp"
#include "strainwave/dynamics/kinematics.hpp"
#include "strainwave/model/input/tooth_numbers.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/torsion/compare.hpp"
#include "strainwave/torsion/ring_energy.hpp"
#include "strainwave/torsion/torsion_curve.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr std::size_t kTorquesPerSense = 24;
constexpr double kCorner = 4.0;          // of the sinh that spreads the torques [-]
constexpr std::size_t kCagePoints = 24;  // between two balls [-]
constexpr std::size_t kMeanPhases = 2;   // over which the cracks are averaged [-]
constexpr int kMostAngles = 200;         // of a family [-]
constexpr double kOfLargest = 2.0;       // largest torque over T3 and the rated torque [-]
constexpr std::uint64_t kSeed = 16;

/// What a crack moves with.
enum class CrackFamily { cage, flexspline, spline, series };

template <class Crack>
CrackFamily crack_family(std::string_view member, const Crack& crack) {
  if constexpr (ContactCrack<Crack>)
    return crack.place().part == CrackedPart::circular_spline ? CrackFamily::spline
                                                              : CrackFamily::flexspline;
  else
    return member == "wave_generator" ? CrackFamily::cage : CrackFamily::series;
}

/// The drive with the cracks of some families alone.
GearSet with_families(const GearSet& gear, std::initializer_list<CrackFamily> kept) {
  return with_cracks_where(gear, [&](std::string_view member, const auto& crack) {
    return std::ranges::find(kept, crack_family(member, crack)) != kept.end();
  });
}

bool has_tooth_crack(const GearSet& gear) {
  bool any = false;
  for_each_crack(gear, [&]<class Crack>(const std::string&, const Crack&) {
    any = any || std::is_same_v<Crack, ToothCrack>;
  });
  return any;
}

/// Torques of a table, close together near zero.
std::vector<double> table_torques(double most) {
  std::vector<double> rising;
  for (std::size_t k = 0; k < kTorquesPerSense; ++k) {
    const double x = (static_cast<double>(k) + 0.5) / (kTorquesPerSense - 0.5);
    rising.push_back(most * std::sinh(kCorner * x) / std::sinh(kCorner));
  }
  std::vector<double> torques;
  for (auto at = rising.rbegin(); at != rising.rend(); ++at) torques.push_back(-*at);
  torques.insert(torques.end(), rising.begin(), rising.end());
  return torques;
}

/// Solves the coupled drive at the torques of a table, and gives the energy at the output.
class AtOutput {
 public:
  /// @param step  torque of the flexspline over that of the output, with sign
  AtOutput(std::vector<double> torques, double step) : torques_(std::move(torques)), step_(step) {}

  [[nodiscard]] const std::vector<double>& torques() const { return torques_; }

  /// Energies at any torques that do not change their order of size within a sense.
  [[nodiscard]] std::vector<RingEnergy> energies(const AssembledDrive& drive,
                                                 const std::vector<double>& torques) const {
    // Each sense begins at the assembled state and goes on to larger torques.
    std::vector<RingEnergy> made(torques.size());
    for (const double sense : {1.0, -1.0}) {
      std::vector<std::size_t> index;
      for (std::size_t n = 0; n < torques.size(); ++n)
        if (torques[n] * sense > 0) index.push_back(n);
      std::ranges::sort(index, {}, [&](std::size_t n) { return std::abs(torques[n]); });
      std::vector<double> at;
      // The torque of the drive on its load is minus that on the output (MO-14).
      for (const std::size_t n : index) at.push_back(-step_ * torques[n]);
      const std::vector<RingEnergy> solved = ring_energies(drive, at);
      for (std::size_t k = 0; k < index.size(); ++k)
        made[index[k]] = {.torque = torques[index[k]],
                          .rotation = -step_ * solved[k].rotation,
                          .energy = solved[k].energy};
    }
    return made;
  }

  /// Samples of one angle, without rate and period.
  [[nodiscard]] EnergySamples samples(const AssembledDrive& drive) const {
    const std::vector<RingEnergy> at = energies(drive, torques_);
    EnergySamples made;
    for (const RingEnergy& of : at) made.twist.push_back(of.rotation);
    made.compliance = rising_slopes(torques_, made.twist);
    const auto first = std::ranges::find_if(at, [](const RingEnergy& e) { return e.torque > 0; });
    made.energy = {first->energy};
    return made;
  }

 private:
  std::vector<double> torques_;
  double step_;
};

/// Adds samples to others, each times a factor.
void add_samples(EnergySamples& sum, const EnergySamples& more, double factor) {
  const auto each = [&](std::vector<double>& a, const std::vector<double>& b) {
    a.resize(b.size());
    for (std::size_t n = 0; n < b.size(); ++n) a[n] += factor * b[n];
  };
  each(sum.energy, more.energy);
  each(sum.twist, more.twist);
  each(sum.compliance, more.compliance);
}

EnergySamples joined(const std::vector<EnergySamples>& angles, double rate, double period) {
  EnergySamples made{.rate = rate, .period = period, .energy = {}, .twist = {}, .compliance = {}};
  for (const EnergySamples& of : angles) {
    made.energy.push_back(of.energy.front());
    made.twist.insert(made.twist.end(), of.twist.begin(), of.twist.end());
    made.compliance.insert(made.compliance.end(), of.compliance.begin(), of.compliance.end());
  }
  return made;
}

/// Turns of cage, flexspline and circular spline against the wave generator in one of its turns,
/// with sign (DY-1, DY-2).
struct FamilyRates {
  double cage = 0.0;
  double flexspline = 0.0;
  double spline = 0.0;
};

FamilyRates rates_of(const GearSet& gear) {
  const Arrangement arrangement = arrangement_of(gear.drivetrain->fixed);
  const PartTurns turns = part_turns(arrangement, gear.drive.ratio);
  const Bearing& bearing = *gear.wave_generator->bearing;
  const double pitch = (bearing.inner_raceway_diameter + bearing.outer_raceway_diameter) / 2;
  const double cage =
      ball_orders(arrangement, gear.drive.ratio,
                  {.balls = *bearing.ball_count, .diameter_ratio = bearing.ball_diameter / pitch})
          .cage;
  // A position against the wave falls by the turn of the wave against the part.
  return {.cage = -cage,
          .flexspline = turns.wave_generator - turns.flexspline,
          .spline = turns.wave_generator - turns.circular_spline};
}

/// Places of a crack over one period of its angle.
struct FamilyAngles {
  double period = 0.0;         ///< [rad]
  std::vector<double> places;  ///< whole pitches nearest to even angles [rad]
};

/// @param pitches  teeth or spaces on the part
/// @param each     whether each of them differs from all others
FamilyAngles family_angles(const GearSet& gear, int pitches, bool each) {
  const int teeth = flexspline_teeth(gear.drive);
  // With an even number of teeth, the drive looks the same from its other lobe (MO-27).
  const bool even = teeth % 2 == 0 && !each;
  const int whole = even ? pitches / 2 : pitches;
  const int count = each ? whole : std::min(whole, kMostAngles);
  FamilyAngles made{.period = even ? pi : 2 * pi, .places = {}};
  for (int q = 0; q < count; ++q)
    made.places.push_back(2 * pi / pitches * std::round(static_cast<double>(q) * whole / count));
  return made;
}

/// The drive at the phases of the cage over which the cracks are averaged.
std::vector<AssembledDrive> at_phases(const GearSet& gear) {
  const double pitch = 2 * pi / *gear.wave_generator->bearing->ball_count;
  std::vector<AssembledDrive> made;
  for (std::size_t p = 0; p < kMeanPhases; ++p) {
    CoupledOptions options;
    options.cage_phase = pitch * static_cast<double>(p) / static_cast<double>(kMeanPhases);
    made.emplace_back(gear, options);
  }
  return made;
}

/// Deviations of the teeth of a drive, after both parts have moved against the wave (MO-58).
class DeviatingTeeth {
 public:
  /// @param teeth  null: none deviates
  DeviatingTeeth(const Deviations* teeth, const GearSet& gear) {
    if (teeth == nullptr) return;
    teeth_ = *teeth;
    teeth_.balls.clear();  // a deviating ball turns with the cage
    turn_of_tooth_ = 2 * pi / flexspline_teeth(gear.drive);
    turn_of_space_ = 2 * pi / (flexspline_teeth(gear.drive) + gear.drive.wave_number);
  }

  [[nodiscard]] bool any() const { return !teeth_.empty(); }
  /// The drive with the gap of the pair and the eccentricity of its cam, and with the teeth of the
  /// parts whose moves are given [rad].
  [[nodiscard]] AssembledDrive of(const AssembledDrive& drive, std::optional<double> flexspline,
                                  std::optional<double> spline) const {
    if (!any()) return drive;
    Deviations moved = teeth_;
    const auto place = [](std::vector<ToothDeviation>& teeth, const auto& rotated,
                          std::optional<double> move) {
      if (move)
        teeth = rotated;
      else
        std::ranges::fill(teeth, ToothDeviation{});
    };
    const auto teeth_of = [](std::optional<double> move, double turn) {
      return static_cast<int>(std::lround(move.value_or(0.0) / turn));
    };
    place(moved.flexspline, moved_on(teeth_, teeth_of(flexspline, turn_of_tooth_)).flexspline,
          flexspline);
    place(moved.spline, moved_on(teeth_, teeth_of(spline, turn_of_space_)).spline, spline);
    return drive.with_deviations(moved);
  }

 private:
  Deviations teeth_ = {};
  double turn_of_tooth_ = 0.0;
  double turn_of_space_ = 0.0;
};

/// What cracks and teeth of one family add, over their angle and as a mean over the cage (MO-27).
EnergySamples added_samples(const GearSet& gear, CrackFamily family, int pitches, double rate,
                            const DeviatingTeeth& teeth, const AtOutput& output,
                            const Progress& progress) {
  const FamilyAngles angles = family_angles(gear, pitches, teeth.any());
  const std::vector<AssembledDrive> drives = at_phases(with_families(gear, {family}));
  std::vector<EnergySamples> sound;
  for (const AssembledDrive& drive : drives)
    sound.push_back(output.samples(teeth.of(drive.without_cracks(), {}, {})));
  std::vector<EnergySamples> added(angles.places.size());
  for_each_index(added.size(), {}, progress, [&] {
    return [&](std::size_t q) {
      const double place = angles.places[q];
      for (std::size_t p = 0; p < drives.size(); ++p) {
        const AssembledDrive moved = family == CrackFamily::flexspline
                                         ? teeth.of(drives[p].moved(place, 0.0), place, {})
                                         : teeth.of(drives[p].moved(0.0, place), {}, place);
        const double share = 1.0 / static_cast<double>(drives.size());
        add_samples(added[q], output.samples(moved), share);
        add_samples(added[q], sound[p], -share);
      }
    };
  });
  return joined(added, rate, angles.period);
}

/// The whole energy over the angle of the cage.
EnergySamples cage_samples(const GearSet& gear, double rate, const DeviatingTeeth& teeth,
                           const AtOutput& output, const Progress& progress) {
  const double pitch = 2 * pi / *gear.wave_generator->bearing->ball_count;
  std::vector<EnergySamples> made(kCagePoints);
  for_each_index(made.size(), {}, progress, [&] {
    return [&](std::size_t q) {
      CoupledOptions options;
      options.cage_phase = pitch * static_cast<double>(q) / static_cast<double>(kCagePoints);
      made[q] = output.samples(teeth.of(AssembledDrive(gear, options), {}, {}));
    };
  });
  return joined(made, rate, pitch);
}

/// Compares the table with the coupled drive at random angles of all parts.
/// @param angles_of  for each family of the cracked and of the sound table, the number of its
/// angle:
///                   cage, flexspline, circular spline
void check_table(const GearSet& gear, const ComputedCurve& curve,
                 const std::array<std::vector<int>, 2>& angles_of, bool with_cracks,
                 const DeviatingTeeth& deviating, const AtOutput& output, CurveTable& result,
                 const Progress& progress) {
  const GearSet contacts =
      with_families(gear, {CrackFamily::cage, CrackFamily::flexspline, CrackFamily::spline});
  const double pitch = 2 * pi / *gear.wave_generator->bearing->ball_count;
  const int teeth = flexspline_teeth(gear.drive);
  const bool whole_teeth = has_tooth_crack(gear) || deviating.any();
  const MakersTorques makers = makers_torques(gear);
  std::vector<double> torques;
  for (const double torque : {makers.T1, makers.T2, makers.T3})
    if (torque < result.most_torque) {
      torques.push_back(torque);
      torques.push_back(-torque);
    }
  if (torques.empty()) torques = {result.most_torque / 2, -result.most_torque / 2};
  struct Checked {
    std::vector<double> difference;
    std::vector<double> added;
    std::vector<double> added_difference;
  };
  std::vector<Checked> checked(kCheckedTriples);
  for_each_index(checked.size(), {}, progress, [&] {
    return [&](std::size_t n) {
      const auto uniform = [&](std::uint64_t input) { return counter_uniform(kSeed, n, input); };
      double flexspline = 2 * pi * uniform(0);
      // The model has no place between two teeth (TC-21).
      if (whole_teeth) flexspline = 2 * pi / teeth * std::floor(teeth * uniform(0));
      double spline = 2 * pi * uniform(1);
      const int spaces = teeth + gear.drive.wave_number;
      if (deviating.any()) spline = 2 * pi / spaces * std::floor(spaces * uniform(1));
      CoupledOptions options;
      options.cage_phase = pitch * uniform(2);
      const AssembledDrive full = deviating.of(
          AssembledDrive(contacts, options).moved(flexspline, spline), flexspline, spline);
      const std::vector<RingEnergy> is = output.energies(full, torques);
      const std::vector<RingEnergy> sound = output.energies(full.without_cracks(), torques);
      const std::array<double, 3> angles = {options.cage_phase, flexspline, spline};
      const auto slice_of = [&](const EnergyTable& table, const std::vector<int>& families) {
        std::array<double, EnergyTable::kMostFamilies> of_table{};
        for (std::size_t k = 0; k < families.size(); ++k)
          of_table[k] = angles[static_cast<std::size_t>(families[k])];
        return table.at_angles(of_table);
      };
      const EnergyTable::Slice slice = slice_of(*curve.cracked, angles_of[0]);
      const EnergyTable::Slice sound_slice = slice_of(*curve.sound, angles_of[1]);
      for (std::size_t i = 0; i < torques.size(); ++i) {
        // The compliance in series is the same in both.
        const double more = curve.sound->compliance() * torques[i];
        const double twist = slice.at_torque(torques[i]).twist - more;
        const double sound_twist = sound_slice.at_torque(torques[i]).twist - more;
        const double added = is[i].rotation - sound[i].rotation;
        checked[n].difference.push_back(twist - is[i].rotation);
        checked[n].added.push_back(added);
        checked[n].added_difference.push_back(twist - sound_twist - added);
      }
    };
  });
  double squares = 0.0;
  double added_squares = 0.0;
  double share_squares = 0.0;
  double most_added = 0.0;
  double most_share = 0.0;
  double count = 0.0;
  for (const Checked& of : checked)
    for (std::size_t i = 0; i < of.difference.size(); ++i) {
      squares += of.difference[i] * of.difference[i];
      added_squares += of.added[i] * of.added[i];
      result.worst_difference = std::max(result.worst_difference, std::abs(of.difference[i]));
      most_added = std::max(most_added, std::abs(of.added[i]));
      share_squares += of.added_difference[i] * of.added_difference[i];
      most_share = std::max(most_share, std::abs(of.added_difference[i]));
      ++count;
    }
  result.triples = kCheckedTriples;
  result.rms_difference = std::sqrt(squares / count);
  if (!with_cracks) return;
  result.cracks_twist = std::sqrt(added_squares / count);
  if (*result.cracks_twist > 0) {
    result.rms_share = std::sqrt(share_squares / added_squares);
    result.worst_share = most_share / most_added;
  }
}

std::shared_ptr<const EnergyTable> table_of(const CurveSamples& of,
                                            const std::vector<EnergySamples>& families) {
  return std::make_shared<const EnergyTable>(of.torques, families, of.compliance);
}

/// Kinematic error of the teeth at a torque, from peak to valley over a turn of the output, where
/// nearly all positions of one part meet all of the other (DY-17) [rad].
double range_of_teeth(const ComputedCurve& curve, double torque) {
  double range = 0.0;
  for (std::size_t k = 1; k < curve.samples.sound.size(); ++k) {
    const EnergySamples& family = curve.samples.sound[k];
    const std::size_t count = family.angles();
    std::vector<double> twist;
    for (std::size_t q = 0; q < count; ++q) {
      std::array<double, EnergyTable::kMostFamilies> angles{};
      angles[k] = family.period * static_cast<double>(q) / static_cast<double>(count);
      twist.push_back(curve.sound->at_angles(angles).at_torque(torque).twist);
    }
    const auto [least, largest] = std::ranges::minmax(twist);
    range += largest - least;
  }
  return range;
}

/// @param teeth  null: no tooth deviates
ComputedCurve curve_of_teeth(const GearSet& gear, const Deviations* teeth,
                             const Progress& progress) {
  if (!gear.drivetrain)
    throw InputError("drivetrain",
                     "must be given for a computed curve; give [drivetrain] with motor_inertia and "
                     "load_inertia");
  require_inputs_of_curve(gear);
  const double step = flexspline_torque(arrangement_of(gear.drivetrain->fixed), gear.drive.ratio);
  ComputedCurve made;
  CurveTable& result = made.table;
  result.most_torque = largest_curve_torque(gear);
  const AtOutput output(table_torques(result.most_torque), step);
  const GearSet sound = without_cracks(gear);
  const FamilyRates rates = rates_of(gear);
  const DeviatingTeeth deviating(teeth, gear);
  const double shaft = gear.output_shaft ? output_shaft_compliance(sound).intact : 0.0;
  CurveSamples& samples = made.samples;
  samples.torques = output.torques();
  samples.compliance =
      step * step * (sound_series_compliance(AssembledDrive(sound)) - shaft) + shaft;  // (MO-14)
  try {
    samples.sound = {cage_samples(sound, rates.cage, deviating, output, progress.part(0.0, 0.05))};
    result.torques = static_cast<int>(output.torques().size());
    result.cage_angles = static_cast<int>(samples.sound.front().angles());
    samples.cracked = samples.sound;
    std::array<std::vector<int>, 2> angles_of = {std::vector<int>{0}, std::vector<int>{0}};
    bool with_cracks = false;
    const GearSet inner = with_families(gear, {CrackFamily::cage});
    if (has_cracks(inner)) {
      samples.cracked[0] =
          cage_samples(inner, rates.cage, deviating, output, progress.part(0.05, 0.1));
      with_cracks = true;
    }
    const auto take = [&](CrackFamily family, int angle, int pitches, double rate,
                          std::optional<int>& angles, const Progress& part) {
      const bool cracked = has_cracks(with_families(gear, {family}));
      if (!cracked && !deviating.any()) return;
      const auto added = [&](const GearSet& of, const Progress& its_part) {
        return added_samples(of, family, pitches, rate, deviating, output, its_part);
      };
      if (deviating.any()) {
        samples.sound.push_back(added(sound, part.part(0.0, 0.5)));
        angles_of[1].push_back(angle);
      }
      samples.cracked.push_back(cracked ? added(gear, part.part(0.5, 1.0)) : samples.sound.back());
      angles_of[0].push_back(angle);
      angles = static_cast<int>(samples.cracked.back().angles());
      with_cracks = with_cracks || cracked;
    };
    const int pitches = flexspline_teeth(gear.drive);
    take(CrackFamily::flexspline, 1, pitches, rates.flexspline, result.flexspline_angles,
         progress.part(0.1, 0.45));
    take(CrackFamily::spline, 2, pitches + gear.drive.wave_number, rates.spline,
         result.spline_angles, progress.part(0.45, 0.8));
    if (!with_cracks) samples.cracked.clear();
    made.sound = table_of(samples, samples.sound);
    made.cracked = with_cracks ? table_of(samples, samples.cracked) : made.sound;
    if (deviating.any())
      result.teeth_range = range_of_teeth(
          made, -std::min(makers_torques(gear).rated, result.most_torque));  // on the output
    check_table(gear, made, angles_of, with_cracks, deviating, output, result,
                progress.part(0.8, 1.0));
  } catch (const SolverError& error) {
    throw SolverError(fmt::format(
        "the computed curve up to {:.4g} N*m has no table: {}; lower drivetrain.curve_torque, or "
        "give drivetrain.spring = \"lines\"",
        result.most_torque, error.what()));
  }
  samples.table = result;
  return made;
}

[[noreturn]] void refuse_curve_text() {
  throw InputError("curve table", "cannot be read; compute it again");
}

/// Visits the numbers of a curve in their order.  Writer and reader share it.
/// @param number   takes a number or a count
/// @param size     takes a list, and gives it its size
/// @param present  takes an optional value, and makes it present or absent
template <class Samples, class Number, class Size, class Present>
void each_curve_number(Samples& of, const Number& number, const Size& size,
                       const Present& present) {
  const auto list = [&](auto& values) {
    size(values);
    for (auto& value : values) number(value);
  };
  const auto families = [&](auto& all) {
    size(all);
    for (auto& family : all) {
      number(family.rate);
      number(family.period);
      list(family.energy);
      list(family.twist);
      list(family.compliance);
    }
  };
  const auto optional = [&](auto& value) {
    present(value);
    if (value) number(*value);
  };
  list(of.torques);
  families(of.sound);
  families(of.cracked);
  number(of.compliance);
  auto& table = of.table;
  number(table.most_torque);
  number(table.torques);
  number(table.cage_angles);
  optional(table.flexspline_angles);
  optional(table.spline_angles);
  number(table.triples);
  number(table.worst_difference);
  number(table.rms_difference);
  optional(table.cracks_twist);
  optional(table.worst_share);
  optional(table.rms_share);
  optional(table.teeth_range);
}

}  // namespace

GearSet what_the_curve_depends_on(const GearSet& gear) {
  GearSet kept = gear;
  kept.name.clear();
  kept.duty.reset();
  kept.duty_record.reset();
  kept.kinematic_error.clear();
  kept.error_table.reset();
  kept.manoeuvre.clear();
  kept.range.clear();
  kept.scatter.clear();
  kept.correlation.clear();
  if (gear.drivetrain)
    kept.drivetrain = Drivetrain{.fixed = gear.drivetrain->fixed,
                                 .motor_inertia = 1.0,
                                 .load_inertia = 1.0,
                                 .spring = gear.drivetrain->spring,
                                 .curve_torque = gear.drivetrain->curve_torque};
  return kept;
}

std::string curve_text(const CurveSamples& samples) {
  std::string text;
  const auto word = [&](const auto& value) { add_word(text, value); };
  each_curve_number(
      samples, word, [&](const auto& list) { word(list.size()); },
      [&](const auto& value) { word(value ? 1 : 0); });
  return text;
}

ComputedCurve read_curve(std::string_view text) {
  NumberWords words(text, refuse_curve_text);
  ComputedCurve made;
  each_curve_number(
      made.samples, [&](auto& value) { words.take(value); },
      [&](auto& list) { list.resize(words.size()); },
      [&](auto& value) {
        if (words.flag()) value.emplace();
      });
  if (words.left() > 0) refuse_curve_text();
  made.table = made.samples.table;
  made.sound = table_of(made.samples, made.samples.sound);
  made.cracked =
      made.samples.cracked.empty() ? made.sound : table_of(made.samples, made.samples.cracked);
  return made;
}

void require_inputs_of_curve(const GearSet& gear) {
  if (const std::string missing = missing_for_torsion_curve(gear); !missing.empty())
    throw InputError(
        "drivetrain.spring",
        fmt::format("is \"computed\", but the torsion curve lacks fields: {}", missing));
}

double largest_curve_torque(const GearSet& gear) {
  const MakersTorques makers = makers_torques(gear);
  const auto peak = gear.rating ? gear.rating->momentary_peak : std::nullopt;
  return gear.drivetrain->curve_torque.value_or(
      peak.value_or(kOfLargest * std::max(makers.T3, makers.rated)));
}

ComputedCurve computed_curve(const GearSet& gear, const Progress& progress) {
  return curve_of_teeth(gear, nullptr, progress);
}

ComputedCurve computed_curve_of_teeth(const GearSet& gear, const Deviations& teeth,
                                      const Progress& progress) {
  return curve_of_teeth(gear, &teeth, progress);
}

}  // namespace strainwave
