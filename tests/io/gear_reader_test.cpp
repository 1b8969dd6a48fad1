// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/gear_reader.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <ostream>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/materials/material_library.hpp"
#include "support/article_gear.hpp"
#include "support/expect.hpp"

namespace strainwave {
namespace {

/// The article's example; the columns matter to the messages below.
constexpr std::string_view kArticle = R"(format = "strainwave-drive/1"
name = "Article example: double wave, ratio 100, pitch diameter 160 mm"

[material.steel]
youngs_modulus = "210 GPa"
shear_modulus = "80 GPa"
poissons_ratio = 0.3

[drive]
ratio = 100
wave_number = 2
pitch_diameter = "160 mm"
radial_displacement = "0.8 mm"

[load]
torque = "100 N*m"
axial_force = "0 N"

[wave_generator]
material = "steel"
force_transmission_coefficient = 0.35
load_factor = 1.15
radial_stiffness = "1.2e5 N/mm"
inner_ring_thickness = "10 mm"
contact_semi_axes = ["5 mm", "2 mm"]

[[wave_generator.crack]]
kind = "surface"
depth = "0.1 mm"
aspect_ratio = 0.52147039
stress_driver = "orthogonal_shear"
contact_factor = 0.45

[flexspline]
material = "steel"
shape = "cup"
wall_thickness = "2.24 mm"
length = "160 mm"
crack_free = "factor"
stress_nonuniformity = 1.1
dynamic_load = 1.2

[[flexspline.crack]]
kind = "through"
half_length = "0.1 mm"
angle = "45 deg"
shell_correction = true

[output_shaft]
material = "steel"
outer_diameter = "70 mm"
inner_diameter = "45 mm"
length = "200 mm"

[[output_shaft.crack]]
kind = "annular"
depth = "0.1 mm"

[article]
radial_load = "500 N"
flaw_parameter = 1.5
mean_radius = "79.88 mm"
equivalent_shaft_diameter = "60 mm"
M_p = 0.85
M_M = 0.42
)";

/// The article's example with one piece of text replaced.
std::string with(std::string_view from, std::string_view to, std::string_view base = kArticle) {
  std::string text(base);
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("not in the example: " + std::string(from));
  return text.replace(at, from.size(), to);
}

/// The message that refuses a text; "accepted" if it is valid.
std::string refusal(std::string_view text) {
  try {
    (void)read_gear_set(text, "gear.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

/// Everything that a value holds, as text: for the comparison of drives.
template <class T>
void dump(const T& value, std::ostream& out) {
  if constexpr (std::is_same_v<T, double>) {
    out << quantity_text(value, "1");
  } else if constexpr (std::is_enum_v<T>) {
    out << enum_name(value);
  } else if constexpr (is_optional<T>) {
    if (value) dump(*value, out);
  } else if constexpr (is_vector<T> || is_pair_of_numbers<T>) {
    for (const auto& element : value) {
      out << '[';
      dump(element, out);
      out << ']';
    }
  } else if constexpr (is_string_map<T>) {
    for (const auto& [name, element] : value) {
      out << name << ": ";
      dump(element, out);
    }
  } else if constexpr (is_variant<T>) {
    std::visit(
        [&](const auto& alternative) {
          out << alternative.kKind << ' ';
          dump(alternative, out);
        },
        value);
  } else if constexpr (Described<T>) {
    out << '{';
    T::describe([&](const Field& field, auto member) {
      out << field.name << '=';
      dump(value.*member, out);
      out << ' ';
    });
    out << '}';
  } else {
    out << value;
  }
}

std::string dump(const GearSet& gear) {
  std::ostringstream out;
  dump(gear, out);
  return out.str();
}

std::string file_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// --- What is read --------------------------------------------------------------------------------

TEST(GearReader, CrosscheckTheTextIsTheDriveBuiltInCode) {
  const GearSet read = read_gear_set(kArticle, "gear.toml");
  const GearSet built = test::article_gear();
  const GearSet& read_only = read;
  std::vector<std::pair<std::string, double>> numbers;
  for_each_number(read_only, [&](const FieldPath& path, const Field&, const double& number) {
    numbers.emplace_back(path.text(), number);
  });
  std::size_t i = 0;
  for_each_number(built, [&](const FieldPath& path, const Field&, const double& number) {
    ASSERT_LT(i, numbers.size());
    EXPECT_EQ(numbers[i].first, path.text());
    EXPECT_DOUBLE_EQ(numbers[i].second, number) << path.text();
    ++i;
  });
  EXPECT_EQ(i, numbers.size());
  EXPECT_EQ(read.name, built.name);
  EXPECT_EQ(read.drive.wave_number, 2);
}

TEST(GearReader, BehaviourValuesArriveInSiExactly) {
  // A prefix moves the decimal point, so the value is the double nearest to the decimal number.
  const GearSet gear = read_gear_set(kArticle, "gear.toml");
  EXPECT_EQ(gear.drive.pitch_diameter, 0.16);
  EXPECT_EQ(gear.drive.radial_displacement, 0.0008);
  EXPECT_EQ(gear.flexspline->wall_thickness, 0.00224);
  EXPECT_EQ(gear.material.at("steel").youngs_modulus, 210e9);
  EXPECT_EQ(gear.material.at("steel").poissons_ratio, 0.3);
  EXPECT_EQ(gear.load.torque, 100);
  EXPECT_EQ(gear.wave_generator->radial_stiffness, 1.2e8);
  EXPECT_EQ(gear.wave_generator->contact_semi_axes, (std::array<double, 2>{0.005, 0.002}));
  EXPECT_EQ(std::get<WallThroughCrack>(gear.flexspline->crack[0]).angle, std::numbers::pi / 4);
  EXPECT_EQ(gear.article->flaw_parameter, 1.5);
}

TEST(GearReader, IdentityTheUnitDoesNotMatter) {
  const GearSet reference = read_gear_set(kArticle, "gear.toml");
  const std::vector<std::pair<std::string_view, std::string_view>> same = {
      {"\"160 mm\"", "\"16 cm\""},
      {"\"160 mm\"", "\"0.16 m\""},
      {"\"160 mm\"", "\"0.16m\""},
      {"\"160 mm\"", "'160 mm'"},
      {"\"160 mm\"", "\"\"\"160 mm\"\"\""},
      {"\"160 mm\"", "\"160\\u0020mm\""},
      {"\"100 N*m\"", "\"0.1 kN*m\""},
      {"\"100 N*m\"", "\"100 Nm\""},
      {"\"100 N*m\"", "\"+1e2 N*m\""},
      {"\"45 deg\"", "\"2700 arcmin\""},
      {"\"210 GPa\"", "\"210 kN/mm^2\""},
      {"ratio = 100", "ratio = 100.0"},
      {"ratio = 100", "ratio = 1e2"},
      {"ratio = 100", "ratio = 1_00"},
      {"ratio = 100", "ratio = 0x64"},
      {"wave_number = 2", "wave_number = 0b10"},
      {"\"0 N\"", "\"-0.0 kN\""}};
  for (const auto& change : same) {
    const GearSet gear = read_gear_set(with(change.first, change.second), "gear.toml");
    for_each_number(gear, [&](const FieldPath& path, const Field&, const double& number) {
      EXPECT_DOUBLE_EQ(number, number_at(reference, path.text()).value)
          << change.second << " " << path.text();
    });
  }
}

TEST(GearReader, IdentityTheOrderOfKeysAndTablesDoesNotMatter) {
  // Blocks are separated by empty lines; the first block holds the keys outside all tables.
  std::vector<std::vector<std::string>> blocks(1);
  std::istringstream lines{std::string(kArticle)};
  for (std::string line; std::getline(lines, line);) {
    if (line.empty())
      blocks.emplace_back();
    else
      blocks.back().push_back(line);
  }
  const std::string expected = dump(read_gear_set(kArticle, "gear.toml"));
  std::mt19937 random(1);
  for (int round = 0; round < 50; ++round) {
    auto shuffled = blocks;
    std::shuffle(shuffled.begin() + 1, shuffled.end(), random);
    // TOML allows [wave_generator] both before and after [[wave_generator.crack]].
    std::string text;
    for (std::size_t b = 0; b < shuffled.size(); ++b) {
      auto& block = shuffled[b];
      std::shuffle(block.begin() + (b == 0 ? 0 : 1), block.end(), random);
      for (const std::string& line : block) text += line + "\n";
    }
    EXPECT_EQ(dump(read_gear_set(text, "gear.toml")), expected) << text;
  }
}

TEST(GearReader, IdentityCommentsAndLayoutDoNotMatter) {
  const std::string expected = dump(read_gear_set(kArticle, "gear.toml"));
  std::string commented = "# at the start\n";
  std::string crlf;
  for (const char c : kArticle) {
    commented += c == '\n' ? std::string(" \t# a comment, = [ \" and all\n\n") : std::string(1, c);
    crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  }
  EXPECT_EQ(dump(read_gear_set(commented, "gear.toml")), expected);
  EXPECT_EQ(dump(read_gear_set(crlf, "gear.toml")), expected);
  EXPECT_EQ(dump(read_gear_set("\xEF\xBB\xBF" + std::string(kArticle), "gear.toml")), expected);
  EXPECT_EQ(dump(read_gear_set(with("[drive]", "# " + std::string(1000, '.') + "\n[drive]"),
                               "gear.toml")),
            expected);
}

TEST(GearReader, BehaviourTablesInlineAndDotted) {
  const std::string expected = dump(read_gear_set(kArticle, "gear.toml"));
  const std::string inline_tables =
      with("[[output_shaft.crack]]\nkind = \"annular\"\ndepth = \"0.1 mm\"\n", "",
           with("length = \"200 mm\"\n",
                "length = \"200 mm\"\ncrack = [{kind = \"annular\", depth = \"0.1 mm\"}]\n"));
  EXPECT_EQ(dump(read_gear_set(inline_tables, "gear.toml")), expected);
  const std::string dotted = with("[load]\ntorque = \"100 N*m\"\naxial_force = \"0 N\"\n", "",
                                  with("\n[material.steel]",
                                       "load.torque = \"100 N*m\"\nload.'axial_force' = \"0 N\"\n"
                                       "[material.\"steel\"]"));
  EXPECT_EQ(dump(read_gear_set(dotted, "gear.toml")), expected);
}

TEST(GearReader, BehaviourFieldsLeftOutTakeTheirDefaults) {
  std::string text(kArticle);
  for (const std::string_view line :
       {"name = \"Article example: double wave, ratio 100, pitch diameter 160 mm\"\n",
        "wave_number = 2\n", "axial_force = \"0 N\"\n", "load_factor = 1.15\n",
        "stress_driver = \"orthogonal_shear\"\n", "shape = \"cup\"\n", "crack_free = \"factor\"\n",
        "stress_nonuniformity = 1.1\n", "dynamic_load = 1.2\n", "angle = \"45 deg\"\n",
        "shell_correction = true\n", "inner_diameter = \"45 mm\"\n"})
    text = with(line, "", text);
  const GearSet gear = read_gear_set(text, "gear.toml");
  EXPECT_EQ(gear.name, "");
  EXPECT_EQ(gear.drive.wave_number, 2);
  EXPECT_EQ(gear.load.axial_force, 0);
  EXPECT_EQ(gear.wave_generator->load_factor, 1.15);
  EXPECT_EQ(gear.wave_generator->conversion, Conversion::reciprocity);
  EXPECT_EQ(std::get<RaceSurfaceCrack>(gear.wave_generator->crack[0]).stress_driver,
            StressDriver::orthogonal_shear);
  EXPECT_EQ(gear.flexspline->shape, FlexsplineShape::cup);
  EXPECT_EQ(gear.flexspline->crack_free, CrackFree::factor);
  EXPECT_EQ(gear.flexspline->stress_nonuniformity, 1);
  EXPECT_EQ(gear.flexspline->dynamic_load, 1);
  const auto& through = std::get<WallThroughCrack>(gear.flexspline->crack[0]);
  EXPECT_EQ(through.angle, std::numbers::pi / 4);
  EXPECT_TRUE(through.shell_correction);
  EXPECT_EQ(through.section, WallSection::barrel);
  EXPECT_TRUE(gear.output_shaft->solid());
  EXPECT_EQ(std::get<AnnularCrack>(gear.output_shaft->crack[0]).solution,
            AnnularSolution::improved);
}

TEST(GearReader, BehaviourMembersLeftOutAreAbsent) {
  const std::string text =
      with(kArticle.substr(kArticle.find("[wave_generator]"),
                           kArticle.find("[output_shaft]") - kArticle.find("[wave_generator]")),
           "");
  const GearSet gear = read_gear_set(text, "gear.toml");
  EXPECT_FALSE(gear.wave_generator.has_value());
  EXPECT_FALSE(gear.flexspline.has_value());
  EXPECT_TRUE(gear.output_shaft.has_value());
}

TEST(GearReader, BehaviourSeveralCracksKeepTheirOrder) {
  const GearSet gear =
      read_gear_set(std::string(kArticle) +
                        "[[output_shaft.crack]]\nkind = \"annular\"\ndepth = \"1 mm\"\n"
                        "[[output_shaft.crack]]\ndepth = \"2 mm\"\nkind = \"annular\"\n",
                    "gear.toml");
  ASSERT_EQ(gear.output_shaft->crack.size(), 3U);
  EXPECT_EQ(std::get<AnnularCrack>(gear.output_shaft->crack[1]).depth, 1 * units::mm);
  EXPECT_EQ(std::get<AnnularCrack>(gear.output_shaft->crack[2]).depth, 2 * units::mm);
}

TEST(GearReader, BehaviourTheCoupledDriveIsRead) {
  const std::string text = std::string(kArticle) + R"(
[mesh]
lobe_gap = "-2 um"
[[mesh.crack]]
kind = "tooth"
stiffness_loss = 0.5
position = "9 deg"
[circular_spline]
material = "steel"
outer_diameter = "214 mm"
inner_diameter = "164 mm"
width = "25 mm"
support = 0.5
[[circular_spline.crack]]
kind = "ring"
depth = "2 mm"
[rating]
T1 = "212 N*m"
T2 = "766 N*m"
[[range]]
path = "mesh.lobe_gap"
lower = "-5 um"
upper = "0 um"
knowledge = "assumed"
[[range]]
path = "flexspline.wall_thickness"
lower = "2 mm"
upper = "2.5 mm"
source = "drawing"
[[range]]
path = "mesh.gap_factor"
lower = 0.05
upper = 1
[[scatter]]
path = "flexspline.wall_thickness"
relative_standard_deviation = 0.02
[[scatter]]
path = "load.torque"
relative_standard_deviation = 0.1
distribution = "normal"
source = "measured"
[[scatter]]
path = "drive.ratio"
distribution = "table"
quantile = [{probability = 0, ratio = 0.9}, {probability = 1, ratio = 1.2}]
[[correlation]]
path = "load.torque"
with = "drive.ratio"
rank_correlation = -0.5
)";
  const GearSet gear = read_gear_set(text, "gear.toml");
  EXPECT_EQ(gear.mesh->lobe_gap, -2e-6);
  EXPECT_EQ(gear.mesh->gap_factor, 1.0);
  const auto& tooth = std::get<ToothCrack>(gear.mesh->crack.at(0));
  EXPECT_EQ(tooth.stiffness_loss, 0.5);
  EXPECT_NEAR(tooth.position, 0.15707963267948966, 1e-16);
  EXPECT_EQ(gear.circular_spline->support, 0.5);
  const auto& ring = std::get<CircularSplineRingCrack>(gear.circular_spline->crack.at(0));
  EXPECT_EQ(ring.depth, 2e-3);
  EXPECT_EQ(ring.position, 0.0);
  EXPECT_EQ(gear.rating->T2, 766);
  EXPECT_FALSE(gear.rating->T3.has_value());
  EXPECT_EQ(gear.rating->lost_motion_share, 0.04);
  ASSERT_EQ(gear.range.size(), 3U);
  EXPECT_EQ(gear.range[0].knowledge, Knowledge::assumed);
  EXPECT_EQ(gear.range[0].source, "");
  EXPECT_EQ(gear.range[1].path, "flexspline.wall_thickness");
  EXPECT_EQ(gear.range[1].knowledge, Knowledge::typical);
  EXPECT_EQ(gear.range[1].upper, "2.5 mm");
  // A number without a unit may be bare, as in other fields.
  EXPECT_EQ(gear.range[2].lower, "0.05");
  EXPECT_EQ(gear.range[2].upper, "1");
  EXPECT_NO_THROW(check(gear));
  ASSERT_EQ(gear.scatter.size(), 3U);
  EXPECT_EQ(gear.scatter[0].path, "flexspline.wall_thickness");
  EXPECT_EQ(gear.scatter[0].relative_standard_deviation, 0.02);
  EXPECT_EQ(gear.scatter[0].distribution, ScatterDistribution::lognormal);
  EXPECT_EQ(gear.scatter[1].distribution, ScatterDistribution::normal);
  EXPECT_EQ(gear.scatter[1].source, "measured");
  EXPECT_FALSE(gear.scatter[2].relative_standard_deviation);
  ASSERT_EQ(gear.scatter[2].quantile.size(), 2U);
  EXPECT_EQ(gear.scatter[2].quantile[1].probability, 1);
  EXPECT_EQ(gear.scatter[2].quantile[1].ratio, 1.2);
  ASSERT_EQ(gear.correlation.size(), 1U);
  EXPECT_EQ(gear.correlation[0].with, "drive.ratio");
  EXPECT_EQ(gear.correlation[0].rank_correlation, -0.5);
  // Fields that are left out are absent.
  const GearSet plain = read_gear_set(kArticle, "gear.toml");
  EXPECT_FALSE(plain.mesh || plain.circular_spline || plain.rating);
  EXPECT_TRUE(plain.range.empty());
  EXPECT_TRUE(plain.scatter.empty());
}

TEST(GearReader, BehaviourAnInspection) {
  const std::string text = std::string(kArticle) + R"(
[inspection]
detection = "log_normal"
a50 = "1 mm"
a90 = "2 mm"
false_calls = 0.02
find = "repair"
repaired_to = "0.5 mm"
cost = {inspection = 200, failure = 5e4}
[[inspection.place]]
crack = "output_shaft.crack[0]"
)";
  const GearSet gear = read_gear_set(text, "gear.toml");
  ASSERT_TRUE(gear.inspection.has_value());
  EXPECT_EQ(gear.inspection->method, InspectionMeans::curve);
  EXPECT_EQ(gear.inspection->detection, DetectionForm::log_normal);
  EXPECT_EQ(gear.inspection->a50, 1e-3);
  EXPECT_EQ(gear.inspection->a90, 2e-3);
  EXPECT_EQ(gear.inspection->false_calls, 0.02);
  EXPECT_EQ(gear.inspection->find, FindLeadsTo::repair);
  EXPECT_EQ(gear.inspection->repaired_to, 0.5e-3);
  EXPECT_EQ(gear.inspection->cost->inspection, 200);
  EXPECT_EQ(gear.inspection->cost->call, 0);
  EXPECT_EQ(gear.inspection->cost->failure, 5e4);
  ASSERT_EQ(gear.inspection->place.size(), 1U);
  EXPECT_EQ(gear.inspection->place[0].crack, "output_shaft.crack[0]");
  const GearSet measured = read_gear_set(
      std::string(kArticle) +
          "\n[inspection]\nmethod = \"one_sided_stiffness\"\nnoise = 0.01\nfalse_calls = 0.05\n",
      "gear.toml");
  EXPECT_EQ(measured.inspection->method, InspectionMeans::one_sided_stiffness);
  EXPECT_EQ(measured.inspection->noise, 0.01);
  EXPECT_FALSE(measured.inspection->a50 || measured.inspection->detection);
}

// Kind: input.  A rule between the fields of the table has its place in the file.
TEST(GearReader, InputAnInspectionThatFalls) {
  const std::string text =
      std::string(kArticle) + "\n[inspection]\na50 = \"2 mm\"\na90 = \"1 mm\"\n";
  const std::string message =
      test::broken_rule([&] { return read_gear_set(text, "gear.toml").name; });
  EXPECT_TRUE(message.starts_with("gear.toml:")) << message;
  EXPECT_NE(
      message.find("inspection.a90 = \"1 mm\" violates: > a50: a larger crack is found more often"),
      std::string::npos)
      << message;
}

TEST(GearReader, BehaviourMaterialsMayHaveAnyName) {
  for (const std::string_view name :
       {"\"a.b\"", "\"\"", "'[0]'", "\"\\u03B1-Ti\"", "kind", "4340"}) {
    std::string text = with("[material.steel]", "[material." + std::string(name) + "]");
    for (int member = 0; member < 3; ++member)
      text = with("material = \"steel\"",
                  "material = " + (name.front() == '"' || name.front() == '\''
                                       ? std::string(name)
                                       : "\"" + std::string(name) + "\""),
                  text);
    EXPECT_EQ(refusal(text), "accepted") << text;
  }
}

TEST(GearReader, BehaviourMaterialsOfTheLibrary) {
  std::string text = with("material = \"steel\"\nshape", "material = \"17-4ph  h900\"\nshape");
  text = with("material = \"steel\"\nforce", "material = \"100Cr6 hardened\"\nforce", text);
  text = with("material = \"steel\"\nouter", "material = \"100Cr6 hardened\"\nouter", text);
  const GearSet gear = read_gear_set(text, "gear.toml");
  // The material is stored under the name that the member gives, in addition to those of the file.
  ASSERT_EQ(gear.material.size(), 3U);
  const Material& flexspline = gear.material.at("17-4ph  h900");
  const MaterialRecord& record = require_material("17-4PH H900");
  EXPECT_EQ(flexspline.youngs_modulus, record.youngs_modulus->value);
  EXPECT_EQ(flexspline.yield_strength, record.yield_strength->value);
  EXPECT_EQ(flexspline.origin, as_material(record).origin);
  EXPECT_EQ(gear.material.at("100Cr6 hardened").ultimate_strength,
            require_material("52100 hardened").ultimate_strength->value);
  EXPECT_EQ(gear.material.at("steel").origin, "");
  // A drive does not need any material table.
  text = with(
      "[material.steel]\nyoungs_modulus = \"210 GPa\"\nshear_modulus = \"80 GPa\"\npoissons_ratio "
      "= 0.3\n",
      "", text);
  EXPECT_EQ(read_gear_set(text, "gear.toml").material.size(), 2U);
  // Sweep and solve reach its numbers by name.
  EXPECT_EQ(number_at(gear, "material.17-4ph  h900.yield_strength").value,
            record.yield_strength->value);
  EXPECT_EQ(number_at(gear, "material.17-4ph  h900.yield_strength").field.unit, "Pa");
}

TEST(GearReader, BehaviourATableOfTheFileWinsOverTheLibrary) {
  std::string text = with("[material.steel]", "[material.\"17-4PH H900\"]");
  for (int member = 0; member < 3; ++member)
    text = with("material = \"steel\"", "material = \"17-4PH H900\"", text);
  const GearSet gear = read_gear_set(text, "gear.toml");
  ASSERT_EQ(gear.material.size(), 1U);
  EXPECT_EQ(gear.material.at("17-4PH H900").youngs_modulus, 210e9);
  EXPECT_EQ(gear.material.at("17-4PH H900").yield_strength, std::nullopt);
  EXPECT_EQ(gear.material.at("17-4PH H900").origin, "");
  // Table and library are not mixed: missing fields of the table are not filled in.
  const std::string_view E = "youngs_modulus = \"210 GPa\"\n";
  EXPECT_EQ(
      refusal(text.replace(text.find(E), E.size(), "")),
      "gear.toml:4:1: material.17-4PH H900.youngs_modulus: must be given (Young's modulus E; of a "
      "layer, E1 along the fibres "
      "[Pa])");
}

TEST(GearReader, BehaviourATableCompletesARecordOfTheLibrary) {
  const std::string own =
      "[material.steel]\nbased_on = \"40CrNiMoA QT\"\nfracture_toughness = \"90 MPa*m^0.5\"\n";
  const std::string whole =
      "[material.steel]\nyoungs_modulus = \"210 GPa\"\nshear_modulus = \"80 GPa\"\npoissons_ratio "
      "= 0.3\n";
  const GearSet gear = read_gear_set(with(whole, own), "gear.toml");
  const Material& steel = gear.material.at("steel");
  const MaterialRecord& record = require_material("40CrNiMoA QT");
  EXPECT_EQ(steel.youngs_modulus, record.youngs_modulus->value);
  EXPECT_EQ(steel.yield_strength, record.yield_strength->value);
  EXPECT_EQ(steel.fracture_toughness, 90e6);
  EXPECT_NE(steel.origin.find("own values: fracture_toughness 90 MPa*m^0.5"), std::string::npos)
      << steel.origin;
  // Sweep and solve may set a number that the library gives; the number then counts as the file's
  // own.
  GearSet swept = gear;
  set_number(swept, "material.steel.yield_strength", 1e9);
  EXPECT_EQ(std::ranges::count(swept.material.at("steel").from_library, "yield_strength"), 0);
  EXPECT_EQ(std::ranges::count(steel.from_library, "yield_strength"), 1);
  // The faults are an unknown steel and a contradiction between numbers of the file and of the
  // library.
  EXPECT_EQ(
      refusal(with(whole, "[material.steel]\nbased_on = \"40CrNiMoA\"\n")),
      "gear.toml:5:12: material.steel.based_on: \"40CrNiMoA\" is not in the material library; "
      "did you mean 40CrNiMoA QT?");
  EXPECT_NE(refusal(with(whole,
                         "[material.steel]\nbased_on = \"40CrNiMoA QT\"\nyield_strength = "
                         "\"3 GPa\"\n"))
                .find("ultimate_strength >= yield_strength"),
            std::string::npos);
}

TEST(GearReader, InputATableOfTheFileIsNotPassedOver) {
  // Some members name the table, and one member uses an alias of the same steel.
  std::string text = with("[material.steel]", "[material.\"52100 hardened\"]");
  text = with("material = \"steel\"\nforce", "material = \"52100 hardened\"\nforce", text);
  text = with("material = \"steel\"\nshape", "material = \"100Cr6 hardened\"\nshape", text);
  text = with("material = \"steel\"\nouter", "material = \"52100 hardened\"\nouter", text);
  EXPECT_EQ(refusal(text),
            "gear.toml:35:12: flexspline.material: \"100Cr6 hardened\" is in the material library, "
            "but the file gives the same steel as [material.\"52100 hardened\"]; use one name");
  // Two names of one steel of the library do not contradict each other.
  std::string library = with("material = \"steel\"\nforce", "material = \"GCr15 hardened\"\nforce");
  library = with("material = \"steel\"\nshape", "material = \"100Cr6 hardened\"\nshape", library);
  EXPECT_EQ(read_gear_set(library, "gear.toml").material.size(), 3U);
  // Only tables of the file are listed as given.
  EXPECT_EQ(
      refusal(with("material = \"steel\"\nouter", "material = \"unobtainium\"\nouter", library)),
      "gear.toml:50:12: output_shaft.material: \"unobtainium\" is not one of the materials given "
      "(steel), nor in the material library; strainwave material list shows the names");
}

TEST(GearReader, BehaviourExamplesAreRead) {
  const std::filesystem::path folder = STRAINWAVE_EXAMPLES;
  ASSERT_TRUE(std::filesystem::exists(folder)) << folder;
  int n = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    ++n;
    EXPECT_NO_THROW((void)read_gear_set_file(entry.path())) << entry.path();
    EXPECT_EQ(dump(read_gear_set_file(entry.path())),
              dump(read_gear_set(file_text(entry.path()), "other name",
                                 attachments_beside(entry.path()))));
  }
  EXPECT_GT(n, 0);
}

TEST(GearReader, CrosscheckArticleExampleIsTheDriveBuiltInCode) {
  const std::filesystem::path file = std::filesystem::path(STRAINWAVE_EXAMPLES) / "article.toml";
  ASSERT_TRUE(std::filesystem::exists(file)) << file;
  EXPECT_EQ(dump(read_gear_set_file(file)), dump(read_gear_set(kArticle, "gear.toml")));
}

// --- What is refused, message by message ---------------------------------------------------------

struct Wrong {
  std::string name;
  std::string from;
  std::string to;
  std::string message;  ///< without the file's name

