// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/core/progress.hpp"
#include "strainwave/drive_growth/checkpoint.hpp"
#include "strainwave/drive_growth/growing_crack.hpp"
#include "strainwave/drive_growth/interaction.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"

namespace strainwave {

/// What ended the growth of the cracks of a drive.
enum class DriveEnd {
  until,       ///< the end that was asked for: time, cycles or size
  arrested,    ///< no crack grows any more: the life has no end
  breaks,      ///< K_max of a crack reaches the toughness
  assessment,  ///< the failure assessment of a crack is beyond its line
  severed,     ///< less than 1 % of the stiffness is left
  range,       ///< a crack leaves the range of its solution: the rest is not known
  too_slow,    ///< the longest duty that this version computes ends before anything else
  not_known,   ///< no crack could be computed
};
template <>
struct EnumNames<DriveEnd> {
  static constexpr std::array<std::string_view, 8> names = {
      "until", "arrested", "breaks", "assessment", "severed", "range", "too_slow", "not_known"};
};

/// Something that happens to a crack on its way.
enum class CrackEvent {
  arrested,      ///< the crack stands still from here on, up to the end
  through_wall,  ///< a surface crack goes on as a crack through the wall
  breaks,        ///< K_max reaches the toughness
  assessment,    ///< the point leaves the assessment line
  severed,       ///< the crack leaves less than 1 % of the stiffness of the drive
  range,         ///< the solution of the stress intensity ends
  wanted_size,   ///< the size that was asked for
  merges,        ///< it grows together with another crack in its line (CG-14)
};
template <>
struct EnumNames<CrackEvent> {
  static constexpr std::array<std::string_view, 8> names = {"arrested",    "through_wall", "breaks",
                                                            "assessment",  "severed",      "range",
                                                            "wanted_size", "merges"};
};

/// When the computation stops, if nothing else ends it before.
struct GrowthStop {
  std::optional<double> time;    ///< of duty [s]
  std::optional<double> cycles;  ///< of the crack that sees most of them [-]
  std::string crack;             ///< path of the crack whose size is asked for; empty: none
  double size = 0.0;             ///< depth or half length of that crack [m]
};

/// Choices of grow_cracks and life_trace.
struct GrowthOptions {
  RateChoice rate;          ///< law of growth and rule of mixed modes
  Interaction interaction;  ///< how overloads slow the growth
  GrowthStop stop;          ///< where the computation stops at the latest
  double tolerance = 1e-9;  ///< of each step, relative [-]
  int points = 60;          ///< largest number of rows of a series [-]; >= 2
};

/// An event of one crack.
struct GrowthEvent {
  CrackEvent event = CrackEvent::arrested;
  double time = 0.0;         ///< of duty [s]
  double cycles = 0.0;       ///< of this crack [-]
  double size = 0.0;         ///< depth or half length [m]
  double half_length = 0.0;  ///< of a surface crack, else the size [m]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"event", "", "what happens"}, &GrowthEvent::event);
    field({"time", "s", "time of duty"}, &GrowthEvent::time);
    field({"cycles", "1", "cycles of this crack"}, &GrowthEvent::cycles);
    field({"size", "m", "depth, or half length of a through crack"}, &GrowthEvent::size);
    field({"half_length", "m", "half length on the surface"}, &GrowthEvent::half_length);
  }
};

/// One row of the growth of a crack.
struct GrowthPoint {
  static constexpr bool kTableRow = true;
  double time = 0.0;         ///< [s]
  double cycles = 0.0;       ///< [-]
  double size = 0.0;         ///< a [m]
  double half_length = 0.0;  ///< c [m]
  double K_max = 0.0;        ///< largest K of a repetition, over all tips [Pa*m^0.5]
  double delta_K = 0.0;      ///< full range of the widest cycle at that tip [Pa*m^0.5]
  double ratio = 0.0;        ///< R of the widest cycle [-]
  double rate = 0.0;         ///< growth of the size per cycle, mean over a repetition [m]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"time", "s", "time of duty"}, &GrowthPoint::time);
    field({"cycles", "1", "cycles of this crack"}, &GrowthPoint::cycles);
    field({"size", "m", "depth, or half length of a through crack"}, &GrowthPoint::size);
    field({"half_length", "m", "half length on the surface"}, &GrowthPoint::half_length);
    field({"K_max", "Pa*m^0.5", "largest K of a repetition of the duty, at any point of the tip"},
          &GrowthPoint::K_max);
    field({"delta_K", "Pa*m^0.5", "widest range of K, with its pressed part"},
          &GrowthPoint::delta_K);
    field({"ratio", "1", "R of the widest cycle"}, &GrowthPoint::ratio);
    field({"rate", "m", "growth of the size per cycle, mean over a repetition"},
          &GrowthPoint::rate);
  }
};

