// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

/// @file
/// Hysteresis of the twist by friction in the contacts of a drive, in series with its spring.

namespace strainwave {

/// What the contacts of a drive remember of the path of their torque.
struct LoopMemory {
  /// Play elements with a threshold above 0 (MO-52).
  static constexpr std::size_t kElements = 16;

  double torque = 0.0;       ///< elastic torque at which the memory was taken [N*m]
  double input_angle = 0.0;  ///< theta_m there [rad]
  /// q_k, twist of each element beyond that without friction [rad]
  std::array<double, kElements> play{};
  /// +1 or -1: the element stays at this bound; 0: it moves between its bounds
  std::array<double, kElements> side{};

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

  /// Distance of the envelopes.
  struct Width {
    double value = 0.0;  ///< w [rad]; beyond the last torques it is constant
    double slope = 0.0;  ///< dw/dT [rad/(N*m)]
  };
  /// At a torque [N*m].
  [[nodiscard]] Width width(double torque) const { return width_near(torque).at(torque); }
  /// The width over a range of the torque, for a method that asks many torques near each other.
  struct WidthPiece {
    double least = 0.0;         ///< torque from which on it holds [N*m]
    double most = 0.0;          ///< torque below which it holds [N*m]
    double from = 0.0;          ///< [N*m]
    std::array<double, 4> a{};  ///< w = sum_j a[j] (T - from)^j
    /// The width at a torque T that the piece contains [N*m].
    [[nodiscard]] Width at(double torque) const {
      const double t = torque - from;
      return {.value = a[0] + t * (a[1] + t * (a[2] + t * a[3])),
              .slope = a[1] + t * (2 * a[2] + t * 3 * a[3])};
    }
    /// Whether the piece holds at a torque T: least <= T < most [N*m].
    [[nodiscard]] bool contains(double torque) const { return torque >= least && torque < most; }
  };
  /// The piece that contains a torque [N*m].
  [[nodiscard]] const WidthPiece& width_near(double torque) const;
  /// 1/Theta of the constructor [1/rad].
  [[nodiscard]] double fading() const { return fading_; }
  /// Largest |q_k| of an element at a torque [rad].
  [[nodiscard]] double bound(std::size_t element, double torque) const;

  /// What happened since a memory was taken.
  struct Path {
    double slide = 0.0;  ///< S, what is left of the change of the spring's twist (MO-53) [rad]
    double turn = 0.0;   ///< |theta_m - theta_m0| [rad]
  };
  /// The twist h = free_twist + held w(T) of the loops while no element meets or leaves a bound.
  struct At {
    double free_weight = 0.0;  ///< of the elements between their bounds: -dh/dS [-]
    double free_twist = 0.0;   ///< their part of h, which fades [rad]
    double held = 0.0;         ///< part of the elements that stay at a bound, over w [-]
    /// h at the width of the present torque [rad].
    [[nodiscard]] double twist(const Width& w) const { return free_twist + held * w.value; }
  };
  /// The twist of the loops after a path from the memory (MO-52, MO-53).
  [[nodiscard]] At at(const LoopMemory& memory, const Path& path) const;
  /// Largest |q_k| less its bound of the elements that move between their bounds [rad]; -w if
  /// there is none.
  [[nodiscard]] double margin(const LoopMemory& memory, const Path& path, double torque) const;

  /// The memory after a path.
  /// @param memory       where the path begins
  /// @param path         from there on
  /// @param torque       T at the end [N*m]
  /// @param input_angle  theta_m there [rad]
  [[nodiscard]] LoopMemory after(const LoopMemory& memory, const Path& path, double torque,
                                 double input_angle) const;
  /// How a state goes on.
  struct Rates {
    double torque = 0.0;  ///< dT/dt [N*m/s]; its sign counts even if it is tiny
    double slide = 0.0;   ///< d psi/dT times dT/dt [rad/s]
    double turn = 0.0;    ///< |w_m| [rad/s]
  };
  /// By how much an element at a bound would move outward faster than this bound; the least of all
  /// that stay there, but at most 1 [rad/s]; 1 if there is none.
  /// @param memory  of this state
  /// @param rates   of this state
  /// @param torque  T [N*m]
  [[nodiscard]] double hold_margin(const LoopMemory& memory, const Rates& rates,
                                   double torque) const;
  /// The step that led to a memory.
  struct Step {
    double torque = 0.0;  ///< T at its beginning [N*m]
    Rates rates;          ///< there
    double length = 0.0;  ///< [s]
  };
  /// Decides which elements within a distance of their bound stay there, and moves the others out
  /// of this distance.
  /// @param memory  taken at this state; receives the elements as decided
  /// @param rates   with which this state goes on
  /// @param within  this distance [rad]; > 0
  /// @param step    in which elements may have left their bound already; absent: none did
  /// @return whether an element changed
  [[nodiscard]] bool hold(LoopMemory& memory, const Rates& rates, double within,
                          const std::optional<Step>& step) const;
  /// The memory of contacts that have no friction yet.
  /// @param torque  T [N*m]; @param input_angle  theta_m [rad]
  [[nodiscard]] LoopMemory relaxed(double torque, double input_angle) const;

 private:
  /// Share of the memory that has not faded [-].
  [[nodiscard]] double left_of(const Path& path) const;
  /// By how much an element at a bound would move outward faster than this bound [rad/s].
  [[nodiscard]] double outward(std::size_t element, double side, const Rates& rates,
                               const Width& w) const;

  std::vector<double> torques_;
  std::vector<WidthPiece> pieces_;  ///< the first and the last are constant
  double fading_ = 0.0;
};

}  // namespace strainwave
