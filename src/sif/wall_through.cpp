// SPDX-License-Identifier: Apache-2.0
#include "strainwave/sif/member/wall_through.hpp"

#include <cmath>
#include <numbers>

#include "strainwave/crack_group/crack_row.hpp"

namespace strainwave::sif {

namespace {

using std::numbers::pi;

/// Replaces a rounding error by zero, because 45 and 90 degrees cannot be represented exactly in
/// radians.
double without_rounding_noise(double x) { return std::abs(x) < 1e-15 ? 0.0 : x; }
template <std::size_t N>
Dual<N> without_rounding_noise(Dual<N> x) {  // its derivatives are not rounding errors
  x.value = without_rounding_noise(x.value);
  return x;
}

/// Fitted to finite elements, tests/data/judgement_through.csv and judgement_closed.csv.
constexpr double kRelief = 10.5;
constexpr double kReliefPower = 1.35;
constexpr double kThickAxial = 0.05;
constexpr double kThickRound = 0.54;
constexpr double kThickPressed = 0.75;

/// Factors without bulging: each stress causes only its own mode, uniformly through the wall.
template <class Real>
BasicShellFactors<Real> flat_sheet() {
  return {.opening_by_normal = {.mean = 1.0, .linear = 0.0},
          .sliding_by_normal = {},
          .opening_by_shear = {},
          .sliding_by_shear = {.mean = 1.0, .linear = 0.0}};
}

/// The stress on the plane of a crack of a row that acts like its stress and its neighbours.
template <class Real>
BasicCrackPlaneStress<Real> with_neighbours(const BasicThroughCrackInTube<Real>& crack,
                                            const Real& a, bool open,
                                            const BasicCrackPlaneStress<Real>& stress) {
  const Real share = crack.row_share(a);
  BasicCrackPlaneStress<Real> result;
  if (!open) {
    const Real sliding = pressed_row(share, crack.row_angle());
    for (const std::size_t i : {kAxial, kTorsion})
      result.shear[i] = sliding * stress.shear[i];  // (CG-7)
    return result;
  }
  const BasicRowFactors<Real> row = row_factors(share, crack.row_angle());
  for (const std::size_t i : {kAxial, kTorsion}) {
    result.normal[i] = row.opening_by_normal * stress.normal[i] +
                       row.opening_by_shear * stress.shear[i];  // (CG-7)
    result.shear[i] = row.sliding_by_normal * stress.normal[i] +
                      row.sliding_by_shear * stress.shear[i];  // (CG-7)
  }
  return result;
}

template <class Real>
BasicCrackPlaneStress<Real> plane_stress(const Real& r, const Real& t, const Real& angle,
                                         const Real& nonuniformity) {
  using std::cos, std::sin;
  const Real sigma = 1 / (2 * pi * r * t);                // per unit of P
  const Real tau = nonuniformity / (2 * pi * r * r * t);  // per unit of T
  const Real s = without_rounding_noise(sin(angle));
  const Real c = without_rounding_noise(cos(angle));
  const Real cos_2beta = without_rounding_noise(c * c - s * s);
  return {.normal = {sigma * s * s, tau * 2 * s * c},  // (FR-6)
          .shear = {sigma * s * c, tau * cos_2beta}};  // (FR-6)
}

}  // namespace

CrackPlaneStress crack_plane_stress(double mean_radius, double wall_thickness, double angle,
                                    double nonuniformity) {
  return plane_stress(mean_radius, wall_thickness, angle, nonuniformity);
}

BasicCrackPlaneStress<CrackReal> crack_plane_stress(const CrackReal& mean_radius,
                                                    const CrackReal& wall_thickness,
                                                    const CrackReal& angle,
                                                    const CrackReal& nonuniformity) {
  return plane_stress(mean_radius, wall_thickness, angle, nonuniformity);
}

BasicCrackPlaneStress<DualReal> crack_plane_stress(const DualReal& mean_radius,
                                                   const DualReal& wall_thickness,
                                                   const DualReal& angle,
                                                   const DualReal& nonuniformity) {
  return plane_stress(mean_radius, wall_thickness, angle, nonuniformity);
}

template <class Real>
Real BasicThroughCrackInTube<Real>::wall_factor(const Real& a) const {
  const ApartAndPressed<Real> both = BasicWallFactor<Real>(*this).at(a);
  return open ? both.apart : both.pressed;
}

template <class Real>
BasicWallFactor<Real>::BasicWallFactor(const BasicThroughCrackInTube<Real>& crack)
    : thin_sheet_(crack.thin_sheet),
      poissons_ratio_squared_(crack.poissons_ratio * crack.poissons_ratio),
      wall_thickness_(crack.wall_thickness) {
  if (thin_sheet_ || !crack.shell_correction) return;
  using std::sin, std::sqrt;
  const Real sine = sin(crack.angle);
  const Real apart = kThickAxial + kThickRound * sine * sine;
  // Pressed faces reduce the effect; it vanishes if they only slide.
  const Real slant = without_rounding_noise(sin(2 * crack.angle));
  const Real pressed = apart - kThickPressed * slant * slant;
  const Real thickness =
      sqrt(crack.shell_parameter_squared(1.0)) * crack.wall_thickness / crack.mean_radius;
  bulging_ = {apart * thickness, pressed * thickness};
}

template <class Real>
ApartAndPressed<Real> BasicWallFactor<Real>::at(const Real& a) const {
  if (thin_sheet_) return {1.0, 1.0};
  using std::pow;
  const Real constraint =
      1 - poissons_ratio_squared_ / (1 + kRelief * pow(a / wall_thickness_, kReliefPower));
  return {constraint * (1 + bulging_.apart * a),
          constraint * (1 + bulging_.pressed * a)};  // (FR-21)
}

template <class Real>
BasicThroughCrackFamily<Real>::BasicThroughCrackFamily(const BasicThroughCrackInTube<Real>& crack)
    : crack_(crack),
      stress_(crack.tip_stress ? *crack.tip_stress
                               : crack_plane_stress(crack.mean_radius, crack.wall_thickness,
                                                    crack.angle, crack.stress_nonuniformity)),
      wall_(crack) {
  if (!crack.shell_correction) return;
  using std::sqrt;
  shell_per_size_ = sqrt(crack.shell_parameter_squared(1.0));
  shell_.emplace(crack.angle);
  if (crack.count > 1 && crack.open) row_.emplace(crack.angle);
}

template <class Real>
Real BasicThroughCrackFamily<Real>::wall_factor(const Real& a) const {
  const ApartAndPressed<Real> both = wall_factors(a);
  return crack_.open ? both.apart : both.pressed;
}

template <class Real>
LinearStressIntensity<2, Real> BasicThroughCrackFamily<Real>::linear_stress_intensity(
    const Real& a) const {
  return intensity(factors(a), a, crack_.open);
}

template <class Real>
ApartAndPressed<LinearStressIntensity<2, Real>> BasicThroughCrackFamily<Real>::in_both_states(
    const Real& a) const {
  const BasicShellFactors<Real> of_shell = factors(a);
  return {intensity(of_shell, a, true), intensity(of_shell, a, false)};
}

template <class Real>
BasicShellFactors<Real> BasicThroughCrackFamily<Real>::factors(const Real& a) const {
  if (!shell_) return flat_sheet<Real>();
  const Real lambda = shell_per_size_ * a;
  // Beyond the end of the table, its last value is used.
  return shell_->at(value_of(lambda) < kShellTableEnd ? lambda : Real(kShellTableEnd));
}

template <class Real>
LinearStressIntensity<2, Real> BasicThroughCrackFamily<Real>::intensity(
    const BasicShellFactors<Real>& f, const Real& a, bool open) const {
  using std::sqrt;
  const bool in_row = crack_.count > 1;
  const BasicCrackPlaneStress<Real> plane =
      in_row ? with_neighbours(crack_, a, open, stress_) : stress_;
  const bool curved_between = row_ && open;
  BasicShellFactors<Real> between{};  // what the curvature between the cracks adds
  if (curved_between) between = row_->at(Real(shell_per_size_ * a), crack_.row_share(a));
  const Real root = sqrt(pi * a);
  LinearStressIntensity<2, Real> k;
  const auto fill = [&](UnitStressIntensity<2, Real>& part, Real BasicWallIntensity<Real>::*which) {
    for (const std::size_t i : {kAxial, kTorsion}) {
      const Real& normal = plane.normal[i];
      const Real& shear = plane.shear[i];
      const Real& sound_normal = stress_.normal[i];
      const Real& sound_shear = stress_.shear[i];
      part.II[i] = f.sliding_by_shear.*which * shear * root;  // (FR-7)
      if (!open) continue;  // the faces carry the stress that presses them
      part.I[i] = (f.opening_by_normal.*which * normal + f.opening_by_shear.*which * shear) *
                  root;                                          // (FR-7, FR-9)
      part.II[i] += f.sliding_by_normal.*which * normal * root;  // (FR-9)
      if (!curved_between) continue;
      part.I[i] += (between.opening_by_normal.*which * sound_normal +
                    between.opening_by_shear.*which * sound_shear) *
                   root;  // (CG-8)
      part.II[i] += (between.sliding_by_normal.*which * sound_normal +
                     between.sliding_by_shear.*which * sound_shear) *
                    root;  // (CG-8)
    }
  };
  fill(k.mean, &BasicWallIntensity<Real>::mean);
  fill(k.slope, &BasicWallIntensity<Real>::linear);
  return k;
}

template <class Real>
Real BasicThroughCrackInTube<Real>::shell_release(const Real& a) const {
  BasicThroughCrackInTube crack = *this;
  crack.open = true;
  crack.count = 1;
  const auto release = [&](bool shell) {
    crack.shell_correction = shell;
    const auto [mean, slope] = crack.family().linear_stress_intensity(a);
    const auto square = [](const UnitStressIntensity<2, Real>& k) {
      return k.I[kTorsion] * k.I[kTorsion] + k.II[kTorsion] * k.II[kTorsion];
    };
    return Real(square(mean) + square(slope) / 3);
  };
  return release(true) / release(false);  // (FR-9)
}

template class BasicWallFactor<double>;
template class BasicWallFactor<CrackReal>;
template class BasicThroughCrackFamily<double>;
template class BasicThroughCrackFamily<CrackReal>;
template struct BasicThroughCrackInTube<double>;
template struct BasicThroughCrackInTube<CrackReal>;

}  // namespace strainwave::sif
