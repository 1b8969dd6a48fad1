// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <optional>
#include <vector>

#include "strainwave/motion/breathing_crack.hpp"
#include "strainwave/motion/energy_table.hpp"
#include "strainwave/motion/losses.hpp"
#include "strainwave/motion/spring.hpp"

/// @file
/// Torque of spring, cracks and hysteresis over one period of a given twist.

namespace strainwave {

/// Elastic torque over the twist, with the cracks that open by the sense of the torque.
class ElasticCurve {
 public:
  /// Cracks that open over an angle have their mean opening.
  ElasticCurve(const Spring& spring, const std::vector<BreathingCrack>& cracks);
  /// The curve of a table at one angle of the input, in place of a spring (MO-28).
  ElasticCurve(const EnergyTable::Slice& slice, const std::vector<double>& torques,
               const std::vector<BreathingCrack>& cracks);

  struct At {
    double torque = 0.0;   ///< [N*m]
    double tangent = 0.0;  ///< dT/dphi [N*m/rad]
  };
  [[nodiscard]] At at(double twist) const;
  /// Tangents on both sides of a torque; they differ at 0 if the cracks open under one sense.
  struct Sides {
    double below = 0.0;  ///< [N*m/rad]
    double above = 0.0;  ///< [N*m/rad]
  };
  [[nodiscard]] Sides tangents_under(double torque) const;
  /// The twist under a torque [rad].
  [[nodiscard]] double twist_under(double torque) const;
  /// Twists at which the tangent or its slope jumps, rising [rad].
  [[nodiscard]] const std::vector<double>& corners() const { return corners_; }

 private:
  /// An end of the cubic pieces of the twist over the torque.
  struct Node {
    double torque = 0.0;  ///< [N*m]
    double twist = 0.0;   ///< [rad]
    double below = 0.0;   ///< compliance of the piece below [rad/(N*m)]
    double above = 0.0;   ///< the same of the piece above [rad/(N*m)]
  };
  void take_cracks(const std::vector<BreathingCrack>& cracks);
  [[nodiscard]] At on_nodes(double twist) const;

  Spring spring_;
  std::vector<Node> nodes_;  ///< of a table, rising; empty for a spring
  double forward_ = 0.0;     ///< compliance of the cracks that are open under positive torque
  double backward_ = 0.0;    ///< the same under negative torque
  std::vector<double> corners_;
};

/// A periodic twist as a Fourier series over the angle tau of the period.
///
/// The coefficients are the mean, then cosine and sine of each harmonic; those of an even series
/// are the mean and the cosines.
struct TwistSeries {
  const Eigen::VectorXd& coefficients;
  bool even = false;

  struct At {
    double value = 0.0;      ///< phi [rad]
    double slope = 0.0;      ///< dphi/dtau [rad]
    double curvature = 0.0;  ///< [rad]
  };
  [[nodiscard]] At at(double angle) const;
};

/// A change of the hysteresis torque along a twist that moves to one side.
struct LoopStep {
  double torque = 0.0;     ///< z at the end [N*m]
  double by_torque = 1.0;  ///< derivative of it by z at the beginning [-]
};
/// Exact for n = 1 and n = 2 (MO-8, MO-9), else by steps of the fourth order.
[[nodiscard]] LoopStep loop_after(const BoucWen& model, double torque, double change);
/// dz/dphi while the twist moves to the side of `sense`, +1 or -1 [N*m/rad].
[[nodiscard]] double loop_slope(const BoucWen& model, double torque, double sense);

/// Derivative of `loop_slope` by z [1/rad].
[[nodiscard]] double loop_bend(const BoucWen& model, double torque, double sense);

/// A place of the period at which a piece of the integrals begins.
struct CycleBreak {
  double angle = 0.0;  ///< tau [rad]
  double twist = 0.0;  ///< [rad]
  double loop = 0.0;   ///< z of Bouc and Wen [N*m]
  /// index of the last turn of the twist, counted from the first break [-]
  std::size_t turn = 0;
};

/// The slip elements in a smooth piece of the period (MO-44).
struct SlipPiece {
  double torque = 0.0;     ///< of all elements at the beginning of the piece [N*m]
  double stiffness = 0.0;  ///< of those that stick in it [N*m/rad]
  /// the same of those that slipped at a turn last, by this turn; behind them that of those that
  /// stick in the whole period [N*m/rad]
  std::vector<double> since;
};

/// Harmonics of the torque over one period, with their derivatives (MO-15).
///
/// The period is cut where the twist turns and where the tangent jumps, so that Gauss' rule
/// integrates smooth pieces.
class TwistCycle {
 public:
  /// @param slip  elements parallel to the spring (MO-44); none for an even series
  TwistCycle(const ElasticCurve& elastic, const std::optional<BoucWen>& loop, int harmonics,
             bool even, std::vector<SlipElement> slip = {});

