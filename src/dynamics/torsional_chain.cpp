// SPDX-License-Identifier: Apache-2.0
#include "strainwave/dynamics/torsional_chain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "free_chain.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// Squares of frequencies below this share of the largest one are only rounding.
constexpr double kRounding = 1e-12;

void check(const TorsionalChain& chain, std::span<const std::size_t> held) {
  if (chain.inertias.empty()) throw InputError("inertias", "must not be empty");
  for (const ChainInertia& of : chain.inertias) {
    require(of.inertia > 0 && std::isfinite(of.inertia), of.name + ".inertia", of.inertia, "kg*m^2",
            "> 0");
    require(of.damping_to_ground >= 0 && std::isfinite(of.damping_to_ground),
            of.name + ".damping_to_ground", of.damping_to_ground, "N*m*s/rad", ">= 0");
  }
  for (const ChainSpring& of : chain.springs) {
    require(of.compliance > 0 && std::isfinite(of.compliance), of.name + ".compliance",
            of.compliance, "rad/(N*m)", "> 0");
    require(of.damping >= 0 && std::isfinite(of.damping), of.name + ".damping", of.damping,
            "N*m*s/rad", ">= 0");
    if (of.twist_of.size() != chain.inertias.size())
      throw InputError(of.name + ".twist_of", "must have one number for each inertia");
    for (const double factor : of.twist_of)
      require(std::isfinite(factor), of.name + ".twist_of", factor, "1", "a finite number");
  }
  for (const std::size_t at : held)
    if (at >= chain.inertias.size())
      throw InputError("held", "must be indices of inertias of the chain");
}

/// Angles under torques of one frequency; (DY-6).
ChainResponse solved(const TorsionalChain& chain, const FreeChain& of, double frequency,
                     const Eigen::VectorXcd& torque) {
  require(frequency > 0 && std::isfinite(frequency), "frequency", frequency, "Hz", "> 0");
  const double omega = 2 * pi * frequency;
  Eigen::MatrixXcd dynamic =
      of.stiffness.cast<std::complex<double>>() + std::complex<double>(0, omega) * of.damping;
  dynamic.diagonal() -= omega * omega * of.mass;
  const Eigen::VectorXcd angle = dynamic.partialPivLu().solve(torque);
  ChainResponse response(chain.inertias.size());
  for (std::size_t j = 0; j < of.inertia.size(); ++j) {
    const std::complex<double> at = angle(static_cast<Eigen::Index>(j));
    if (!std::isfinite(at.real()) || !std::isfinite(at.imag())) refuse_infinite_response();
    response[of.inertia[j]] = at;
  }
  return response;
}

}  // namespace

FreeChain free_chain(const TorsionalChain& chain, std::span<const std::size_t> held) {
  check(chain, held);
  FreeChain made;
  for (std::size_t i = 0; i < chain.inertias.size(); ++i) {
    bool turns = true;
    for (const std::size_t at : held) turns = turns && at != i;
    if (turns) made.inertia.push_back(i);
  }
  if (made.inertia.empty()) throw InputError("held", "must leave an inertia that can turn");
  const auto n = static_cast<Eigen::Index>(made.inertia.size());
  made.mass.resize(n);
  made.stiffness = Eigen::MatrixXd::Zero(n, n);
  made.damping = Eigen::MatrixXd::Zero(n, n);
  made.twist.resize(static_cast<Eigen::Index>(chain.springs.size()), n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const ChainInertia& of = chain.inertias[made.inertia[static_cast<std::size_t>(j)]];
    made.mass(j) = of.inertia;
    made.damping(j, j) = of.damping_to_ground;
    for (std::size_t s = 0; s < chain.springs.size(); ++s)
      made.twist(static_cast<Eigen::Index>(s), j) =
          chain.springs[s].twist_of[made.inertia[static_cast<std::size_t>(j)]];
  }
  for (std::size_t s = 0; s < chain.springs.size(); ++s) {
    const Eigen::VectorXd g = made.twist.row(static_cast<Eigen::Index>(s));
    made.stiffness += g * g.transpose() / chain.springs[s].compliance;
    made.damping += chain.springs[s].damping * g * g.transpose();
  }
  return made;
}

