// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/sif/solution.hpp"

namespace strainwave::sif {

/// K_I, K_II, K_III at one point of a front [Pa*m^0.5].
struct PointIntensity {
  std::string name;  ///< name of the point; empty for a point found by scanning the front
  double s = 0.0;    ///< front parameter
  double K_I = 0.0;
  double K_II = 0.0;
  double K_III = 0.0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"name", "", "name of the point; empty for a point found by scanning the front"},
          &PointIntensity::name);
    field({"s", "1", "front parameter"}, &PointIntensity::s);
    field({"K_I", "Pa*m^0.5", "opening"}, &PointIntensity::K_I);
    field({"K_II", "Pa*m^0.5", "sliding"}, &PointIntensity::K_II);
    field({"K_III", "Pa*m^0.5", "tearing"}, &PointIntensity::K_III);
  }
};

/// A limit of the validity range.
struct ValidityLimit {
  bool inside = false;
  std::string_view text;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"limit", "", "the limit in words"}, &ValidityLimit::text);
    field({"inside", "", "whether the crack keeps this limit"}, &ValidityLimit::inside);
  }
};

/// Values of the fields of a solution, by name [SI].
using Assignments = std::map<std::string, double, std::less<>>;

/// One solution with its numbers behind a common type; rows of the library make it.
///
/// Stress intensities are per unit of one load; sum them over the acting loads.
class AnyCrack {
 public:
  virtual ~AnyCrack() = default;
  AnyCrack() = default;
  AnyCrack(const AnyCrack&) = delete;
  AnyCrack& operator=(const AnyCrack&) = delete;
  AnyCrack(AnyCrack&&) = delete;
  AnyCrack& operator=(AnyCrack&&) = delete;

  [[nodiscard]] virtual double size() const = 0;  ///< size a in Y = K/(sigma sqrt(pi a)) [m]
  /// Range of the front parameter s; begin == end for a front of one point.
  [[nodiscard]] virtual FrontRange front() const = 0;
  /// K of all modes per unit of a load, for the crack scaled in proportion to size `a`.
  [[nodiscard]] virtual PointIntensity unit_intensity(std::size_t load, double a,
                                                      double s) const = 0;
  /// Area that the front sweeps per da and ds (per da alone for a front of one point) [m].
  [[nodiscard]] virtual double swept_area(double a, double s) const = 0;
  /// Reference stress of Y at the size a, per unit of a load [1; 1/m^2, 1/m^3].
  [[nodiscard]] virtual double gross_stress(std::size_t load, double a) const = 0;
  /// The limits of the range in which the stated accuracy holds.
  [[nodiscard]] virtual std::vector<ValidityLimit> validity() const = 0;
  /// Rules between fields; a crack that breaks one is refused.
  [[nodiscard]] virtual std::vector<std::string_view> rules() const = 0;
  /// Added compliance, upper triangle row by row, and whether its quadrature converged.
  struct Compliance {
    std::vector<double> upper;    ///< [displacement of load i per unit of load j]
    double relative_error = 0.0;  ///< estimated, relative to the largest entry [-]
    bool converged = false;       ///< every integral met its tolerance
  };
  /// Added compliance of the crack with open faces (FR-2).
  /// @param moduli  E' and mu; > 0
  [[nodiscard]] virtual Compliance compliance(const CrackModuli& moduli) const = 0;
  /// Field values of this crack, in order.
  [[nodiscard]] virtual const std::vector<double>& values() const = 0;
};

/// A row of the library.
struct Row {
  SolutionInfo info;               ///< title, source, accuracy and tag of the equation
  std::vector<LoadInfo> loads;     ///< in the order of the indices of the loads
  std::vector<FrontPoint> points;  ///< the named points of the front
  std::vector<Field> fields;       ///< every field is a number; `example` is its default
  /// Makes the crack with fields set to `values`; other fields take their examples.
  /// @throws InputError  if a field is unknown, a number is outside its range, or the geometry is
  ///                     impossible
  std::function<std::unique_ptr<AnyCrack>(const Assignments& values)> make;
};

/// All solutions, grouped by family in the order of registration.
[[nodiscard]] std::span<const Row> library();

/// The solution with a given name.
/// @throws InputError  if no solution has the name; the message names near ones
[[nodiscard]] const Row& solution(std::string_view name);

}  // namespace strainwave::sif
