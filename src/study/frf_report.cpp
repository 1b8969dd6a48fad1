// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/frf_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "strainwave/core/error.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/dynamics/kinematics.hpp"
#include "vibrating_drive.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// The curves begin and end this factor beyond the natural frequencies [-].
constexpr double kBeyondModes = 10;

MotorGives motor_of(DriveResponse response) {
  return response == DriveResponse::error_given_speed ||
                 response == DriveResponse::load_torque_at_speed
             ? MotorGives::speed
             : MotorGives::torque;
}

/// A response as a path through the chain, with the factor of its excitation.
struct DrivePath {
  ChainPath path;
  double factor = 1.0;
};

DrivePath path_of(const DrivetrainChain& made, DriveResponse response) {
  switch (response) {
    case DriveResponse::motor_angle:
      return {{.at = made.motor, .inertia = made.motor}};
    case DriveResponse::load_angle:
      return {{.at = made.motor, .inertia = made.load}};
    case DriveResponse::error_given_torque:
    case DriveResponse::error_given_speed:
      return {{.by = ShakenBy::twist, .at = made.error_spring, .inertia = made.load},
              made.error_twist};  // (DY-12)
    case DriveResponse::load_torque:
    case DriveResponse::load_torque_at_speed:
      break;
  }
  return {{.at = made.load, .inertia = made.load}};
}

constexpr std::array kAllResponses = {
    DriveResponse::motor_angle,        DriveResponse::load_angle,
    DriveResponse::error_given_torque, DriveResponse::error_given_speed,
    DriveResponse::load_torque,        DriveResponse::load_torque_at_speed};
static_assert(kAllResponses.size() == kDriveResponses);

/// Phases without jumps; the first is above -3/2 pi and at most 1/2 pi.
std::vector<double> continuous_phases(const std::vector<std::complex<double>>& response) {
  std::vector<double> phases;
  phases.reserve(response.size());
  double before = 0.0;
  for (const std::complex<double>& at : response) {
    const double phase = std::arg(at);
    if (phases.empty()) {
      phases.push_back(phase > pi / 2 ? phase - 2 * pi : phase);
    } else {
      const double step = phase - before;
      phases.push_back(phases.back() + step - (step > pi ? 2 * pi : step < -pi ? -2 * pi : 0.0));
    }
    before = phase;
  }
  return phases;
}

std::vector<ResponseExtremum> extrema_of(const VibratingDrive& drive, DriveResponse response,
                                         double from, double to) {
  const DrivePath path = path_of(drive.made, response);
  std::vector<ResponseExtremum> extrema =
      response_extrema(drive.made.chain, path.path, from, to, drive.held(motor_of(response)));
  for (ResponseExtremum& extremum : extrema)
    if (extremum.amplitude) *extremum.amplitude *= std::abs(path.factor);
  return extrema;
}

/// Phases of a response without damping, which is real: its sign changes at a resonance, where the
/// phase falls, and at an antiresonance, where the phase rises (DY-13).
std::vector<double> real_phases(const std::vector<std::complex<double>>& response,
                                const std::vector<double>& frequency,
                                const std::vector<ResponseExtremum>& extrema) {
  std::vector<double> phases;
  phases.reserve(response.size());
  for (std::size_t n = 0; n < response.size(); ++n) {
    const bool negative = response[n].real() < 0;
    if (n == 0) {
      phases.push_back(negative ? -pi : 0.0);
      continue;
    }
    if (negative == (response[n - 1].real() < 0)) {
      phases.push_back(phases.back());
      continue;
    }
    const bool rises = std::ranges::any_of(extrema, [&](const ResponseExtremum& of) {
      return of.kind == ExtremumKind::antiresonance && of.frequency > frequency[n - 1] &&
             of.frequency <= frequency[n];
    });
    phases.push_back(phases.back() + (rises ? pi : -pi));
  }
  return phases;
}

/// Whether anything damps a drive whose motor gives its torque or its speed.
bool has_damping(const VibratingDrive& drive, MotorGives motor) {
  return has_damping(drive.made.chain, drive.held(motor));
}

