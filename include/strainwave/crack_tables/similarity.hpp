// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
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
///     kWidths            widths of the boxes in which f is one polynomial, by coordinate
///     kParts             what each part f_i contains
///     kFacesChangeShape  whether f depends on the state of the faces
///     arguments(p)       x of a crack, from the numbers of its solution
///     fixed(p)           switches of the solution, which similar cracks share
///     weights(p, moduli, faces)  w_i
///     In<Other>          the solution in another scalar
///     shape(p, x, part)  numbers of a crack with arguments x in its own unit of length, whose
///                        compliance f_i is; its switches are those of p
///     size_of(p)         the power of lengths in w_i
///     known(p)           whether the solution exists for these numbers; without it, it always does
///     coordinate(i, x)   the variable of a table for argument i, if f is smoother over another
///                        variable than the argument
///     argument(i, y)     the argument at this variable
///     vanishing(x, faces)  a factor of f that becomes 0, which a polynomial cannot give with a
///     small
///                        relative error; without it, 1

namespace strainwave {

/// A part of an added compliance, by the modes that release it; the last is inversely proportional
/// to mu, the others to E'.
enum class CrackPart { opening, sliding, opening_and_sliding, tearing };

template <class Solution>
struct Similarity;

namespace similarity {

inline constexpr double kByLogarithm = 0.5;  ///< width of a box in the logarithm of a ratio
inline constexpr double kByPoissonsRatio = 0.1;
inline constexpr double kByHalfLogarithm = kByLogarithm / 2;
inline constexpr double kBySquare = 1.0 / 3;  ///< in the square of a cosine

template <class Real>
[[nodiscard]] Real fifth_power(const Real& x) {
  const Real square = x * x;
  return square * square * x;
}

}  // namespace similarity

template <class Real>
struct Similarity<sif::BasicThroughCrackInTube<Real>> {
  template <class Other>
  using In = sif::BasicThroughCrackInTube<Other>;
  using Parameters = In<Real>;
  static constexpr std::size_t kArguments = 4;
  static constexpr std::size_t kAngle = 2;  ///< index of beta
  static constexpr std::array kParts = {CrackPart::opening_and_sliding};
  static constexpr bool kFacesChangeShape = true;
  static constexpr std::array<double, kArguments> kWidths = {
      similarity::kByHalfLogarithm, similarity::kByLogarithm, similarity::kBySquare,
      similarity::kByPoissonsRatio};

  static std::array<Real, kArguments> arguments(const Parameters& p) {
    using std::log;
    return {log(p.half_length / p.wall_thickness), log(p.wall_thickness / p.mean_radius), p.angle,
            p.poissons_ratio};
  }
  /// K of an isotropic wall at -beta is K at beta with the other sign of K_II, so f is even in beta
  /// and in beta - pi/2.  It is close to a polynomial of cos^2(beta).
  static double coordinate(std::size_t i, double x) {
    if (i != kAngle) return x;
    const double cosine = std::cos(x);
    return cosine * cosine;
  }
  static double argument(std::size_t i, double y) {
    return i == kAngle ? std::acos(std::sqrt(y)) : y;
  }
  /// The shear along a crack: pressed faces at 45 degrees to the shear have no K [-].
  static double vanishing(const std::array<double, kArguments>& x, Faces faces) {
    const double cosine = faces == Faces::pressed ? std::cos(2 * x[kAngle]) : 1.0;
    return cosine * cosine;
  }
  static bool known(const Parameters& p) {
    return p.count == 1 ||
           row_gap(value_of(p.row_share(p.half_length)), value_of(p.row_angle())) >= kLeastRowGap;
  }
  static auto fixed(const Parameters& p) {
    return std::tuple(p.shell_correction, p.thin_sheet, p.count, p.in_line);
  }
  static std::array<Real, 1> weights(const Parameters& p, const BasicCrackModuli<Real>& moduli,
                                     Faces) {
    return {p.stress_nonuniformity * p.stress_nonuniformity * size_of(p) / moduli.opening};
  }
  template <class From>
  static Parameters shape(const From& of, const std::array<Real, kArguments>& x, CrackPart) {
    using std::exp;
    Parameters p;
    p.half_length = exp(x[0]);
    p.wall_thickness = 1.0;
    p.mean_radius = exp(-x[1]);
    p.angle = x[2];
    p.poissons_ratio = x[3];
    p.shell_correction = of.shell_correction;
    p.thin_sheet = of.thin_sheet;
    p.count = of.count;
    p.in_line = of.in_line;
    return p;
  }
  /// a^2/(t r^4) [1/m^3].
  static Real size_of(const Parameters& p) {
    const Real per_radius = p.half_length / (p.mean_radius * p.mean_radius);
    return per_radius * per_radius / p.wall_thickness;
  }
};

template <std::size_t N, class Real>
struct Similarity<sif::SurfaceCrack<N, Real>> {
  template <class Other>
  using In = sif::SurfaceCrack<N, Other>;
  using Parameters = typename In<Real>::Parameters;
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