  /// Computes all that the accessors below return.
  void evaluate(const Eigen::VectorXd& coefficients);

  [[nodiscard]] const Eigen::VectorXd& torque() const { return torque_; }      ///< [N*m]
  [[nodiscard]] const Eigen::MatrixXd& by_twist() const { return by_twist_; }  ///< [N*m/rad]
  [[nodiscard]] double amplitude() const { return amplitude_; }  ///< half range of twist [rad]
  /// Derivative of the half range by the coefficients [-].
  [[nodiscard]] const Eigen::VectorXd& amplitude_slope() const { return amplitude_slope_; }
  [[nodiscard]] double torque_amplitude() const { return torque_amplitude_; }  ///< [N*m]
  /// Ends of the smooth pieces over a whole period, first and last included; empty if the twist
  /// does not move.
  [[nodiscard]] const std::vector<CycleBreak>& breaks() const { return breaks_; }
  /// z at tau = 0 [N*m].
  [[nodiscard]] double loop_at_zero() const;
  /// The slip elements at tau = 0.
  [[nodiscard]] SlipState slip_at_zero() const;
  /// The slip elements in each piece between two breaks; empty without elements.
  [[nodiscard]] const std::vector<SlipPiece>& slip_pieces() const { return slip_pieces_; }
  /// The turn of the largest twist, as `CycleBreak::turn` [-].
  [[nodiscard]] std::size_t highest_turn() const { return highest_turn_; }
  /// How many elements slip at a turn, summed over the turns [-].  Where this number changes, the
  /// derivatives jump.
  [[nodiscard]] int slips() const { return slips_; }

  [[nodiscard]] Eigen::Index size() const { return size_; }

 private:
  struct Node {
    double angle = 0.0;
    double weight = 0.0;  ///< of a mean over the period [-]
    std::size_t piece = 0;
  };
  void find_breaks();
  void add_levels(std::size_t turn, double to);
  void follow_slip();
  void place_slip();
  void place_nodes();
  void close_loop();
  void split_where_loop_is_zero();
  void measure_torque();
  void sum_up();
  void fill_basis();
  [[nodiscard]] Eigen::VectorXd basis(double angle) const;
  [[nodiscard]] std::size_t break_before_zero() const;
  [[nodiscard]] double crossing(double level, double from, double to) const;

  const ElasticCurve& elastic_;
  std::optional<BoucWen> loop_;
  std::vector<SlipElement> slip_;
  int harmonics_ = 0;
  bool even_ = false;
  Eigen::Index size_ = 0;
  Eigen::MatrixXd grid_slopes_;    ///< dphi/dtau on the grid by the coefficients
  Eigen::MatrixXd uniform_basis_;  ///< basis at the evenly spaced nodes
  Eigen::VectorXd x_;
  std::vector<double> turns_;
  std::vector<double> turn_twists_;
  std::size_t lowest_turn_ = 0;
  std::size_t highest_turn_ = 0;
  std::vector<SlipState> slip_at_turns_;
  /// the turn at which each element slipped last, by turn, then by element; the number of turns if
  /// it sticks in the whole period
  std::vector<std::vector<std::size_t>> slipped_at_;
  std::vector<SlipPiece> slip_pieces_;
  int slips_ = 0;
  std::vector<double> levels_;
  std::vector<CycleBreak> breaks_;
  std::vector<Node> nodes_;
  Eigen::MatrixXd basis_;
  Eigen::MatrixXd weighted_;
  Eigen::MatrixXd slopes_;  ///< derivative of the torque at each node by the coefficients
  Eigen::VectorXd at_nodes_;
  Eigen::VectorXd twist_;
  Eigen::VectorXd torque_;
  Eigen::MatrixXd by_twist_;
  double amplitude_ = 0.0;
  Eigen::VectorXd amplitude_slope_;
  double torque_amplitude_ = 0.0;
};

}  // namespace strainwave
