// SPDX-License-Identifier: Apache-2.0
#include "elastic_rings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "strainwave/torsion/plate_edge.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// Up to this harmonic the whole barrel follows its end.  Beyond, the part that follows shrinks
/// like 1/n: short waves stay near the rim.  The number has no derivation (TC-2); the ring's own
/// bending rules there.
constexpr double kDecay = 2.5;

double sinc(double x) { return std::sin(x) / x; }

/// Mean over the radius: the plate's own thickness law matters little here.
double mean_thickness(const Diaphragm& diaphragm) {
  if (diaphragm.profile.empty()) return diaphragm.thickness;
  constexpr int kPoints = 64;
  const double width = diaphragm.outer_diameter - diaphragm.inner_diameter;
  double h = 0.0;
  for (int i = 0; i < kPoints; ++i)
    h += diaphragm_thickness(diaphragm,
                             (diaphragm.inner_diameter + width * (i + 0.5) / kPoints) / 2) /
         kPoints;
  return h;
}

}  // namespace

Waves::Waves(std::vector<double> positions, int harmonics)
    : positions_(std::move(positions)),
      cosine_(positions_.size(), harmonics),
      sine_(positions_.size(), harmonics) {
  for (Eigen::Index i = 0; i < cosine_.rows(); ++i)
    for (int n = 1; n <= harmonics; ++n) {
      cosine_(i, n - 1) = std::cos(n * positions_[static_cast<std::size_t>(i)]);
      sine_(i, n - 1) = std::sin(n * positions_[static_cast<std::size_t>(i)]);
    }
}

ElasticRings::ElasticRings(const GearSet& gear, const CoupledGeometry& geometry,
                           const CoupledOptions& options, int contacts)
    : N_(options.harmonics),
      has_spline_(geometry.support > 0),
      ring_radius_(geometry.ring_radius),
      spline_radius_(geometry.spline_radius),
      row_(Rows::Zero(contacts, coefficients())),
      compliant_row_(Rows::Zero(contacts, coefficients())),
      lobe_(Eigen::VectorXd::Zero(coefficients())),
      flexibility_(contacts) {
  make_modes(gear, geometry, options);
  lobe_[0] = 1.0;  // mean of w at 0 and pi: the even cosines
  for (int n = 2; n <= N_; n += 2) lobe_[at(n)] = 1.0;
}

void ElasticRings::make_modes(const GearSet& gear, const CoupledGeometry& g,
                              const CoupledOptions& options) {
  const Flexspline& fs = *gear.flexspline;
  const double R = g.ring_radius;
  const double L = g.barrel_length;
  const auto& [E, G, nu] = g.rim_steel;
  const double plate = E * std::pow(g.barrel_thickness, 3) / (12 * (1 - nu * nu));
  const ClampedPlate bottom{.outer_radius = fs.diaphragm->outer_diameter / 2,
                            .inner_radius = fs.diaphragm->inner_diameter / 2,
                            .thickness = mean_thickness(*fs.diaphragm),
                            .youngs_modulus = E,
                            .poissons_ratio = nu};
  modes_.assign(static_cast<std::size_t>(N_) + 1, {});
  modes_[0].extension = 2 * pi * g.extension / R;  // (TC-1)
  modes_[0].rim_bending = 2 * pi * g.rim_bending / (R * R * R);
  modes_[0].outer_bending = 2 * pi * g.outer_bending / (R * R * R);
  for (int n = 1; n <= N_; ++n) {
    Mode& mode = modes_[static_cast<std::size_t>(n)];
    const double n2 = n * n;
    const double bent = (n2 - 1) * (n2 - 1);
    mode.rim_bending = pi * g.rim_bending / (R * R * R) * bent;      // (TC-1)
    mode.outer_bending = pi * g.outer_bending / (R * R * R) * bent;  // (TC-1)
    mode.extension = pi * g.extension / R;                           // (TC-1)
    if (n == 1) {
      mode.lateral = 0.5 * pi * G * R * g.barrel_thickness / L;  // (TC-2)
      continue;
    }
    const double twist = (n - 1.0 / n) * (n - 1.0 / n);
    mode.barrel = plate * pi * R * (L / 3) *
                  (bent / std::pow(R, 4) + 6 * (1 - nu) * twist / (R * R * L * L)) *
                  std::min(1.0, kDecay / n);  // (TC-2)
    if (options.diaphragm_warping)
      mode.diaphragm = plate_edge_stiffness(bottom, n) * std::pow(R / (n2 * L), 2);  // (TC-2)
    if (g.support > 0)
      mode.spline =
          pi * g.spline_bending / std::pow(g.spline_radius, 3) * bent / g.support;  // (TC-10)
  }
  for (int n = 1; n <= N_; ++n) {
    Mode& mode = modes_[static_cast<std::size_t>(n)];
    mode.inverse = mode.inverted(n);
  }
}

