// SPDX-License-Identifier: Apache-2.0
#include "strainwave/model/input/gear_set.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "support/article_gear.hpp"
#include "support/reference.hpp"

namespace strainwave {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 210 * GPa reads as it should
using test::article_gear;

template <class F>
InputError refusal(const F& f) {
  try {
    f();
  } catch (const InputError& error) {
    return error;
  }
  return {"", "accepted"};
}

Material steel() {
  Material material;
  material.youngs_modulus = 210 * GPa;
  material.poissons_ratio = 0.3;
  return material;
}

// --- Lists that name numbers by their paths ------------------------------------------------------

TEST(PathLists, IdentityAllListsWithPathsAreKnown) {
  // Every list of the drive whose entries have a field `path` is one of for_each_path_list.
  std::set<std::string_view> described;
  GearSet::describe([&](const Field& list, auto member) {
    using Value = std::decay_t<decltype(std::declval<GearSet>().*member)>;
    if constexpr (is_vector<Value>)
      Value::value_type::describe([&](const Field& field, auto) {
        if (field.name == "path") described.insert(list.name);
      });
  });
  std::set<std::string_view> known;
  const GearSet gear;
  for_each_path_list(gear, [&](std::string_view name, const auto&) { known.insert(name); });
  EXPECT_EQ(known, described);
  EXPECT_EQ(known, (std::set<std::string_view>{"range", "scatter", "correlation"}));
}

/// The article's drive with a range and a scatter of each of these numbers, and correlations of the
/// first with each other one.
GearSet stated(std::initializer_list<const char*> paths) {
  GearSet gear = article_gear();
  for (const char* const path : paths) {
    gear.range.push_back({.path = path, .lower = "1 um", .upper = "1 m", .source = {}});
    gear.scatter.push_back({.path = path, .relative_standard_deviation = 0.1, .source = {}});
    if (path != *paths.begin())
      gear.correlation.push_back(
          {.path = *paths.begin(), .with = path, .rank_correlation = 0.1, .source = {}});
  }
  check(gear);
  return gear;
}

TEST(PathLists, BehaviourWhatIsLostGoesAndTheRestStays) {
  const GearSet before =
      stated({"flexspline.length", "wave_generator.crack[0].depth", "flexspline.wall_thickness"});
  GearSet gear = before;
  drop_lost_paths(gear, before);
  EXPECT_EQ(gear.range.size(), 3U);
  gear.wave_generator->crack.clear();
  *gear.flexspline->wall_thickness *= 2;
  drop_lost_paths(gear, before);
  for_each_path_list(gear, [](std::string_view name, const auto& entries) {
    ASSERT_EQ(entries.size(), name == "correlation" ? 0U : 1U);  // both have lost a number
    for (const auto& entry : entries) EXPECT_EQ(entry.path, "flexspline.length");
  });
}

TEST(PathLists, BehaviourANumberThatIsSetIsKnown) {
  GearSet gear = stated({"flexspline.length", "flexspline.wall_thickness"});
  set_number(gear, "flexspline.length", 2.0);  // out of its range
  EXPECT_NO_THROW(check(gear));
  for_each_path_list(gear, [](std::string_view name, const auto& entries) {
    ASSERT_EQ(entries.size(), name == "correlation" ? 0U : 1U);
    for (const auto& entry : entries) EXPECT_EQ(entry.path, "flexspline.wall_thickness");
  });
}

// --- Elastic constants ---------------------------------------------------------------------------

TEST(ElasticConstants, ReferenceShearModulusOfSteel) {
  constexpr test::Reference kReference{
      .value = 80.76923076923077e9,
      .unit = "Pa",
      .relative_tolerance = 1e-15,
      .source = "G = E/(2(1+nu)) in fractions: 210/2.6 = 1050/13 GPa",
      .tolerance_is = "rounding of three operations"};
  EXPECT_NEAR(elastic_constants(steel()).G, kReference.value,
              kReference.value * kReference.relative_tolerance);
}

TEST(ElasticConstants, IdentityAnyTwoDefineTheThird) {
  for (const double nu : {-0.9, -0.1, 0.0, 0.28, 0.3, 0.499}) {
    Material by_nu = steel();
    by_nu.poissons_ratio = nu;
    const ElasticConstants c = elastic_constants(by_nu);
    EXPECT_EQ(c.E, 210 * GPa);
    EXPECT_EQ(c.nu, nu);
    EXPECT_NEAR(c.G * 2 * (1 + nu) / c.E, 1, 1e-15);

    Material by_G = steel();
    by_G.poissons_ratio.reset();
    by_G.shear_modulus = c.G;
    EXPECT_EQ(elastic_constants(by_G).E, c.E);
    EXPECT_EQ(elastic_constants(by_G).G, c.G);
    EXPECT_NEAR(elastic_constants(by_G).nu, nu, 1e-14);
    EXPECT_EQ(elastic_contradiction(by_nu), 0);
    EXPECT_EQ(elastic_contradiction(by_G), 0);
  }
}

TEST(ElasticConstants, BehaviourThreeAreTakenAsGiven) {
  Material article = steel();
  article.shear_modulus = 80 * GPa;
  const ElasticConstants c = elastic_constants(article);
  EXPECT_EQ(c.E, 210 * GPa);
  EXPECT_EQ(c.G, 80 * GPa);
  EXPECT_EQ(c.nu, 0.3);
  // The article's three constants contradict each other by about one per cent.
  EXPECT_NEAR(elastic_contradiction(article), 80 * 13.0 / 1050 - 1, 1e-14);
}

TEST(ElasticConstants, IdentityPlaneStrainModulus) {
  EXPECT_NEAR(elastic_constants(steel()).plane_strain_modulus(), 210 * GPa / 0.91, 1);
  Material soft = steel();
  soft.poissons_ratio = 0;
  EXPECT_EQ(elastic_constants(soft).plane_strain_modulus(), 210 * GPa);
}

TEST(ElasticConstants, InputNeitherShearModulusNorPoissonsRatio) {
  Material material = steel();
  material.poissons_ratio.reset();
  const InputError error = refusal([&] { (void)elastic_constants(material); });
  EXPECT_STREQ(error.what(), "poissons_ratio: must be given, or shear_modulus");
}

TEST(ElasticConstants, LimitShearModulusThatNoMaterialHas) {
  // E/(2G) - 1 lies in (-1, 0.5) if G > E/3; 70 GPa would be incompressible.
  for (const double G : {1e-300, 1.0, 69 * GPa, 70 * GPa}) {
    Material material = steel();
    material.poissons_ratio.reset();
    material.shear_modulus = G;
    const InputError error = refusal([&] { (void)elastic_constants(material); });
    EXPECT_EQ(error.field(), "shear_modulus") << G;
    EXPECT_EQ(error.rule(), "Poisson's ratio E/(2G) - 1 > -1 and < 0.5") << G;
  }
  for (const double G : {70.001 * GPa, 80 * GPa, 1e20}) {
    Material material = steel();
    material.poissons_ratio.reset();
    material.shear_modulus = G;
    EXPECT_NO_THROW((void)elastic_constants(material)) << G;
  }
}

// --- Materials by name ---------------------------------------------------------------------------

TEST(MaterialOf, BehaviourFindsByName) {
  GearSet gear = article_gear();
  EXPECT_EQ(&material_of(gear, "steel", "flexspline.material"), &gear.material.at("steel"));
}

TEST(MaterialOf, InputUnknownNameListsTheKnown) {
  GearSet gear = article_gear();
  gear.material["bronze"] = steel();
  const InputError error = refusal([&] { (void)material_of(gear, "stel", "flexspline.material"); });
  EXPECT_EQ(error.field(), "flexspline.material");
  EXPECT_STREQ(error.what(),
               "flexspline.material: \"stel\" is not one of the materials given (bronze, steel)");
  gear.material.clear();
  EXPECT_STREQ(refusal([&] { (void)material_of(gear, "", "m"); }).what(),
               "m: \"\" is not one of the materials given ()");
}

// --- Numbers by path -----------------------------------------------------------------------------

TEST(NumberAt, BehaviourEveryNumberOfADriveCanBeReadAndSet) {
  const GearSet original = article_gear();
  GearSet gear = original;
  int n = 0;
  for_each_number(original, [&](const FieldPath& path, const Field& field, const double& x) {
    const NumberAt at = number_at(gear, path.text());
    EXPECT_EQ(at.path, path.text());
    EXPECT_EQ(at.value, x) << at.path;
    EXPECT_EQ(at.field.name, field.name);
    EXPECT_EQ(at.field.unit, field.unit);
    set_number(gear, path.text(), 7 + n);
    EXPECT_EQ(number_at(gear, path.text()).value, 7 + n) << at.path;
    ++n;
  });
  EXPECT_GT(n, 30);
  EXPECT_EQ(gear.material.at("steel").youngs_modulus, 7);
}

TEST(NumberAt, BehaviourPathsAreThoseOfTheFile) {
  GearSet gear = article_gear();
  EXPECT_EQ(number_at(gear, "drive.pitch_diameter").value, 160 * mm);
  EXPECT_EQ(number_at(gear, "drive.pitch_diameter").field.unit, "m");
  EXPECT_EQ(number_at(gear, "output_shaft.crack[0].depth").value, 0.1 * mm);
  EXPECT_EQ(number_at(gear, "flexspline.crack[0].angle").value, std::numbers::pi / 4);
  EXPECT_EQ(number_at(gear, "wave_generator.contact_semi_axes[1]").value, 2 * mm);
  EXPECT_EQ(number_at(gear, "material.steel.poissons_ratio").value, 0.3);
  EXPECT_EQ(number_at(gear, "article.M_p").value, 0.85);

  set_number(gear, "output_shaft.crack[0].depth", 2 * mm);
  EXPECT_EQ(std::get<AnnularCrack>(gear.output_shaft->crack[0]).depth, 2 * mm);
}

TEST(NumberAt, BehaviourNamesOfMaterialsNeedNoQuotes) {
  GearSet gear = article_gear();
  gear.material["17-4PH H900 1.4542"] = steel();
  gear.material["17-4PH H900 1.4542"].yield_strength = 1170e6;
  const std::string path = "material.17-4PH H900 1.4542.yield_strength";
  EXPECT_EQ(number_at(gear, path).value, 1170e6);
  set_number(gear, path, 1000e6);
  EXPECT_EQ(gear.material["17-4PH H900 1.4542"].yield_strength, 1000e6);
  EXPECT_EQ(gear.material["17-4PH H900 1.4542"].origin, "");
}

TEST(NumberAt, BehaviourTheOriginSaysWhatWasSetSince) {
  GearSet gear = article_gear();
  Material known = steel();
  known.yield_strength = 1170e6;
  known.origin = "a book";
  gear.material["a.b"] = known;
  gear.material["a"] = known;
  set_number(gear, "material.a.b.yield_strength", 1170e6);  // the same
  EXPECT_EQ(gear.material["a.b"].origin, "a book");
  set_number(gear, "material.a.b.yield_strength", 1000e6);
  set_number(gear, "material.a.b.yield_strength", 900e6);
  EXPECT_EQ(gear.material["a.b"].origin, "a book; yield_strength was set since");
  set_number(gear, "material.a.b.poissons_ratio", 0.28);
  EXPECT_EQ(gear.material["a.b"].origin,
            "a book; yield_strength was set since; poissons_ratio was set since");
  set_number(gear, "drive.ratio", 50);
  EXPECT_EQ(gear.material["a"].origin, "a book");
  EXPECT_EQ(gear.material["steel"].origin, "");
}

TEST(NumberAt, BehaviourANumberIsSetUnchecked) {
  GearSet gear = article_gear();
  set_number(gear, "output_shaft.crack[0].depth", -1);
  EXPECT_EQ(refusal([&] { check(gear); }).field(), "output_shaft.crack[0].depth");
}

struct Wrong {
  std::string_view path;
  std::string_view message;
};

TEST(NumberAt, InputPathsThatAreNoNumberSuggestOne) {
  const GearSet gear = article_gear();
  for (const Wrong& wrong : {
           Wrong{"output_shaft.crack[0].dept",
                 "output_shaft.crack[0].dept: is not a number of this drive; did you mean "
                 "output_shaft.crack[0].depth?"},
           Wrong{"output_shaft.crack.depth",
                 "output_shaft.crack.depth: is not a number of this drive; did you mean "
                 "output_shaft.crack[0].depth?"},
           Wrong{"output_shaft.crack[1].depth",
                 "output_shaft.crack[1].depth: is not a number of this drive; did you mean "
                 "output_shaft.crack[0].depth?"},
           Wrong{"steel.youngs_modulus", "steel.youngs_modulus: is not a number of this drive"},
           Wrong{"drive.ration",
                 "drive.ration: is not a number of this drive; did you mean drive.ratio?"},
           Wrong{"Drive.Ratio",
                 "Drive.Ratio: is not a number of this drive; did you mean drive.ratio?"},
           Wrong{"torque", "torque: is not a number of this drive"},
           Wrong{"", ": is not a number of this drive"},
           Wrong{"drive", "drive: is not a number of this drive"},
           Wrong{"flexspline.shape", "flexspline.shape: is not a number of this drive"},
       }) {
    EXPECT_STREQ(refusal([&] { (void)number_at(gear, wrong.path); }).what(), wrong.message.data());
    GearSet copy = gear;
    EXPECT_STREQ(refusal([&] { set_number(copy, wrong.path, 1); }).what(), wrong.message.data());
  }
}

TEST(NumberAt, InputFieldsThatAreNotGivenAreNoNumbers) {
  GearSet gear = article_gear();
  gear.wave_generator->inner_ring_width.reset();
  EXPECT_NE(refusal([&] { set_number(gear, "wave_generator.inner_ring_width", 1); }).field(), "");
  EXPECT_FALSE(gear.wave_generator->inner_ring_width.has_value());
  gear.output_shaft.reset();
  EXPECT_NE(refusal([&] { set_number(gear, "output_shaft.length", 1); }).field(), "");
  // A whole number cannot be swept, because values between whole numbers are not valid.
  EXPECT_NE(refusal([&] { set_number(gear, "drive.wave_number", 3); }).field(), "");
}

TEST(NumberAt, InputPathsOfAnyLengthAreRefused) {
  const GearSet gear = article_gear();
  EXPECT_NE(refusal([&] { (void)number_at(gear, std::string(1'000'000, 'x')); }).field(), "");
}

// --- Thickness of a diaphragm --------------------------------------------------------------------

Diaphragm stepped_diaphragm() {
  return {.outer_diameter = 150 * mm,
          .inner_diameter = 80 * mm,
          .thickness = 3 * mm,
          .profile = {{.radius = 45 * mm, .thickness = 5 * mm},
                      {.radius = 50 * mm, .thickness = 2 * mm}}};
}

TEST(DiaphragmThickness, IdentityConstantWithoutProfile) {
  Diaphragm plain = stepped_diaphragm();
  plain.profile.clear();
  for (const double r : {40 * mm, 45 * mm, 60 * mm, 75 * mm})
    EXPECT_EQ(diaphragm_thickness(plain, r), 3 * mm);
}

TEST(DiaphragmThickness, ReferenceLinearBetweenTheStations) {
  const Diaphragm diaphragm = stepped_diaphragm();
  const auto h = [&](double r) { return diaphragm_thickness(diaphragm, r * mm) / mm; };
  EXPECT_EQ(h(40), 5);  // constant inside the first station
  EXPECT_EQ(h(45), 5);
  EXPECT_NEAR(h(46), 4.4, 1e-14);  // 5 - 3/5; rounding
  EXPECT_NEAR(h(47.5), 3.5, 1e-14);
  EXPECT_NEAR(h(50), 2, 1e-15);
  EXPECT_NEAR(h(62.5), 2.5, 1e-14);  // half way to 3 mm at the outer diameter
  EXPECT_NEAR(h(75), 3, 1e-14);
  EXPECT_EQ(h(80), 3);
}

TEST(DiaphragmThickness, IdentityContinuous) {
  const Diaphragm diaphragm = stepped_diaphragm();
  for (const double r : {45 * mm, 50 * mm, 75 * mm})
    // The steepest slope is 0.6.
    EXPECT_NEAR(diaphragm_thickness(diaphragm, r * (1 - 1e-9)),
                diaphragm_thickness(diaphragm, r * (1 + 1e-9)), 0.61 * 2e-9 * r);
}

TEST(DiaphragmThickness, LimitOneStation) {
  Diaphragm diaphragm = stepped_diaphragm();
  diaphragm.profile.resize(1);
  EXPECT_EQ(diaphragm_thickness(diaphragm, 40 * mm), 5 * mm);
  EXPECT_NEAR(diaphragm_thickness(diaphragm, 60 * mm), 4 * mm, 1e-17);  // half way to the edge
}

// Kind: behaviour.  A place of the inspection leaves with its crack.
TEST(PathLists, BehaviourPlacesOfTheInspectionGoWithTheirCracks) {
  GearSet gear = article_gear();
  gear.inspection = Inspection{
      .a50 = 1e-3, .a90 = 2e-3, .place = {{"flexspline.crack[0]"}, {"output_shaft.crack[0]"}}};
  const GearSet before = gear;
  gear.flexspline->crack.clear();
  drop_lost_paths(gear, before);
  ASSERT_EQ(gear.inspection->place.size(), 1U);
  EXPECT_EQ(gear.inspection->place[0].crack, "output_shaft.crack[0]");
  EXPECT_NO_THROW(check(gear));
  // Without its last place it would see all cracks, so it leaves too.
  gear.output_shaft->crack.clear();
  drop_lost_paths(gear, before);
  EXPECT_FALSE(gear.inspection);
  // An inspection of all cracks stays.
  gear.inspection = Inspection{.a50 = 1e-3, .a90 = 2e-3};
  drop_lost_paths(gear, before);
  EXPECT_TRUE(gear.inspection);
}

}  // namespace
}  // namespace strainwave