/// Growth of one crack.
struct CrackGrowth {
  std::string path;              ///< of the crack in the file: "flexspline.crack[0]"
  std::string kind;              ///< of the crack in the file: "through"
  std::string law = {};          ///< name of the law
  std::string constants = {};    ///< origin of its constants, in words
  double cycles_per_hour = 0.0;  ///< [-]
  bool grows = false;            ///< whether the crack grows at all from its size in the file
  /// For a crack that stands still at the end: threshold over the range of K there [-]; > 1
  std::optional<double> margin = {};
  /// Factor on the loads of the duty from which the crack grows on [-]; absent: it grows, or no
  /// factor up to 1000, or up to the end of its table of K over a turn, does it
  std::optional<double> factor_to_grow = {};
  /// angle by which the crack would turn, at its size in the file [rad]
  std::optional<double> kink_angle = {};
  std::vector<GrowthEvent> events = {};
  std::vector<GrowthPoint> series = {};

  template <class Visitor>
  static void describe(Visitor&& field) {
    using C = CrackGrowth;
    field({"path", "", "the crack"}, &C::path);
    field({"kind", "", "kind of the crack in the file"}, &C::kind);
    field({"law", "", "law of growth"}, &C::law);
    field({"constants", "", "origin of the constants"}, &C::constants);
    field({"cycles_per_hour", "1", "cycles in an hour of duty"}, &C::cycles_per_hour);
    field({"grows", "", "whether the crack grows from its size in the file"}, &C::grows);
    field({"margin", "1", "of a crack at rest: threshold over the range of K"}, &C::margin);
    field({"factor_to_grow", "1", "factor on the duty's loads from which a crack at rest grows"},
          &C::factor_to_grow);
    field({"kink_angle", "rad", "angle by which the crack would turn, at its size in the file"},
          &C::kink_angle);
    field({"events", "", "what happens to the crack"}, &C::events);
    field({"series", "", "growth over time"}, &C::series);
  }
};

/// Stiffness of the drive at one moment.
struct StiffnessOverLife {
  static constexpr bool kTableRow = true;
  double time = 0.0;       ///< [s]
  double positive = 0.0;   ///< K_HD under T > 0 [N*m/rad]
  double negative = 0.0;   ///< K_HD under T < 0 [N*m/rad]
  double change = 0.0;     ///< of the softer sense, against the drive of the file [-]
  double resonance = 0.0;  ///< lowest natural frequency over that of the file, sqrt(K/K_0) [-]
  std::optional<double> reserve = {};  ///< least factor on the largest load of the duty [-]
  /// K1 of the coupled drive under T > 0 [N*m/rad], the maker's stiffness; absent in rows between,
  /// and if the file does not give the coupled drive.
  std::optional<double> K1_positive = {};
  std::optional<double> K2_positive = {};  ///< K2, as K1_positive [N*m/rad]
  std::optional<double> K3_positive = {};  ///< K3, as K1_positive [N*m/rad]
  std::optional<double> K1_negative = {};  ///< K1 under T < 0, as K1_positive [N*m/rad]
  std::optional<double> K2_negative = {};  ///< K2 under T < 0, as K1_positive [N*m/rad]
  std::optional<double> K3_negative = {};  ///< K3 under T < 0, as K1_positive [N*m/rad]

  template <class Visitor>
  static void describe(Visitor&& field) {
    using S = StiffnessOverLife;
    field({"time", "s", "time of duty"}, &S::time);
    field({"positive", "N*m/rad", "K_HD under T > 0"}, &S::positive);
    field({"negative", "N*m/rad", "K_HD under T < 0"}, &S::negative);
    field({"change", "1", "of the softer sense, against the drive of the file"}, &S::change);
    field({"resonance", "1", "natural frequency over that of the file"}, &S::resonance);
    field({"reserve", "1", "least factor on the duty's largest load at which a crack fails"},
          &S::reserve);
    const auto line = [&](std::string_view name, std::string_view doc, auto member) {
      field({.name = name, .unit = "N*m/rad", .doc = doc}, member);
    };
    line("K1_positive", "K1 of the coupled drive, T > 0", &S::K1_positive);
    line("K2_positive", "K2 of the coupled drive, T > 0", &S::K2_positive);
    line("K3_positive", "K3 of the coupled drive, T > 0", &S::K3_positive);
    line("K1_negative", "K1 of the coupled drive, T < 0", &S::K1_negative);
    line("K2_negative", "K2 of the coupled drive, T < 0", &S::K2_negative);
    line("K3_negative", "K3 of the coupled drive, T < 0", &S::K3_negative);
  }
};