/// Adds the curves of one drive.
void add_curves(const VibratingDrive& drive, bool cracked, FrfReport& report) {
  for (const MotorGives motor : {MotorGives::torque, MotorGives::speed}) {
    const bool damped = has_damping(drive, motor);
    std::vector<DriveResponse> responses;
    std::vector<ChainPath> paths;
    std::vector<double> factors;
    for (const DriveResponse response : kAllResponses) {
      if (motor_of(response) != motor) continue;
      const DrivePath path = path_of(drive.made, response);
      responses.push_back(response);
      paths.push_back(path.path);
      factors.push_back(path.factor);
    }
    std::vector<std::vector<std::complex<double>>> found =
        frequency_responses(drive.made.chain, paths, report.frequency, drive.held(motor));
    for (std::size_t p = 0; p < paths.size(); ++p) {
      ResponseCurve& curve = report.curves[static_cast<std::size_t>(responses[p])];
      std::vector<double> amplitude(found[p].size());
      for (std::size_t n = 0; n < amplitude.size(); ++n) {
        found[p][n] *= factors[p];
        amplitude[n] = std::sqrt(std::norm(found[p][n]));  // std::abs takes ten times as long
      }
      (cracked ? curve.cracked_amplitude : curve.intact_amplitude) = std::move(amplitude);
      (cracked ? curve.cracked_phase : curve.intact_phase) =
          damped ? continuous_phases(found[p])
                 : real_phases(found[p], report.frequency,
                               extrema_of(drive, responses[p], report.frequency.front(),
                                          report.frequency.back()));
    }
  }
}

/// Extrema of the sound drive, each with the nearest one of the same kind of the cracked drive.
void add_extrema(DriveResponse response, const std::vector<ResponseExtremum>& intact,
                 std::vector<ResponseExtremum> cracked, FrfReport& report) {
  for (const ResponseExtremum& sound : intact) {
    ExtremumPair& pair = report.extrema.emplace_back(
        ExtremumPair{.response = response, .kind = sound.kind, .intact = sound});
    const auto distance = [&](const ResponseExtremum& of) {
      return of.kind == sound.kind ? std::abs(std::log(of.frequency / sound.frequency))
                                   : std::numeric_limits<double>::infinity();
    };
    const auto nearest = std::ranges::min_element(cracked, {}, distance);
    if (nearest == cracked.end() || nearest->kind != sound.kind) continue;
    // Another extremum of the sound drive may be nearer to it.
    const auto closer = [&](const ResponseExtremum& other) {
      return other.kind == sound.kind &&
             std::abs(std::log(nearest->frequency / other.frequency)) < distance(*nearest);
    };
    if (std::ranges::any_of(intact, closer)) continue;
    pair.cracked = *nearest;
    cracked.erase(nearest);
  }
  for (const ResponseExtremum& left : cracked)
    report.extrema.push_back({.response = response, .kind = left.kind, .cracked = left});
}

std::optional<double> ratio_less_one(const std::optional<double>& above,
                                     const std::optional<double>& below) {
  if (!above || !below || *below == 0) return std::nullopt;
  return *above / *below - 1;
}

void note_losses(const GearSet& gear, bool damped_at_speed, FrfReport& report) {
  if (!damped_at_speed)
    report.notes.push_back(
        {.code = "frf.undamped",
         .text =
             report.damped
                 ? "nothing damps the drive while the motor keeps its speed, so the amplitudes "
                   "at these resonances are infinite"
                 : "the file gives no damping, so the amplitudes at the resonances are infinite",
         .path = "drivetrain.gear_damping",
         .equation = "DY-13",
         .severity = Severity::information,
         .next_step = "Give drivetrain.gear_damping."});
  const bool contacts = gear.drivetrain->contact_friction == ContactFriction::computed;
  if (gear.drivetrain->hysteresis || !gear.drivetrain->slip_element.empty() || contacts ||
      gear.drivetrain->friction || gear.drivetrain->load_friction)
    report.notes.push_back(
        {.code = "frf.linear",
         .text = "hysteresis and friction are left out, because a frequency response is linear; "
                 "small vibrations are stiffer and more damped than here",
         .path = gear.drivetrain->hysteresis              ? "drivetrain.hysteresis"
                 : !gear.drivetrain->slip_element.empty() ? "drivetrain.slip_element"
                 : contacts                               ? "drivetrain.contact_friction"
                 : gear.drivetrain->friction              ? "drivetrain.friction"
                                                          : "drivetrain.load_friction",
         .equation = "DY-6",
         .severity = Severity::information,
         .next_step = "Run strainwave simulate for a motion with both."});
}

}  // namespace

