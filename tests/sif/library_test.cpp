// SPDX-License-Identifier: Apache-2.0 Properties that every solution of the library must have.  The
// tests walk the registry, so a new row is tested automatically.
#include "strainwave/sif/library.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/sif/evaluation.hpp"

namespace strainwave::sif {
namespace {

/// Length exponent of an SI unit, and its force exponent; newton counts as force alone.
struct Exponents {
  double length = 0.0;
  double force = 0.0;
};

Exponents exponents_of(std::string_view unit) {
  const Dimension d = parse_unit(std::string(unit)).dimension;  // length, mass, time, ...
  return {.length = d[0] - d[1], .force = d[1]};                // N = kg*m/s^2
}

/// Factor on a quantity of that unit if lengths grow by `length` and forces by `force`.
double scale_of(std::string_view unit, double length, double force) {
  const Exponents e = exponents_of(unit);
  return std::pow(length, e.length) * std::pow(force, e.force);
}

Assignments examples_of(const Row& row) {
  Assignments values;
  const auto crack = row.make({});
  for (std::size_t i = 0; i < row.fields.size(); ++i)
    values.emplace(row.fields[i].name, crack->values()[i]);
  return values;
}

/// Index of the diagonal entry of a load in an upper triangle stored row by row.
std::size_t diagonal_index(std::size_t load, std::size_t loads) {
  std::size_t at = 0;
  for (std::size_t k = 0; k < load; ++k) at += loads - k;
  return at;
}

class EverySolution : public testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] const Row& row() const { return solution(GetParam()); }
};

TEST(Library, BehaviourHasAtLeastTwentyFourSolutions) { EXPECT_GE(library().size(), 24U); }

TEST(Library, BehaviourNamesAreUniqueAndSaidOnce) {
  std::set<std::string_view> names;
  for (const Row& row : library()) {
    EXPECT_TRUE(names.insert(row.info.name).second) << row.info.name << " is there twice";
    EXPECT_TRUE(std::ranges::all_of(row.info.name, [](char c) {
      return std::islower(static_cast<unsigned char>(c)) || c == '-' ||
             std::isdigit(static_cast<unsigned char>(c));
    })) << row.info.name;
  }
}

TEST(Library, InputUnknownSolutionNamesANearOne) {
  try {
    (void)solution("plate-trough");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("plate-through"), std::string::npos) << error.what();
  }
}

TEST_P(EverySolution, BehaviourSaysWhatItIs) {
  const SolutionInfo& info = row().info;
  EXPECT_FALSE(info.title.empty());
  EXPECT_FALSE(info.accuracy.empty());
  EXPECT_FALSE(info.source.empty());
  EXPECT_TRUE(
      std::set<std::string_view>({"plate", "tube", "bar", "gradient"}).contains(info.family))
      << info.family;
  for (const Field& field : row().fields) EXPECT_FALSE(field.doc.empty()) << field.name;
  for (const LoadInfo& load : row().loads) {
    EXPECT_FALSE(load.doc.empty()) << load.name;
    EXPECT_TRUE(load.unit == "Pa" || load.unit == "N" || load.unit == "N*m") << load.unit;
  }
  if (info.basis != Basis::exact) {
    EXPECT_GT(info.relative_uncertainty, 0) << "nothing is so good";
  }
  EXPECT_LT(info.relative_uncertainty, 0.5);
}

// The source must be a key of the list of references, or "-" with a derivation in the manual.
TEST_P(EverySolution, BehaviourSourceIsInTheReferences) {
  std::ifstream file(std::string(STRAINWAVE_EXAMPLES) + "/../docs/references.bib");
  const std::string bib{std::istreambuf_iterator<char>(file), {}};
  ASSERT_FALSE(bib.empty());
  std::string sources(row().info.source);
  if (sources == "-") return;
  std::ranges::replace(sources, ',', ' ');
  std::istringstream words(sources);
  for (std::string key; words >> key;)
    EXPECT_NE(bib.find("{" + key + ","), std::string::npos) << key << " is in no reference";
}

