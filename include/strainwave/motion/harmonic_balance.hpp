// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <complex>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/core/progress.hpp"
#include "strainwave/motion/joint.hpp"

/// @file
/// Periodic motions of a joint by harmonic balance: its frequency over the amplitude, and its
/// response to a harmonic torque, with folds and stability.
///
/// The only nonlinear element is between the two ends, so the unknowns are the harmonics of the
/// twist.  The joint works about a constant load torque, without mean speed.  The kinematic error,
/// gravity, the friction of the input and the profiles of a joint do not enter; a crack that opens
/// over an angle has its mean opening (MO-15).  Slip elements have their periodic state (MO-47),
/// and a table is that of an input at the angle 0 (MO-28).

namespace strainwave {

/// What the input of a vibrating joint may do.
enum class VibratingInput {
  free,    ///< the motor gives its mean torque, and its inertia vibrates
  locked,  ///< the motor keeps its speed, and its inertia does not vibrate
};
template <>
struct EnumNames<VibratingInput> {
  static constexpr std::array<std::string_view, 2> names = {"free", "locked"};
};

/// The end of a joint on which a torque acts.
enum class JointEnd { motor, load };
template <>
struct EnumNames<JointEnd> {
  static constexpr std::array<std::string_view, 2> names = {"motor", "load"};
};

/// What all periodic motions of a joint have in common.
struct BalanceSettings {
  VibratingInput input = VibratingInput::free;  ///< whether the input vibrates too
  double load_torque = 0.0;                     ///< T_0, constant torque on the output [N*m]
  int harmonics = 9;                            ///< H of the twist [-]; 1 to 200
};

/// Which free vibration a backbone describes.
enum class BackboneKind {
  undamped,    ///< without damping, hysteresis and excitation (MO-16)
  quadrature,  ///< with both, where the twist is a quarter of a period behind the torque (MO-17)
};
template <>
struct EnumNames<BackboneKind> {
  static constexpr std::array<std::string_view, 2> names = {"undamped", "quadrature"};
};

/// What `backbone` is asked for.
struct BackboneSettings {
  BalanceSettings balance = {};                ///< input, load torque and number of harmonics
  BackboneKind kind = BackboneKind::undamped;  ///< without losses and excitation, or with both
  JointEnd excited = JointEnd::load;           ///< where `excitation` of a quadrature acts
  /// half of the range of the twist [rad]; > 0 and rising
  std::vector<double> amplitudes = {};
};

/// A vibration of a backbone.
struct BackbonePoint {
  double amplitude = 0.0;      ///< half of the range of the twist [rad]
  double frequency = 0.0;      ///< f [Hz]
  double mean_twist = 0.0;     ///< [rad]
  double torque = 0.0;         ///< half of the range of spring and hysteresis [N*m]
  double damping_ratio = 0.0;  ///< equivalent zeta (MO-17); 0 for an undamped vibration [-]
  /// amplitude of the torque that keeps the vibration, at the excited end [N*m]; 0 if undamped
  double excitation = 0.0;
  double truncation = 0.0;  ///< share of the last two harmonics in the energy (MO-15) [-]
  /// harmonics of the twist: mean, then cosine and sine of each [rad]
  std::vector<double> twist = {};
};

/// Frequencies over the amplitude, and their evidence.
struct Backbone {
  bool converged = false;                  ///< whether there is a point for each amplitude
  std::string reason = {};                 ///< why it did not converge; empty if it did
  std::vector<BackbonePoint> points = {};  ///< in the order of the amplitudes
};

/// Frequency of a joint over the amplitude of its twist, by continuation in the amplitude.
///
/// Implements theory manual eqs. (MO-15) to (MO-17).  A curve that cannot be finished has
/// `converged` false, the reason, and the points before.
/// @throws InputError  if a number is out of range, a locked input is excited at the motor, or the
///                     spring cannot bear the load torque
/// @throws Stopped     if the caller requests a stop
[[nodiscard]] Backbone backbone(const Joint& joint, const BackboneSettings& settings,
                                const Progress& progress = {});

/// What `forced_response` is asked for.
struct ResponseSettings {
  BalanceSettings balance = {};       ///< input, load torque and number of harmonics
  JointEnd excited = JointEnd::load;  ///< where the torque acts; motor: a free input only
  double excitation = 0.0;            ///< amplitude of the torque at the excited end [N*m]; > 0
  double from = 0.0;                  ///< frequency at which the curve begins [Hz]; > 0
  double to = 0.0;                    ///< frequency at which the curve ends [Hz]; > from
  int most_points = 4000;             ///< without an end after this number of points [-]; >= 2
  double largest_step = 0.1;          ///< of the relative length of the curve [-]; > 0
};

/// A periodic response to a harmonic torque.
struct ResponsePoint {
  double frequency = 0.0;   ///< f [Hz]
  double amplitude = 0.0;   ///< half of the range of the twist [rad]
  double mean_twist = 0.0;  ///< [rad]
  double torque = 0.0;      ///< half of the range of spring and hysteresis [N*m]
  double output = 0.0;      ///< amplitude of the first harmonic of theta_L [rad]
  double lag = 0.0;         ///< of the first harmonic of theta_L behind the torque, -pi to pi [rad]
  double truncation = 0.0;  ///< share of the last two harmonics in the energy [-]
  double multiplier = 0.0;  ///< largest magnitude of the Floquet multipliers (MO-19) [-]
  bool stable = false;      ///< multiplier <= 1 + 1e-6
  /// Floquet multipliers, by falling magnitude [-]
  std::vector<std::complex<double>> multipliers = {};
  /// harmonics of the twist: mean, then cosine and sine of each [rad].  The excitation is a cosine
  std::vector<double> twist = {};
};

/// A point of a curve at which the frequency turns back: the response jumps there (MO-18).
struct Fold {
  double frequency = 0.0;  ///< [Hz]
  double amplitude = 0.0;  ///< half of the range of the twist [rad]
  /// whether the response jumps there while the frequency rises; else while it falls
  bool rising = false;
};

/// A point of a curve at which the amplitude is the largest among its neighbours (MO-18).
struct Peak {
  double frequency = 0.0;  ///< [Hz]
  double amplitude = 0.0;  ///< half of the range of the twist [rad]
  double torque = 0.0;     ///< half of the range of spring and hysteresis [N*m]
  bool stable = false;     ///< multiplier <= 1 + 1e-6, as of a ResponsePoint
};

/// A curve of responses in the order of its length, and its evidence.
struct ForcedResponse {
  bool converged = false;                  ///< whether the curve reaches its last frequency
  std::string reason = {};                 ///< why the curve has no end; empty if it has one
  std::vector<ResponsePoint> points = {};  ///< along the curve; the frequency may fall
  std::vector<Fold> folds = {};            ///< along the curve, within the range of frequencies
  std::vector<Peak> peaks = {};            ///< likewise
};

/// Response of a joint to a harmonic torque over the frequency, by continuation along the curve.
///
/// Implements theory manual eqs. (MO-15), (MO-18) and (MO-19).  The curve begins at the response
/// at `from` that grows out of rest with the excitation, and contains what is connected with it.
/// Folds are accurate to 1e-9 of the frequency, and peaks to 1e-6 of it.
/// @throws InputError  as `backbone`
/// @throws Stopped     if the caller requests a stop
[[nodiscard]] ForcedResponse forced_response(const Joint& joint, const ResponseSettings& settings,
                                             const Progress& progress = {});

/// State of a joint on a periodic response while the exciting cosine is 1, with the motor at the
/// angle 0 and without mean speed: a start for `simulate`.
[[nodiscard]] JointState state_on_response(const Joint& joint, const ResponseSettings& settings,
                                           const ResponsePoint& point);

/// Frequency of small vibrations about the load torque, with the hysteresis at rest as a spring of
/// its stiffness and without damping [Hz].  Without a load torque, cracks that open under one sense
/// are open for a part of each period.
[[nodiscard]] double small_frequency(const Joint& joint, const BalanceSettings& settings);

/// Frequency of a vibration whose spring has one stiffness for each sense of the torque (MO-16).
/// @param one    frequency with the stiffness of one sense [Hz]; > 0
/// @param other  the same of the other sense [Hz]; > 0
[[nodiscard]] double bilinear_frequency(double one, double other);

/// Twist of the spring and the open cracks under the load torque alone [rad].
[[nodiscard]] double twist_at_rest(const Joint& joint, double load_torque);

}  // namespace strainwave
