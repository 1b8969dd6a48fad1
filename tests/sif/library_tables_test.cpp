// SPDX-License-Identifier: Apache-2.0 Every entry of the tables of fitted numbers, and the curves
// between the entries, against tools/reference/library_curves.py, which interpolates
// tests/data/library_tables.csv by other formulas.  A change of any entry by one per cent changes a
// curve by far more than the tolerance.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>

#include "strainwave/sif/bar/tables.hpp"
#include "strainwave/sif/member/shaft_annular.hpp"
#include "strainwave/sif/tube/shell_factors.hpp"
#include "strainwave/sif/weight_function.hpp"
#include "support/reference_csv.hpp"

namespace strainwave {
namespace {

using Curve = std::function<double(const test::CsvRow& at)>;
using WallPart = double sif::WallIntensity::*;

double x_of(const test::CsvRow& at) { return at("x"); }
double y_of(const test::CsvRow& at) { return at("y"); }
double z_of(const test::CsvRow& at) { return at("z"); }

void add_bars(std::map<std::string, Curve>& curves) {
  curves["outer.bending"] = [](const test::CsvRow& at) {
    return sif::annular_outer_bending(x_of(at), y_of(at));
  };
  const std::array loads = {"tension", "bending", "torsion"};
  for (std::size_t i = 0; i < loads.size(); ++i) {
    curves[std::string("inner.") + loads[i]] = [i](const test::CsvRow& at) {
      return sif::annular_inner(x_of(at), y_of(at))[i];
    };
    curves[std::string("penny.") + loads[i]] = [i](const test::CsvRow& at) {
      return sif::penny_in_bar(x_of(at))[i];
    };
  }
  const auto front = [&](const char* mode, double sif::OneSidedFactors::*factor) {
    curves[std::string("front.") + mode] = [factor](const test::CsvRow& at) {
      return sif::one_sided_factors(x_of(at), y_of(at), z_of(at)).*factor;
    };
  };
  front("tension", &sif::OneSidedFactors::tension);
  front("bending", &sif::OneSidedFactors::bending);
  front("sliding", &sif::OneSidedFactors::sliding);
  front("tearing", &sif::OneSidedFactors::tearing);
}

void add_shells(std::map<std::string, Curve>& curves) {
  const std::map<std::string, WallPart> parts = {{".mean", &sif::WallIntensity::mean},
                                                 {".linear", &sif::WallIntensity::linear}};
  const std::map<std::string, sif::WallIntensity sif::ShellFactors::*> any_angle = {
      {"opening_by_normal", &sif::ShellFactors::opening_by_normal},
      {"sliding_by_normal", &sif::ShellFactors::sliding_by_normal},
      {"opening_by_shear", &sif::ShellFactors::opening_by_shear},
      {"sliding_by_shear", &sif::ShellFactors::sliding_by_shear}};
  const std::map<std::string, sif::WallIntensity sif::CircumferentialFactors::*> round = {
      {"axial", &sif::CircumferentialFactors::axial},
      {"bending", &sif::CircumferentialFactors::bending},
      {"torque", &sif::CircumferentialFactors::torque}};
  for (const auto& [name, part] : parts) {
    for (const auto& [kind, factor] : any_angle)
      curves[kind + name] = [factor = factor, part = part](const test::CsvRow& at) {
        return sif::shell_factors(x_of(at), y_of(at)).*factor.*part;
      };
    for (const auto& [kind, factor] : round)
      curves[kind + name] = [factor = factor, part = part](const test::CsvRow& at) {
        return sif::circumferential_factors(x_of(at), y_of(at), z_of(at)).*factor.*part;
      };
  }
}

void add_shafts_and_strip(std::map<std::string, Curve>& curves) {
  const auto shaft = [](double radius_ratio) {
    return sif::AnnularCrackHollow(
        {.depth = 1e-3, .outer_radius = 1.0, .inner_radius = radius_ratio});
  };
  curves["hollow.torsion"] = [shaft](const test::CsvRow& at) {
    return shaft(y_of(at)).torsion_factor(x_of(at));
  };
  curves["hollow.tension"] = [shaft](const test::CsvRow& at) {
    return shaft(y_of(at)).tension_factor(x_of(at));
  };
  curves["edge_weight"] = [](const test::CsvRow& at) {
    return sif::EdgeWeight(x_of(at)).value(y_of(at));
  };
}

TEST(LibraryTables, ReferenceEveryEntryAndTheCurvesBetweenThem) {
  constexpr double kRounding = 1e-12;
  std::map<std::string, Curve> curves;
  add_bars(curves);
  add_shells(curves);
  add_shafts_and_strip(curves);
  std::map<std::string, int> rows;
  for (const test::CsvRow& row : test::read_reference_csv("library_curves")) {
    ASSERT_TRUE(curves.contains(row.quantity)) << row.place;
    ++rows[row.quantity];
    EXPECT_NEAR(curves.at(row.quantity)(row), row.value,
                kRounding * std::max(1.0, std::abs(row.value)))
        << row.place;
  }
  for (const auto& [name, curve] : curves) EXPECT_GT(rows[name], 20) << name;
}

}  // namespace
}  // namespace strainwave