ElasticRings::Mode::Inverse ElasticRings::Mode::inverted(int n) const {
  if (n == 1) {
    const double ke = extension;
    const double kl = lateral;
    const double det = kl * (kl + 2 * ke);
    const double ww = (ke + kl) / det;
    return {.ww = ww, .wv = -ke / det, .vv = ww};
  }
  const double bend = rim_bending + outer_bending + barrel + diaphragm;
  return {.ww = 1 / bend, .wv = -1 / (n * bend), .vv = (1 / extension + 1 / bend) / (n * n)};
}

void ElasticRings::set_contacts(const Waves& waves, int position,
                                std::initializer_list<std::pair<int, ContactDirection>> contacts) {
  for (const auto& [contact, d] : contacts) row_(contact, 0) = d.radial;
  for (int n = 1; n <= N_; ++n) {
    const double c = waves.cosine(position, n);
    const double s = waves.sine(position, n);
    for (const auto& [contact, d] : contacts) {
      auto row = row_.row(contact);
      row[at(n)] = d.radial * c - d.slope * n * s;
      row[at(n) + 1] = d.radial * s + d.slope * n * c;
      row[at(n) + 2] = d.tangential * c;
      row[at(n) + 3] = d.tangential * s;
      if (has_spline_ && n >= 2) {  // inextensional: v = -(a/n) sin + (b/n) cos
        row[spline_at(n)] =
            d.spline_radial * c - d.spline_slope * n * s - d.spline_tangential / n * s;
        row[spline_at(n) + 1] =
            d.spline_radial * s + d.spline_slope * n * c + d.spline_tangential / n * c;
      }
    }
  }
  for (const auto& [contact, d] : contacts)
    apply_compliance(Row(&row_(contact, 0), coefficients()),
                     MutableRow(&compliant_row_(contact, 0), coefficients()));
}

void ElasticRings::apply_compliance(const Row& load, MutableRow out) const {
  const Mode& breathing = modes_[0];
  out[0] = load[0] / (breathing.extension + breathing.rim_bending + breathing.outer_bending);
  for (int n = 1; n <= N_; ++n) {
    const Mode& mode = modes_[static_cast<std::size_t>(n)];
    const auto& [ww, wv, vv] = mode.inverse;
    const int i = at(n);
    out[i] = ww * load[i] + wv * load[i + 3];
    out[i + 3] = wv * load[i] + vv * load[i + 3];
    out[i + 1] = ww * load[i + 1] - wv * load[i + 2];
    out[i + 2] = -wv * load[i + 1] + vv * load[i + 2];
    if (mode.spline > 0) {
      out[spline_at(n)] = load[spline_at(n)] / mode.spline;
      out[spline_at(n) + 1] = load[spline_at(n) + 1] / mode.spline;
    }
  }
}

void ElasticRings::add_softening(const Softening& soft, const Row& load, MutableRow out) const {
  out += soft.factor * soft.response.dot(load) * soft.response;  // (TC-22)
}

ElasticRings ElasticRings::softened(const std::vector<RingHinge>& hinges) const {
  ElasticRings soft_rings = *this;
  for (const RingHinge& hinge : hinges) {
    const bool spline = hinge.ring == RingHinge::Ring::spline;
    if (spline && !has_spline_) continue;  // a rigid ring does not bend
    const double R = spline ? spline_radius_ : ring_radius_;
    Softening soft{.ring = hinge.ring,
                   .softening = hinge.softening,
                   .curvature = Eigen::VectorXd::Zero(coefficients()),
                   .response = Eigen::VectorXd::Zero(coefficients())};
    for (int n = 2; n <= N_; ++n) {
      const double amplitude =
          (1.0 - n * n) / (R * R) * sinc(n * hinge.length / (2 * R));  // (TC-22)
      const int i = spline ? spline_at(n) : at(n);
      soft.curvature[i] = amplitude * std::cos(n * hinge.position);
      soft.curvature[i + 1] = amplitude * std::sin(n * hinge.position);
    }
    const Row load(soft.curvature.data(), coefficients());
    const MutableRow response(soft.response.data(), coefficients());
    apply_compliance(load, response);
    for (const Softening& before : soft_rings.softenings_) add_softening(before, load, response);
    // Below 1: the energy of the mean curvature is never more than that of the curvature itself.
    soft.factor = soft.softening / (1 - soft.softening * soft.curvature.dot(soft.response));
    for (int i = 0; i < contacts(); ++i)
      add_softening(soft, Row(&row_(i, 0), coefficients()),
                    MutableRow(&soft_rings.compliant_row_(i, 0), coefficients()));
    soft_rings.softenings_.push_back(std::move(soft));
  }
  return soft_rings;
}

