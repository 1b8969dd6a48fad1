// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

#include "strainwave/core/crack_real.hpp"
#include "strainwave/core/quadrature.hpp"

/// @file
/// The engine that turns stress intensity factors into added compliance, the same for all cracks. A
/// crack is a value that provides its stress intensity factors per unit of each generalised load,
/// and the area that its front sweeps; the engine derives everything else.
///
/// The scalar `Real` is double, or CrackReal for the derivatives too (core/crack_real.hpp).

namespace strainwave {

/// Symmetric N x N matrix, stored as its upper triangle, row by row.
template <std::size_t N, class Real = double>
struct SymmetricMatrix {
  std::array<Real, N*(N + 1) / 2> upper{};  ///< (0, 0), (0, 1), ..., (0, N-1), (1, 1), ...

  SymmetricMatrix() = default;
  /// A matrix whose entries are all equal to `fill`.
  explicit SymmetricMatrix(const Real& fill) { upper.fill(fill); }

  /// Place in `upper` of the entry (i, j), or (j, i).
  [[nodiscard]] static constexpr std::size_t index(std::size_t i, std::size_t j) {
    return i <= j ? i * N - i * (i + 1) / 2 + j : index(j, i);
  }
  /// The entry (i, j), which is also the entry (j, i).
  /// @{
  [[nodiscard]] const Real& operator()(std::size_t i, std::size_t j) const {
    return upper[index(i, j)];
  }
  Real& operator()(std::size_t i, std::size_t j) { return upper[index(i, j)]; }
  /// @}

  /// Sums, differences and multiples, entry by entry.
  /// @{
  SymmetricMatrix& operator+=(const SymmetricMatrix& other) {
    for (std::size_t n = 0; n < upper.size(); ++n) upper[n] += other.upper[n];
    return *this;
  }
  template <class Factor>
  SymmetricMatrix& operator*=(const Factor& factor) {
    for (Real& entry : upper) entry *= factor;
    return *this;
  }
  friend SymmetricMatrix operator-(SymmetricMatrix a) { return a *= -1.0; }
  friend SymmetricMatrix operator+(SymmetricMatrix a, const SymmetricMatrix& b) { return a += b; }
  friend SymmetricMatrix operator-(SymmetricMatrix a, SymmetricMatrix b) {
    return a += (b *= -1.0);
  }
  friend SymmetricMatrix operator*(SymmetricMatrix a, double factor) { return a *= factor; }
  friend SymmetricMatrix operator*(double factor, SymmetricMatrix a) { return a *= factor; }
  friend SymmetricMatrix operator*(SymmetricMatrix a, const Real& factor) requires is_dual<Real> {
    return a *= factor;
  }
  /// @}

  /// Largest magnitude of an entry; adaptive quadrature uses it as the norm.
  friend double abs(const SymmetricMatrix& a) {
    double largest = 0.0;
    for (const Real& entry : a.upper) largest = std::max(largest, magnitude(entry));
    return largest;
  }
};

/// What a crack has while its faces are apart, and while they are pressed together (FR-17).
template <class T>
struct ApartAndPressed {
  T apart{};    ///< with the faces apart
  T pressed{};  ///< with the faces pressed together
};

/// Indices of the two generalised loads of a tube or shaft.
enum Load2 : std::size_t { kAxial = 0, kTorsion = 1 };

/// k_m,i = dK_m/dQ_i: stress intensity factors of modes I, II, III per unit of each of N
/// generalised loads Q_i, at one point of the front [Pa*m^0.5 per unit of load].
template <std::size_t N, class Real = double>
struct UnitStressIntensity {
  std::array<Real, N> I{};    ///< dK_I/dQ_i, shape (N)
  std::array<Real, N> II{};   ///< dK_II/dQ_i, shape (N)
  std::array<Real, N> III{};  ///< dK_III/dQ_i, shape (N)
};

/// Mode II of a crack in a sheet that is not isotropic, (LA-9).
template <class Real>
struct AnisotropicSliding {
  Real sliding{};   ///< G per K_II^2 [1/Pa]
  Real coupling{};  ///< half of G per K_I K_II [1/Pa]
};

/// Elastic constants that turn stress intensity into energy.
template <class Real>
struct BasicCrackModuli {
  /// E' of modes I and II: E in plane stress, E/(1-nu^2) in plane strain [Pa].  In a sheet that is
  /// not isotropic: of mode I alone.
  Real opening{};
  Real shear{};  ///< shear modulus mu of mode III [Pa]
  /// Absent: mode II releases as much energy as mode I, independently of it.
  std::optional<AnisotropicSliding<Real>> anisotropic = {};

