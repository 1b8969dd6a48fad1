// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

/// @file
/// Restoring torque of a drive from one tabulated energy, which depends on the torque and on the
/// angle of the input.

namespace strainwave {

/// Complementary energy over torque and one angle, at the points of a grid.
///
/// The angle alpha is `rate` times the angle of the input.  The points of the angle are even over
/// the period and begin at alpha = 0.
struct EnergySamples {
  double rate = 0.0;               ///< d alpha/d theta_m [-]; finite
  double period = 0.0;             ///< of alpha [rad]; > 0
  std::vector<double> energy;      ///< W at the first positive torque, one per angle [J]
  std::vector<double> twist;       ///< dW/dT by angle, then by torque [rad]
  std::vector<double> compliance;  ///< d2W/dT2, in the same order [rad/(N*m)]

  /// Number of angles over the period [-].
  [[nodiscard]] std::size_t angles() const { return energy.size(); }
};

/// Compliances d2W/dT2 at the points of one curve, so that the cubic pieces between them join with
/// a continuous third derivative of W where the curve rises evenly, and rise everywhere if the
/// points do (MO-26).
/// @param torques  [N*m]; at least 3, rising
/// @param twist    [rad]; as many
[[nodiscard]] std::vector<double> rising_slopes(const std::vector<double>& torques,
                                                const std::vector<double>& twist);

/// Complementary energy W(T, theta_m) of a drive: the sum of families of one angle each (MO-25).
///
/// Twist, compliance and the torque on the input are derivatives of one function, which is
/// piecewise polynomial (MO-26).  Beyond the last torques the compliance is constant.  The object
/// is immutable, and any number of threads may use it.
class EnergyTable {
 public:
  /// Largest number of families [-].
  static constexpr std::size_t kMostFamilies = 4;

  /// @param torques     [N*m]; at least 3, rising, the first negative and the last positive
  /// @param families    from 1 to kMostFamilies
  /// @param compliance  in series with all [rad/(N*m)]; >= 0
  /// @throws InputError   if a number is out of range
  /// @throws SolverError  if the twist does not rise with the torque at every angle
  EnergyTable(std::vector<double> torques, const std::vector<EnergySamples>& families,
              double compliance);

  /// Torques of the grid, rising [N*m].
  [[nodiscard]] const std::vector<double>& torques() const { return torques_; }
  /// The first torque of the grid, < 0 [N*m].
  [[nodiscard]] double least_torque() const { return torques_.front(); }
  /// The last torque of the grid, > 0 [N*m].
  [[nodiscard]] double most_torque() const { return torques_.back(); }
  /// In series with all families [rad/(N*m)].
  [[nodiscard]] double compliance() const { return compliance_; }
  /// Points of the angles in one turn of the input, of the family that has most [-].
  [[nodiscard]] double points_per_turn() const { return points_per_turn_; }

  /// The state at a torque or at a twist.
  struct At {
    double torque = 0.0;          ///< T [N*m]
    double twist = 0.0;           ///< phi = dW/dT [rad]
    double compliance = 0.0;      ///< d2W/dT2 [rad/(N*m)]
    double energy = 0.0;          ///< W [J]
    double by_input = 0.0;        ///< dW/d theta_m at constant torque [N*m]
    double twist_by_input = 0.0;  ///< d phi/d theta_m at constant torque [-]
  };

  /// The energy at one angle of the input, for any torque.
  class Slice {
   public:
    /// @param torque    T [N*m]
    /// @param in_series  more compliance in series, of open cracks [rad/(N*m)]
    [[nodiscard]] At at_torque(double torque, double in_series = 0.0) const;
    /// The torque at a twist [rad], by Newton's method in a bracket.
    [[nodiscard]] At at_twist(double twist, double in_series = 0.0) const;
    /// Twist without torque [rad].
    [[nodiscard]] double rest() const { return at_torque(0.0).twist; }

    /// W = sum_j a[j] t^j above the torque `from`, and its derivative by the input's angle.
    struct Piece {
      double from = 0.0;                 ///< [N*m]
      double least = 0.0;                ///< torque from which on it holds [N*m]
      double most = 0.0;                 ///< torque below which it holds [N*m]
      std::array<double, 5> a{};         ///< of W; t = T - from [J/(N*m)^j]
      std::array<double, 5> by_input{};  ///< of dW/d theta_m, over the same t [J/(N*m)^j]
      /// The state at a torque T that the piece contains [N*m].
      [[nodiscard]] At at(double torque) const;
      /// Whether the piece holds at a torque T: least <= T < most [N*m].
      [[nodiscard]] bool contains(double torque) const { return torque >= least && torque < most; }
    };
    /// The piece that contains a torque, for a method that asks many torques near each other.
    [[nodiscard]] Piece piece_at(double torque, double in_series = 0.0) const;

   private:
    friend class EnergyTable;
    [[nodiscard]] Piece piece(std::size_t interval, double in_series) const;
    [[nodiscard]] double twist_at_node(std::size_t node, double in_series) const;

    const EnergyTable* table_ = nullptr;
    std::array<std::size_t, kMostFamilies> cell_{};
    std::array<double, kMostFamilies> in_cell_{};
  };
  /// @param input_angle  theta_m [rad]
  [[nodiscard]] Slice at(double input_angle) const;
  /// The same with the angles of all families given, in their order [rad].
  [[nodiscard]] Slice at_angles(const std::array<double, kMostFamilies>& angles) const;

 private:
  /// Coefficients of one cell, by power of the torque, then by power of the angle.
  using Cell = std::array<std::array<double, 4>, 5>;
  struct Family {
    double rate = 0.0;
    double step = 0.0;  ///< between two points of the angle [rad]
    std::size_t angles = 0;
    /// by interval of the torque, then by interval of the angle; the first and the last interval
    /// of the torque lie beyond the table
    std::vector<Cell> cells;
  };

  [[nodiscard]] Family family_of(const EnergySamples& samples) const;
  void require_rising() const;

  std::vector<double> torques_;
  std::vector<Family> families_;
  double compliance_ = 0.0;
  double points_per_turn_ = 0.0;
};

}  // namespace strainwave
