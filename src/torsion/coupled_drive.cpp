// SPDX-License-Identifier: Apache-2.0
#include "coupled_drive.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "strainwave/torsion/plate_edge.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr double kToothSpan = pi / 4;  // teeth farther from a lobe never touch

double angle_from_lobe(double theta) { return std::remainder(theta, pi); }

double sinc(double x) { return std::sin(x) / x; }

}  // namespace

CoupledDrive::CoupledDrive(const GearSet& gear, const CoupledGeometry& geometry,
                           const ContactCracks& cracks, const CoupledOptions& options)
    : g_(geometry),
      N_(options.harmonics),
      tolerance_(options.tolerance),
      max_iterations_(options.max_iterations) {
  make_modes(gear, options);
  soften(cracks.hinges);
  make_contacts();
  soften_contacts(cracks);
}

void CoupledDrive::make_modes(const GearSet& gear, const CoupledOptions& options) {
  const Flexspline& fs = *gear.flexspline;
  const double R = g_.ring_radius;
  const double L = g_.barrel_length;
  const auto& [E, G, nu] = g_.rim_steel;
  const double plate = E * std::pow(g_.barrel_thickness, 3) / (12 * (1 - nu * nu));
  // The plate's own thickness law matters little here; its mean over the radius is taken.
  double h = fs.diaphragm->thickness;
  if (!fs.diaphragm->profile.empty()) {
    constexpr int kPoints = 64;
    h = 0.0;
    for (int i = 0; i < kPoints; ++i)
      h += diaphragm_thickness(*fs.diaphragm,
                               (fs.diaphragm->inner_diameter +
                                (fs.diaphragm->outer_diameter - fs.diaphragm->inner_diameter) *
                                    (i + 0.5) / kPoints) /
                                   2) /
           kPoints;
  }
  const ClampedPlate bottom{.outer_radius = fs.diaphragm->outer_diameter / 2,
                            .inner_radius = fs.diaphragm->inner_diameter / 2,
                            .thickness = h,
                            .youngs_modulus = E,
                            .poissons_ratio = nu};
  modes_.assign(static_cast<std::size_t>(N_) + 1, {});
  modes_[0].extension = 2 * pi * g_.extension / R;  // (TC-1)
  modes_[0].rim_bending = 2 * pi * g_.rim_bending / (R * R * R);
  modes_[0].outer_bending = 2 * pi * g_.outer_bending / (R * R * R);
  for (int n = 1; n <= N_; ++n) {
    Mode& mode = modes_[static_cast<std::size_t>(n)];
    const double n2 = n * n;
    const double bent = (n2 - 1) * (n2 - 1);
    mode.rim_bending = pi * g_.rim_bending / (R * R * R) * bent;      // (TC-1)
    mode.outer_bending = pi * g_.outer_bending / (R * R * R) * bent;  // (TC-1)
    mode.extension = pi * g_.extension / R;                           // (TC-1)
    if (n == 1) {
      mode.lateral = 0.5 * pi * G * R * g_.barrel_thickness / L;  // (TC-2)
      continue;
    }
    const double twist = (n - 1.0 / n) * (n - 1.0 / n);
    mode.barrel = plate * pi * R * (L / 3) *
                  (bent / std::pow(R, 4) + 6 * (1 - nu) * twist / (R * R * L * L)) *
                  std::min(1.0, 2.5 / n);  // (TC-2)
    if (options.diaphragm_warping)
      mode.diaphragm = plate_edge_stiffness(bottom, n) * std::pow(R / (n2 * L), 2);  // (TC-2)
    if (g_.support > 0)
      mode.spline =
          pi * g_.spline_bending / std::pow(g_.spline_radius, 3) * bent / g_.support;  // (TC-10)
  }
}

