// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "front_frame.hpp"
#include "fronts.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave::fem::solid {
namespace {

constexpr std::size_t kModes = 3;

/// Assembles the interaction integrals of a front as functionals.
///
/// The integral of `evaluate_front`, written as a product with the displacement gradient: with the
/// virtual advance v, g = grad v, the field of a mode e = grad w and its stress s,
///   (e g - e tr g) : sigma(grad u) + (grad u - spin) : s g^T        in the volume,
///   -(grad u - spin) : v (s n)^T - (e v) . t                        on faces with traction t.
class Assembler {
 public:
  Assembler(const Space& space, const Front& front)
      : space_(space),
        front_(front),
        velocity_(4),
        rule_(static_cast<unsigned>(space.problem.order) + 3),
        values_(space.body.mapping, space.scalar, rule_,
                dealii::update_gradients | dealii::update_JxW_values |
                    dealii::update_quadrature_points),
        slopes_(space.body.mapping, velocity_, rule_, dealii::update_gradients),
        faces_(space, velocity_),
        far_share_(far_share(front.radii(space.mesh))) {
    const std::size_t count = kModes * front.nodes();
    displacement_.assign(count, Vector(space.dofs.n_dofs()));
    traction_ = displacement_;
    spin_of_.fill(Vector(space.dofs.n_dofs()));
    on_spin_.assign(3 * count + 1, 0.0);  // and the volume of the cells
  }

  void assemble() {
    for (const Cell& cell : space_.dofs.active_cell_iterators()) {
      const HexCell& origin = space_.source(cell);
      if (!origin.front || origin.front->front != front_.number || !cell->is_locally_owned())
        continue;
      const HexCell& tip = *front_.tips.at(origin.front->segment);
      const std::vector<Index> indices = space_.indices(cell);
      const auto advances = advances_of(origin);
      add_volume(cell, origin, tip, indices, advances);
      for (const unsigned f : cell->face_indices())
        if (cell->face(f)->at_boundary()) add_face(cell, f, origin, tip, indices, advances);
    }
    for (Vector& v : displacement_) sum_over_ranks(v);
    for (Vector& v : traction_) sum_over_ranks(v);
    for (Vector& v : spin_of_) sum_over_ranks(v);
    sum_over_ranks(on_spin_);
    // Insert the mean rotation, which is itself a functional.
    const double volume = on_spin_.back();
    for (std::size_t n = 0; n < displacement_.size(); ++n)
      for (std::size_t k = 0; k < 3; ++k)
        displacement_[n].add(on_spin_[3 * n + k] / volume, spin_of_[k]);
  }

  std::vector<Vector> displacement_;
  std::vector<Vector> traction_;

 private:
  /// The virtual advance for each of a segment's three nodes, at the nodes of its element.
  using Advance = std::vector<Tensor<1, 3>>;
  [[nodiscard]] std::array<Advance, 3> advances_of(const HexCell& origin) const {
    std::array<Advance, 3> advances;
    const auto weight = [&](std::size_t domain, double u) {
      const int ring = origin.front->ring;
      const auto k = static_cast<int>(domain);
      return ring < k ? 1.0 : ring == k ? 1 - u : 0.0;
    };
    for (unsigned n = 0; n < velocity_.n_dofs_per_cell(); ++n) {
      const Point3 unit = to_array(velocity_.unit_support_point(n));
      const double of_rings =
          (1 - far_share_) * weight(kNear, unit[0]) + far_share_ * weight(kFar, unit[0]);
      const Tensor<1, 3> d = to_tensor(origin.front->advance(unit));
      const std::array<double, 3> shape = quadratic(unit[2]);
      for (std::size_t i = 0; i < 3; ++i) advances[i].push_back(of_rings * shape[i] * d);
    }
    return advances;
  }

  [[nodiscard]] std::size_t number(const HexCell& origin, std::size_t i, std::size_t mode) const {
    return kModes * (2 * origin.front->segment + i) + mode;
  }

  /// Adds weight * (factor : grad u) to a functional.
  void add(Vector& to, const Tensor2& factor, double weight, const dealii::FEValuesBase<3>& values,
           unsigned q, const std::vector<Index>& indices) const {
    for (unsigned a = 0; a < space_.scalar.n_dofs_per_cell(); ++a) {
      const Tensor<1, 3> along = factor * values.shape_grad(a, q);
      for (unsigned k = 0; k < 3; ++k) to[indices[space_.node_of[k][a]]] += weight * along[k];
    }
  }

  /// Adds weight * (-factor : spin).
  void add_spin(std::size_t n, const Tensor2& factor, double weight) {
    for (unsigned k = 0; k < 3; ++k) {
      const unsigned i = (k + 1) % 3;
      const unsigned j = (k + 2) % 3;
      on_spin_[3 * n + k] -= weight * (factor[i][j] - factor[j][i]);
    }
  }

