// SPDX-License-Identifier: Apache-2.0
#include "fronts.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <optional>

#include "strainwave/core/error.hpp"

namespace strainwave::fem::solid {
namespace {

/// Displacement gradient of one mode with K = 1 at a crack tip, in plane strain; (FE-24).
/// @param mode  0, 1, 2 for I, II, III
/// @param side  side of the crack, which distinguishes +180 from -180 degrees near its faces
Tensor2 crack_tip_gradient(std::size_t mode, double x1, double x2, int side, double nu, double mu) {
  using std::numbers::pi;
  const double r = std::hypot(x1, x2);
  double angle = std::atan2(x2, x1);
  if (std::abs(angle) > pi / 2 && angle * side < 0) angle += 2 * pi * side;
  const double s = std::sin(angle / 2);
  const double c = std::cos(angle / 2);
  const double S = std::sin(angle);
  const double C = std::cos(angle);
  const double kappa = 3 - 4 * nu;
  Tensor<1, 3> f;   // u = sqrt(r) f(angle)
  Tensor<1, 3> df;  // df/dangle
  if (mode == 0) {
    f = Tensor<1, 3>({c * (kappa - C), s * (kappa - C), 0});
    df = Tensor<1, 3>({-0.5 * s * (kappa - C) + c * S, 0.5 * c * (kappa - C) + s * S, 0});
  } else if (mode == 1) {
    f = Tensor<1, 3>({s * (kappa + 2 + C), -c * (kappa - 2 + C), 0});
    df = Tensor<1, 3>({0.5 * c * (kappa + 2 + C) - s * S, 0.5 * s * (kappa - 2 + C) + c * S, 0});
  } else {
    f = Tensor<1, 3>({0, 0, 4 * s});
    df = Tensor<1, 3>({0, 0, 2 * c});
  }
  const double scale = 1 / (2 * mu * std::sqrt(2 * pi * r));
  Tensor2 gradient;
  for (unsigned i = 0; i < 3; ++i) {
    gradient[i][0] = scale * (C * f[i] / 2 - S * df[i]);
    gradient[i][1] = scale * (S * f[i] / 2 + C * df[i]);
  }
  return gradient;
}

/// The front's frame and place at one point.
struct FrontFrame {
  Point<3> place;
  Tensor2 axes;    ///< rows x1, x2, x3
  double rate;     ///< area swept per length of front and unit of `advance`
  double stretch;  ///< length of front per unit of w
};

FrontFrame front_frame(const HexCell& tip, double w) {
  constexpr double kStep = 1e-4;
  FrontFrame frame;
  frame.place = to_point(tip.map({0, 0, w}));
  const Tensor<1, 3> along =
      (to_point(tip.map({0, 0, w + kStep})) - to_point(tip.map({0, 0, w - kStep}))) / (2 * kStep);
  frame.stretch = along.norm();
  const Tensor<1, 3> x3 = along / frame.stretch;
  const Tensor<1, 3> d = to_tensor(tip.front->advance({0, 0, w}));
  Tensor<1, 3> x1 = d - (d * x3) * x3;
  frame.rate = x1.norm();
  x1 /= frame.rate;
  frame.axes[0] = x1;
  frame.axes[1] = cross_product_3d(x3, x1);
  frame.axes[2] = x3;
  return frame;
}

/// Quadratic shape functions on [0,1] with nodes 0, 1/2, 1.
std::array<double, 3> quadratic(double w) {
  return {(1 - w) * (1 - 2 * w), 4 * w * (1 - w), w * (2 * w - 1)};
}

/// Gauss points on a face; `toward` is the coordinate (0 or 1) that starts at a crack front.
/// Points are denser near the front, so the inverse root is integrated accurately too.
dealii::Quadrature<2> face_points(unsigned n, std::optional<unsigned> toward) {
  dealii::Quadrature<2> rule = dealii::QGauss<2>(n);
  if (!toward) return rule;
  std::vector<Point<2>> points = rule.get_points();
  std::vector<double> weights = rule.get_weights();
  for (std::size_t q = 0; q < points.size(); ++q) {
    const double s = points[q][*toward];
    points[q][*toward] = s * s;
    weights[q] *= 2 * s;
  }
  return {points, weights};
}

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
/// places in the cells at the front and in the innermost ring.
std::vector<bool> touching_stations(const Space& space, const Contact* contact, std::size_t front,
                                    std::size_t nodes) {
  std::vector<int> balance(nodes, 0);
  if (contact != nullptr)
    space.visit_crack_faces([&](const Cell& cell, unsigned f) {
      const HexCell& origin = space.source(cell);
      if (!origin.front || origin.front->front != front || origin.front->ring > 0) return;
      space.visit_face_nodes(cell, f, [&](unsigned a, const Node& node) {
        const auto nearest =
            static_cast<std::size_t>(std::lround(2 * space.scalar.unit_support_point(a)[2]));
        if (contact->on_front.count(node[0]) == 0)
          balance[2 * origin.front->segment + nearest] += contact->pressure[node[0]] > 0 ? 1 : -1;
      });
    });
  std::vector<bool> touching(nodes);
  std::transform(balance.begin(), balance.end(), touching.begin(), [](int b) { return b > 0; });
  return touching;
}

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
};

constexpr std::size_t kFields = 4;  // G and the interaction with modes I, II, III

/// Domain integrals, indexed [field][node of the front][ring].
struct Integrals {
  std::size_t nodes;
  std::size_t rings;
  std::vector<double> value = std::vector<double>(kFields * nodes * rings, 0.0);
  std::vector<double> radius = std::vector<double>(rings, 0.0);  ///< radii of the rings [m]

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
  FrontIntegrator(const Space& space, const Vector& u, const Contact* contact, const Front& front)
      : space_(space),
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
        face_rules_{face_rule({}), face_rule(0U), face_rule(1U)},
        moment_(kFields * velocity_.n_dofs_per_cell()) {}

