// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <variant>

#include "strainwave/drive_cracks/loaded_crack.hpp"

/// @file
/// Similar cracks: those whose dimensionless arguments agree.  Their added compliances differ by
/// factors alone (ST-21).  A kind of solution without a `Similarity` does not compile.
///
/// The added compliance under the torque, or under the lobe force, is sum_i w_i f_i(x).  Each
/// `Similarity<Solution>` has
///
///     kArguments         number of dimensionless arguments x
///     kWidths            widths of the boxes in which f is one polynomial, by argument
///     kParts             what each part f_i contains
///     kFacesChangeShape  whether f depends on the state of the faces
///     arguments(p)       x of a crack, from the numbers of its solution
///     fixed(p)           switches of the solution, which similar cracks share
///     weights(p, moduli, faces)  w_i
///     shape(p, x, part)  numbers of a crack with arguments x in its own unit of length, whose
///                        compliance f_i is; its switches are those of p
///     size_of(p)         the power of lengths in w_i
///     known(p)           whether the solution exists for these numbers; without it, it always does

namespace strainwave {

/// A part of an added compliance, by the modes that release it; the last is inversely proportional
/// to mu, the others to E'.
enum class CrackPart { opening, sliding, opening_and_sliding, tearing };

template <class Solution>
struct Similarity;

namespace similarity {

inline constexpr double kByLogarithm = 0.5;  ///< width of a box in the logarithm of a ratio
inline constexpr double kByPoissonsRatio = 0.1;
inline constexpr double kByAngle = 0.2;  ///< [rad]

}  // namespace similarity

template <>
struct Similarity<sif::ThroughCrackInTube> {
  using Parameters = sif::ThroughCrackInTube;
  static constexpr std::size_t kArguments = 4;
  static constexpr std::array kParts = {CrackPart::opening_and_sliding};
  static constexpr bool kFacesChangeShape = true;
  static constexpr std::array<double, kArguments> kWidths = {
      similarity::kByLogarithm, similarity::kByLogarithm, similarity::kByAngle,
      similarity::kByPoissonsRatio};

  static std::array<double, kArguments> arguments(const Parameters& p) {
    return {std::log(p.half_length / p.wall_thickness), std::log(p.wall_thickness / p.mean_radius),
            p.angle, p.poissons_ratio};
  }
  static bool known(const Parameters& p) {
    return p.count == 1 || row_gap(p.row_share(p.half_length), p.row_angle()) >= kLeastRowGap;
  }
  static auto fixed(const Parameters& p) {
    return std::tuple(p.shell_correction, p.thin_sheet, p.count, p.in_line);
  }
  static std::array<double, 1> weights(const Parameters& p, const CrackModuli& moduli, Faces) {
    return {p.stress_nonuniformity * p.stress_nonuniformity * size_of(p) / moduli.opening};
  }
  static Parameters shape(const Parameters& of, const std::array<double, kArguments>& x,
                          CrackPart) {
    Parameters p = of;
    p.half_length = std::exp(x[0]);
    p.wall_thickness = 1.0;
    p.mean_radius = std::exp(-x[1]);
    p.angle = x[2];
    p.poissons_ratio = x[3];
    p.stress_nonuniformity = 1.0;
    return p;
  }
  /// a^2/(t r^4) [1/m^3].
  static double size_of(const Parameters& p) {
    const double per_radius = p.half_length / (p.mean_radius * p.mean_radius);
    return per_radius * per_radius / p.wall_thickness;
  }
};

template <std::size_t N>
struct Similarity<sif::SurfaceCrack<N>> {
  using Parameters = typename sif::SurfaceCrack<N>::Parameters;
  static constexpr bool kSheared = N == 2;  ///< a wall; otherwise a ring under a normal stress
  static constexpr std::size_t kArguments = 4;
  static constexpr auto kParts = [] {
    if constexpr (kSheared)
      return std::array{CrackPart::opening, CrackPart::sliding, CrackPart::tearing};
    else
      return std::array{CrackPart::opening};
  }();
  static constexpr bool kFacesChangeShape = false;
  static constexpr std::array<double, kArguments> kWidths = {
      similarity::kByLogarithm, similarity::kByLogarithm, similarity::kByLogarithm,
      similarity::kByPoissonsRatio};