TEST_P(EverySolution, BehaviourExampleIsInsideItsRange) {
  for (const ValidityLimit& limit : row().make({})->validity())
    EXPECT_TRUE(limit.inside) << limit.text;
}

TEST_P(EverySolution, IdentityEveryLoadOpensOrShearsTheCrack) {
  const auto crack = row().make({});
  const FrontRange front = crack->front();
  std::set<std::string> modes;
  for (std::size_t load = 0; load < row().loads.size(); ++load) {
    double largest = 0.0;
    for (int i = 0; i <= 16; ++i) {
      const double s = front.begin + (front.end - front.begin) * i / 16;
      const PointIntensity K = crack->unit_intensity(load, crack->size(), s);
      ASSERT_TRUE(std::isfinite(K.K_I) && std::isfinite(K.K_II) && std::isfinite(K.K_III)) << s;
      if (K.K_I != 0) modes.insert("I");
      if (K.K_II != 0) modes.insert("II");
      if (K.K_III != 0) modes.insert("III");
      largest = std::max({largest, std::abs(K.K_I), std::abs(K.K_II), std::abs(K.K_III)});
    }
    EXPECT_GT(largest, 0) << row().loads[load].name << " does nothing at the example";
    EXPECT_GT(crack->gross_stress(load, crack->size()), 0) << row().loads[load].name;
  }
  // A solution has exactly the modes that it states, tested at the example with every angle changed
  // slightly.
  std::set<std::string> said;
  std::string text(row().info.modes);
  std::ranges::replace(text, ',', ' ');
  std::istringstream words(text);
  for (std::string mode; words >> mode;) said.insert(mode);
  for (const std::string& mode : modes) EXPECT_TRUE(said.contains(mode)) << mode << " is not said";
}

// Test of dimensions with lengths twice as large and forces three times as large.
TEST_P(EverySolution, ScalingOfStressIntensityAndCompliance) {
  constexpr double L = 2.0;
  constexpr double F = 3.0;
  const CrackModuli moduli{.opening = 230e9, .shear = 80e9};
  const CrackModuli scaled_moduli{.opening = 230e9 * F / (L * L), .shear = 80e9 * F / (L * L)};
  const Assignments values = examples_of(row());
  Assignments scaled = values;
  for (const Field& field : row().fields)
    scaled.find(field.name)->second *= scale_of(field.unit, L, F);
  const auto crack = row().make(values);
  const auto large = row().make(scaled);
  EXPECT_NEAR(large->size(), L * crack->size(), 1e-12 * crack->size());
  for (std::size_t load = 0; load < row().loads.size(); ++load) {
    // K per unit of load: Pa*m^0.5 = N*m^-1.5.
    const double unit = scale_of(row().loads[load].unit, L, F);
    const double factor = F * std::pow(L, -1.5) / unit;
    for (const FrontPoint& point : row().points) {
      const PointIntensity K = crack->unit_intensity(load, crack->size(), point.s);
      const PointIntensity K_large = large->unit_intensity(load, large->size(), point.s);
      const double largest = std::max({std::abs(K.K_I), std::abs(K.K_II), std::abs(K.K_III)});
      EXPECT_NEAR(K_large.K_I, factor * K.K_I, 1e-9 * factor * largest) << point.name;
      EXPECT_NEAR(K_large.K_II, factor * K.K_II, 1e-9 * factor * largest) << point.name;
      EXPECT_NEAR(K_large.K_III, factor * K.K_III, 1e-9 * factor * largest) << point.name;
    }
    EXPECT_NEAR(large->gross_stress(load, large->size()) / crack->gross_stress(load, crack->size()),
                F / (L * L) / unit, 1e-12 * F / (L * L) / unit);
  }
  const auto compliance = crack->compliance(moduli);
  const auto compliance_large = large->compliance(scaled_moduli);
  ASSERT_TRUE(compliance.converged);
  const std::size_t loads = row().loads.size();
  const auto diagonal = [&](std::size_t i) { return compliance.upper[diagonal_index(i, loads)]; };
  std::size_t n = 0;
  for (std::size_t i = 0; i < loads; ++i)
    for (std::size_t j = i; j < loads; ++j, ++n) {
      // Energy N*m per product of two loads.
      const double factor =
          F * L / (scale_of(row().loads[i].unit, L, F) * scale_of(row().loads[j].unit, L, F));
      EXPECT_NEAR(compliance_large.upper[n], factor * compliance.upper[n],
                  1e-7 * factor * std::sqrt(diagonal(i) * diagonal(j)));
    }
}