  /// The integrals, summed over the ranks.
  [[nodiscard]] Integrals integrate() {
    Integrals integrals{.nodes = front_.nodes(), .rings = front_.rings};
    const std::size_t segments = front_.tips.size();
    for (const Cell& cell : space_.dofs.active_cell_iterators()) {
      const HexCell& origin = space_.source(cell);
      if (!origin.front || origin.front->front != front_.number) continue;
      const std::size_t segment = origin.front->segment;
      const HexCell& tip = *front_.tips.at(segment);
      const int ring = origin.front->ring;
      if (ring >= 0 && 2 * segment + 1 >= segments && 2 * segment <= segments)
        integrals.radius[static_cast<std::size_t>(ring)] =
            to_point(origin.map({1, 0.5, 0.5})).distance(front_frame(tip, 0.5).place);
      if (!cell->is_locally_owned()) continue;
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
  [[nodiscard]] std::unique_ptr<FaceRule> face_rule(std::optional<unsigned> toward) const {
    return std::make_unique<FaceRule>(
        space_.body.mapping, space_.scalar, velocity_,
        face_points(static_cast<unsigned>(space_.problem.order) + 3, toward));
  }

  /// Gradient of the auxiliary field of a mode at a place of a cell.
  [[nodiscard]] Tensor2 auxiliary(std::size_t mode, const FrontFrame& frame, const Point<3>& place,
                                  const HexCell& cell) const {
    const Tensor<1, 3> from = place - frame.place;
    const Tensor2 local =
        crack_tip_gradient(mode, from * frame.axes[0], from * frame.axes[1], cell.front->side,
                           space_.problem.material.poissons_ratio, space_.lame.mu);
    return transpose(frame.axes) * local * frame.axes;
  }

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
        const Tensor2 dv = auxiliary(mode, frame, values_.quadrature_point(q), origin);
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
    FaceRule& on_face = *face_rules_[crack && origin.front->ring < 0 ? (f < 2 ? 1 : 2) : 0];
    dealii::FEFaceValues<3>& values = Space::reinit(on_face.values, cell, f);
    Space::reinit(on_face.velocity, cell, f);
    const std::vector<Tensor2> gradient = CellDisplacement(space_, cell, u_).gradients(values);
    const unsigned n_velocity = velocity_.n_dofs_per_cell();
    for (unsigned q = 0; q < on_face.points.size(); ++q) {
      const Tensor2& du = gradient[q];
      const Tensor<1, 3>& normal = values.normal_vector(q);
      const Point<2>& point = on_face.points.point(q);
      const double w = f == 4 ? 0.0 : f == 5 ? 1.0 : f < 2 ? point[1] : point[0];
      const FrontFrame frame = front_frame(tip, w);
      const Tensor<1, 3> traction =
          crack ? -pressure_at(cell, values, q) * normal : space_.lame.stress(du) * normal;
      std::array<Tensor<1, 3>, kFields> force;
      if (crack) force[0] = transpose(du) * traction;  // (FE-31)
      for (std::size_t mode = 0; mode < 3; ++mode) {
        const Tensor2 dv = auxiliary(mode, frame, values.quadrature_point(q), origin);
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
  /// The crack's faces at its front: u = 0 has the coordinates (v, w), v = 0 has (w, u).
  std::array<std::unique_ptr<FaceRule>, 3> face_rules_;
  /// contributions of one cell, indexed [field][node of the virtual crack advance]
  std::vector<Tensor<1, 3>> moment_;
};

/// The integrals along a front as values at its nodes.
///
/// The rate of area is distributed by the shape functions of G, that is, consistently and not
/// lumped.
class NodalValues {
 public:
  NodalValues(const Front& front, const Integrals& integrals)
      : integrals_(integrals), mass_(Eigen::MatrixXd::Zero(size(), size())) {
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

  [[nodiscard]] Eigen::VectorXd of(std::size_t field, std::size_t ring) const {
    Eigen::VectorXd b(size());
    for (std::size_t i = 0; i < integrals_.nodes; ++i)
      b(static_cast<Eigen::Index>(i)) = integrals_.at(field, i, ring);
    return solver_.solve(b);
  }
  [[nodiscard]] Eigen::VectorXd area() const { return mass_.rowwise().sum(); }
  [[nodiscard]] double length() const { return length_; }  ///< length of the front [m]

 private:
  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(integrals_.nodes); }

  const Integrals& integrals_;
  Eigen::MatrixXd mass_;
  Eigen::LDLT<Eigen::MatrixXd> solver_;
  double length_ = 0;
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
///
/// The interaction integral is exact in the limit of a small ring, so a line through two rings is
/// extrapolated.
std::array<Eigen::VectorXd, 3> stress_intensities(const NodalValues& nodal,
                                                  const std::vector<double>& radius,
                                                  double plane_strain, double mu) {
  const std::array<double, 3> factor{plane_strain / 2, plane_strain / 2, mu};
  std::array<Eigen::VectorXd, 3> K;
  for (std::size_t mode = 0; mode < 3; ++mode) {
    const Eigen::VectorXd near = nodal.of(mode + 1, 1);
    const Eigen::VectorXd far = nodal.of(mode + 1, 2);
    K[mode] = factor[mode] * (near - (far - near) * (radius[1] / (radius[2] - radius[1])));
  }
  return K;
}

}  // namespace

CrackFront evaluate_front(const Space& space, const Vector& u, const Contact* contact,
                          std::size_t number) {
  const Front front(space.mesh, number);
  const Integrals integrals = FrontIntegrator(space, u, contact, front).integrate();
  if (integrals.rings < 3) throw InputError("mesh", "needs three rings about a crack front");
  const NodalValues nodal(front, integrals);
  const ReleaseRates G = release_rates(nodal, integrals);
  const Elasticity& material = space.problem.material;
  const double plane_strain =
      material.youngs_modulus / (1 - material.poissons_ratio * material.poissons_ratio);
  const double mu = space.lame.mu;
  std::array<Eigen::VectorXd, 3> K = stress_intensities(nodal, integrals.radius, plane_strain, mu);
  const std::vector<bool> touching = touching_stations(space, contact, number, integrals.nodes);

  CrackFront result{.release = G.release, .length = nodal.length(), .ring_spread = G.spread};
  double of_K = 0;
  double of_G = 0;
  const double scale = std::abs(G.mean.sum() / static_cast<double>(integrals.nodes));
  const Eigen::VectorXd area = nodal.area();
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