  static std::array<double, kArguments> arguments(const Parameters& p) {
    return {std::log(p.depth / p.thickness), std::log(p.aspect_ratio),
            p.half_width ? std::log(*p.half_width / p.thickness) : 0.0,
            kSheared ? p.poissons_ratio : 0.0};
  }
  static auto fixed(const Parameters& p) {
    return std::tuple(p.loading, p.half_width.has_value(), p.count);
  }
  static std::array<double, kParts.size()> weights(const Parameters& p, const CrackModuli& moduli,
                                                   Faces faces) {
    const double normal = p.normal_stress[N - 1] * p.normal_stress[N - 1] * size_of(p);
    const double opening = faces == Faces::pressed ? 0.0 : normal / moduli.opening;
    if constexpr (kSheared) {
      const double shear = p.shear_stress[N - 1] * p.shear_stress[N - 1] * size_of(p);
      return {opening, shear / moduli.opening, shear / moduli.shear};
    } else {
      return {opening};
    }
  }
  static Parameters shape(const Parameters& of, const std::array<double, kArguments>& x,
                          CrackPart part) {
    Parameters p = of;
    p.thickness = 1.0;
    p.depth = std::exp(x[0]);
    p.aspect_ratio = std::exp(x[1]);
    if (p.half_width) p.half_width = std::exp(x[2]);
    if (kSheared) p.poissons_ratio = x[3];
    p.normal_stress = {};
    p.shear_stress = {};
    (part == CrackPart::opening ? p.normal_stress : p.shear_stress)[N - 1] = 1.0;
    return p;
  }
  static double size_of(const Parameters& p) { return p.depth * p.depth * p.depth; }
};

template <>
struct Similarity<sif::EdgeCrack> {
  using Parameters = sif::EdgeCrack;
  static constexpr std::size_t kArguments = 1;
  static constexpr std::array kParts = {CrackPart::opening};
  static constexpr bool kFacesChangeShape = false;
  static constexpr std::array<double, kArguments> kWidths = {similarity::kByLogarithm};

  static std::array<double, kArguments> arguments(const Parameters& p) {
    return {std::log(p.depth / (p.thickness - p.depth))};
  }
  static auto fixed(const Parameters& p) { return p.loading; }
  static std::array<double, 1> weights(const Parameters& p, const CrackModuli& moduli,
                                       Faces faces) {
    if (faces == Faces::pressed) return {0.0};
    return {p.unit_stress * p.unit_stress * p.width * size_of(p) / moduli.opening};
  }
  static Parameters shape(const Parameters& of, const std::array<double, kArguments>& x,
                          CrackPart) {
    Parameters p = of;
    p.depth = 1 / (1 + std::exp(-x[0]));
    p.thickness = 1.0;
    p.width = 1.0;
    p.unit_stress = 1.0;
    return p;
  }
  static double size_of(const Parameters& p) { return p.depth * p.depth; }
};

template <>
struct Similarity<sif::AnnularCrackSolid> {
  using Parameters = sif::AnnularCrackSolid;
  static constexpr std::size_t kArguments = 1;
  static constexpr std::array kParts = {CrackPart::tearing};
  static constexpr bool kFacesChangeShape = false;
  static constexpr std::array<double, kArguments> kWidths = {similarity::kByLogarithm};

  static std::array<double, kArguments> arguments(const Parameters& p) {
    return {std::log(p.depth / (p.diameter / 2 - p.depth))};
  }
  static auto fixed(const Parameters& p) { return p.polynomials; }
  static std::array<double, 1> weights(const Parameters& p, const CrackModuli& moduli, Faces) {
    return {size_of(p) / moduli.shear};
  }
  static Parameters shape(const Parameters& of, const std::array<double, kArguments>& x,
                          CrackPart) {
    Parameters p = of;
    p.depth = 1 / (1 + std::exp(-x[0]));
    p.diameter = 2.0;
    return p;
  }
  /// a^2/d^5 [1/m^3].
  static double size_of(const Parameters& p) { return p.depth * p.depth / std::pow(p.diameter, 5); }
};

template <>
struct Similarity<sif::AnnularCrackHollow> {
  using Parameters = sif::AnnularCrackHollow::Parameters;
  static constexpr std::size_t kArguments = 2;
  static constexpr std::array kParts = {CrackPart::tearing};
  static constexpr bool kFacesChangeShape = false;
  static constexpr std::array<double, kArguments> kWidths = {similarity::kByLogarithm, 0.1};