  /// Opening by a unit of shear stress on the crack's plane over that by a unit of normal stress
  /// [-]; 0 in an isotropic material.
  [[nodiscard]] Real opening_by_shear() const {
    return anisotropic ? Real(opening * anisotropic->coupling) : Real(0.0);
  }
  /// The constants of a crack whose faces are pressed together without friction and slide; its mode
  /// I is left out (LA-9).
  [[nodiscard]] BasicCrackModuli pressed() const {
    BasicCrackModuli without = *this;
    if (anisotropic)
      without.anisotropic = AnisotropicSliding<Real>{
          .sliding = anisotropic->sliding - opening_by_shear() * anisotropic->coupling,
          .coupling = Real(0.0)};
    return without;
  }
};
/// BasicCrackModuli without derivatives.
using CrackModuli = BasicCrackModuli<double>;

/// Energy release rate of a mixed-mode crack, G = (K_I^2 + K_II^2)/E' + K_III^2/(2 mu) [J/m^2].
///
/// Implements theory manual eqs. (FR-1) and (LA-9).  The term of mode III is the same in plane
/// stress and plane strain.
[[nodiscard]] inline double energy_release_rate(double K_I, double K_II, double K_III,
                                                const CrackModuli& moduli) {
  const double tearing = K_III * K_III / (2 * moduli.shear);
  if (const auto& sheet = moduli.anisotropic)
    return K_I * K_I / moduli.opening +  // (LA-9)
           K_II * (K_II * sheet->sliding + 2 * K_I * sheet->coupling) + tearing;
  return (K_I * K_I + K_II * K_II) / moduli.opening + tearing;  // (FR-1)
}

/// Parameter range of a crack front; begin == end for a front of one point.  Each crack states what
/// its parameter s is.
struct FrontRange {
  double begin = 0.0;  ///< s at the first end [-] or [rad]
  double end = 0.0;    ///< s at the other end, likewise; >= begin
};

/// The scalar type in which a crack computes.
template <class Crack>
using ScalarOf = std::remove_cvref_t<decltype(std::declval<const Crack&>().size())>;

/// Requirements of the engine on a crack.
///
/// The front is a curve with parameter s.  While the crack grows from 0 to size(), a piece ds of
/// the front at size a sweeps the area swept_area(a, s) ds da; where the front is one point, it
/// sweeps swept_area(a, s) da.
template <class C>
concept SweptCrack = requires(const C& crack, const ScalarOf<C>& a, double s) {
  { C::kLoads } -> std::convertible_to<std::size_t>;
  { crack.size() } -> std::convertible_to<ScalarOf<C>>;
  { crack.front() } -> std::same_as<FrontRange>;
  { crack.stress_intensity(a, s) } -> std::same_as<UnitStressIntensity<C::kLoads, ScalarOf<C>>>;
  { crack.swept_area(a, s) } -> std::convertible_to<ScalarOf<C>>;
};

/// Stress intensity that is linear along a front, k = mean + s slope for s from -1 to 1.
template <std::size_t N, class Real = double>
struct LinearStressIntensity {
  UnitStressIntensity<N, Real> mean;   ///< k at s = 0, the mean along the front
  UnitStressIntensity<N, Real> slope;  ///< dk/ds, so that k at s = 1 is mean + slope

