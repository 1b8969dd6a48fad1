// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <variant>
#include <vector>

/// @file
/// Torsional springs of a drive: the twist without cracks and without memory.
///
/// A spring is odd and stiffens or keeps its stiffness.  A crack adds a compliance in series, which
/// each spring takes as an argument, so that torque, energy and corners belong together.

namespace strainwave {

/// Torque of a spring in series with a compliance, and its share of the twist.
struct SpringState {
  double torque = 0.0;  ///< T [N*m]
  double twist = 0.0;   ///< psi of the spring alone; the compliance takes T times itself [rad]
};

/// T = K psi.
struct LinearSpring {
  double stiffness = 0.0;  ///< K [N*m/rad]; > 0

  /// Torque of the spring with a compliance in series.
  /// @param twist       phi of both [rad]
  /// @param compliance  [rad/(N*m)]; >= 0
  [[nodiscard]] SpringState in_series(double twist, double compliance) const;
  [[nodiscard]] double twist(double torque) const;      ///< psi [rad]
  [[nodiscard]] double energy(double twist) const;      ///< integral of the torque [J]
  [[nodiscard]] double tangent(double twist) const;     ///< dT/dpsi [N*m/rad]
  [[nodiscard]] std::array<double, 0> corners() const;  ///< torques at which the tangent jumps
};

/// The maker's line of three pieces: K1 up to T1, K2 up to T2, K3 beyond (MO-2).
struct CatalogueSpring {
  std::array<double, 3> stiffness{};  ///< K1, K2, K3 [N*m/rad]; > 0
  std::array<double, 2> torque{};     ///< T1, T2 [N*m]; 0 < T1 < T2

  /// See LinearSpring::in_series.
  [[nodiscard]] SpringState in_series(double twist, double compliance) const;
  [[nodiscard]] double twist(double torque) const;   ///< psi [rad]
  [[nodiscard]] double energy(double twist) const;   ///< integral of the torque over psi [J]
  [[nodiscard]] double tangent(double twist) const;  ///< dT/dpsi [N*m/rad]
  /// T1 and T2, at whose magnitudes the tangent jumps [N*m].
  [[nodiscard]] const std::array<double, 2>& corners() const { return torque; }
};

/// T = K psi + K_3 psi^3 (MO-3).
struct CubicSpring {
  double stiffness = 0.0;  ///< K [N*m/rad]; > 0
  double cubic = 0.0;      ///< K_3 [N*m/rad^3]; >= 0

  /// See LinearSpring::in_series.
  [[nodiscard]] SpringState in_series(double twist, double compliance) const;
  [[nodiscard]] double twist(double torque) const;      ///< psi [rad]
  [[nodiscard]] double energy(double twist) const;      ///< integral of the torque over psi [J]
  [[nodiscard]] double tangent(double twist) const;     ///< dT/dpsi [N*m/rad]
  [[nodiscard]] std::array<double, 0> corners() const;  ///< the tangent jumps nowhere
};

/// A spring of one of the three kinds.
using Spring = std::variant<LinearSpring, CatalogueSpring, CubicSpring>;

/// Torque at a twist of the spring and a compliance together (MO-1).
/// @param spring      with constants in their range (require_constants)
/// @param twist       phi [rad]
/// @param compliance  Lambda of the open cracks in series [rad/(N*m)]; >= 0
[[nodiscard]] SpringState in_series(const Spring& spring, double twist, double compliance);
/// Twist psi of the spring alone at a torque [rad].
[[nodiscard]] double spring_twist(const Spring& spring, double torque);
/// Elastic energy of the spring alone [J]; `twist` is psi.
[[nodiscard]] double elastic_energy(const Spring& spring, double twist);
/// dT/dpsi of the spring alone [N*m/rad].
[[nodiscard]] double tangent_stiffness(const Spring& spring, double twist);
/// Magnitudes of the torques at which the tangent jumps [N*m].
[[nodiscard]] std::vector<double> corner_torques(const Spring& spring);

/// Throws InputError, which names the constant, unless each constant is in its range.
void require_constants(const Spring& spring);

}  // namespace strainwave