  static std::array<Real, kArguments> arguments(const Parameters& p) {
    using std::log;
    return {log(p.depth / p.thickness), log(p.aspect_ratio),
            p.half_width ? Real(log(*p.half_width / p.thickness)) : Real(0.0),
            kSheared ? p.poissons_ratio : Real(0.0)};
  }
  static auto fixed(const Parameters& p) {
    return std::tuple(p.loading, p.half_width.has_value(), p.count);
  }
  static std::array<Real, kParts.size()> weights(const Parameters& p,
                                                 const BasicCrackModuli<Real>& moduli,
                                                 Faces faces) {
    const Real normal = p.normal_stress[N - 1] * p.normal_stress[N - 1] * size_of(p);
    const Real opening = faces == Faces::pressed ? Real(0.0) : Real(normal / moduli.opening);
    if constexpr (kSheared) {
      const Real shear = p.shear_stress[N - 1] * p.shear_stress[N - 1] * size_of(p);
      return {opening, shear / moduli.opening, shear / moduli.shear};
    } else {
      return {opening};
    }
  }
  template <class From>
  static Parameters shape(const From& of, const std::array<Real, kArguments>& x, CrackPart part) {
    using std::exp;
    Parameters p;
    p.thickness = 1.0;
    p.depth = exp(x[0]);
    p.aspect_ratio = exp(x[1]);
    if (of.half_width) p.half_width = exp(x[2]);
    if (kSheared) p.poissons_ratio = x[3];
    p.loading = of.loading;
    p.count = of.count;
    (part == CrackPart::opening ? p.normal_stress : p.shear_stress)[N - 1] = 1.0;
    return p;
  }
  static Real size_of(const Parameters& p) { return p.depth * p.depth * p.depth; }
};

template <class Real>
struct Similarity<sif::BasicEdgeCrack<Real>> {
  template <class Other>
  using In = sif::BasicEdgeCrack<Other>;
  using Parameters = In<Real>;
  static constexpr std::size_t kArguments = 1;
  static constexpr std::array kParts = {CrackPart::opening};
  static constexpr bool kFacesChangeShape = false;
  static constexpr std::array<double, kArguments> kWidths = {similarity::kByLogarithm};

  static std::array<Real, kArguments> arguments(const Parameters& p) {
    using std::log;
    return {log(p.depth / (p.thickness - p.depth))};
  }
  static auto fixed(const Parameters& p) { return p.loading; }
  static std::array<Real, 1> weights(const Parameters& p, const BasicCrackModuli<Real>& moduli,
                                     Faces faces) {
    if (faces == Faces::pressed) return {0.0};
    return {p.unit_stress * p.unit_stress * p.width * size_of(p) / moduli.opening};
  }
  template <class From>
  static Parameters shape(const From& of, const std::array<Real, kArguments>& x, CrackPart) {
    using std::exp;
    Parameters p;
    p.depth = 1 / (1 + exp(-x[0]));
    p.thickness = 1.0;
    p.width = 1.0;
    p.unit_stress = 1.0;
    p.loading = of.loading;
    return p;
  }
  static Real size_of(const Parameters& p) { return p.depth * p.depth; }
};

template <class Real>
struct Similarity<sif::BasicAnnularCrackSolid<Real>> {
  template <class Other>
  using In = sif::BasicAnnularCrackSolid<Other>;
  using Parameters = In<Real>;
  static constexpr std::size_t kArguments = 1;
  static constexpr std::array kParts = {CrackPart::tearing};
  static constexpr bool kFacesChangeShape = false;
  static constexpr std::array<double, kArguments> kWidths = {similarity::kByLogarithm};