  /// k at one place, s from -1 to 1 [-].
  [[nodiscard]] UnitStressIntensity<N, Real> at(double s) const {
    UnitStressIntensity<N, Real> k = mean;
    for (std::size_t i = 0; i < N; ++i) {
      k.I[i] += s * slope.I[i];
      k.II[i] += s * slope.II[i];
      k.III[i] += s * slope.III[i];
    }
    return k;
  }
};

/// A crack with linear stress intensity along its front and a swept area that is the same at every
/// s.  It needs no quadrature along the front.  `family()` is the crack at all sizes, in which what
/// does not depend on the size is computed once.
template <class C>
concept LinearFront = SweptCrack<C> && requires(const C& crack, const ScalarOf<C>& a) {
  {
    crack.family().linear_stress_intensity(a)
    } -> std::same_as<LinearStressIntensity<C::kLoads, ScalarOf<C>>>;
};

/// A crack for which one quadrature along the front serves all sizes: K of each mode varies along
/// the front alike for all loads, and the swept area is the same at every s.  `front_squares` is
/// empty if the crack's loading needs a quadrature at each size.  The root mean square of each
/// mode's K along the front releases the same energy as the front.
template <class C>
concept FrontOfSquares = SweptCrack<C> &&
    requires(const C& crack, const ScalarOf<C>& a, const QuadratureOptions& o) {
  { crack.front_squares(o)->converged } -> std::convertible_to<bool>;
  {
    crack.root_mean_square(a, *crack.front_squares(o))
    } -> std::same_as<UnitStressIntensity<C::kLoads, ScalarOf<C>>>;
};

/// A crack in a wall too thick for a sheet: G is wall_factor(a) times the value from K and the
/// moduli.
template <class C>
concept WallCrack = LinearFront<C> && requires(const C& crack, const ScalarOf<C>& a) {
  { crack.family().wall_factor(a) } -> std::convertible_to<ScalarOf<C>>;
};

/// A crack whose stress intensity, as a function of the size, has a step in a derivative at one
/// size.  The quadrature ends a piece there, because inside of a piece a step escapes its estimate
/// of the error.
template <class C>
concept KinkedCrack = SweptCrack<C> && requires(const C& crack) {
  { crack.kink() } -> std::convertible_to<ScalarOf<C>>;
};

/// A crack whose solutions with the faces apart and pressed share most of their work, so one
/// quadrature takes both.
template <class C>
concept SharedByFaces = WallCrack<C> && requires(const C& crack, const ScalarOf<C>& a) {
  {
    crack.family().in_both_states(a)
    } -> std::same_as<ApartAndPressed<LinearStressIntensity<C::kLoads, ScalarOf<C>>>>;
  { crack.family().wall_factors(a) } -> std::same_as<ApartAndPressed<ScalarOf<C>>>;
};

/// A crack whose stress intensity was derived from its added compliance, which it knows at every
/// size without a quadrature.
template <class C>
concept KnownCompliance = SweptCrack<C> &&
    requires(const C& crack, const BasicCrackModuli<ScalarOf<C>>& moduli) {
  { crack.compliance(moduli) } -> std::same_as<SymmetricMatrix<C::kLoads, ScalarOf<C>>>;
};

/// Added compliance matrix with the error estimate of its quadrature.
template <std::size_t N, class Real = double>
struct CrackCompliance {
  /// Delta lambda_ij [displacement of load i per unit of load j]
  SymmetricMatrix<N, Real> matrix = {};
  /// estimated error of the quadrature, relative to the largest entry
  double relative_error = 0.0;
  bool converged = false;  ///< every integral met its tolerance
};

/// d(lambda_ij)/dA at one point of the front.
///
/// Implements theory manual eq. (FR-2), the integrand,
///
///     (2/E')(k_I,i k_I,j + k_II,i k_II,j) + (1/mu) k_III,i k_III,j,
///
/// and (LA-9) in a sheet that is not isotropic.
template <std::size_t N, class Real>
[[nodiscard]] SymmetricMatrix<N, Real> compliance_density(
    const UnitStressIntensity<N, Real>& k,
    const std::type_identity_t<BasicCrackModuli<Real>>& moduli) {
  SymmetricMatrix<N, Real> density;
  if (const auto& sheet = moduli.anisotropic) {
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t j = i; j < N; ++j)
        density(i, j) = 2 * (k.I[i] * k.I[j] / moduli.opening +  // (LA-9)
                             k.II[i] * k.II[j] * sheet->sliding +
                             (k.I[i] * k.II[j] + k.II[i] * k.I[j]) * sheet->coupling) +
                        k.III[i] * k.III[j] / moduli.shear;
    return density;
  }
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = i; j < N; ++j)
      density(i, j) = 2 / moduli.opening * (k.I[i] * k.I[j] + k.II[i] * k.II[j]) +  // (FR-2)
                      k.III[i] * k.III[j] / moduli.shear;
  return density;
}

/// Mean of d(lambda_ij)/dA along a front with linear stress intensity; (FR-2).
template <std::size_t N, class Real>
[[nodiscard]] SymmetricMatrix<N, Real> mean_compliance_density(
    const LinearStressIntensity<N, Real>& k, const BasicCrackModuli<Real>& moduli) {
  return compliance_density(k.mean, moduli) + compliance_density(k.slope, moduli) * Real(1.0 / 3);
}