std::string_view unit_of(DriveResponse response) {
  return response == DriveResponse::error_given_torque ||
                 response == DriveResponse::error_given_speed
             ? "1"
             : "rad/(N*m)";
}

std::optional<double> ExtremumPair::change() const {
  if (!intact || !cracked) return std::nullopt;
  return cracked->frequency / intact->frequency - 1;
}

std::optional<double> ExtremumPair::amplitude_change() const {
  if (!intact || !cracked) return std::nullopt;
  return ratio_less_one(cracked->amplitude, intact->amplitude);
}

const ResponseExtremum* FrfReport::first(DriveResponse response, ExtremumKind kind) const {
  for (const ExtremumPair& pair : extrema) {
    if (pair.response != response || pair.kind != kind) continue;
    const std::optional<ResponseExtremum>& found = cracked ? pair.cracked : pair.intact;
    if (found) return &*found;
  }
  return nullptr;
}

std::optional<double> FrfReport::resonance() const {
  const ResponseExtremum* const at = first(DriveResponse::motor_angle, ExtremumKind::resonance);
  return at != nullptr ? std::optional(at->frequency) : std::nullopt;
}

std::optional<double> FrfReport::antiresonance() const {
  const ResponseExtremum* const at = first(DriveResponse::motor_angle, ExtremumKind::antiresonance);
  return at != nullptr ? std::optional(at->frequency) : std::nullopt;
}

std::optional<double> FrfReport::error_gain() const {
  const ResponseExtremum* const at =
      first(DriveResponse::error_given_speed, ExtremumKind::resonance);
  return at != nullptr ? at->amplitude : std::nullopt;
}

FrfReport frf_report(const GearSet& gear, const FrfOptions& options, const Progress& progress) {
  require(options.points >= 2 && options.points <= kMostFrfPoints, "--points",
          static_cast<double>(options.points), "1", "from 2 to 100000");
  const VibratingStates states = vibrating_states(gear, {.torque = options.torque},
                                                  "the frequency responses", progress.part(0, 0.5));
  FrfReport report;
  report.torque = states.torque;
  report.springs = states.springs;
  report.signed_ratio = signed_ratio(arrangement_of(gear.drivetrain->fixed), gear.drive.ratio);
  report.damped = has_damping(states.intact, MotorGives::torque);
  report.cracked = states.with_cracks.has_value();
  double from = states.intact.modes(MotorGives::speed).front().frequency / kBeyondModes;
  double to = states.intact.modes(MotorGives::torque).front().frequency * kBeyondModes;
  if (options.from) {
    require(*options.from > 0 && std::isfinite(*options.from), "--from", *options.from, "Hz",
            "> 0");
    from = *options.from;
  }
  if (options.to) to = *options.to;
  if (options.to)
    require(to > from && std::isfinite(to), "--to", to, "Hz", "above the first frequency");
  else
    require(to > from, "--from", from, "Hz",
            fmt::format("below the end of the responses, {}; give --to too",
                        shown_quantity(to, "Hz", 4)));
  report.frequency = logarithmic_frequencies(from, to, static_cast<std::size_t>(options.points));
  for (const DriveResponse response : kAllResponses)
    report.curves.push_back({.response = response});
  add_curves(states.intact, false, report);
  if (states.with_cracks) add_curves(*states.with_cracks, true, report);
  progress.at(0.8);
  for (const DriveResponse response : kAllResponses)
    add_extrema(response, extrema_of(states.intact, response, from, to),
                states.with_cracks ? extrema_of(*states.with_cracks, response, from, to)
                                   : std::vector<ResponseExtremum>(),
                report);
  report.notes = states.notes;
  note_losses(gear, has_damping(states.intact, MotorGives::speed), report);
  report.equations = {"DY-1", "DY-6", "DY-7", "DY-9", "DY-10", "DY-12", "DY-13"};
  return report;
}

}  // namespace strainwave