  friend std::ostream& operator<<(std::ostream& out, const Wrong& w) { return out << w.name; }
};

const std::vector<Wrong> kWrong = {
    // no TOML
    {"SyntaxNoValue", "ratio = 100", "ratio =", "10:8: is not valid TOML: "},
    {"SyntaxNoQuote", "\"160 mm\"", "\"160 mm", "12:25: is not valid TOML: "},
    {"SyntaxBareUnit", "\"160 mm\"", "160 mm", "12:22: is not valid TOML: "},
    {"SyntaxDegreeSign", "\"45 deg\"", "45\u00B0", "46:11: is not valid TOML: "},
    {"DuplicateKey", "ratio = 100", "ratio = 100\nratio = 99", "11:9: is not valid TOML: "},
    {"DuplicateTable", "[article]", "[drive]", "59:1: is not valid TOML: "},
    {"DuplicateTableOfAnotherKind", "[article]", "[[flexspline]]", "59:1: is not valid TOML: "},
    {"IntegerOverflow", "ratio = 100", "ratio = 9223372036854775808", "10:28: is not valid TOML: "},
    {"ExponentOverflow", "ratio = 100", "ratio = 1e999", "10:14: is not valid TOML: "},

    // keys
    {"UnknownKeyAtTheTop",
     "name = ", "nmae = ", "2:1: nmae: is not known here; did you mean name?"},
    {"UnknownKeyInATable", "outer_diameter = ", "diameter_outer = ",
     "51:1: output_shaft.diameter_outer: is not known here; known names are material, "
     "outer_diameter, inner_diameter, length, crack"},
    {"UnknownKeyMisspelt", "outer_diameter = ", "outer_diametre = ",
     "51:1: output_shaft.outer_diametre: is not known here; did you mean outer_diameter?"},
    {"UnknownKeyOfACrack", "depth = \"0.1 mm\"\naspect", "dept = \"0.1 mm\"\naspect",
     "29:1: wave_generator.crack[0].dept: is not known here; did you mean depth?"},
    {"UnknownTable", "[article]", "[artikel]",
     "59:2: artikel: is not known here; known names are format, name, material, drive, load, "
     "wave_generator, flexspline, output_shaft, mesh, circular_spline, output_bearing, duty, "
     "drivetrain, kinematic_error, manoeuvre, rating, tolerance, range, "
     "scatter, correlation, inspection, article"},
    {"UnknownMember", "[article]", "[input_shaft]",
     "59:2: input_shaft: is not known here; did you mean output_shaft?"},
    {"UnknownEmptyKey", "M_M = ", "\"\" = ",
     "65:1: article.\"\": is not known here; known names are radial_load, flaw_parameter, "
     "mean_radius, equivalent_shaft_diameter, M_p, M_M"},
    {"UnknownDottedKey",
     "M_M = ", "\"M.M\" = ", "65:1: article.\"M.M\": is not known here; did you mean M_M?"},
    {"UnknownDottedTable",
     "M_M = ", "M.M = ", "65:1: article.M: is not known here; did you mean M_p?"},
    {"UnknownKeyOfTwoLines",
     "M_M = ", "\"M\\nM\" = ", "65:1: article.\"M\\nM\": is not known here; did you mean M_M?"},
    {"KeyOfAnotherKindOfCrack", "angle = \"45 deg\"", "depth = \"0.1 mm\"",
     "46:1: flexspline.crack[0].depth: is not known here; known names are kind, half_length, "
     "angle, section, distance, position, count, pitch, axial_pitch, "
     "positions, shell_correction, compliance_table, turn_table"},
    {"KindWhereThereIsNone", "[load]\n", "[load]\nkind = \"static\"\n",
     "16:1: load.kind: is not known here; known names are torque, axial_force"},

    // keys that are missing
    {"MissingFormat", "format = \"strainwave-drive/1\"\n", "",
     "1:1: format: must be given (always \"strainwave-drive/1\")"},
    {"MissingNumber", "ratio = 100\n", "",
     "9:1: drive.ratio: must be given (transmission ratio i_h with fixed circular spline)"},
    {"MissingQuantity", "torque = \"100 N*m\"\n", "",
     "15:1: load.torque: must be given (torque T at the output, right-handed about +z; both senses "
     "are computed [N*m])"},
    {"MissingQuantityOfACrack", "half_length = \"0.1 mm\"\n", "",
     "43:1: flexspline.crack[0].half_length: must be given (half of the crack's length, a [m])"},
    {"MissingText", "material = \"steel\"\nouter", "outer",
     "49:1: output_shaft.material: must be given (name of a [material], or of a record of "
     "the library)"},
    {"MissingKind", "kind = \"annular\"\n", "",
     "55:1: output_shaft.crack[0].kind: must be given, one of \"annular\", \"surface\""},
    {"MissingKindOfFive", "kind = \"through\"\n", "",
     "43:1: flexspline.crack[0].kind: must be given, one of \"through\", \"surface\", "
     "\"diaphragm_arc\", \"diaphragm_groove\", \"rim_axial\""},
    {"MissingTable", "[load]\ntorque = \"100 N*m\"\naxial_force = \"0 N\"\n", "",
     "1:1: load: must be given (static load at the output)"},
    {"MissingMaterial",
     "[material.steel]\nyoungs_modulus = \"210 GPa\"\nshear_modulus = \"80 GPa\"\npoissons_ratio = "
     "0.3\n",
     "",
     "16:12: wave_generator.material: \"steel\" is not one of the materials given (), nor in the "
     "material library; strainwave material list shows the names"},
    {"MissingShearModulusAndPoissonsRatio", "shear_modulus = \"80 GPa\"\npoissons_ratio = 0.3\n",
     "", "4:1: material.steel.poissons_ratio: must be given, or shear_modulus"},
    {"MissingRadialStiffness", "radial_stiffness = \"1.2e5 N/mm\"\n", "",
     "19:1: wave_generator.radial_stiffness: must be given (K_G0 of one lobe [N/m]), or "
     "displacements, or bearing"},
    {"MissingRingThickness", "inner_ring_thickness = \"10 mm\"\n", "",
     "19:1: wave_generator.inner_ring_thickness: must be given for wave_generator.crack[0] (inner "
     "ring thickness t_i [m])"},

    // units
    {"BareNumber", "\"160 mm\"", "160",
     "12:18: drive.pitch_diameter: 160 has no unit; write it as text with a unit of m, such as "
     "\"160 mm\""},
    {"BareFloat", "\"2.24 mm\"", "2.24",
     "37:18: flexspline.wall_thickness: 2.24 has no unit; write it as text with a unit of m, such "
     "as \"2.24 mm\""},
    {"BareNaN", "\"2.24 mm\"", "nan",
     "37:18: flexspline.wall_thickness: nan has no unit; write it as text with a unit of m, such "
     "as \"2.24 mm\""},
    {"BareInfinity", "\"2.24 mm\"", "-inf",
     "37:18: flexspline.wall_thickness: -inf has no unit; write it as text with a unit of m, such "
     "as \"2.24 mm\""},
    {"BareNumberInAList", "[\"5 mm\", \"2 mm\"]", "[\"5 mm\", 2]",
     "25:30: wave_generator.contact_semi_axes[1]: 2 has no unit; write it as text with a unit of "
     "m, such as [\"5 mm\", \"2 mm\"]"},
    {"NoUnit", "\"160 mm\"", "\"160\"",
     "12:18: drive.pitch_diameter: \"160\" has no unit; it must be convertible to m"},
    {"WrongDimension", "\"160 mm\"", "\"160 N\"",
     "12:18: drive.pitch_diameter: \"160 N\" is not convertible to m"},
    {"WrongDimensionTorque", "\"100 N*m\"", "\"100 J\"",
     "16:10: load.torque: \"100 J\" is not convertible to N*m"},
    {"WrongDimensionAngle", "\"45 deg\"", "\"0.7\"",
     "46:9: flexspline.crack[0].angle: \"0.7\" has no unit; it must be convertible to rad"},
    {"WrongDimensionInAList", "[\"5 mm\", \"2 mm\"]", "[\"5 mm\", \"2 mm^2\"]",
     "25:30: wave_generator.contact_semi_axes[1]: \"2 mm^2\" is not convertible to m"},
    {"UnknownUnit", "\"160 mm\"", "\"160 inch\"",
     "12:18: drive.pitch_diameter: \"160 inch\" has the unknown unit \"inch\"; write a unit such "
     "as mm, N*m/rad or MPa*m^0.5; strainwave units lists all units"},
    {"UnitOfTwoLines", "\"160 mm\"", "\"160\\nmm\"",
     "12:18: drive.pitch_diameter: \"160\\nmm\" has the unknown unit \"\\nmm\"; write a unit such "
     "as mm, N*m/rad or MPa*m^0.5; strainwave units lists all units"},
    {"DecimalComma", "\"2.24 mm\"", "\"2,24 mm\"",
     "37:18: flexspline.wall_thickness: \"2,24 mm\" has a comma; write a decimal point"},
    {"NaN", "\"2.24 mm\"", "\"nan mm\"",
     "37:18: flexspline.wall_thickness: \"nan mm\" must start with a finite number, such as 2.24 "
     "or 1.2e5"},
    {"Infinity", "\"2.24 mm\"", "\"inf mm\"",
     "37:18: flexspline.wall_thickness: \"inf mm\" must start with a finite number, such as 2.24 "
     "or 1.2e5"},
    {"Overflow", "\"210 GPa\"", "\"1e300 GPa\"",
     "5:18: material.steel.youngs_modulus: \"1e300 GPa\" is too large"},
    {"UnitForAPureNumber", "ratio = 100", "ratio = \"100\"",
     "10:9: drive.ratio: \"100\" is not a bare number, such as 100"},

    // types
    {"WholeNumberAsFloat", "wave_number = 2", "wave_number = 2.0",
     "11:15: drive.wave_number: 2.0 is not a whole number, such as 2"},
    {"WholeNumberAsText", "wave_number = 2", "wave_number = \"2\"",
     "11:15: drive.wave_number: \"2\" is not a whole number, such as 2"},
    {"WholeNumberTooLarge", "wave_number = 2", "wave_number = 4294967298",
     "11:15: drive.wave_number = 4294967298 violates: >= 1 and <= 8"},
    {"NumberAsDate", "ratio = 100", "ratio = 2026-11-21",
     "10:9: drive.ratio: a date or time is not a bare number, such as 100"},
    {"NumberAsFlag", "ratio = 100", "ratio = true",
     "10:9: drive.ratio: true is not a bare number, such as 100"},
    {"QuantityAsFlag", "\"160 mm\"", "true",
     "12:18: drive.pitch_diameter: true is not text with a unit of m, such as \"160 mm\""},
    {"QuantityAsList", "\"160 mm\"", "[\"160 mm\"]",
     "12:18: drive.pitch_diameter: a list is not text with a unit of m, such as \"160 mm\""},
    {"QuantityAsTable", "\"160 mm\"", "{mm = 160}",
     "12:18: drive.pitch_diameter: a table is not text with a unit of m, such as \"160 mm\""},
    {"FlagAsText", "shell_correction = true", "shell_correction = \"true\"",
     "47:20: flexspline.crack[0].shell_correction: \"true\" is not true or false, such as true"},
    {"FlagAsNumber", "shell_correction = true", "shell_correction = 1",
     "47:20: flexspline.crack[0].shell_correction: 1 is not true or false, such as true"},
    {"TextAsNumber", "material = \"steel\"\nouter", "material = 1.7225\nouter",
     "50:12: output_shaft.material: 1.7225 is not text, such as \"steel\""},
    {"TextAsList", "name = \"Article example: double wave, ratio 100, pitch diameter 160 mm\"",
     "name = [\"a\", \"b\"]", "2:8: name: a list is not text, such as \"My drive\""},
    {"ListAsText", "[\"5 mm\", \"2 mm\"]", "\"5 mm\"",
     "25:21: wave_generator.contact_semi_axes: \"5 mm\" is not a list of two, such as [\"5 mm\", "
     "\"2 mm\"]"},
    {"ListOfOne", "[\"5 mm\", \"2 mm\"]", "[\"5 mm\"]",
     "25:21: wave_generator.contact_semi_axes: must have two values, not 1, such as [\"5 mm\", \"2 "
     "mm\"]"},
    {"ListOfThree", "[\"5 mm\", \"2 mm\"]", "[\"5 mm\", \"2 mm\", \"1 mm\"]",
     "25:21: wave_generator.contact_semi_axes: must have two values, not 3, such as [\"5 mm\", \"2 "
     "mm\"]"},
    {"ListOfNone", "[\"5 mm\", \"2 mm\"]", "[]",
     "25:21: wave_generator.contact_semi_axes: must have two values, not 0, such as [\"5 mm\", \"2 "
     "mm\"]"},
    {"TableAsList", "[drive]", "[[drive]]", "9:1: drive: must be a table"},
    {"ListOfTablesAsTable", "[[output_shaft.crack]]", "[output_shaft.crack]",
     "55:1: output_shaft.crack: must be an array of tables, [[output_shaft.crack]]"},
    {"ListOfTablesAsText", "length = \"200 mm\"\n\n[[output_shaft.crack]]",
     "length = \"200 mm\"\ncrack = \"deep\"\n[article.x]",
     "54:9: output_shaft.crack: must be an array of tables, [[output_shaft.crack]]"},
    {"ListOfTablesOfNumbers", "length = \"200 mm\"\n\n[[output_shaft.crack]]",
     "length = \"200 mm\"\ncrack = [1]\n[article.x]",
     "54:10: output_shaft.crack[0]: must be a table"},
    {"MaterialAsText",
     "[material.steel]\nyoungs_modulus = \"210 GPa\"\nshear_modulus = \"80 GPa\"\npoissons_ratio = "
     "0.3",
     "[material]\nsteel = \"C45\"", "5:9: material.steel: must be a table"},
    {"MaterialsAsList", "[material.steel]", "[[material]]",
     "4:1: material: must be a table of tables, [material.NAME]"},
    {"EnumUnknown", "shape = \"cup\"", "shape = \"cap\"",
     "36:9: flexspline.shape: \"cap\" is not one of \"cup\", \"hat\", \"cylinder\""},
    {"EnumCapital", "shape = \"cup\"", "shape = \"Cup\"",
     "36:9: flexspline.shape: \"Cup\" is not one of \"cup\", \"hat\", \"cylinder\""},
    {"EnumAsNumber", "shape = \"cup\"", "shape = 0",
     "36:9: flexspline.shape: 0 is not one of \"cup\", \"hat\", \"cylinder\""},
    {"EnumAsList", "shape = \"cup\"", "shape = [\"cup\"]",
     "36:9: flexspline.shape: a list is not one of \"cup\", \"hat\", \"cylinder\""},
    {"KindOfAnotherMember", "kind = \"annular\"", "kind = \"through\"",
     "56:8: output_shaft.crack[0].kind: \"through\" is not a kind of crack that this member can "
     "have: \"annular\", \"surface\""},
    {"KindUnknown", "kind = \"surface\"", "kind = \"Surface\"",
     "28:8: wave_generator.crack[0].kind: \"Surface\" is not a kind of crack that this member can "
     "have: \"surface\", \"edge\", \"outer_race\""},
    {"KindAsNumber", "kind = \"annular\"", "kind = 1",
     "56:8: output_shaft.crack[0].kind: 1 is not a kind of crack that this member can have: "
     "\"annular\", \"surface\""},
    {"FormatOfAnotherVersion", "strainwave-drive/1", "strainwave-drive/2",
     "1:10: format: \"strainwave-drive/2\" is not known; this version reads "
     "\"strainwave-drive/1\""},
    {"NameOfTwoLines", "Article example", "Article\\nexample",
     "2:8: name: must be one line, without control characters"},

    // ranges
    {"Zero", "\"2.24 mm\"", "\"0 mm\"",
     "37:18: flexspline.wall_thickness = \"0 mm\" violates: > 0"},
    {"Negative", "\"2.24 mm\"", "\"-2.24 mm\"",
     "37:18: flexspline.wall_thickness = \"-2.24 mm\" violates: > 0"},
    {"NegativeBore", "\"45 mm\"", "\"-1 um\"",
     "52:18: output_shaft.inner_diameter = \"-1 um\" violates: >= 0"},
    {"Vanishing", "\"2.24 mm\"", "\"1e-320 um\"",
     "37:18: flexspline.wall_thickness: \"1e-320 um\" is too small"},
    {"PoissonsRatio", "poissons_ratio = 0.3", "poissons_ratio = 0.5",
     "7:18: material.steel.poissons_ratio = 0.5 violates: > -1 and < 0.5"},
    {"PoissonsRatioNaN", "poissons_ratio = 0.3", "poissons_ratio = nan",
     "7:18: material.steel.poissons_ratio = nan violates: a finite number"},
    {"RatioInfinite", "ratio = 100", "ratio = +inf",
     "10:9: drive.ratio = inf violates: a finite number"},
    {"RatioAsHugeInteger", "ratio = 100", "ratio = -9223372036854775807",
     "10:9: drive.ratio = -9223372036854775807 violates: > 0"},
    {"AspectRatio", "aspect_ratio = 0.52147039", "aspect_ratio = 1.0000001",
     "30:16: wave_generator.crack[0].aspect_ratio = 1.0000001 violates: > 0 and <= 1"},
    {"Angle", "\"45 deg\"", "\"-90 deg\"",
     "46:9: flexspline.crack[0].angle = \"-90 deg\" violates: > -90 deg and <= 90 deg"},
    {"SemiAxis", "[\"5 mm\", \"2 mm\"]", "[\"5 mm\", \"0 mm\"]",
     "25:30: wave_generator.contact_semi_axes[1] = \"0 mm\" violates: > 0"},
    {"NoWave", "wave_number = 2", "wave_number = 0",
     "11:15: drive.wave_number = 0 violates: >= 1 and <= 8"},
    {"Override", "M_p = 0.85", "M_p = 0", "64:7: article.M_p = 0 violates: > 0"},

    // rules between fields
    {"NoTorque", "\"100 N*m\"", "\"0 kN*m\"",
     "16:10: load.torque = \"0 kN*m\" violates: torque != 0"},
    {"MaterialNotGiven", "material = \"steel\"\nouter", "material = \"stel\"\nouter",
     "50:12: output_shaft.material: \"stel\" is not one of the materials given (steel), nor in the "
     "material library; did you mean steel?"},
    {"MaterialNearlyOfTheLibrary", "material = \"steel\"\nouter",
     "material = \"17-4PH H90\"\nouter",
     "50:12: output_shaft.material: \"17-4PH H90\" is not one of the materials given (steel), nor "
     "in the material library; did you mean 17-4PH H900?"},
    {"BoreNotInside", "\"45 mm\"", "\"7 cm\"",
     "52:18: output_shaft.inner_diameter = \"7 cm\" violates: inner_diameter < outer_diameter"},
    {"CrackThroughTheWall", "kind = \"annular\"\ndepth = \"0.1 mm\"",
     "kind = \"annular\"\ndepth = \"12.5 mm\"",
     "57:9: output_shaft.crack[0].depth = \"12.5 mm\" violates: depth < (outer_diameter - "
     "inner_diameter)/2, the wall"},
    {"SecondCrackThroughTheWall", "M_M = 0.42\n",
     "[[output_shaft.crack]]\nkind = \"annular\"\ndepth = \"13 mm\"\n",
     "67:9: output_shaft.crack[1].depth = \"13 mm\" violates: depth < (outer_diameter - "
     "inner_diameter)/2, the wall"},
    {"SecondCrackOfAnotherMember", "M_M = 0.42\n",
     "[[output_shaft.crack]]\nkind = \"through\"\ndepth = \"13 mm\"\n",
     "66:8: output_shaft.crack[1].kind: \"through\" is not a kind of crack that this member can "
     "have: \"annular\", \"surface\""},
    {"SecondCrackIncomplete", "M_M = 0.42\n", "[[output_shaft.crack]]\nkind = \"annular\"\n",
     "65:1: output_shaft.crack[1].depth: must be given (crack depth a [m])"},
    {"CrackThroughTheRing", "depth = \"0.1 mm\"\naspect", "depth = \"1 cm\"\naspect",
     "29:9: wave_generator.crack[0].depth = \"1 cm\" violates: depth < inner_ring_thickness"},
    {"WallOfTheRadius", "\"2.24 mm\"", "\"80 mm\"",
     "37:18: flexspline.wall_thickness = \"80 mm\" violates: wall_thickness < "
     "drive.pitch_diameter/2"},
    {"SemiAxesSwapped", "[\"5 mm\", \"2 mm\"]", "[\"2 mm\", \"5 mm\"]",
     "25:30: wave_generator.contact_semi_axes[1] = \"5 mm\" violates: second semi-axis <= first "
     "semi-axis"},
    {"StressDriverNeedsMore", "\"orthogonal_shear\"\ncontact_factor = 0.45", "\"ring_bending\"",
     "19:1: wave_generator.inner_ring_width: must be given for wave_generator.crack[0] "
     "(stress_driver = \"ring_bending\" needs it)"},
    {"SecondSourceOfStiffness", "[[wave_generator.crack]]",
     "[wave_generator.displacements]\nbearing = \"3 um\"\n[[wave_generator.crack]]",
     "27:1: wave_generator.displacements: is a second source of the radial stiffness; give only "
     "one of radial_stiffness, displacements, bearing"},
    {"SectionsNeedABarrel", "crack_free = \"factor\"", "crack_free = \"sections\"",
     "34:1: flexspline.barrel: must be given where crack_free = \"sections\" (smooth tube)"},
};

class GearReaderRefusal : public testing::TestWithParam<Wrong> {};

TEST_P(GearReaderRefusal, InputOneSentenceSaysWhereAndWhat) {
  const std::string message = refusal(with(GetParam().from, GetParam().to));
  const std::string expected = "gear.toml:" + GetParam().message;
  // The parser determines the text behind "is not valid TOML: ".
  if (expected.ends_with(": "))
    EXPECT_EQ(message.substr(0, expected.size()), expected);
  else
    EXPECT_EQ(message, expected);
}

INSTANTIATE_TEST_SUITE_P(Messages, GearReaderRefusal, testing::ValuesIn(kWrong),
                         [](const auto& test) { return test.param.name; });

TEST(GearReader, InputEveryValueIsPlacedAndNamed) {
  // Each value in turn is replaced by a table, which no field here accepts.
  std::istringstream lines{std::string(kArticle)};
  std::size_t start = 0;
  std::size_t number = 0;
  int n = 0;
  for (std::string line; std::getline(lines, line); start += line.size() + 1) {
    ++number;
    const std::size_t equals = line.find(" = ");
    if (equals == std::string::npos) continue;
    ++n;
    const std::size_t at = equals + 3;
    const std::string message =
        refusal(std::string(kArticle).replace(start + at, line.size() - at, "{}"));
    const std::string place =
        "gear.toml:" + std::to_string(number) + ":" + std::to_string(at + 1) + ": ";
    EXPECT_TRUE(message.starts_with(place)) << message << "\nexpected at " << place;
    EXPECT_NE(message.find(line.substr(0, equals) + ": a table is not "), std::string::npos)
        << message;
  }
  EXPECT_EQ(n, 45);
}

TEST(GearReader, InputEveryKeyIsHeldToItsSpelling) {
  std::istringstream lines{std::string(kArticle)};
  std::size_t start = 0;
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line); start += line.size() + 1) {
    ++number;
    const std::size_t equals = line.find(" = ");
    if (equals == std::string::npos) continue;
    const std::string key = line.substr(0, equals);
    const std::string message = refusal(std::string(kArticle).insert(start, key + "Q = 1\n"));
    EXPECT_TRUE(message.starts_with("gear.toml:" + std::to_string(number) + ":1: ")) << message;
    EXPECT_TRUE(message.ends_with("is not known here; did you mean " + key + "?")) << message;
  }
}