/// Units of the entries of a compliance matrix in which loads that release equal energy count
/// alike, so that one tolerance suits all entries.
template <std::size_t N, class Real>
[[nodiscard]] SymmetricMatrix<N> units_of_equal_energy(const SymmetricMatrix<N, Real>& matrix) {
  SymmetricMatrix<N> units(1.0);
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = i; j < N; ++j) {
      const double product =
          std::sqrt(magnitude(matrix(i, i))) * std::sqrt(magnitude(matrix(j, j)));
      if (product > 0) units(i, j) = product;
    }
  return units;
}

/// A matrix divided by its units, entry by entry, and multiplied by them again.
/// @{
template <std::size_t N, class Real>
[[nodiscard]] SymmetricMatrix<N, Real> over_units(SymmetricMatrix<N, Real> matrix,
                                                  const SymmetricMatrix<N>& units) {
  for (std::size_t n = 0; n < units.upper.size(); ++n) matrix.upper[n] /= units.upper[n];
  return matrix;
}
template <std::size_t N, class Real>
[[nodiscard]] SymmetricMatrix<N, Real> in_units(SymmetricMatrix<N, Real> matrix,
                                                const SymmetricMatrix<N>& units) {
  for (std::size_t n = 0; n < units.upper.size(); ++n) matrix.upper[n] *= units.upper[n];
  return matrix;
}
/// @}

/// Integral over the size of a crack, from 0 to the size that it has; (FR-2).
/// @param crack        gives the size
/// @param along_front  callable: size -> what the front at this size adds per unit of size
/// @param options      tolerance of the adaptive quadrature
template <SweptCrack Crack, class AlongFront>
[[nodiscard]] auto integrated_over_size(const Crack& crack, const AlongFront& along_front,
                                        const QuadratureOptions& options) {
  using Real = ScalarOf<Crack>;
  if constexpr (WallCrack<Crack>) {
    // A non-integer power of a is smoother as a function of the square root of a.
    const auto over_root = [&](double u) {
      const Real a = crack.size() * (u * u);
      return along_front(a) * (2 * u * crack.size());
    };
    return integrate(over_root, 0.0, 1.0, options);
  } else if constexpr (KinkedCrack<Crack>) {
    const Real kink = crack.kink();
    if (!(value_of(kink) < value_of(crack.size())))
      return integrate(along_front, 0.0, crack.size(), options);
    auto whole = integrate(along_front, 0.0, kink, options);
    const auto beyond = integrate(along_front, kink, crack.size(), options);
    whole.value += beyond.value;
    whole.error += beyond.error;
    whole.converged = whole.converged && beyond.converged;
    return whole;
  } else {
    return integrate(along_front, 0.0, crack.size(), options);
  }
}

/// The integral of `added_compliance` by adaptive quadrature, for any crack.
///
/// Implements theory manual eq. (FR-2).
/// @param crack    stress intensity per unit of each generalised load, and the swept area
/// @param moduli   E' and mu; > 0
/// @param options  tolerance of the adaptive quadrature
template <SweptCrack Crack>
[[nodiscard]] CrackCompliance<Crack::kLoads, ScalarOf<Crack>> integrated_compliance(
    const Crack& crack, const BasicCrackModuli<ScalarOf<Crack>>& moduli,
    const QuadratureOptions& options = {}) {
  constexpr std::size_t N = Crack::kLoads;
  using Real = ScalarOf<Crack>;
  const FrontRange front = crack.front();
  const bool point = front.begin == front.end;
  const auto density = [&](const Real& a, double s) {
    return compliance_density(crack.stress_intensity(a, s), moduli) * crack.swept_area(a, s);
  };
  CrackCompliance<N, Real> result{.converged = true};
  const auto by_quadrature = [&](const Real& a) {
    // Use 31 points, because a slender front bends sharply at the surface.
    const auto integral =
        integrate<31>([&](double s) { return density(a, s); }, front.begin, front.end, options);
    result.converged = result.converged && integral.converged;
    return integral.value;
  };
  const auto along_front = [&] {
    if constexpr (LinearFront<Crack>) {
      return [&, family = crack.family()](const Real& a) {
        const auto sum = mean_compliance_density(family.linear_stress_intensity(a), moduli);
        Real length = 2 * crack.swept_area(a, 0.0);
        if constexpr (WallCrack<Crack>) length *= family.wall_factor(a);
        return sum * length;
      };
    } else if constexpr (FrontOfSquares<Crack>) {
      const auto squares = crack.front_squares(options);
      if (squares) result.converged = result.converged && squares->converged;
      return [&, squares](const Real& a) {
        if (!squares) return by_quadrature(a);
        return compliance_density(crack.root_mean_square(a, *squares), moduli) *
               (crack.swept_area(a, front.begin) * (front.end - front.begin));
      };
    } else {
      return [&](const Real& a) { return point ? density(a, front.begin) : by_quadrature(a); };
    }
  }();
  // The loads have different units, so the entries may differ by powers of ten.
  SymmetricMatrix<N> units(1.0);
  if constexpr (N > 1) units = units_of_equal_energy(along_front(crack.size()));
  const auto integral = integrated_over_size(
      crack, [&](const Real& a) { return over_units(along_front(a), units); }, options);
  result.matrix = in_units(integral.value, units);
  const double size = abs(integral.value);
  result.relative_error = size > 0 ? integral.error / size : 0.0;
  result.converged = result.converged && (integral.converged || size == 0);
  return result;
}

