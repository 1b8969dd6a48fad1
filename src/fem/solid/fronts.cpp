// SPDX-License-Identifier: Apache-2.0
#include "fronts.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <optional>

#include "assembly.hpp"
#include "front_frame.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave::fem::solid {
namespace {

/// Mean rotation of the cells about a front over their volume, from the antisymmetric gradient.
Tensor2 mean_spin(const Space& space, const Vector& u, std::size_t front) {
  const dealii::QGauss<3> rule(static_cast<unsigned>(space.problem.order) + 1);
  dealii::FEValues<3> values(space.body.mapping, space.scalar, rule,
                             dealii::update_gradients | dealii::update_JxW_values);
  std::array<double, 4> sums{};  // three rotations, volume
  for (const Cell& cell : space.dofs.active_cell_iterators()) {
    const HexCell& origin = space.source(cell);
    if (!origin.front || origin.front->front != front || !cell->is_locally_owned()) continue;
    Space::reinit(values, cell);
    const std::vector<Tensor2> gradient = CellDisplacement(space, cell, u).gradients(values);
    for (unsigned q = 0; q < rule.size(); ++q) {
      for (unsigned k = 0; k < 3; ++k) {
        const unsigned i = (k + 1) % 3;
        const unsigned j = (k + 2) % 3;
        sums[k] += values.JxW(q) * 0.5 * (gradient[q][i][j] - gradient[q][j][i]);
      }
      sums[3] += values.JxW(q);
    }
  }
  sum_over_ranks(sums);
  Tensor2 spin;
  for (unsigned k = 0; k < 3; ++k) {
    spin[(k + 1) % 3][(k + 2) % 3] = sums[k] / sums[3];
    spin[(k + 2) % 3][(k + 1) % 3] = -sums[k] / sums[3];
  }
  return spin;
}

/// Whether the faces touch next to the nodes of a front, that is, at the majority of the nearest
/// places.
std::vector<bool> touching_stations(const Space& space, const Contact* contact, std::size_t front,
                                    std::size_t nodes) {
  std::vector<bool> touching(nodes, false);
  if (contact == nullptr) return touching;
  const auto beside = beside_stations(space, front, nodes);
  for (std::size_t i = 0; i < nodes; ++i) {
    int balance = 0;
    for (const Index dof : beside[i])
      if (contact->on_front.count(dof) == 0) balance += contact->pressure[dof] > 0 ? 1 : -1;
    touching[i] = balance > 0;
  }
  return touching;
}

constexpr std::size_t kFields = 4;  // G and the interaction with modes I, II, III

/// Domain integrals, indexed [field][node of the front][ring].
struct Integrals {
  std::size_t nodes;
  std::size_t rings;
  std::vector<double> value = std::vector<double>(kFields * nodes * rings, 0.0);

  [[nodiscard]] double& at(std::size_t field, std::size_t node, std::size_t ring) {
    return value[(field * nodes + node) * rings + ring];
  }
  [[nodiscard]] double at(std::size_t field, std::size_t node, std::size_t ring) const {
    return value[(field * nodes + node) * rings + ring];
  }
};

/// Computes the domain integrals about one front, cell by cell.
class FrontIntegrator {
 public:
  FrontIntegrator(const Space& space, const SolidLoad& load, const Vector& u,
                  const Contact* contact, const Front& front)
      : space_(space),
        load_(load),
        u_(u),
        contact_(contact),
        front_(front),
        spin_(mean_spin(space, u, front.number)),
        velocity_(4),
        rule_(static_cast<unsigned>(space.problem.order) + 3),
        values_(space.body.mapping, space.scalar, rule_,
                dealii::update_gradients | dealii::update_JxW_values |
                    dealii::update_quadrature_points),
        slopes_(space.body.mapping, velocity_, rule_, dealii::update_gradients),
        faces_(space, velocity_),
        moment_(kFields * velocity_.n_dofs_per_cell()) {}