TEST(GearReader, InputTheFieldOfTheErrorIsThePath) {
  try {
    (void)read_gear_set(with("\"2.24 mm\"", "\"-2.24 mm\""), "gear.toml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.field(), "flexspline.wall_thickness");
    EXPECT_EQ(error.rule(), "> 0");
  }
}

// --- Files ---------------------------------------------------------------------------------------

/// A file that is removed again.
class TemporaryFile {
 public:
  explicit TemporaryFile(std::string_view text)
      : path_(std::filesystem::temp_directory_path() /
              ("strainwave_gear_reader_test_" + std::to_string(std::random_device{}()) + ".toml")) {
    std::ofstream(path_, std::ios::binary) << text;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::string file_refusal(const std::filesystem::path& path) {
  try {
    (void)read_gear_set_file(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(GearReaderFile, IdentityAFileIsReadAsItsText) {
  const TemporaryFile file(kArticle);
  EXPECT_EQ(dump(read_gear_set_file(file.path())), dump(read_gear_set(kArticle, "")));
}

TEST(GearReaderFile, InputFilesThatCannotBeRead) {
  EXPECT_EQ(file_refusal("no/such/gear.toml"), "no/such/gear.toml: cannot be opened for reading");
  EXPECT_EQ(file_refusal(STRAINWAVE_TEST_DATA), STRAINWAVE_TEST_DATA ": is a directory");
  EXPECT_EQ(file_refusal(std::string(300, 'x')),
            std::string(300, 'x') + ": cannot be opened for reading");
  EXPECT_EQ(file_refusal("two\nlines"), "two\\nlines: cannot be opened for reading");
}

TEST(GearReaderFile, InputEmptyFileSaysWhatMustBeGiven) {
  const TemporaryFile file("");
  EXPECT_EQ(file_refusal(file.path()),
            file.path().string() + ":1:1: format: must be given (always \"strainwave-drive/1\")");
}

TEST(GearReaderFile, LimitOneMebibyteIsReadAndNoMore) {
  std::string text(kArticle);
  text.resize(1U << 20U, '\n');
  EXPECT_EQ(refusal(text), "accepted");
  EXPECT_EQ(file_refusal(TemporaryFile(text).path()), "accepted");
  text += '\n';
  const std::string problem = ": is larger than 1 MiB; a drive takes a few kilobytes";
  EXPECT_EQ(refusal(text), "gear.toml" + problem);
  const TemporaryFile file(text);
  EXPECT_EQ(file_refusal(file.path()), file.path().string() + problem);
}

TEST(GearReaderFile, LimitAFileWithoutEndIsRefused) {
  EXPECT_EQ(file_refusal("/dev/zero"),
            "/dev/zero: is larger than 1 MiB; a drive takes a few kilobytes");
}

// --- Hostile texts -------------------------------------------------------------------------------

std::string repeated(std::string_view piece, std::size_t n) {
  std::string text;
  for (std::size_t i = 0; i < n; ++i) text += piece;
  return text;
}

/// Checks that a refusal is one line of moderate length and names a place in the file.
void expect_one_sentence(const std::string& message) {
  EXPECT_LT(message.size(), 1000U);
  EXPECT_TRUE(message.starts_with("gear.toml:")) << message;
  EXPECT_TRUE(std::ranges::none_of(message, [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
  })) << message;
}

constexpr std::size_t kMany = 100'000;

TEST(GearReaderHostile, InputBytesThatAreNoText) {
  using std::string_literals::operator""s;
  std::string noise;
  for (int i = 0; i < 5000; ++i) noise += static_cast<char>((i * 7919 + 13) % 256);
  for (const std::string& text :
       {"\0"s, with("100 N*m", "100\0 N*m"s), "name = \"\xFF\xFE\""s, "name = \"\xC3\""s,
        "name = \"\xED\xA0\x80\""s /* half a surrogate pair */, "\xC3\x28 = 1"s,
        "\xFF\xFE"
        "f\0o\0"s /* UTF-16 */,
        with("100 N*m", "100 \xF0\x9F\x98\x80"), noise,
        "\x7F"
        "ELF\x02\x01\x01"s,
        "s=tru\x01"s, "\r"s, "\x1A"s}) {
    const std::string message = refusal(text);
    EXPECT_NE(message, "accepted") << text;
    expect_one_sentence(message);
  }
}

TEST(GearReaderHostile, InputNestingWithoutEnd) {
  for (const std::string& text :
       {repeated("[", kMany), "name = " + repeated("[", kMany),
        "name = " + repeated("[", kMany) + repeated("]", kMany), "name = " + repeated("[\n", kMany),
        "name = " + repeated("{a=", kMany) + "1" + repeated("}", kMany),
        "a" + repeated(".a", kMany) + " = 1", "[a" + repeated(".a", kMany) + "]",
        "[[a" + repeated(".a", kMany) + "]]", "\"\"" + repeated(".\"=\"", kMany) + " = 1",
        "  a" + repeated(" . a", kMany) + " = 1",
        "a" + repeated(".a", 90) + " = " + repeated("[{a" + repeated(".a", 90) + " = \n", 8),
        // nested as deep as allowed, so it is refused for its key
        "a" + repeated(".a", 90) + " = " + repeated("[\n{a" + repeated(".a", 90) + " = ", 7) + "1" +
            repeated("}\n]", 7)}) {
    const std::string message = refusal(text);
    EXPECT_NE(message, "accepted") << text.substr(0, 100);
    expect_one_sentence(message);
  }
}

TEST(GearReaderHostile, InputBrokenSyntax) {
  for (const std::string text : {"[&",
                                 "[[[1]]]",
                                 "[[=",
                                 "[.]",
                                 "[]",
                                 "[[]]",
                                 "[a",
                                 "[[a]",
                                 "[a]]",
                                 ".",
                                 "=",
                                 "a",
                                 "a.",
                                 "a.=1",
                                 "a..b = 1",
                                 "\"\"\"a\"\"\" = 1",
                                 "a = \"",
                                 "a = '''",
                                 "a = \"\"\"",
                                 "a = \"\\u12\"",
                                 "a = \"\\UFFFFFFFF\"",
                                 "a = \"\\uD800\"",
                                 "a = \"\\q\"",
                                 "a = 1 b = 2",
                                 "a = {",
                                 "a = {b=1",
                                 "a = {b=1,}",
                                 "a = {b=1\n}",
                                 "a = [1",
                                 "a = [1,,2]",
                                 "a = [1 2]",
                                 "a = 1.",
                                 "a = .1",
                                 "a = 1e",
                                 "a = 1__0",
                                 "a = _1",
                                 "a = 01",
                                 "a = 0x",
                                 "a = -0x1",
                                 "a = 0b2",
                                 "a = +-1",
                                 "a = tru",
                                 "a = True",
                                 "a = nul",
                                 "a = nan.0",
                                 "a = infinity",
                                 "a = 2026-13-41",
                                 "a = 25:61:61",
                                 "a = 2026-11-21T",
                                 "a = 1e999",
                                 "a = -1e999",
                                 "45\u00B0 = 1",
                                 "a = 45\u00B0"}) {
    const std::string message = refusal(text);
    EXPECT_NE(message.find(": is not valid TOML: "), std::string::npos) << text << "\n" << message;
    expect_one_sentence(message);
  }
}

TEST(GearReaderHostile, InputNumbersWithoutEnd) {
  for (const std::string& text :
       {with("ratio = 100", "ratio = " + std::string(kMany, '1')),
        with("ratio = 100", "ratio = 1." + std::string(kMany, '0')),
        with("ratio = 100", "ratio = 1e999999999"), with("ratio = 100", "ratio = 1e-999999999"),
        with("100 N*m", "1e999999999 N*m"), with("100 N*m", "1e-999999999 N*m"),
        with("100 N*m", "1" + std::string(kMany, '0') + " N*m"),
        with("100 N*m", "100 " + repeated("N*", kMany) + "m"),
        with("100 N*m", "100 " + std::string(kMany, '(') + "N*m" + std::string(kMany, ')')),
        with("100 N*m", "100 N^1" + std::string(kMany, '0') + "*m"),
        with("100 N*m", "1e-300 " + repeated("nm*", kMany) + "N")}) {
    const std::string message = refusal(text);
    EXPECT_NE(message, "accepted") << text.substr(0, 300);
    expect_one_sentence(message);
  }
}

TEST(GearReaderHostile, InputNamesWithoutEndAndWithoutLetters) {
  for (const std::string& text :
       {std::string(kMany, 'a') + " = 1\n" + std::string(kArticle),
        "\"" + repeated("\\n", kMany) + "\" = 1\n" + std::string(kArticle),
        "\"" + repeated("\\u001B[31m", kMany / 10) + "\" = 1\n" + std::string(kArticle),
        with("material = \"steel\"", "material = \"" + std::string(kMany, 'a') + "\""),
        with("material = \"steel\"", "material = \"\\u001b[31m\\n\""),
        with("[material.steel]", "[material." + std::string(kMany, 'a') + "]"),
        with("\"cup\"", "\"" + std::string(kMany, 'c') + "\""),
        with("kind = \"annular\"", "kind = \"" + std::string(kMany, 'c') + "\""),
        with("strainwave-drive/1", std::string(kMany, 'f')), with("M_M = ", "'\"' = "),
        with("M_M = ", "'a b' = "), with("M_M = ", "__proto__ = "), with("M_M = ", "\"M_M \" = "),
        with("M_M = ", "\"\\u0000\" = ")}) {
    const std::string message = refusal(text);
    EXPECT_NE(message, "accepted") << text.substr(0, 100);
    expect_one_sentence(message);
  }
}

TEST(GearReaderHostile, LimitAMebibyteOfTablesIsReadInAMoment) {
  std::string cracks(kArticle);
  while (cracks.size() < (1U << 20U) - 100)
    cracks += "[[output_shaft.crack]]\nkind = \"annular\"\ndepth = \"1 mm\"\n";
  EXPECT_EQ(refusal(cracks), "accepted");
  std::string materials(kArticle);
  for (int i = 0; materials.size() < (1U << 20U) - 100; ++i)
    materials +=
        "[material.m" + std::to_string(i) + "]\nyoungs_modulus = \"1 GPa\"\npoissons_ratio = 0.0\n";
  EXPECT_EQ(refusal(materials), "accepted");
  expect_one_sentence(refusal(with("material = \"steel\"", "material = \"none\"", materials)));
}

TEST(GearReaderHostile, InputMutationsAreReadOrRefusedInOneSentence) {
  const std::vector<std::string_view> pieces = {"[",
                                                "]",
                                                "[[",
                                                "]]",
                                                "{",
                                                "}",
                                                "=",
                                                ".",
                                                ",",
                                                "\"",
                                                "'",
                                                "\"\"\"",
                                                "'''",
                                                "\\",
                                                "#",
                                                "\n",
                                                "\r\n",
                                                " ",
                                                "\t",
                                                "-",
                                                "+",
                                                "e",
                                                "_",
                                                "0x",
                                                "1e999",
                                                "nan",
                                                "inf",
                                                "true",
                                                "1979-05-27",
                                                "07:32:00",
                                                "\xC2\xB5",
                                                "\xC2\xB0",
                                                "\xFF",
                                                "\\u0000",
                                                "kind",
                                                "crack",
                                                "steel",
                                                "[drive]",
                                                "\"0 mm\"",
                                                "\"-1 mm\"",
                                                "\"1e308 GPa\"",
                                                "[[flexspline.crack]]"};
  std::mt19937 random(20261121);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
  int accepted = 0;
  for (int round = 0; round < 4000; ++round) {
    std::string text(kArticle);
    for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
      const std::size_t at = below(text.size());
      switch (below(5)) {
        case 0:
          text[at] = static_cast<char>(below(256));
          break;
        case 1:
          text.erase(at, 1 + below(20));
          break;
        case 2:
          text.insert(at, pieces[below(pieces.size())]);
          break;
        case 3:
          text.insert(at, text.substr(below(text.size()), 1 + below(60)));
          break;
        default:
          text.resize(at + 1);
      }
    }
    const std::string message = refusal(text);
    if (message == "accepted")
      ++accepted;
    else
      expect_one_sentence(message);
    ASSERT_FALSE(testing::Test::HasFailure()) << text;
  }
  // Some mutations must be accepted and some refused; otherwise the test is not effective.
  EXPECT_GT(accepted, 50);
  EXPECT_LT(accepted, 2000);
}

}  // namespace
}  // namespace strainwave
