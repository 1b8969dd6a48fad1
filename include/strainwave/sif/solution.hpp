// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <string_view>

#include "strainwave/core/fields.hpp"
#include "strainwave/fracture/crack_compliance.hpp"

/// @file
/// Types of the stress intensity library.  A solution is a struct of lengths, angles and constants
/// that provides its stress intensity factors per unit of each load, its validity, its accuracy and
/// its source.  Each solution has a header of its own and one row of a registry
/// (src/sif, a source for each family).  The engine of crack_compliance.hpp computes its added
/// compliance.

namespace strainwave::sif {

/// Basis of a formula.
enum class Basis {
  exact,      ///< derived here, or shown to be exact by independent computation
  read,       ///< taken from a publication that was read
  secondary,  ///< taken from memory or from publications that quote the source
  computed,   ///< fit or table from strainwave's own computations
};

/// Plane stress or plane strain ahead of the crack: E' = E or E/(1 - nu^2).
enum class Constraint { plane_strain, plane_stress };

}  // namespace strainwave::sif

namespace strainwave {

template <>
struct EnumNames<sif::Basis> {
  static constexpr std::array<std::string_view, 4> names = {"exact", "read", "secondary",
                                                            "computed"};
};
template <>
struct EnumNames<sif::Constraint> {
  static constexpr std::array<std::string_view, 2> names = {"plane strain", "plane stress"};
};

}  // namespace strainwave

namespace strainwave::sif {

/// Description of a solution.
struct SolutionInfo {
  std::string_view name;      ///< name on the command line: "plate-through"
  std::string_view family;    ///< "plate", "tube", "bar" or "gradient"
  std::string_view title;     ///< one line
  std::string_view modes;     ///< "I, II"
  std::string_view equation;  ///< first tag in the theory manual
  std::string_view source;    ///< keys of docs/references.bib; "-" if derived here
  Basis basis = Basis::secondary;
  double relative_uncertainty =
      0.0;  ///< one standard uncertainty of K inside the validity range [-]
  /// One standard uncertainty of K_II and K_III, if it differs from that of K_I [-].
  std::optional<double> shear_uncertainty = {};
  std::string_view accuracy;  ///< comparisons made and their results
  Constraint constraint = Constraint::plane_strain;
  /// sigma in Y = K/(sigma sqrt(pi a)): the name of a stress of the uncracked body and its place.
  std::string_view reference_stress = "the load itself";

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"name", "", "name on the command line"}, &SolutionInfo::name);
    field({"family", "", "plate, tube, bar or gradient"}, &SolutionInfo::family);
    field({"title", "", "one line"}, &SolutionInfo::title);
    field({"modes", "", "modes for which the solution gives K"}, &SolutionInfo::modes);
    field({"equation", "", "first tag in the theory manual"}, &SolutionInfo::equation);
    field({"source", "", "keys of the references; - if derived here"}, &SolutionInfo::source);
    field({"basis", "", "basis of the formula"}, &SolutionInfo::basis);
    field({"relative_uncertainty", "1",
           "one standard uncertainty of K inside the validity range; of K_I only, if "
           "shear_uncertainty is given"},
          &SolutionInfo::relative_uncertainty);
    field({"shear_uncertainty", "1",
           "one standard uncertainty of K_II and K_III, if it differs from that of K_I"},
          &SolutionInfo::shear_uncertainty);
    field({"accuracy", "", "comparisons made and their results"}, &SolutionInfo::accuracy);
    field({"constraint", "", "plane strain or plane stress"}, &SolutionInfo::constraint);
    field({"reference_stress", "",
           "sigma in Y = K/(sigma sqrt(pi a)), and the place at which it is taken"},
          &SolutionInfo::reference_stress);
  }
};

/// One generalised load.
struct LoadInfo {
  std::string_view name;  ///< "tension"
  std::string_view unit;  ///< "Pa", "N" or "N*m"
  std::string_view doc;   ///< meaning, sign, point of action

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"name", "", "name of the load"}, &LoadInfo::name);
    field({"unit", "", "its unit"}, &LoadInfo::unit);
    field({"meaning", "", "meaning and sign of the load, and the place where it acts"},
          &LoadInfo::doc);
  }
};

/// A named point of the crack front.
struct FrontPoint {
  std::string_view name;  ///< "deepest"
  double s = 0.0;         ///< front parameter

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"name", "", "name of the point"}, &FrontPoint::name);
    field({"front_parameter", "1", "s, place along the front"}, &FrontPoint::s);
  }
};

/// A solution of the library.
///
/// A solution models the concept SweptCrack, and its loads are the entries of kLoadInfo.  In
/// addition:
///   - it describes its fields (core/fields.hpp), which are numbers only, each with an example;
///   - `check(rule)` calls `rule(ok, field, value, unit, text)` for each rule between fields, which
///     an impossible geometry breaks;
///   - `validity(range)` calls `range(inside, text)` for each limit of the range in which the
///     stated accuracy holds;
///   - `gross_stress(load)`: nominal stress of the uncracked section per unit of a load, which
///     makes K dimensionless, Y = K/(sigma sqrt(pi a)) [1 for a stress; 1/m^2, 1/m^3].  If Y refers
///     to the stress at the front, `gross_stress(load, a)` is the stress at the size a.
template <class S>
concept Solution = SweptCrack<S> && Described<S> && requires(const S& s, std::size_t load) {
  { S::kInfo } -> std::convertible_to<const SolutionInfo&>;
  { S::kLoadInfo } -> std::convertible_to<std::array<LoadInfo, S::kLoads>>;
  { S::kPoints.size() } -> std::convertible_to<std::size_t>;
  { s.gross_stress(load) } -> std::convertible_to<double>;
  s.check([](bool, std::string_view, double, std::string_view, std::string_view) {});
  s.validity([](bool, std::string_view) {});
};

/// The loads of most solutions for plates.
/// @{
inline constexpr LoadInfo kTension{"tension", "Pa", "stress normal to the crack, far away"};
inline constexpr LoadInfo kInPlaneShear{"shear", "Pa", "in-plane shear stress, far away"};
inline constexpr LoadInfo kAntiplaneShear{"antiplane_shear", "Pa", "out-of-plane shear stress"};
/// @}

}  // namespace strainwave::sif