  /// The integrals, summed over the ranks.
  [[nodiscard]] Integrals integrate() {
    Integrals integrals{.nodes = front_.nodes(), .rings = front_.rings};
    for (const Cell& cell : space_.dofs.active_cell_iterators()) {
      const HexCell& origin = space_.source(cell);
      if (!origin.front || origin.front->front != front_.number) continue;
      if (!cell->is_locally_owned()) continue;
      const HexCell& tip = *front_.tips.at(origin.front->segment);
      std::fill(moment_.begin(), moment_.end(), Tensor<1, 3>());
      add_volume(cell, origin, tip);
      for (const unsigned f : cell->face_indices())
        if (cell->face(f)->at_boundary()) add_face(cell, f, origin, tip);
      distribute(origin, integrals);
    }
    sum_over_ranks(integrals.value);
    return integrals;
  }

 private:
  void add_volume(const Cell& cell, const HexCell& origin, const HexCell& tip) {
    Space::reinit(values_, cell);
    Space::reinit(slopes_, cell);
    const std::vector<Tensor2> gradient = CellDisplacement(space_, cell, u_).gradients(values_);
    const unsigned n_velocity = velocity_.n_dofs_per_cell();
    for (unsigned q = 0; q < rule_.size(); ++q) {
      const Tensor2& du = gradient[q];
      const Tensor2 stress = space_.lame.stress(du);
      std::array<Tensor2, kFields> flux;  // [k][j]: contracted with dq_k/dx_j
      flux[0] = transpose(du) * stress;
      const double density = 0.5 * scalar_product(stress, du);
      for (unsigned k = 0; k < 3; ++k) flux[0][k][k] -= density;  // (FE-23)
      const FrontFrame frame = front_frame(tip, rule_.point(q)[2]);
      for (std::size_t mode = 0; mode < 3; ++mode) {
        const Tensor2 dv =
            auxiliary_gradient(space_, mode, frame, values_.quadrature_point(q), origin);
        flux[mode + 1] = transpose(dv) * stress + transpose(du - spin_) * space_.lame.stress(dv);
        const double mutual = scalar_product(stress, dv);
        for (unsigned k = 0; k < 3; ++k) flux[mode + 1][k][k] -= mutual;  // (FE-24)
      }
      for (unsigned n = 0; n < n_velocity; ++n) {
        const Tensor<1, 3> slope = values_.JxW(q) * slopes_.shape_grad(n, q);
        for (std::size_t field = 0; field < kFields; ++field)
          moment_[field * n_velocity + n] += flux[field] * slope;
      }
    }
  }

  /// The auxiliary fields leave tractions on curved crack faces and on the front's end faces.
  void add_face(const Cell& cell, unsigned f, const HexCell& origin, const HexCell& tip) {
    const bool crack = space_.is_crack_face(cell, f);
    FaceRule& on_face = faces_.at(cell, f, origin);
    dealii::FEFaceValues<3>& values = on_face.values;
    const std::vector<Tensor2> gradient = CellDisplacement(space_, cell, u_).gradients(values);
    const unsigned n_velocity = velocity_.n_dofs_per_cell();
    for (unsigned q = 0; q < on_face.points.size(); ++q) {
      const Tensor2& du = gradient[q];
      const Tensor<1, 3>& normal = values.normal_vector(q);
      const FrontFrame frame = front_frame(tip, FaceRules::along(on_face, f, q));
      Tensor<1, 3> traction =
          crack ? -pressure_at(cell, values, q) * normal : space_.lame.stress(du) * normal;
      if (crack && load_.released) traction += released_traction(load_, values, q);
      std::array<Tensor<1, 3>, kFields> force;
      if (crack) force[0] = transpose(du) * traction;  // (FE-31)
      for (std::size_t mode = 0; mode < 3; ++mode) {
        const Tensor2 dv =
            auxiliary_gradient(space_, mode, frame, values.quadrature_point(q), origin);
        force[mode + 1] =
            transpose(du - spin_) * (space_.lame.stress(dv) * normal) + transpose(dv) * traction;
      }
      for (unsigned n = 0; n < n_velocity; ++n)
        for (std::size_t field = 0; field < kFields; ++field)
          moment_[field * n_velocity + n] -=
              on_face.velocity.shape_value(n, q) * values.JxW(q) * force[field];  // (FE-24)
    }
  }