  static std::array<Real, kArguments> arguments(const Parameters& p) {
    using std::log;
    return {log(p.depth / (p.diameter / 2 - p.depth))};
  }
  static auto fixed(const Parameters& p) { return p.polynomials; }
  static std::array<Real, 1> weights(const Parameters& p, const BasicCrackModuli<Real>& moduli,
                                     Faces) {
    return {size_of(p) / moduli.shear};
  }
  template <class From>
  static Parameters shape(const From& of, const std::array<Real, kArguments>& x, CrackPart) {
    using std::exp;
    Parameters p;
    p.depth = 1 / (1 + exp(-x[0]));
    p.diameter = 2.0;
    p.polynomials = of.polynomials;
    p.open = false;  // the torque does not open it
    return p;
  }
  /// a^2/d^5 [1/m^3].
  static Real size_of(const Parameters& p) {
    return p.depth * p.depth / similarity::fifth_power(p.diameter);
  }
};

template <class Real>
struct Similarity<sif::BasicAnnularCrackHollow<Real>> {
  template <class Other>
  using In = sif::BasicAnnularCrackHollow<Other>;
  using Parameters = typename In<Real>::Parameters;
  static constexpr std::size_t kArguments = 2;
  static constexpr std::array kParts = {CrackPart::tearing};
  static constexpr bool kFacesChangeShape = false;
  static constexpr std::array<double, kArguments> kWidths = {similarity::kByLogarithm, 0.1};

  static std::array<Real, kArguments> arguments(const Parameters& p) {
    using std::log;
    return {log(p.depth / (p.outer_radius - p.inner_radius)), p.inner_radius / p.outer_radius};
  }
  static std::tuple<> fixed(const Parameters&) { return {}; }
  static std::array<Real, 1> weights(const Parameters& p, const BasicCrackModuli<Real>& moduli,
                                     Faces) {
    return {size_of(p) / moduli.shear};
  }
  template <class From>
  static Parameters shape(const From&, const std::array<Real, kArguments>& x, CrackPart) {
    using std::exp;
    Parameters p;
    p.outer_radius = 1.0;
    p.inner_radius = x[1];
    p.depth = exp(x[0]) * (1 - x[1]);
    p.open = false;  // the torque does not open it
    return p;
  }
  /// a^2/r_o^5 [1/m^3].
  static Real size_of(const Parameters& p) {
    return p.depth * p.depth / similarity::fifth_power(p.outer_radius);
  }
};

template <class Real>
struct Similarity<sif::BasicShaftSurfaceSolid<Real>> {
  template <class Other>
  using In = sif::BasicShaftSurfaceSolid<Other>;
  using Parameters = typename In<Real>::Parameters;
  static constexpr std::size_t kArguments = 2;
  static constexpr double kKink = sif::BasicOneSidedTable<Real>::kKink;
  static constexpr std::array kParts = {CrackPart::sliding, CrackPart::tearing};
  static constexpr bool kFacesChangeShape = false;
  static constexpr std::array<double, kArguments> kWidths = {similarity::kByLogarithm,
                                                             similarity::kByLogarithm};

  static std::array<Real, kArguments> arguments(const Parameters& p) {
    using std::log;
    // A box ends at the kink.
    return {log(p.depth / (kKink * p.diameter)), log(p.half_length / p.diameter)};
  }
  static std::tuple<> fixed(const Parameters&) { return {}; }
  static std::array<Real, 2> weights(const Parameters& p, const BasicCrackModuli<Real>& moduli,
                                     Faces) {
    return {size_of(p) / moduli.opening, size_of(p) / moduli.shear};
  }
  template <class From>
  static Parameters shape(const From&, const std::array<Real, kArguments>& x, CrackPart) {
    using std::exp;
    Parameters p;
    p.diameter = 1.0;
    p.depth = kKink * exp(x[0]);
    p.half_length = exp(x[1]);
    p.open = false;  // the torque does not open it
    return p;
  }
  /// a^3/d^6 [1/m^3].
  static Real size_of(const Parameters& p) {
    const Real root = p.depth / (p.diameter * p.diameter);
    return root * root * root;
  }
};

template <class Real>
struct Similarity<sif::BasicShaftSurfaceHollow<Real>> {
  template <class Other>
  using In = sif::BasicShaftSurfaceHollow<Other>;
  using Parameters = typename In<Real>::Parameters;
  static constexpr std::size_t kArguments = 4;
  static constexpr std::array kParts = {CrackPart::sliding, CrackPart::tearing};
  static constexpr bool kFacesChangeShape = false;
  static constexpr std::array<double, kArguments> kWidths = {
      similarity::kByLogarithm, similarity::kByLogarithm, 0.1, similarity::kByPoissonsRatio};