  void add_volume(const Cell& cell, const HexCell& origin, const HexCell& tip,
                  const std::vector<Index>& indices, const std::array<Advance, 3>& advances) {
    Space::reinit(values_, cell);
    Space::reinit(slopes_, cell);
    for (unsigned q = 0; q < rule_.size(); ++q) {
      const double weight = values_.JxW(q);
      for (unsigned k = 0; k < 3; ++k) {
        Tensor2 half;
        half[(k + 1) % 3][(k + 2) % 3] = 0.5;
        half[(k + 2) % 3][(k + 1) % 3] = -0.5;
        add(spin_of_[k], half, weight, values_, q, indices);
      }
      on_spin_.back() += weight;
      std::array<Tensor2, 3> slope;
      for (std::size_t i = 0; i < 3; ++i)
        for (unsigned n = 0; n < velocity_.n_dofs_per_cell(); ++n)
          slope[i] += outer_product(advances[i][n], slopes_.shape_grad(n, q));
      const FrontFrame frame = front_frame(tip, rule_.point(q)[2]);
      for (std::size_t mode = 0; mode < kModes; ++mode) {
        const Tensor2 dv =
            auxiliary_gradient(space_, mode, frame, values_.quadrature_point(q), origin);
        const Tensor2 stress = space_.lame.stress(dv);
        for (std::size_t i = 0; i < 3; ++i) {
          if (slope[i].norm() == 0) continue;
          const Tensor2 on_strain = dv * slope[i] - trace(slope[i]) * dv;
          const Tensor2 on_rotated = stress * transpose(slope[i]);
          const std::size_t n = number(origin, i, mode);
          add(displacement_[n],
              space_.lame.stress(0.5 * (on_strain + transpose(on_strain))) + on_rotated, weight,
              values_, q, indices);  // (FE-54)
          add_spin(n, on_rotated, weight);
        }
      }
    }
  }

  void add_face(const Cell& cell, unsigned f, const HexCell& origin, const HexCell& tip,
                const std::vector<Index>& indices, const std::array<Advance, 3>& advances) {
    const bool crack = space_.is_crack_face(cell, f);
    FaceRule& on_face = faces_.at(cell, f, origin);
    const dealii::FEFaceValues<3>& values = on_face.values;
    for (unsigned q = 0; q < on_face.points.size(); ++q) {
      const double weight = -values.JxW(q);
      const Tensor<1, 3>& normal = values.normal_vector(q);
      const FrontFrame frame = front_frame(tip, FaceRules::along(on_face, f, q));
      std::array<Tensor<1, 3>, 3> advance;
      for (std::size_t i = 0; i < 3; ++i)
        for (unsigned n = 0; n < velocity_.n_dofs_per_cell(); ++n)
          advance[i] += on_face.velocity.shape_value(n, q) * advances[i][n];
      for (std::size_t mode = 0; mode < kModes; ++mode) {
        const Tensor2 dv =
            auxiliary_gradient(space_, mode, frame, values.quadrature_point(q), origin);
        const Tensor<1, 3> auxiliary_traction = space_.lame.stress(dv) * normal;
        for (std::size_t i = 0; i < 3; ++i) {
          if (advance[i].norm() == 0) continue;
          const std::size_t n = number(origin, i, mode);
          const Tensor2 on_rotated = outer_product(auxiliary_traction, advance[i]);
          add(displacement_[n], on_rotated, weight, values, q, indices);
          add_spin(n, on_rotated, weight);
          const Tensor<1, 3> on_traction = dv * advance[i];
          if (crack) {
            for (unsigned a = 0; a < space_.scalar.n_dofs_per_cell(); ++a)
              for (unsigned k = 0; k < 3; ++k)
                traction_[n][indices[space_.node_of[k][a]]] +=
                    origin.side * weight * on_traction[k] * values.shape_value(a, q);
          } else {  // the traction of the displacements themselves
            const Tensor2 on_stress = outer_product(on_traction, normal);
            add(displacement_[n], space_.lame.stress(0.5 * (on_stress + transpose(on_stress))),
                weight, values, q, indices);
          }
        }
      }
    }
  }

  const Space& space_;
  const Front& front_;
  dealii::FE_Q<3> velocity_;  ///< of the virtual advance
  dealii::QGauss<3> rule_;
  dealii::FEValues<3> values_;
  dealii::FEValues<3> slopes_;
  FaceRules faces_;
  double far_share_;
  std::array<Vector, 3> spin_of_;  ///< integral of the rotation over the cells
  /// factors of the functionals on the mean rotation; last, the volume of the cells [m^3]
  std::vector<double> on_spin_;
};

}  // namespace

FrontFunctionals front_functionals(const Space& space, std::size_t number) {
  const Front front(space.mesh, number);
  if (front.rings < 3) throw InputError("mesh", "needs three rings about a crack front");
  Assembler assembler(space, front);
  assembler.assemble();
  FrontFunctionals result{.stations = {},
                          .of_displacement = std::move(assembler.displacement_),
                          .of_traction = std::move(assembler.traction_),
                          .to_K = {}};
  const auto nodes = static_cast<Eigen::Index>(front.nodes());
  const Eigen::MatrixXd inverse = FrontMass(front).values(Eigen::MatrixXd::Identity(nodes, nodes));
  const std::array<double, 3> modulus = interaction_moduli(space);
  result.to_K = Eigen::MatrixXd::Zero(3 * nodes, 3 * nodes);
  for (Eigen::Index i = 0; i < nodes; ++i)
    for (Eigen::Index j = 0; j < nodes; ++j)
      for (Eigen::Index mode = 0; mode < 3; ++mode)
        result.to_K(3 * i + mode, 3 * j + mode) =
            modulus[static_cast<std::size_t>(mode)] * inverse(i, j);
  for (const auto& [segment, tip] : front.tips)
    for (std::size_t j = segment == 0 ? 0 : 1; j < 3; ++j) {
      FrontStation station;
      station.position = (static_cast<double>(segment) + 0.5 * static_cast<double>(j)) /
                         static_cast<double>(front.tips.size());
      station.place = to_array(front_frame(*tip, 0.5 * static_cast<double>(j)).place);
      result.stations.push_back(station);
    }
  return result;
}

}  // namespace strainwave::fem::solid
