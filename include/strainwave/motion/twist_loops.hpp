// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

/// @file
/// Hysteresis of the twist by friction in the contacts of a drive, in series with its spring.

namespace strainwave {

/// What the contacts of a drive remember of the path of their torque.
struct LoopMemory {
  /// Play elements with a threshold above 0 (MO-52).
  static constexpr std::size_t kElements = 16;

  double torque = 0.0;       ///< elastic torque at which the memory was taken [N*m]
  double width = 0.0;        ///< w there [rad]
  double input_angle = 0.0;  ///< theta_m there [rad]
  /// q_k, twist of each element beyond that without friction [rad]
  std::array<double, kElements> play{};

  friend bool operator==(const LoopMemory&, const LoopMemory&) = default;
};

/// Twist that friction in flanks and bearing adds to the twist of a spring (MO-52, MO-53).
///
/// Play elements between the envelopes of the torsion curve: the loops of (TC-17), as a function of
/// the elastic torque.  While the input stands, the path of the torque alone decides.  While the
/// input turns, each pair of teeth leaves the mesh and begins anew, so the twist fades to the
/// middle of the envelopes.  The object is immutable, and any number of threads may use it.
class TwistLoops {
 public:
  /// @param torques  [N*m]; at least 4, rising, the first negative and the last positive
  /// @param widths   w, distance of the envelopes at each torque [rad]; >= 0; as many
  /// @param fading   1/Theta: share of the memory that is lost per angle of the input [1/rad];
  ///                 >= 0; 0: pairs of teeth stay in the mesh
  /// @throws InputError  if a number is out of range
  TwistLoops(const std::vector<double>& torques, const std::vector<double>& widths, double fading);
  ~TwistLoops();
  TwistLoops(TwistLoops&&) noexcept;
  TwistLoops& operator=(TwistLoops&&) noexcept;
  TwistLoops(const TwistLoops&) = delete;
  TwistLoops& operator=(const TwistLoops&) = delete;

  /// Distance of the envelopes [rad]; beyond the last torques it is constant.
  [[nodiscard]] double width(double torque) const;
  [[nodiscard]] double fading() const { return fading_; }
  /// Largest |q_k| of an element at a torque [rad].
  [[nodiscard]] double bound(std::size_t element, double torque) const;

  /// A change of the state since a memory was taken, in which the torque goes to one side only and
  /// the input too.
  struct Change {
    double torque = 0.0;      ///< T at its end [N*m]
    double slide = 0.0;       ///< psi(T) - psi(T_0), change of the spring's twist [rad]
    double compliance = 0.0;  ///< d psi/dT at its end [rad/(N*m)]
    double turn = 0.0;        ///< |theta_m - theta_m0| [rad]
    /// rates at its end, which say whether an element at its bound stays there
    double slide_rate = 0.0;  ///< of the slide [rad/s]
    double turn_rate = 0.0;   ///< |w_m| [rad/s]
    /// whether the change ends before an element between its bounds meets one: within a step of a
    /// motion, whose rates are then smooth
    bool before_slip = false;
  };
  /// The twist of the loops and its derivatives.
  struct At {
    double twist = 0.0;       ///< h, mean of q_k [rad]
    double compliance = 0.0;  ///< dh/dT, with the slide that belongs to it [rad/(N*m)]
    double by_slide = 0.0;    ///< dh/d slide at constant torque [-]
    double by_turn = 0.0;     ///< dh/d turn at constant torque [-]
    /// largest |q_k| over its bound of the elements that were between their bounds [rad]
    double margin = -1.0;
    bool on_edge = false;  ///< whether an element is just at its bound, where the rates decide
  };
  [[nodiscard]] At at(const LoopMemory& memory, const Change& change) const;
  /// The memory after a change (MO-52).
  /// @param input_angle  theta_m [rad]
  [[nodiscard]] LoopMemory after(const LoopMemory& memory, const Change& change,
                                 double input_angle) const;
  /// The memory of contacts that have no friction yet.
  /// @param torque  T [N*m]; @param input_angle  theta_m [rad]
  [[nodiscard]] LoopMemory relaxed(double torque, double input_angle) const;

 private:
  struct Width;
  std::unique_ptr<const Width> width_;
  double fading_ = 0.0;
};

}  // namespace strainwave