/// Growth of all cracks of a drive over its duty.
struct GrowthReport {
  DriveEnd end = DriveEnd::not_known;
  std::string governing;  ///< path of the crack that ends the growth; empty: none
  std::string sentence;   ///< the answer in words
  double time = 0.0;      ///< of duty until the end [s]
  /// until a crack ends the life of the drive [s]; absent: no end is known
  std::optional<double> life = {};
  double repetitions = 0.0;    ///< of the duty [-]
  double duty_duration = 0.0;  ///< of one repetition [s]
  std::vector<CrackGrowth> cracks;
  std::vector<StiffnessOverLife> stiffness;
  std::vector<GearSet> drives;  ///< the drive at each row of `stiffness`, with its cracks there
  int steps = 0;                ///< of the integration
  double tolerance = 0.0;       ///< of each step [-]
  double step_error = 0.0;      ///< largest difference to a computation with half steps [-]
  std::string rainflow;         ///< rule of the residue
  std::string mixed_mode;       ///< rule of mixed modes
  std::string interaction;      ///< rule of overloads
  std::vector<Note> notes;      ///< on the validity of the answer
  std::vector<std::string> equations;  ///< tags of the theory manual

  template <class Visitor>
  static void describe(Visitor&& field) {
    using G = GrowthReport;
    field({.name = "sentence", .unit = "", .doc = "the answer in words", .headline = true},
          &G::sentence);
    field({.name = "end", .unit = "", .doc = "what ended the growth", .headline = true}, &G::end);
    field({"governing", "", "crack that ends the growth; empty: none"}, &G::governing);
    field({.name = "life",
           .unit = "s",
           .doc = "time of duty until a crack ends the life; absent: no end is known",
           .headline = true},
          &G::life);
    field({"time", "s", "time of duty that was computed"}, &G::time);
    field({"repetitions", "1", "repetitions of the duty that were computed"}, &G::repetitions);
    field({"duty_duration", "s", "time of one repetition of the duty"}, &G::duty_duration);
    field({"cracks", "", "each crack"}, &G::cracks);
    field({"stiffness", "", "stiffness of the drive over time"}, &G::stiffness);
    field({"rainflow", "", "rule of the ranges that stay open"}, &G::rainflow);
    field({"mixed_mode", "", "rule of mixed modes"}, &G::mixed_mode);
    field({"interaction", "", "rule of overloads"}, &G::interaction);
    field({"steps", "", "steps of the integration"}, &G::steps);
    field({"tolerance", "1", "tolerance of each step"}, &G::tolerance);
    field({"step_error", "1",
           "largest relative change of time and sizes at the end if each step is halved"},
          &G::step_error);
  }
};

/// Grows all cracks of a drive over its duty.
///
/// Implements theory manual eqs. (GR-21) to (GR-26), (GR-30) and (GR-31).  The sizes of all tips
/// and the number of repetitions are integrated over the length of the path in the logarithms of
/// the sizes, by Dormand and Prince's pair of orders 5 and 4.  So the last cycles before a fracture
/// and the first ones of a tiny crack take equal steps.  Ends are found by bisection of the step.
///
/// @param gear        has passed `check`, with a duty; a crack whose K is not known keeps its
///                    size, and a note names it
/// @param options     laws, end and accuracy; `tolerance` in (0, 1), `points` >= 2 [-]; {}: the
///                    laws of the materials, without interaction, up to an end of the growth
/// @param progress    receives the share done, 0 to 1, and may stop the run; {}: neither
/// @param checkpoint  steps of a run before, and the place for further ones; null: none
/// @throws InputError  if the duty or the law of a crack is missing, the tolerance is outside
///                     (0, 1), there are fewer than 2 points, or a resonance raises the loads
///                     beyond the table of K of a crack
/// @throws Stopped     if the caller requests a stop
[[nodiscard]] GrowthReport grow_cracks(const GearSet& gear, const GrowthOptions& options = {},
                                       const Progress& progress = {},
                                       GrowthCheckpoint* checkpoint = nullptr);

}  // namespace strainwave