  static std::array<Real, kArguments> arguments(const Parameters& p) {
    using std::log;
    return {log(p.depth / (p.outer_radius - p.inner_radius)), log(p.depth / p.half_length),
            p.inner_radius / p.outer_radius, p.poissons_ratio};
  }
  static std::tuple<> fixed(const Parameters&) { return {}; }
  static std::array<Real, 2> weights(const Parameters& p, const BasicCrackModuli<Real>& moduli,
                                     Faces) {
    return {size_of(p) / moduli.opening, size_of(p) / moduli.shear};
  }
  template <class From>
  static Parameters shape(const From&, const std::array<Real, kArguments>& x, CrackPart) {
    using std::exp;
    Parameters p;
    p.outer_radius = 1.0;
    p.inner_radius = x[2];
    p.depth = exp(x[0]) * (1 - x[2]);
    p.half_length = p.depth / exp(x[1]);
    p.poissons_ratio = x[3];
    p.open = false;  // the torque does not open it
    return p;
  }
  /// a^3/r_o^6 [1/m^3].
  static Real size_of(const Parameters& p) {
    const Real root = p.depth / (p.outer_radius * p.outer_radius);
    return root * root * root;
  }
};

/// What a table uses for an argument; see `Similarity`.
template <class Solution>
[[nodiscard]] double table_coordinate(std::size_t argument, double x) {
  if constexpr (requires { Similarity<Solution>::coordinate(argument, x); })
    return Similarity<Solution>::coordinate(argument, x);
  else
    return x;
}

/// The argument at a coordinate of a table.
template <class Solution>
[[nodiscard]] double argument_at(std::size_t argument, double coordinate) {
  if constexpr (requires { Similarity<Solution>::argument(argument, coordinate); })
    return Similarity<Solution>::argument(argument, coordinate);
  else
    return coordinate;
}

/// One object of any solution of the series model in one scalar, or none.
template <class Real, template <class> class Of>
using OfAnySolution =
    std::variant<std::monostate, Of<sif::SurfaceCrack<1, Real>>, Of<sif::BasicEdgeCrack<Real>>,
                 Of<sif::BasicThroughCrackInTube<Real>>, Of<sif::SurfaceCrack<2, Real>>,
                 Of<sif::BasicAnnularCrackSolid<Real>>, Of<sif::BasicAnnularCrackHollow<Real>>,
                 Of<sif::BasicShaftSurfaceSolid<Real>>, Of<sif::BasicShaftSurfaceHollow<Real>>>;

/// One part f_i of the added compliance at dimensionless arguments (ST-21).
template <class Real>
struct SimilarPart {
  Real value{};           ///< f_i [-]
  bool converged = true;  ///< its quadrature met the tolerance
};

/// A crack under the last of its loads alone: the torque, or the lobe force.
template <class Crack>
class UnderLastLoad {
 public:
  using Real = ScalarOf<Crack>;             ///< scalar of the crack
  static constexpr std::size_t kLoads = 1;  ///< the one load

  /// @param crack  under all of its loads
  explicit UnderLastLoad(const Crack& crack) : crack_(crack) {}

  /// The members of a crack, as the engine needs them.
  /// @{
  [[nodiscard]] Real size() const { return crack_.size(); }
  [[nodiscard]] FrontRange front() const { return crack_.front(); }
  [[nodiscard]] Real swept_area(const Real& a, double s) const { return crack_.swept_area(a, s); }
  [[nodiscard]] UnitStressIntensity<1, Real> stress_intensity(const Real& a, double s) const {
    return last(crack_.stress_intensity(a, s));
  }
  [[nodiscard]] Real kink() const requires KinkedCrack<Crack> { return crack_.kink(); }
  [[nodiscard]] auto family() const requires LinearFront<Crack> {
    struct Family {
      decltype(std::declval<const Crack&>().family()) of;
      [[nodiscard]] LinearStressIntensity<1, Real> linear_stress_intensity(const Real& a) const {
        return last(of.linear_stress_intensity(a));
      }
      [[nodiscard]] ApartAndPressed<LinearStressIntensity<1, Real>> in_both_states(
          const Real& a) const requires SharedByFaces<Crack> {
        const auto both = of.in_both_states(a);
        return {last(both.apart), last(both.pressed)};
      }
      [[nodiscard]] Real wall_factor(const Real& a) const requires WallCrack<Crack> {
        return of.wall_factor(a);
      }
      [[nodiscard]] ApartAndPressed<Real> wall_factors(const Real& a) const requires
          SharedByFaces<Crack> {
        return of.wall_factors(a);
      }
    };
    return Family{crack_.family()};
  }
  [[nodiscard]] auto front_squares(const QuadratureOptions& options) const requires
      FrontOfSquares<Crack> {
    return crack_.front_squares(options);
  }
  template <class Squares>
  [[nodiscard]] UnitStressIntensity<1, Real> root_mean_square(const Real& a,
                                                              const Squares& squares) const {
    return last(crack_.root_mean_square(a, squares));
  }
  [[nodiscard]] SymmetricMatrix<1, Real> compliance(
      const BasicCrackModuli<Real>& moduli) const requires KnownCompliance<Crack> {
    constexpr std::size_t i = Crack::kLoads - 1;
    return SymmetricMatrix<1, Real>(crack_.compliance(moduli)(i, i));
  }
  /// @}

