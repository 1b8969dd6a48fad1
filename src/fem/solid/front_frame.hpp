// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "space.hpp"

/// @file
/// What the integrals along a crack front share: its cells, its frame, the fields of a crack tip,
/// and points on faces.

namespace strainwave::fem::solid {

/// Displacement gradient of one mode with K = 1 at a crack tip, in plane strain; (FE-24).
/// @param mode  0, 1, 2 for I, II, III
/// @param side  side of the crack, which distinguishes +180 from -180 degrees near its faces
[[nodiscard]] Tensor2 crack_tip_gradient(std::size_t mode, double x1, double x2, int side,
                                         double nu, double mu);

/// The front's frame and place at one point.
struct FrontFrame {
  Point<3> place;
  Tensor2 axes;    ///< rows x1, x2, x3
  double rate;     ///< area swept per length of front and unit of `advance`
  double stretch;  ///< length of front per unit of w
};

[[nodiscard]] FrontFrame front_frame(const HexCell& tip, double w);

/// Gradient of the field of a mode with K = 1 at a place of a cell at the front.
[[nodiscard]] Tensor2 auxiliary_gradient(const Space& space, std::size_t mode,
                                         const FrontFrame& frame, const Point<3>& place,
                                         const HexCell& cell);

/// Quadratic shape functions on [0,1] with nodes 0, 1/2, 1.
[[nodiscard]] std::array<double, 3> quadratic(double w);

/// The cells about one front.
struct Front {
  std::size_t number;
  std::map<std::size_t, const HexCell*> tips;  ///< one cell at the front of each segment
  std::size_t rings = 0;

  Front(const HexMesh& mesh, std::size_t n) : number(n) {
    for (const HexCell& cell : mesh.cells)
      if (cell.front && cell.front->front == number) {
        if (cell.front->ring < 0) tips[cell.front->segment] = &cell;
        rings = std::max(rings, static_cast<std::size_t>(cell.front->ring + 1));
      }
  }
  [[nodiscard]] std::size_t nodes() const { return 2 * tips.size() + 1; }

  /// Radii of the rings in the middle of the front [m].
  [[nodiscard]] std::vector<double> radii(const HexMesh& mesh) const {
    std::vector<double> radius(rings);
    for (const HexCell& cell : mesh.cells) {
      if (!cell.front || cell.front->front != number || cell.front->ring < 0) continue;
      const std::size_t segment = cell.front->segment;
      if (2 * segment + 1 >= tips.size() && 2 * segment <= tips.size())
        radius[static_cast<std::size_t>(cell.front->ring)] =
            to_point(cell.map({1, 0.5, 0.5})).distance(front_frame(*tips.at(segment), 0.5).place);
    }
    return radius;
  }
};

/// The rate of area that each node of a front represents, and between two nodes.
///
/// The rate is distributed by the shape functions of G, that is, consistently and not lumped.
class FrontMass {
 public:
  explicit FrontMass(const Front& front) {
    const auto size = static_cast<Eigen::Index>(front.nodes());
    mass_ = Eigen::MatrixXd::Zero(size, size);
    const dealii::QGauss<1> rule(6);
    for (const auto& [segment, tip] : front.tips)
      for (unsigned q = 0; q < rule.size(); ++q) {
        const double w = rule.point(q)[0];
        const FrontFrame frame = front_frame(*tip, w);
        const double ds = rule.weight(q) * frame.stretch;
        length_ += ds;
        const std::array<double, 3> shape = quadratic(w);
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j)
            mass_(static_cast<Eigen::Index>(2 * segment + i),
                  static_cast<Eigen::Index>(2 * segment + j)) +=
                shape[i] * shape[j] * frame.rate * ds;
      }
    solver_.compute(mass_);
  }

  /// Values at the nodes of what has these integrals with their shape functions.
  [[nodiscard]] Eigen::MatrixXd values(const Eigen::MatrixXd& integrals) const {
    return solver_.solve(integrals);
  }
  [[nodiscard]] Eigen::VectorXd area() const { return mass_.rowwise().sum(); }
  [[nodiscard]] double length() const { return length_; }  ///< length of the front [m]

 private:
  Eigen::MatrixXd mass_;
  Eigen::LDLT<Eigen::MatrixXd> solver_;
  double length_ = 0;
};

/// Values on a face of a cell.
struct FaceRule {
  dealii::Quadrature<2> points;
  dealii::FEFaceValues<3> values;    ///< values of the displacements
  dealii::FEFaceValues<3> velocity;  ///< values of the virtual crack advance

  FaceRule(const dealii::Mapping<3>& mapping, const dealii::FE_Q<3>& displacements,
           const dealii::FE_Q<3>& advance, const dealii::Quadrature<2>& at)
      : points(at),
        values(mapping, displacements, at,
               dealii::update_values | dealii::update_gradients | dealii::update_JxW_values |
                   dealii::update_quadrature_points | dealii::update_normal_vectors),
        velocity(mapping, advance, at, dealii::update_values) {}
};

/// The rules for all faces of the cells about a front.
class FaceRules {
 public:
  /// @param advance  element of the virtual crack advance
  FaceRules(const Space& space, const dealii::FE_Q<3>& advance);

  /// The rule of a face, evaluated at this cell.
  [[nodiscard]] FaceRule& at(const Cell& cell, unsigned f, const HexCell& origin);
  /// Position along the front of point q of a face.
  [[nodiscard]] static double along(const FaceRule& rule, unsigned f, unsigned q);

 private:
  const Space& space_;
  /// plain; on the crack's faces at its front: u = 0 has the coordinates (v, w), v = 0 has (w, u)
  std::array<std::unique_ptr<FaceRule>, 3> rules_;
};

/// The interaction integral is exact in the limit of a small ring, so a line through two rings,
/// kNear and kFar, is extrapolated.
inline constexpr std::size_t kNear = 1;
inline constexpr std::size_t kFar = 2;
/// Share of the farther ring in the extrapolated value; < 0 [-].
[[nodiscard]] inline double far_share(const std::vector<double>& radius) {
  return -radius[kNear] / (radius[kFar] - radius[kNear]);
}

/// K over the interaction integrals of the three modes [Pa].
[[nodiscard]] std::array<double, 3> interaction_moduli(const Space& space);

}  // namespace strainwave::fem::solid