// The engine is compared with a plain midpoint sum along the front and over u with a = size u^2,
// which removes the roots of a.  The tolerance is the error of this coarse sum.
TEST_P(EverySolution, CrosscheckComplianceIsTheEnergyReleased) {
  constexpr int kSizes = 120;
  constexpr int kPoints = 80;
  const CrackModuli moduli{.opening = 230e9, .shear = 80e9};
  const auto crack = row().make({});
  const auto compliance = crack->compliance(moduli);
  ASSERT_TRUE(compliance.converged) << compliance.relative_error;
  const FrontRange front = crack->front();
  const bool point = front.begin == front.end;
  const std::size_t n = row().loads.size();
  std::vector<double> sum(compliance.upper.size());
  for (int i = 0; i < kSizes; ++i) {
    const double u = (i + 0.5) / kSizes;
    const double a = crack->size() * u * u;
    const double da = crack->size() * 2 * u / kSizes;
    for (int j = 0; j < (point ? 1 : kPoints); ++j) {
      const double length = front.end - front.begin;
      const double s = point ? front.begin : front.begin + length * (j + 0.5) / kPoints;
      const double dA = crack->swept_area(a, s) * da * (point ? 1 : length / kPoints);
      std::vector<PointIntensity> k;
      for (std::size_t load = 0; load < n; ++load) k.push_back(crack->unit_intensity(load, a, s));
      std::size_t at = 0;
      for (std::size_t l = 0; l < n; ++l)
        for (std::size_t m = l; m < n; ++m)
          sum[at++] += (2 * (k[l].K_I * k[m].K_I + k[l].K_II * k[m].K_II) / moduli.opening +
                        k[l].K_III * k[m].K_III / moduli.shear) *
                       dA;
    }
  }
  const auto diagonal = [&](std::size_t i) { return compliance.upper[diagonal_index(i, n)]; };
  std::size_t at = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i; j < n; ++j, ++at) {
      const double size = std::sqrt(diagonal(i) * diagonal(j));
      EXPECT_GT(size, 0) << row().loads[i].name;
      EXPECT_NEAR(compliance.upper[at], sum[at], 2e-3 * size) << at;
      EXPECT_LE(std::abs(compliance.upper[at]), size * (1 + 1e-9)) << "not positive semidefinite";
    }
}

TEST_P(EverySolution, InputNumbersOutsideTheirRangeAreRefused) {
  for (const Field& field : row().fields) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
      EXPECT_THROW((void)row().make({{std::string(field.name), bad}}), InputError) << field.name;
    if (std::isfinite(field.range.lower)) {
      const double bad = field.range.lower_open ? field.range.lower : field.range.lower - 1;
      EXPECT_THROW((void)row().make({{std::string(field.name), bad}}), InputError) << field.name;
    }
    if (std::isfinite(field.range.upper)) {
      const double bad = field.range.upper_open ? field.range.upper : field.range.upper + 1;
      EXPECT_THROW((void)row().make({{std::string(field.name), bad}}), InputError) << field.name;
    }
  }
  EXPECT_THROW((void)row().make({{"no_such_field", 1.0}}), InputError);
}

std::vector<std::string> names() {
  std::vector<std::string> list;
  for (const Row& row : library()) list.emplace_back(row.info.name);
  return list;
}

INSTANTIATE_TEST_SUITE_P(Library, EverySolution, testing::ValuesIn(names()),
                         [](const testing::TestParamInfo<std::string>& row) {
                           std::string name = row.param;
                           std::erase_if(name, [](char c) { return c == '-'; });
                           return name;
                         });

}  // namespace
}  // namespace strainwave::sif