  static std::array<double, kArguments> arguments(const Parameters& p) {
    return {std::log(p.depth / (p.outer_radius - p.inner_radius)), p.inner_radius / p.outer_radius};
  }
  static std::tuple<> fixed(const Parameters&) { return {}; }
  static std::array<double, 1> weights(const Parameters& p, const CrackModuli& moduli, Faces) {
    return {size_of(p) / moduli.shear};
  }
  static Parameters shape(const Parameters& of, const std::array<double, kArguments>& x,
                          CrackPart) {
    Parameters p = of;
    p.outer_radius = 1.0;
    p.inner_radius = x[1];
    p.depth = std::exp(x[0]) * (1 - x[1]);
    return p;
  }
  /// a^2/r_o^5 [1/m^3].
  static double size_of(const Parameters& p) {
    return p.depth * p.depth / std::pow(p.outer_radius, 5);
  }
};

template <>
struct Similarity<sif::ShaftSurfaceSolid> {
  using Parameters = sif::ShaftSurfaceSolid::Parameters;
  static constexpr std::size_t kArguments = 2;
  static constexpr std::array kParts = {CrackPart::sliding, CrackPart::tearing};
  static constexpr bool kFacesChangeShape = false;
  static constexpr std::array<double, kArguments> kWidths = {similarity::kByLogarithm,
                                                             similarity::kByLogarithm};

  static std::array<double, kArguments> arguments(const Parameters& p) {
    return {std::log(p.depth / p.diameter), std::log(p.half_length / p.diameter)};
  }
  static std::tuple<> fixed(const Parameters&) { return {}; }
  static std::array<double, 2> weights(const Parameters& p, const CrackModuli& moduli, Faces) {
    return {size_of(p) / moduli.opening, size_of(p) / moduli.shear};
  }
  static Parameters shape(const Parameters& of, const std::array<double, kArguments>& x,
                          CrackPart) {
    Parameters p = of;
    p.diameter = 1.0;
    p.depth = std::exp(x[0]);
    p.half_length = std::exp(x[1]);
    return p;
  }
  /// a^3/d^6 [1/m^3].
  static double size_of(const Parameters& p) {
    const double root = p.depth / (p.diameter * p.diameter);
    return root * root * root;
  }
};

template <>
struct Similarity<sif::ShaftSurfaceHollow> {
  using Parameters = sif::ShaftSurfaceHollow::Parameters;
  static constexpr std::size_t kArguments = 4;
  static constexpr std::array kParts = {CrackPart::sliding, CrackPart::tearing};
  static constexpr bool kFacesChangeShape = false;
  static constexpr std::array<double, kArguments> kWidths = {
      similarity::kByLogarithm, similarity::kByLogarithm, 0.1, similarity::kByPoissonsRatio};

  static std::array<double, kArguments> arguments(const Parameters& p) {
    return {std::log(p.depth / (p.outer_radius - p.inner_radius)),
            std::log(p.depth / p.half_length), p.inner_radius / p.outer_radius, p.poissons_ratio};
  }
  static std::tuple<> fixed(const Parameters&) { return {}; }
  static std::array<double, 2> weights(const Parameters& p, const CrackModuli& moduli, Faces) {
    return {size_of(p) / moduli.opening, size_of(p) / moduli.shear};
  }
  static Parameters shape(const Parameters& of, const std::array<double, kArguments>& x,
                          CrackPart) {
    Parameters p = of;
    p.outer_radius = 1.0;
    p.inner_radius = x[2];
    p.depth = std::exp(x[0]) * (1 - x[2]);
    p.half_length = p.depth / std::exp(x[1]);
    p.poissons_ratio = x[3];
    return p;
  }
  /// a^3/r_o^6 [1/m^3].
  static double size_of(const Parameters& p) {
    const double root = p.depth / (p.outer_radius * p.outer_radius);
    return root * root * root;
  }
};

/// One object of any solution of the series model, or none.
template <template <class> class Of>
using OfAnySolution = std::variant<std::monostate, Of<sif::SurfaceCrack<1>>, Of<sif::EdgeCrack>,
                                   Of<sif::ThroughCrackInTube>, Of<sif::SurfaceCrack<2>>,
                                   Of<sif::AnnularCrackSolid>, Of<sif::AnnularCrackHollow>,
                                   Of<sif::ShaftSurfaceSolid>, Of<sif::ShaftSurfaceHollow>>;

}  // namespace strainwave
