// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/stress_intensity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/present/json.hpp"

namespace strainwave {
namespace {

using Json = nlohmann::json;

bool contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

TEST(SifList, BehaviourEverySolutionIsListedInEveryForm) {
  const std::string text = sif_list_text(sif_list(""));
  const std::string markdown = sif_list_markdown(sif_list(""));
  const Json json = Json::parse(json_of(sif_list("")))["solutions"];
  ASSERT_EQ(json.size(), sif::library().size());
  for (std::size_t i = 0; i < json.size(); ++i) {
    const std::string name(sif::library()[i].info.name);
    EXPECT_EQ(json[i]["name"], name);
    EXPECT_TRUE(contains(text, name)) << name;
    EXPECT_TRUE(contains(markdown, "`" + name + "`")) << name;
  }
  EXPECT_TRUE(contains(text, std::to_string(json.size()) + " solutions"));
}

TEST(SifList, BehaviourAFamilyIsAPart) {
  const Json plates = Json::parse(json_of(sif_list("plate")))["solutions"];
  EXPECT_LT(plates.size(), sif::library().size());
  for (const Json& row : plates) EXPECT_EQ(row["family"], "plate");
  EXPECT_FALSE(contains(sif_list_text(sif_list("plate")), "\ntube\n"));
}

TEST(SifList, InputUnknownFamilyNamesThoseThereAre) {
  try {
    (void)sif_list("plates");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_TRUE(contains(error.what(), "plate, tube, bar, gradient")) << error.what();
  }
}

// docs/guide/stress_intensity.md is made by `strainwave sif list --format markdown`.
TEST(SifList, BehaviourGuideIsCurrent) {
  std::ifstream file(std::string(STRAINWAVE_EXAMPLES) + "/../docs/guide/stress_intensity.md",
                     std::ios::binary);
  const std::string guide{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(guide, sif_list_markdown(sif_list("")))
      << "write it anew: strainwave sif list --format markdown > docs/guide/stress_intensity.md";
}

TEST(SifShow, BehaviourTextAndJsonSayTheSame) {
  for (const sif::Row& row : sif::library()) {
    const std::string text = sif_solution_text({&row});
    const Json json = Json::parse(json_of(DescribedSolution{&row}));
    EXPECT_TRUE(contains(text, row.info.accuracy));
    EXPECT_EQ(json["fields"].size(), row.fields.size());
    for (const Field& field : row.fields) EXPECT_TRUE(contains(text, field.name));
    for (const Json& limit : json["validity"])
      EXPECT_TRUE(contains(text, limit.get<std::string>())) << limit;
    EXPECT_EQ(json["loads"].size(), row.loads.size());
  }
}

TEST(SifEval, ReferenceTextHasTheNumbers) {
  // K = 100 MPa sqrt(pi 1 mm) = 5.605 MPa m^0.5, by hand.
  const sif::Row& row = sif::solution("plate-through");
  const std::vector<std::string> set{"half_length=1 mm", "tension=100 MPa"};
  const std::string text = sif_evaluation_text(sif::evaluate(row, sif_assignments(row, set)));
  EXPECT_TRUE(contains(text, "5.605")) << text;
  EXPECT_TRUE(contains(text, "default, not given")) << text;
  EXPECT_TRUE(contains(text, "outside a >= 2 t")) << text;
}

TEST(SifEval, BehaviourFractureAndPressureAreSaid) {
  const sif::Row& row = sif::solution("plate-through");
  const auto text = [&](double tension) {
    return sif_evaluation_text(sif::evaluate(
        row, {{"tension", tension}},
        {.youngs_modulus = 210e9, .poissons_ratio = 0.3, .fracture_toughness = 50e6}));
  };
  // K_Ic is reached at 50e6/sqrt(pi 0.005) = 398.9 MPa.
  EXPECT_FALSE(contains(text(398e6), "reaches the fracture"));
  EXPECT_TRUE(contains(text(400e6), "reaches the fracture toughness"));
  EXPECT_TRUE(contains(text(-1e6), "press"));
  EXPECT_FALSE(contains(text(1e6), "press"));
}

TEST(SifEval, BehaviourJsonHasWhatTheEvaluationHas) {
  const sif::Row& row = sif::solution("plate-surface");
  const std::vector<std::string> set{"depth=9 mm", "bending=10 MPa"};
  const sif::Evaluation e = sif::evaluate(row, sif_assignments(row, set));
  const Json json = Json::parse(json_of(e));
  EXPECT_FALSE(e.in_range());
  const auto given = [&](std::string_view name) {
    const auto field =
        std::ranges::find(json["fields"], name, [](const Json& f) { return f["name"]; });
    return field->at("given").get<bool>();
  };
  EXPECT_TRUE(given("depth"));
  EXPECT_FALSE(given("thickness"));
  EXPECT_EQ(json["points"][1]["name"], "deepest");
  EXPECT_EQ(json["points"][1]["K_I"]["value"].get<double>(), e.points[1].K_I);
  EXPECT_EQ(json["added_compliance"].size(), 3U);
  EXPECT_TRUE(e.converged);
  EXPECT_EQ(json["geometry_factors"]["Y_I"]["values"].size(), e.factors.size());
}

TEST(SifAssignments, InputEachRuleBroken) {
  const sif::Row& row = sif::solution("plate-surface");
  const auto read = [&](std::vector<std::string> set) { return sif_assignments(row, set); };
  EXPECT_THROW((void)read({"depth"}), InputError);
  EXPECT_THROW((void)read({"dpth=1 mm"}), InputError);
  EXPECT_THROW((void)read({"depth=1"}), InputError);
  EXPECT_THROW((void)read({"depth=1 MPa"}), InputError);
  EXPECT_THROW((void)read({"depth=1 mm", "depth=2 mm"}), InputError);
  EXPECT_DOUBLE_EQ(read({" depth = 1 mm"}).at("depth"), 1e-3);
}

TEST(SifPlot, BehaviourEverySolutionHasOne) {
  for (const sif::Row& row : sif::library()) {
    const std::string svg = sif_plot(row, {});
    EXPECT_TRUE(svg.starts_with("<svg")) << row.info.name;
    EXPECT_FALSE(contains(svg, "nan")) << row.info.name;
    EXPECT_EQ(contains(svg, "along the front"),
              row.make({})->front().begin != row.make({})->front().end)
        << row.info.name;
    EXPECT_EQ(svg, sif_plot(row, {})) << "not the same bytes";
  }
}

TEST(SifPlot, InputImpossibleGeometryIsRefused) {
  EXPECT_THROW((void)sif_plot(sif::solution("plate-surface"), {{"depth", 1.0}}), InputError);
}

TEST(SifText, BehaviourAccuracyOfEachModeAndTheReferenceStress) {
  const sif::Row& bar = sif::solution("bar-surface");
  const std::string all = sif_solution_text({&bar});
  EXPECT_TRUE(contains(all, "accuracy   K_I to 3 %, K_II and K_III to 5 %;")) << all;
  EXPECT_TRUE(contains(all, "sigma: P/A, M r/I, T r/(2I) of the uncracked bar at the surface"))
      << all;
  const std::string sheared = sif_evaluation_text(sif::evaluate(bar, {{"torque", 10.0}}));
  EXPECT_TRUE(contains(sheared, "Accuracy: K_II and K_III to 5 %;")) << sheared;
  const ResultEvidence evidence = sif::evidence_of(sif::evaluate(bar, {{"torque", 10.0}}));
  ASSERT_EQ(evidence.accuracies.size(), 1U);
  EXPECT_EQ(evidence.accuracies[0].relative_uncertainty, 0.05);
  EXPECT_EQ(evidence.accuracies[0].path, "bar-surface K_II and K_III");
}

}  // namespace
}  // namespace strainwave
