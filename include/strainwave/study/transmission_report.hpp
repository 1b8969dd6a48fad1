// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/core/progress.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/evidence.hpp"
#include "strainwave/torsion/deviations.hpp"

/// @file
/// The result of `strainwave transmission`: the kinematic error of a drive by deviations of its
/// teeth and by its cracks.

namespace strainwave {

/// The part whose teeth, or cracks, make a family of lines.
enum class ErrorFamily {
  flexspline,       ///< what turns with the flexspline, its teeth and the outer ring
  circular_spline,  ///< what stays with the circular spline
};
template <>
struct EnumNames<ErrorFamily> {
  static constexpr std::array<std::string_view, 2> names = {"flexspline", "circular_spline"};
};

/// Where the deviations of the teeth come from.
enum class DeviationSource {
  none,      ///< no tooth deviates
  measured,  ///< given for each tooth
  drawn,     ///< drawn from the tolerances
};
template <>
struct EnumNames<DeviationSource> {
  static constexpr std::array<std::string_view, 3> names = {"none", "measured", "drawn"};
};

/// A line of the kinematic error.
struct TransmissionLine {
  ErrorFamily family = ErrorFamily::flexspline;
  int periods = 0;                               ///< k, in a turn of the wave against the part
  double order = 0.0;                            ///< periods in a turn of the input [-]
  double amplitude = 0.0;                        ///< A of the sound drive [rad]
  double phase = 0.0;                            ///< p, with A sin(o theta_m + p) [rad]
  std::optional<double> cracked_amplitude = {};  ///< [rad]
  std::optional<double> cracked_phase = {};      ///< [rad]

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    using L = TransmissionLine;
    field({"family", "", "the part whose teeth or cracks make the line"}, &L::family);
    field({"periods", "", "periods in a turn of the wave against the part"}, &L::periods);
    field({"order", "1", "periods in a turn of the input"}, &L::order);
    field({"amplitude", "rad", "amplitude of the output's angle, sound"}, &L::amplitude);
    field({"phase", "rad", "phase of the sine at the angle 0 of the input, sound"}, &L::phase);
    field({"cracked_amplitude", "rad", "amplitude with the cracks"}, &L::cracked_amplitude);
    field({"cracked_phase", "rad", "phase with the cracks"}, &L::cracked_phase);
  }
};

/// The kinematic error of one family at one position of the wave.
struct TransmissionRow {
  ErrorFamily family = ErrorFamily::flexspline;
  double angle = 0.0;  ///< of the input [rad]
  double error = 0.0;  ///< of the output, sound, less its mean [rad]
  std::optional<double> cracked = {};

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = TransmissionRow;
    field({"family", "", "the part whose teeth or cracks make the error"}, &R::family);
    field({"angle", "rad", "angle of the input"}, &R::angle);
    field({"error", "rad", "error of the output, sound, less its mean"}, &R::error);
    field({"cracked", "rad", "error of the output with the cracks, less its mean"}, &R::cracked);
  }
};

/// Range of the kinematic error over the drives that were drawn.
struct DrawnTransmission {
  int draws = 0;   ///< drawn drives that gave an error
  int failed = 0;  ///< drawn drives without an equilibrium
  std::uint64_t seed = 0;
  double low = 0.0;     ///< 5 % [rad]
  double median = 0.0;  ///< [rad]
  double high = 0.0;    ///< 95 % [rad]

  template <class Visitor>
  static void describe(Visitor&& field) {
    using D = DrawnTransmission;
    field({"draws", "", "drawn drives that gave an error"}, &D::draws);
    field({"failed", "", "drawn drives without an equilibrium"}, &D::failed);
    field({"seed", "", "seed of the draws"}, &D::seed);
    field({"low", "rad", "range from peak to valley, 5 % of the drawn drives"}, &D::low);
    field({"median", "rad", "range from peak to valley, 50 % of the drawn drives"}, &D::median);
    field({"high", "rad", "range from peak to valley, 95 % of the drawn drives"}, &D::high);
  }
};

/// Torque and deviations for a kinematic error.
struct TransmissionOptions {
  std::optional<double> torque = {};  ///< T at the output [N*m], not 0; absent: that of the load
  /// deviations of each tooth, without `pairing_gap`, which follows from them (TC-36); without them
  /// they are drawn from the tolerances
  std::optional<Deviations> measured = {};
  int draws = 20;          ///< drives drawn from the tolerances; 0: no tooth deviates
  std::uint64_t seed = 1;  ///< the same seed gives the same drives
  int threads = 0;         ///< 0: as many as the machine runs at once; the result is the same
};

/// The result of `strainwave transmission`.
struct TransmissionReport {
  double torque = 0.0;  ///< T at the output [N*m]
  DeviationSource source = DeviationSource::none;
  double range = 0.0;                        ///< peak to valley over a turn of the output [rad]
  std::optional<double> cracked_range = {};  ///< the same with the cracks [rad]
  std::vector<TransmissionLine> lines = {};  ///< by falling amplitude
  std::vector<TransmissionRow> rows = {};    ///< over one turn of the wave against each part
  std::optional<DrawnTransmission> drawn = {};
  int checks = 0;                ///< positions at which the sum of the families was compared
  double adding_error = 0.0;     ///< largest difference there [rad]
  std::vector<Note> notes = {};  ///< remarks on the validity of the error
  std::vector<std::string> equations = {};  ///< tags of the theory manual

  template <class Visitor>
  static void describe(Visitor&& field) {
    using R = TransmissionReport;
    field({.name = "range",
           .unit = "rad",
           .doc = "kinematic error from peak to valley over a turn of the output, sound",
           .headline = true},
          &R::range);
    field({.name = "cracked_range",
           .unit = "rad",
           .doc = "the same with the cracks",
           .headline = true},
          &R::cracked_range);
    field({"torque", "N*m", "torque at the output"}, &R::torque);
    field({"source", "", "where the deviations of the teeth come from"}, &R::source);
    field({"lines", "", "lines of the error over the angle of the input, largest first"},
          &R::lines);
    field({"drawn", "",
           "range over the drives that were drawn; the rest shows the drive with the "
           "median"},
          &R::drawn);
    field({"checks", "",
           "random positions at which the sum of both parts was compared with the complete drive"},
          &R::checks);
    field({"adding_error", "rad", "largest difference at these positions"}, &R::adding_error);
    field({"rows", "", "error over one turn of the wave against each part"}, &R::rows);
  }
};

/// Kinematic error of a drive by deviations of its teeth and by its cracks, under a torque.
///
/// Implements theory manual eq. (DY-17).  The coupled drive is solved at each tooth of the
/// flexspline, and again at each tooth of the circular spline; both errors are added, and
/// the sum is compared with the complete drive at random positions.  What passes within one tooth
/// is left out, and so are the balls and the eccentricity of the cam, which keep their places.
/// @param gear      must give enough for the torsion curve
/// @param options   torque, finite and not 0 [N*m], and deviations; `draws` >= 0; {}: that of the
///                  load, and 20 draws from the tolerances
/// @param progress  receives the share done, 0 to 1, and may stop the run; {}: neither
/// @throws InputError   if a number is out of range, or the deviations do not fit the drive
/// @throws SolverError  if the drive has no equilibrium
/// @throws Stopped      if the caller requests a stop
[[nodiscard]] TransmissionReport transmission_report(const GearSet& gear,
                                                     const TransmissionOptions& options = {},
                                                     const Progress& progress = {});

}  // namespace strainwave