 private:
  [[nodiscard]] static UnitStressIntensity<1, Real> last(
      const UnitStressIntensity<Crack::kLoads, Real>& k) {
    return {.I = {k.I.back()}, .II = {k.II.back()}, .III = {k.III.back()}};
  }
  [[nodiscard]] static LinearStressIntensity<1, Real> last(
      const LinearStressIntensity<Crack::kLoads, Real>& k) {
    return {last(k.mean), last(k.slope)};
  }

  Crack crack_;
};

/// The part f_i(x) of all cracks that are similar to one, by the engine; eq. (ST-21).
///
/// @tparam Solution  in the scalar of x: double, or CrackReal for the derivatives by x
/// @param like   numbers of a crack with the same switches, in any scalar
/// @param x      dimensionless arguments
/// @param part   index in `kParts`
/// @param faces  state of the faces
/// @param moduli  of the part, or those of a sheet that is not isotropic
/// @param options  tolerance of the quadrature
template <class Solution, class From>
[[nodiscard]] SimilarPart<ScalarOf<Solution>> similar_part(
    const From& like, const std::array<ScalarOf<Solution>, Similarity<Solution>::kArguments>& x,
    CrackPart part, Faces faces, const BasicCrackModuli<ScalarOf<Solution>>& moduli,
    const QuadratureOptions& options) {
  using Similar = Similarity<Solution>;
  const auto numbers = Similar::shape(like, x, part);
  const Solution open(numbers);
  const auto added = added_compliance(
      UnderLastLoad<Solution>(faces == Faces::pressed ? open.pressed() : open), moduli, options);
  return {added.matrix(0, 0) / Similar::size_of(numbers), added.converged};
}

/// `similar_part` with the faces apart and pressed, by one quadrature; eq. (ST-21).
///
/// @tparam Solution  in the scalar of x
/// @param like     numbers of a crack with the same switches, in any scalar
/// @param x        dimensionless arguments
/// @param part     index in `kParts`
/// @param moduli   of the part, the same in both states
/// @param options  tolerance of the quadrature
template <class Solution, class From>
[[nodiscard]] ApartAndPressed<SimilarPart<ScalarOf<Solution>>> similar_part_in_both_states(
    const From& like, const std::array<ScalarOf<Solution>, Similarity<Solution>::kArguments>& x,
    CrackPart part, const BasicCrackModuli<ScalarOf<Solution>>& moduli,
    const QuadratureOptions& options) requires SharedByFaces<UnderLastLoad<Solution>> {
  using Similar = Similarity<Solution>;
  const auto numbers = Similar::shape(like, x, part);
  const auto added = integrated_in_both_states(UnderLastLoad<Solution>(Solution(numbers)),
                                               {moduli, moduli}, options);
  const auto size = Similar::size_of(numbers);
  return {{added.apart.matrix(0, 0) / size, added.apart.converged},
          {added.pressed.matrix(0, 0) / size, added.pressed.converged}};
}

/// Unit moduli under which only one part releases energy.
template <class Real>
[[nodiscard]] BasicCrackModuli<Real> moduli_of(CrackPart part) {
  constexpr double kRigid = std::numeric_limits<double>::infinity();
  return part == CrackPart::tearing
             ? BasicCrackModuli<Real>{.opening = Real(kRigid), .shear = Real(1.0)}
             : BasicCrackModuli<Real>{.opening = Real(1.0), .shear = Real(kRigid)};
}

}  // namespace strainwave