void CoupledDrive::make_contacts() {
  const int z = g_.teeth;
  std::vector<double> teeth;
  for (int j = 0; j < z; ++j) {
    const double theta = (j + 0.5) * 2 * pi / z;
    if (std::abs(angle_from_lobe(theta)) <= kToothSpan + 1e-12) teeth.push_back(theta);
  }
  tooth_count_ = static_cast<int>(teeth.size());
  const int count = g_.balls + 2 * tooth_count_;
  row_.setZero(count, coefficients());
  compliant_row_.setZero(count, coefficients());
  free_.setZero(count);
  cam_.setZero(count);
  rotation_.setZero(count);
  multiplier_.setOnes(count);
  own_.setZero(count);
  theta_.assign(static_cast<std::size_t>(count), 0.0);
  flexibility_.setConstant(count, count, std::numeric_limits<double>::quiet_NaN());

  for (int k = 0; k < g_.balls; ++k) {
    const double psi = 2 * pi * k / g_.balls;
    const double s2 = std::sin(2 * psi);
    theta_[static_cast<std::size_t>(k)] = psi;
    fill_row(k, psi, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    cam_[k] = std::cos(2 * psi);  // (TC-5)
    free_[k] = -g_.clearance - g_.cam_flattening * g_.radial_displacement * g_.radial_displacement /
                                   g_.ring_radius * s2 * s2;  // (TC-5)
  }
  const double reach = (g_.pitch_radius - g_.ring_radius) / g_.ring_radius;
  const double spline_reach =
      g_.support > 0 ? (g_.pitch_radius - g_.spline_radius) / g_.spline_radius : 0.0;
  const double w0 = g_.radial_displacement;
  for (int j = 0; j < tooth_count_; ++j)
    for (const int side : {+1, -1}) {
      const int i = g_.balls + j + (side > 0 ? 0 : tooth_count_);
      const double theta = teeth[static_cast<std::size_t>(j)];
      const double t = angle_from_lobe(theta);
      const double across = side * std::cos(g_.force_angle);
      const double up = std::sin(g_.force_angle);
      theta_[static_cast<std::size_t>(i)] = theta;
      // (TC-6): the circular spline's tooth moves away under the same force.
      fill_row(i, theta, up, across * (1 + reach), -across * reach, -up,
               -across * (1 + spline_reach), across * spline_reach);
      rotation_[i] = across * (1 + reach);
      Eigen::VectorXd nominal = Eigen::VectorXd::Zero(row_.cols());
      nominal[at(2)] = w0;
      nominal[at(2) + 3] = -w0 / 2;
      free_[i] = -row_.row(i).dot(nominal) -
                 flank_gap(side * t, w0, g_.flank_angle, g_.gap_factor) - g_.lobe_gap;  // (TC-6)
    }
  lobe_.setZero(row_.cols());  // mean of w at 0 and pi: the even cosines
  lobe_[0] = 1.0;
  for (int n = 2; n <= N_; n += 2) lobe_[at(n)] = 1.0;
}

void CoupledDrive::fill_row(int contact, double theta, double radial, double tangential,
                            double slope, double spline_radial, double spline_tangential,
                            double spline_slope) {
  auto row = row_.row(contact);
  row[0] = radial;
  for (int n = 1; n <= N_; ++n) {
    const double c = std::cos(n * theta);
    const double s = std::sin(n * theta);
    row[at(n)] = radial * c - slope * n * s;
    row[at(n) + 1] = radial * s + slope * n * c;
    row[at(n) + 2] = tangential * c;
    row[at(n) + 3] = tangential * s;
    if (g_.support > 0 && n >= 2) {  // inextensional: v = -(a/n) sin + (b/n) cos
      row[spline_at(n)] = spline_radial * c - spline_slope * n * s - spline_tangential / n * s;
      row[spline_at(n) + 1] = spline_radial * s + spline_slope * n * c + spline_tangential / n * c;
    }
  }
  Eigen::VectorXd out(row_.cols());
  apply_compliance(row.transpose(), out);
  compliant_row_.row(contact) = out.transpose();
}

void CoupledDrive::apply_compliance(const Eigen::VectorXd& load,
                                    Eigen::Ref<Eigen::VectorXd> out) const {
  const Mode& breathing = modes_[0];
  out[0] = load[0] / (breathing.extension + breathing.rim_bending + breathing.outer_bending);
  for (int n = 1; n <= N_; ++n) {
    const Mode& mode = modes_[static_cast<std::size_t>(n)];
    const double bend = mode.rim_bending + mode.outer_bending + mode.barrel + mode.diaphragm;
    double ww;  // (TC-4): inverse of [[bend + ke, n ke], [n ke, n^2 ke]]
    double wv;
    double vv;
    if (n == 1) {
      const double ke = mode.extension;
      const double kl = mode.lateral;
      const double det = kl * (kl + 2 * ke);
      ww = (ke + kl) / det;
      wv = -ke / det;
      vv = ww;
    } else {
      ww = 1 / bend;
      wv = -1 / (n * bend);
      vv = (1 / mode.extension + 1 / bend) / (n * n);
    }
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
  for (const Softening& soft : softenings_)
    out += soft.factor * soft.response.dot(load) * soft.response;  // (TC-22)
}

void CoupledDrive::soften(const std::vector<RingHinge>& hinges) {
  for (const RingHinge& hinge : hinges) {
    const bool spline = hinge.ring == RingHinge::Ring::spline;
    if (spline && g_.support <= 0) continue;  // a rigid ring does not bend
    const double R = spline ? g_.spline_radius : g_.ring_radius;
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
    apply_compliance(soft.curvature, soft.response);
    // Below 1: the energy of the mean curvature is never more than that of the curvature itself.
    soft.factor = soft.softening / (1 - soft.softening * soft.curvature.dot(soft.response));
    softenings_.push_back(std::move(soft));
  }
}

void CoupledDrive::soften_contacts(const ContactCracks& cracks) {
  const auto distance = [&](int contact, double position) {
    return std::abs(std::remainder(position_of(contact) - position, 2 * pi));
  };
  for (const SoftBall& soft : cracks.balls) {
    int nearest = 0;
    for (int k = 1; k < g_.balls; ++k)
      if (distance(k, soft.position) < distance(nearest, soft.position)) nearest = k;
    own_[nearest] += soft.compliance;  // (TC-23)
  }
  for (const SoftTooth& soft : cracks.teeth) {
    if (tooth_count_ == 0) continue;
    int nearest = g_.balls;
    for (int i = g_.balls; i < g_.balls + tooth_count_; ++i)
      if (distance(i, soft.position) < distance(nearest, soft.position)) nearest = i;
    if (distance(nearest, soft.position) > pi / g_.teeth * (1 + 1e-9)) continue;  // never loaded
    multiplier_[nearest] *= 1 - soft.stiffness_loss;                              // (TC-21)
    multiplier_[nearest + tooth_count_] *= 1 - soft.stiffness_loss;
  }
}

double CoupledDrive::flexibility(int i, int j) {
  double& entry = flexibility_(i, j);
  if (std::isnan(entry)) {
    entry = row_.row(i).dot(compliant_row_.row(j)) + (i == j ? own_[i] : 0.0);  // (TC-4)
    flexibility_(j, i) = entry;
  }
  return entry;
}

CoupledDrive::Law CoupledDrive::law(int contact, double closing) const {
  if (closing <= 0) return {};
  if (contact < g_.balls) {
    const double root = std::sqrt(closing);
    const double force = g_.ball_stiffness * closing * root;  // (TC-5)
    return {force, 1.5 * g_.ball_stiffness * root, 0.4 * force * closing};
  }
  const double m = multiplier_[contact];
  return {m * g_.flank.force(closing), m * g_.flank.stiffness(closing),
          m * g_.flank.energy(closing)};
}

Eigen::VectorXd CoupledDrive::closing(const Eigen::VectorXd& force, double rotation) const {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(coefficients());
  for (int i = 0; i < contacts(); ++i)
    if (force[i] != 0) x -= force[i] * compliant_row_.row(i).transpose();
  Eigen::VectorXd u = free_ + amplitude_ * cam_ + rotation * rotation_;
  u.noalias() += row_ * x;
  u -= own_.cwiseProduct(force);
  return u;
}

double CoupledDrive::free_travel(const Eigen::VectorXd& closing, double load) const {
  double travel = std::numeric_limits<double>::infinity();
  for (int i = g_.balls; i < contacts(); ++i)
    if (rotation_[i] * load > 0)
      travel = std::min(travel, std::max(0.0, -closing[i] / std::abs(rotation_[i])));
  // A little farther, so that the flank that touches first has a stiffness.
  return std::copysign(travel + 1e-3 * g_.radial_displacement, load);
}

Equilibrium CoupledDrive::solve(double torque, const Equilibrium& start) {
  // (TC-11): Newton's method on the contact forces; the energy along a step decides its length.
  const double load = torque / g_.ring_radius;
  Equilibrium state = start;
  state.torque = torque;
  state.converged = false;
  state.closing = closing(state.force, state.rotation);
  std::vector<int> active;
  Eigen::VectorXd root;  // of the stiffness of the active contacts
  const auto energy = [&](const Eigen::VectorXd& force, const Eigen::VectorXd& u, double rotation) {
    double sum = -load * rotation;
    for (int i = 0; i < contacts(); ++i) {
      sum += law(i, u[i]).energy;
      if (force[i] != 0)
        sum += 0.5 * force[i] * (free_[i] + amplitude_ * cam_[i] + rotation * rotation_[i] - u[i]);
    }
    return sum;
  };
  for (state.iterations = 0; state.iterations < max_iterations_; ++state.iterations) {
    active.clear();
    for (int i = 0; i < contacts(); ++i)
      if (state.closing[i] > 0 && law(i, state.closing[i]).stiffness > 0) active.push_back(i);
    const auto m = static_cast<Eigen::Index>(active.size());
    // With forces lambda = root y the matrix 1 + root C root is well conditioned, however soft a
    // contact that only just touches.
    Eigen::MatrixXd matrix(m, m);
    Eigen::VectorXd right(m);
    Eigen::VectorXd border(m);
    root.resize(m);
    for (Eigen::Index p = 0; p < m; ++p) {
      const int i = active[static_cast<std::size_t>(p)];
      const Law at = law(i, state.closing[i]);
      root[p] = std::sqrt(at.stiffness);
      right[p] =
          at.force / root[p] + root[p] * (free_[i] + amplitude_ * cam_[i] - state.closing[i]);
      border[p] = root[p] * rotation_[i];
      for (Eigen::Index q = 0; q <= p; ++q)
        matrix(p, q) = root[p] * root[q] * flexibility(i, active[static_cast<std::size_t>(q)]);
      matrix(p, p) += 1.0;
    }
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>, Eigen::Lower> factor(matrix);
    const Eigen::VectorXd base = factor.solve(right);
    const Eigen::VectorXd turned = factor.solve(border);
    // Without a flank in contact nothing resists the rotation: the ring turns until one touches.
    const double resistance = border.dot(turned);
    double rotation = state.rotation;
    if (resistance > 0)
      rotation = (load - border.dot(base)) / resistance;
    else if (load != 0)
      rotation += free_travel(state.closing, load);
    Eigen::VectorXd force = Eigen::VectorXd::Zero(contacts());
    for (Eigen::Index p = 0; p < m; ++p)
      force[active[static_cast<std::size_t>(p)]] = root[p] * (base[p] + turned[p] * rotation);
    const Eigen::VectorXd u = closing(force, rotation);

    // Full step if it lands on the laws of the contacts.
    double largest = 0.0;
    double error = 0.0;
    double carried = 0.0;
    for (int i = 0; i < contacts(); ++i) {
      const double is = law(i, u[i]).force;
      largest = std::max(largest, is);
      error = std::max(error, std::abs(is - force[i]));
      carried += is * rotation_[i];
    }
    error = std::max(error, std::abs(carried - load));
    state.residual = largest > 0 ? error / largest : std::abs(load);
    if (error <= tolerance_ * largest || (largest == 0 && load == 0)) {
      state.force = force;
      state.closing = u;
      state.rotation = rotation;
      state.converged = true;
      ++state.iterations;
      break;
    }
    const Eigen::VectorXd d_force = force - state.force;
    const Eigen::VectorXd d_closing = u - state.closing;
    const double d_rotation = rotation - state.rotation;
    const double before = energy(state.force, state.closing, state.rotation);
    double slope = -load * d_rotation;
    for (int i = 0; i < contacts(); ++i) {
      slope += law(i, state.closing[i]).force * d_closing[i];
      if (d_force[i] != 0)
        slope += d_force[i] * (free_[i] + amplitude_ * cam_[i] + state.rotation * rotation_[i] -
                               state.closing[i]);
    }
    double step = 1.0;
    const double noise = 1e-14 * std::abs(before);
    while (step > 1e-10 &&
           energy(state.force + step * d_force, state.closing + step * d_closing,
                  state.rotation + step * d_rotation) > before + 1e-4 * step * slope + noise)
      step /= 2;
    state.force += step * d_force;
    state.closing += step * d_closing;
    state.rotation += step * d_rotation;
  }
  return state;
}

CoupledDrive::Tangent CoupledDrive::linear_response(const Equilibrium& state,
                                                    const Eigen::VectorXd& moved, double load) {
  std::vector<int> active;
  for (int i = 0; i < contacts(); ++i)
    if (state.closing[i] > 0 && law(i, state.closing[i]).stiffness > 0) active.push_back(i);
  const auto m = static_cast<Eigen::Index>(active.size());
  Eigen::MatrixXd matrix(m, m);
  Eigen::VectorXd root(m);
  Eigen::VectorXd border(m);
  Eigen::VectorXd right(m);
  for (Eigen::Index p = 0; p < m; ++p) {
    const int i = active[static_cast<std::size_t>(p)];
    root[p] = std::sqrt(law(i, state.closing[i]).stiffness);
    border[p] = root[p] * rotation_[i];
    right[p] = root[p] * moved[i];
    for (Eigen::Index q = 0; q <= p; ++q)
      matrix(p, q) = root[p] * root[q] * flexibility(i, active[static_cast<std::size_t>(q)]);
    matrix(p, p) += 1.0;
  }
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>, Eigen::Lower> factor(matrix);
  const Eigen::VectorXd base = factor.solve(right);
  const Eigen::VectorXd turned = factor.solve(border);
  const double resistance = border.dot(turned);
  Tangent result{.force = Eigen::VectorXd::Zero(contacts())};
  if (resistance > 0)
    result.rotation = (load - border.dot(base)) / resistance;
  else if (load != 0)  // no flank touches: the ring turns freely
    result.rotation = std::numeric_limits<double>::infinity();
  const double turn = std::isfinite(result.rotation) ? result.rotation : 0.0;
  for (Eigen::Index p = 0; p < m; ++p)
    result.force[active[static_cast<std::size_t>(p)]] = root[p] * (base[p] + turned[p] * turn);
  return result;
}

CoupledDrive::Tangent CoupledDrive::tangent(const Equilibrium& state) {
  return linear_response(state, Eigen::VectorXd::Zero(contacts()), 1 / g_.ring_radius);  // (TC-15)
}

bool CoupledDrive::assemble() {
  // (TC-12)
  const double w0 = g_.radial_displacement;
  amplitude_ = 1.02 * w0 + g_.clearance;
  assembled_ = {};
  assembled_.force = Eigen::VectorXd::Zero(contacts());
  for (int step = 0; step < 50; ++step) {
    assembled_ = solve(0.0, assembled_);
    if (!assembled_.converged) return false;
    const double lobe = lobe_.dot(coefficients_of(assembled_.force));
    const double missing = w0 - lobe;
    if (std::abs(missing) <= 1e-12 * w0) {
      rest_nearest_to_zero();
      return true;
    }
    const Tangent response = linear_response(assembled_, cam_, 0.0);
    const double rise = lobe_.dot(coefficients_of(response.force));
    if (!(rise > 0)) {
      amplitude_ += missing;  // no ball touches yet
      continue;
    }
    amplitude_ += std::clamp(missing / rise, -w0, w0);
    if (!std::isfinite(amplitude_)) return false;
  }
  if (!(std::abs(w0 - lobe_.dot(coefficients_of(assembled_.force))) <= 1e-9 * w0)) return false;
  rest_nearest_to_zero();
  return true;
}

void CoupledDrive::rest_nearest_to_zero() {
  // (TC-11): without torque no flank carries, and the ring may turn until one touches.
  const double negligible = 1e-10 * assembled_.force.head(g_.balls).maxCoeff();
  double drive = -std::numeric_limits<double>::infinity();  // closing of the flank nearest to touch
  double coast = drive;
  for (int i = g_.balls; i < contacts(); ++i) {
    if (assembled_.force[i] > negligible) return;  // interference: the flanks hold the ring
    double& nearest = i < g_.balls + tooth_count_ ? drive : coast;
    nearest = std::max(nearest, assembled_.closing[i]);
  }
  const double rate = rotation_[g_.balls];  // of closing, the same for all flanks but for its sign
  const double at = assembled_.rotation;
  assembled_.rotation = std::min(std::max(0.0, at + coast / rate), at - drive / rate);
  assembled_.force.tail(contacts() - g_.balls).setZero();
  assembled_.closing = closing(assembled_.force, assembled_.rotation);
}

bool CoupledDrive::assemble_on(double cam_amplitude) {
  amplitude_ = cam_amplitude;
  assembled_ = {};
  assembled_.force = Eigen::VectorXd::Zero(contacts());
  assembled_ = solve(0.0, assembled_);
  if (assembled_.converged) rest_nearest_to_zero();
  return assembled_.converged;
}

Eigen::VectorXd CoupledDrive::coefficients_of(const Eigen::VectorXd& force) const {
  return -(compliant_row_.transpose() * force);
}

void CoupledDrive::add_shares(const Equilibrium& state, const Tangent& tangent,
                              std::array<double, kCurveMembers>& share) const {
  const auto add = [&](CurveMember member, double value) {
    share[static_cast<std::size_t>(member)] += value;
  };
  for (int i = 0; i < contacts(); ++i)
    if (tangent.force[i] != 0)
      add(i < g_.balls ? CurveMember::balls : CurveMember::teeth,
          tangent.force[i] * tangent.force[i] * (1 / law(i, state.closing[i]).stiffness + own_[i]));
  const Eigen::VectorXd x = coefficients_of(tangent.force);
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

double CoupledDrive::radial(const Eigen::VectorXd& x, double theta) const {
  double w = x[0];
  for (int n = 1; n <= N_; ++n)
    w += x[at(n)] * std::cos(n * theta) + x[at(n) + 1] * std::sin(n * theta);
  return w;
}

double CoupledDrive::tangential(const Eigen::VectorXd& x, double theta) const {
  double v = 0.0;
  for (int n = 1; n <= N_; ++n)
    v += x[at(n) + 2] * std::cos(n * theta) + x[at(n) + 3] * std::sin(n * theta);
  return v;
}

double CoupledDrive::curvature(const Eigen::VectorXd& x, double theta) const {
  const double R2 = g_.ring_radius * g_.ring_radius;
  double kappa = 0.0;  // -(w'' + w)/R^2, positive where the ring bends more
  for (int n = 2; n <= N_; ++n)
    kappa +=
        (n * n - 1.0) / R2 * (x[at(n)] * std::cos(n * theta) + x[at(n) + 1] * std::sin(n * theta));
  return kappa - x[0] / R2;
}

double CoupledDrive::hoop_strain(const Eigen::VectorXd& x, double theta) const {
  double strain = x[0];
  for (int n = 1; n <= N_; ++n)
    strain += (x[at(n)] + n * x[at(n) + 3]) * std::cos(n * theta) +
              (x[at(n) + 1] - n * x[at(n) + 2]) * std::sin(n * theta);
  return strain / g_.ring_radius;
}

}  // namespace strainwave