void refuse_infinite_response() {
  throw InputError("frequency",
                   "is that of a resonance without damping, where the response is infinite; "
                   "give a damping");
}

std::vector<ChainMode> chain_modes(const TorsionalChain& chain, std::span<const std::size_t> held) {
  const FreeChain of = free_chain(chain, held);
  const Eigen::VectorXd root = of.mass.cwiseSqrt().cwiseInverse();
  // (DY-3), in angles times the root of the inertia.
  const Eigen::MatrixXd scaled = root.asDiagonal() * of.stiffness * root.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled);
  const double largest = std::max(eigen.eigenvalues().maxCoeff(), 0.0);
  // What twists no spring turns freely.
  const Eigen::Index free_turns =
      of.mass.size() -
      (chain.springs.empty() ? 0 : Eigen::FullPivLU<Eigen::MatrixXd>(of.twist).rank());
  std::vector<ChainMode> modes;
  for (Eigen::Index m = 0; m < of.mass.size(); ++m) {
    ChainMode mode;
    const Eigen::VectorXd angle = root.asDiagonal() * eigen.eigenvectors().col(m);
    mode.shape.assign(chain.inertias.size(), 0.0);
    for (std::size_t j = 0; j < of.inertia.size(); ++j)
      mode.shape[of.inertia[j]] = angle(static_cast<Eigen::Index>(j));
    const double square = eigen.eigenvalues()(m);
    if (m >= free_turns) {
      if (!(square > kRounding * largest))
        throw InputError("inertias",
                         "differ so much that the lowest frequency is below a millionth of the "
                         "highest one, where it cannot be computed; leave out the small inertias, "
                         "or correct the large one");
      const double omega = std::sqrt(square);
      mode.frequency = omega / (2 * pi);
      // Without damping the product may be -0.
      mode.damping_ratio = std::max(0.0, angle.dot(of.damping * angle) / (2 * omega));  // (DY-5)
      const Eigen::VectorXd twist = of.twist * angle;
      for (std::size_t s = 0; s < chain.springs.size(); ++s)
        mode.energy_share.push_back(std::pow(twist(static_cast<Eigen::Index>(s)), 2) /
                                    (chain.springs[s].compliance * square));  // (DY-4)
    }
    modes.push_back(std::move(mode));
  }
  return modes;
}

ChainResponse torque_response(const TorsionalChain& chain, std::size_t loaded, double frequency,
                              std::span<const std::size_t> held) {
  const FreeChain of = free_chain(chain, held);
  Eigen::VectorXcd torque = Eigen::VectorXcd::Zero(of.mass.size());
  bool turns = false;
  for (std::size_t j = 0; j < of.inertia.size(); ++j)
    if (of.inertia[j] == loaded) {
      torque(static_cast<Eigen::Index>(j)) = 1;
      turns = true;
    }
  if (!turns) throw InputError("loaded", "must be an inertia of the chain that can turn");
  return solved(chain, of, frequency, torque);
}

ChainResponse twist_response(const TorsionalChain& chain, std::size_t spring, double frequency,
                             std::span<const std::size_t> held) {
  const FreeChain of = free_chain(chain, held);
  if (spring >= chain.springs.size()) throw InputError("spring", "must be a spring of the chain");
  const ChainSpring& bent = chain.springs[spring];
  // (DY-7): the torque of the spring by the error alone acts against g.
  const std::complex<double> torque(1 / bent.compliance, 2 * pi * frequency * bent.damping);
  const Eigen::VectorXd g = of.twist.row(static_cast<Eigen::Index>(spring));
  return solved(chain, of, frequency, -torque * g);
}

double critical_speed(double frequency, double order) {
  require(frequency >= 0 && std::isfinite(frequency), "frequency", frequency, "Hz", ">= 0");
  require(order > 0 && std::isfinite(order), "order", order, "1", "> 0");
  return 2 * pi * frequency / order;  // (DY-8)
}

}  // namespace strainwave