/// `integrated_compliance` with the faces apart and pressed, by one quadrature.
///
/// Implements theory manual eqs. (FR-2), (FR-17).
/// @param crack    with its faces apart
/// @param moduli   E' and mu in each state; > 0
/// @param options  tolerance of the adaptive quadrature; both results meet the tolerance
template <SharedByFaces Crack>
[[nodiscard]] ApartAndPressed<CrackCompliance<Crack::kLoads, ScalarOf<Crack>>>
integrated_in_both_states(const Crack& crack,
                          const ApartAndPressed<BasicCrackModuli<ScalarOf<Crack>>>& moduli,
                          const QuadratureOptions& options = {}) {
  constexpr std::size_t N = Crack::kLoads;
  using Real = ScalarOf<Crack>;
  using Both = Together<SymmetricMatrix<N, Real>, 2>;  // apart, pressed
  const auto along_front = [&, family = crack.family()](const Real& a) {
    const auto k = family.in_both_states(a);
    const ApartAndPressed<Real> factor = family.wall_factors(a);
    const Real length = 2 * crack.swept_area(a, 0.0);
    return Both{{mean_compliance_density(k.apart, moduli.apart) * (length * factor.apart),
                 mean_compliance_density(k.pressed, moduli.pressed) * (length * factor.pressed)}};
  };
  // A pressed crack may add much less than an open one, and must meet the tolerance too.
  const Both final = along_front(crack.size());
  const std::array units = {units_of_equal_energy(final.of[0]), units_of_equal_energy(final.of[1])};
  const auto integral = integrated_over_size(
      crack,
      [&](const Real& a) {
        const Both both = along_front(a);
        return Both{{over_units(both.of[0], units[0]), over_units(both.of[1], units[1])}};
      },
      options);
  const auto result = [&](std::size_t state) {
    const double size = abs(integral.value.of[state]);
    return CrackCompliance<N, Real>{.matrix = in_units(integral.value.of[state], units[state]),
                                    .relative_error = size > 0 ? integral.error / size : 0.0,
                                    .converged = integral.converged || size == 0};
  };
  return {result(0), result(1)};
}

/// Added compliance of a crack,
///
///     Delta lambda_ij = int_A [(2/E')(k_I,i k_I,j + k_II,i k_II,j) + (1/mu) k_III,i k_III,j] dA.
///
/// Implements theory manual eq. (FR-2).  The material is linear elastic, and stress intensity is
/// proportional to the loads.  The crack grows from zero to its size along the family that `crack`
/// describes.
///
/// @param crack    stress intensity per unit of each generalised load, and the swept area
/// @param moduli   E' and mu; > 0
/// @param options  tolerance of the adaptive quadrature, which a crack of known compliance needs
/// not
/// @return         symmetric positive semidefinite matrix, shape (N, N)
template <SweptCrack Crack>
[[nodiscard]] CrackCompliance<Crack::kLoads, ScalarOf<Crack>> added_compliance(
    const Crack& crack, const BasicCrackModuli<ScalarOf<Crack>>& moduli,
    const QuadratureOptions& options = {}) {
  if constexpr (KnownCompliance<Crack>)
    return CrackCompliance<Crack::kLoads, ScalarOf<Crack>>{.matrix = crack.compliance(moduli),
                                                           .converged = true};
  else
    return integrated_compliance(crack, moduli, options);
}

}  // namespace strainwave