  /// Adds the contribution of one cell to the nodes of the front and to the rings.
  void distribute(const HexCell& origin, Integrals& integrals) const {
    const unsigned n_velocity = velocity_.n_dofs_per_cell();
    for (unsigned n = 0; n < n_velocity; ++n) {
      const Point3 unit = to_array(velocity_.unit_support_point(n));
      const Tensor<1, 3> d = to_tensor(origin.front->advance(unit));
      const std::array<double, 3> shape = quadratic(unit[2]);
      for (std::size_t k = 0; k < integrals.rings; ++k) {
        const int domain = static_cast<int>(k);
        const int ring = origin.front->ring;
        const double weight = ring < domain ? 1.0 : ring == domain ? 1 - unit[0] : 0.0;
        if (weight == 0) continue;
        for (std::size_t field = 0; field < kFields; ++field)
          for (std::size_t i = 0; i < 3; ++i)
            integrals.at(field, 2 * origin.front->segment + i, k) +=
                weight * shape[i] * (d * moment_[field * n_velocity + n]);
      }
    }
  }

  /// Pressure of contact at a point of a crack face; 0 without contact.
  [[nodiscard]] double pressure_at(const Cell& cell, const dealii::FEValuesBase<3>& values,
                                   unsigned q) const {
    if (contact_ == nullptr) return 0;
    const std::vector<Index> indices = space_.indices(cell);
    double pressure = 0;
    for (unsigned a = 0; a < space_.scalar.n_dofs_per_cell(); ++a)
      pressure += contact_->pressure[indices[space_.node_of[0][a]]] * values.shape_value(a, q);
    return pressure;
  }

  const Space& space_;
  const SolidLoad& load_;
  const Vector& u_;
  const Contact* contact_;
  const Front& front_;
  /// Mean rotation, which is subtracted.  The auxiliary fields are not in equilibrium on a curved
  /// front, so a rotation of the body would appear as a stress intensity.
  Tensor2 spin_;
  dealii::FE_Q<3> velocity_;  ///< of the virtual crack advance within a cell
  dealii::QGauss<3> rule_;
  dealii::FEValues<3> values_;  ///< values of the displacements
  dealii::FEValues<3> slopes_;  ///< slopes of the virtual crack advance
  FaceRules faces_;
  /// contributions of one cell, indexed [field][node of the virtual crack advance]
  std::vector<Tensor<1, 3>> moment_;
};

/// The integrals along a front as values at its nodes.
class NodalValues {
 public:
  NodalValues(const FrontMass& mass, const Integrals& integrals)
      : mass_(mass), integrals_(integrals) {}

  [[nodiscard]] Eigen::VectorXd of(std::size_t field, std::size_t ring) const {
    Eigen::VectorXd b(static_cast<Eigen::Index>(integrals_.nodes));
    for (std::size_t i = 0; i < integrals_.nodes; ++i)
      b(static_cast<Eigen::Index>(i)) = integrals_.at(field, i, ring);
    return mass_.values(b);
  }

 private:
  const FrontMass& mass_;
  const Integrals& integrals_;
};

/// G at the nodes of a front: for each ring except the innermost, whose field is the least
/// accurate, and the mean of these rings [J/m^2].
struct ReleaseRates {
  std::vector<Eigen::VectorXd> of_ring;
  Eigen::VectorXd mean;
  double release = 0;  ///< integral over the front, mean of the rings [N]
  double spread = 0;   ///< relative spread of `release` between rings [-]
};

ReleaseRates release_rates(const NodalValues& nodal, const Integrals& integrals) {
  ReleaseRates G;
  std::vector<double> release;
  for (std::size_t k = 1; k < integrals.rings; ++k) {
    G.of_ring.push_back(nodal.of(0, k));
    release.push_back(0);
    for (std::size_t i = 0; i < integrals.nodes; ++i) release.back() += integrals.at(0, i, k);
  }
  const double count = static_cast<double>(G.of_ring.size());
  G.mean = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(integrals.nodes));
  for (std::size_t k = 0; k < G.of_ring.size(); ++k) {
    G.mean += G.of_ring[k] / count;
    G.release += release[k] / count;
  }
  const auto [least, most] = std::minmax_element(release.begin(), release.end());
  G.spread = (*most - *least) / std::abs(G.release);
  return G;
}