double ElasticRings::of_nominal_wave(int contact, double amplitude) const {
  return row_(contact, at(2)) * amplitude - row_(contact, at(2) + 3) * (amplitude / 2);
}

Eigen::VectorXd ElasticRings::sum_of(const Eigen::VectorXd& force) const {
  std::vector<int> carries;
  for (int i = 0; i < contacts(); ++i)
    if (force[i] != 0) carries.push_back(i);
  const auto made = [&](std::size_t p) {
    return force[carries[p]] * compliant_row_.row(carries[p]).transpose();
  };
  Eigen::VectorXd x = Eigen::VectorXd::Zero(coefficients());
  std::size_t p = 0;
  for (; p + 4 <= carries.size(); p += 4)  // four in one pass: the sums stay in registers
    x = (((x - made(p)) - made(p + 1)) - made(p + 2)) - made(p + 3);
  for (; p < carries.size(); ++p) x -= made(p);
  return x;
}

Eigen::VectorXd ElasticRings::product_of(const Eigen::VectorXd& force) const {
  return -(compliant_row_.transpose() * force);
}

void ElasticRings::add_shares(const Eigen::VectorXd& x,
                              std::array<double, kCurveMembers>& share) const {
  const auto add = [&](CurveMember member, double value) {
    share[static_cast<std::size_t>(member)] += value;
  };
  const auto square = [&](int i) { return x[i] * x[i] + x[i + 1] * x[i + 1]; };
  add(CurveMember::rim_extension, modes_[0].extension * x[0] * x[0]);
  add(CurveMember::rim_bending, modes_[0].rim_bending * x[0] * x[0]);
  add(CurveMember::outer_ring_bending, modes_[0].outer_bending * x[0] * x[0]);
  for (int n = 1; n <= N_; ++n) {
    const Mode& mode = modes_[static_cast<std::size_t>(n)];
    const int i = at(n);
    const double bent = square(i);
    add(CurveMember::rim_bending, mode.rim_bending * bent);
    add(CurveMember::outer_ring_bending, mode.outer_bending * bent);
    add(CurveMember::barrel_warping, mode.barrel * bent + mode.lateral * (bent + square(i + 2)));
    add(CurveMember::diaphragm_warping, mode.diaphragm * bent);
    add(CurveMember::rim_extension,
        mode.extension * (std::pow(x[i] + n * x[i + 3], 2) + std::pow(x[i + 1] - n * x[i + 2], 2)));
    if (mode.spline > 0) add(CurveMember::circular_spline, mode.spline * square(spline_at(n)));
  }
  for (const Softening& soft : softenings_) {
    const double lost = soft.softening * std::pow(soft.curvature.dot(x), 2);
    add(soft.ring == RingHinge::Ring::rim     ? CurveMember::rim_bending
        : soft.ring == RingHinge::Ring::outer ? CurveMember::outer_ring_bending
                                              : CurveMember::circular_spline,
        -lost);
  }
}

double ElasticRings::radial(const Eigen::VectorXd& x, double theta) const {
  double w = x[0];
  for (int n = 1; n <= N_; ++n)
    w += x[at(n)] * std::cos(n * theta) + x[at(n) + 1] * std::sin(n * theta);
  return w;
}

double ElasticRings::tangential(const Eigen::VectorXd& x, double theta) const {
  double v = 0.0;
  for (int n = 1; n <= N_; ++n)
    v += x[at(n) + 2] * std::cos(n * theta) + x[at(n) + 3] * std::sin(n * theta);
  return v;
}

double ElasticRings::curvature(const Eigen::VectorXd& x, double theta) const {
  const double R2 = ring_radius_ * ring_radius_;
  double kappa = 0.0;  // -(w'' + w)/R^2, positive where the ring bends more
  for (int n = 2; n <= N_; ++n)
    kappa +=
        (n * n - 1.0) / R2 * (x[at(n)] * std::cos(n * theta) + x[at(n) + 1] * std::sin(n * theta));
  return kappa - x[0] / R2;
}

double ElasticRings::hoop_strain(const Eigen::VectorXd& x, double theta) const {
  double strain = x[0];
  for (int n = 1; n <= N_; ++n)
    strain += (x[at(n)] + n * x[at(n) + 3]) * std::cos(n * theta) +
              (x[at(n) + 1] - n * x[at(n) + 2]) * std::sin(n * theta);
  return strain / ring_radius_;
}

}  // namespace strainwave
