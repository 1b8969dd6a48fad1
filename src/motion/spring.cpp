// SPDX-License-Identifier: Apache-2.0
#include "strainwave/motion/spring.hpp"

#include <algorithm>
#include <cmath>

#include "strainwave/core/error.hpp"

namespace strainwave {
namespace {

constexpr const char* kStiffness = "N*m/rad";

void positive(const char* field, double value, const char* unit) {
  require(value > 0 && std::isfinite(value), field, value, unit, "> 0");
}

void check(const LinearSpring& spring) { positive("stiffness", spring.stiffness, kStiffness); }
void check(const CatalogueSpring& spring) {
  positive("K1", spring.stiffness[0], kStiffness);
  positive("K2", spring.stiffness[1], kStiffness);
  positive("K3", spring.stiffness[2], kStiffness);
  positive("T1", spring.torque[0], "N*m");
  require(spring.torque[1] > spring.torque[0] && std::isfinite(spring.torque[1]), "T2",
          spring.torque[1], "N*m", "larger than T1");
}
void check(const CubicSpring& spring) {
  positive("stiffness", spring.stiffness, kStiffness);
  require(spring.cubic >= 0 && std::isfinite(spring.cubic), "cubic", spring.cubic, "N*m/rad^3",
          ">= 0");
}

}  // namespace

SpringState LinearSpring::in_series(double twist, double compliance) const {
  const double torque = twist * stiffness / (1 + compliance * stiffness);  // (MO-1)
  return {.torque = torque, .twist = torque / stiffness};
}
double LinearSpring::twist(double torque) const { return torque / stiffness; }
double LinearSpring::energy(double twist) const { return stiffness * twist * twist / 2; }
double LinearSpring::tangent(double) const { return stiffness; }
std::array<double, 0> LinearSpring::corners() const { return {}; }

SpringState CatalogueSpring::in_series(double twist, double compliance) const {
  double left = std::abs(twist);
  SpringState at;  // at the beginning of a piece
  for (std::size_t i = 0; i < stiffness.size(); ++i) {
    const double in_series = 1 + compliance * stiffness[i];
    const double own = left / in_series;
    const double more = own * stiffness[i];
    if (i == torque.size() || at.torque + more <= torque[i])
      return {.torque = std::copysign(at.torque + more, twist),  // (MO-1, MO-2)
              .twist = std::copysign(at.twist + own, twist)};
    const double whole = (torque[i] - at.torque) / stiffness[i];
    left -= whole * in_series;
    at = {.torque = torque[i], .twist = at.twist + whole};
  }
  return at;
}
double CatalogueSpring::twist(double of_torque) const {
  const double size = std::abs(of_torque);
  double sum = 0.0;
  double from = 0.0;  // torque at the beginning of a piece
  for (std::size_t i = 0; i < stiffness.size(); ++i) {
    const double to = i < torque.size() ? std::min(size, torque[i]) : size;
    sum += (to - from) / stiffness[i];  // (MO-2)
    if (to == size) break;
    from = to;
  }
  return std::copysign(sum, of_torque);
}
double CatalogueSpring::energy(double twist) const {
  double left = std::abs(twist);
  double from = 0.0;  // torque at the beginning of a piece
  double energy = 0.0;
  for (std::size_t i = 0; i < stiffness.size(); ++i) {
    const bool last = i == torque.size() || from + stiffness[i] * left <= torque[i];
    const double through = last ? left : (torque[i] - from) / stiffness[i];
    energy += through * (from + stiffness[i] * through / 2);  // (MO-2)
    if (last) break;
    left -= through;
    from = torque[i];
  }
  return energy;
}
double CatalogueSpring::tangent(double twist) const {
  const double size = std::abs(in_series(twist, 0.0).torque);
  return stiffness[size > torque[1] ? 2 : size > torque[0] ? 1 : 0];
}

SpringState CubicSpring::in_series(double twist, double compliance) const {
  // (MO-3): psi + Lambda (K psi + K_3 psi^3) = phi has one real root.
  const double third = compliance * cubic;
  const double first = 1 + compliance * stiffness;
  double own = twist / first;
  if (third > 0) {
    const double p = first / third;
    const double q = twist / third;
    const double root = std::sqrt(p / 3);
    own = 2 * root * std::sinh(std::asinh(1.5 * q / (p * root)) / 3);
  }
  return {.torque = own * (stiffness + cubic * own * own), .twist = own};
}
double CubicSpring::twist(double torque) const {
  if (cubic == 0) return torque / stiffness;
  // (MO-3): the only real root of K psi + K_3 psi^3 = T.
  const double root = std::sqrt(stiffness / (3 * cubic));
  const double share = 1.5 * torque / (stiffness * root);
  return 2 * root * std::sinh(std::asinh(share) / 3);
}
double CubicSpring::energy(double twist) const {
  const double square = twist * twist;
  return square * (stiffness / 2 + cubic * square / 4);
}
double CubicSpring::tangent(double twist) const { return stiffness + 3 * cubic * twist * twist; }
std::array<double, 0> CubicSpring::corners() const { return {}; }

SpringState in_series(const Spring& spring, double twist, double compliance) {
  return std::visit([&](const auto& s) { return s.in_series(twist, compliance); }, spring);
}
double spring_twist(const Spring& spring, double torque) {
  return std::visit([&](const auto& s) { return s.twist(torque); }, spring);
}
double elastic_energy(const Spring& spring, double twist) {
  return std::visit([&](const auto& s) { return s.energy(twist); }, spring);
}
double tangent_stiffness(const Spring& spring, double twist) {
  return std::visit([&](const auto& s) { return s.tangent(twist); }, spring);
}
std::vector<double> corner_torques(const Spring& spring) {
  return std::visit(
      [](const auto& s) {
        const auto corners = s.corners();
        return std::vector<double>(corners.begin(), corners.end());
      },
      spring);
}
void require_constants(const Spring& spring) {
  std::visit([](const auto& s) { check(s); }, spring);
}

}  // namespace strainwave