/// Stress intensities at the nodes of a front [Pa*m^0.5].
std::array<Eigen::VectorXd, 3> stress_intensities(const NodalValues& nodal,
                                                  const std::vector<double>& radius,
                                                  const std::array<double, 3>& modulus) {
  const double far = far_share(radius);
  std::array<Eigen::VectorXd, 3> K;
  for (std::size_t mode = 0; mode < 3; ++mode)
    K[mode] =
        modulus[mode] * ((1 - far) * nodal.of(mode + 1, kNear) + far * nodal.of(mode + 1, kFar));
  return K;
}

}  // namespace

std::vector<std::vector<Index>> beside_stations(const Space& space, std::size_t front,
                                                std::size_t nodes) {
  std::vector<std::vector<Index>> beside(nodes);
  space.visit_crack_faces([&](const Cell& cell, unsigned f) {
    const HexCell& origin = space.source(cell);
    if (!origin.front || origin.front->front != front || origin.front->ring > 0) return;
    space.visit_face_nodes(cell, f, [&](unsigned a, const Node& node) {
      const auto nearest =
          static_cast<std::size_t>(std::lround(2 * space.scalar.unit_support_point(a)[2]));
      beside[2 * origin.front->segment + nearest].push_back(node[0]);
    });
  });
  return beside;
}

CrackFront evaluate_front(const Space& space, const SolidLoad& load, const Vector& u,
                          const Contact* contact, std::size_t number) {
  const Front front(space.mesh, number);
  const Integrals integrals = FrontIntegrator(space, load, u, contact, front).integrate();
  if (integrals.rings < 3) throw InputError("mesh", "needs three rings about a crack front");
  const FrontMass mass(front);
  const NodalValues nodal(mass, integrals);
  const ReleaseRates G = release_rates(nodal, integrals);
  const Elasticity& material = space.problem.material;
  const double plane_strain =
      material.youngs_modulus / (1 - material.poissons_ratio * material.poissons_ratio);
  const double mu = space.lame.mu;
  std::array<Eigen::VectorXd, 3> K =
      stress_intensities(nodal, front.radii(space.mesh), interaction_moduli(space));
  const std::vector<bool> touching = touching_stations(space, contact, number, integrals.nodes);

  CrackFront result{.release = G.release, .length = mass.length(), .ring_spread = G.spread};
  double of_K = 0;
  double of_G = 0;
  const double scale = std::abs(G.mean.sum() / static_cast<double>(integrals.nodes));
  const Eigen::VectorXd area = mass.area();
  for (const auto& [segment, tip] : front.tips)
    for (std::size_t j = segment == 0 ? 0 : 1; j < 3; ++j) {
      const auto i = static_cast<Eigen::Index>(2 * segment + j);
      FrontStation station;
      station.position = (static_cast<double>(segment) + 0.5 * static_cast<double>(j)) /
                         static_cast<double>(front.tips.size());
      station.place = to_array(front_frame(*tip, 0.5 * static_cast<double>(j)).place);
      station.energy_release_rate = G.mean(i);
      for (const Eigen::VectorXd& ring : G.of_ring)
        station.ring_spread = std::max(station.ring_spread, std::abs(ring(i) - G.mean(i)) / scale);
      if (space.problem.crack_faces == CrackFaces::contact &&
          (touching[static_cast<std::size_t>(i)] || K[0](i) < 0)) {
        result.closed_K_I = std::max(result.closed_K_I, std::abs(K[0](i)));
        station.closed = true;
        K[0](i) = 0;
      }
      station.G_of_K = (K[0](i) * K[0](i) + K[1](i) * K[1](i)) / plane_strain +
                       K[2](i) * K[2](i) / (2 * mu);  // (FE-25)
      const double rescale = station.energy_release_rate > 0 && station.G_of_K > 0
                                 ? std::sqrt(station.energy_release_rate / station.G_of_K)
                                 : 1.0;
      station.K_I = rescale * K[0](i);
      station.K_II = rescale * K[1](i);
      station.K_III = rescale * K[2](i);
      of_K += station.G_of_K * area(i);
      of_G += station.energy_release_rate * area(i);
      result.stations.push_back(station);
    }
  result.mode_energy_ratio = of_K / of_G;
  return result;
}

}  // namespace strainwave::fem::solid
