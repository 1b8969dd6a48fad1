// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/gear_writer.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <locale>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "strainwave/io/edit.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/io/input_format.hpp"

namespace strainwave {
namespace {

/// Every number with its path, to the last bit.
std::vector<std::pair<std::string, double>> numbers(const GearSet& gear) {
  std::vector<std::pair<std::string, double>> all;
  for_each_number(gear, [&](const FieldPath& path, const Field&, const double& value) {
    all.emplace_back(path.text(), value);
  });
  return all;
}

TEST(GearWriter, IdentityReadsBackEveryExample) {
  int n = 0;
  for (const auto& file : std::filesystem::directory_iterator(STRAINWAVE_EXAMPLES)) {
    if (file.path().extension() != ".toml") continue;
    ++n;
    const GearSet gear = read_gear_set_file(file.path());
    const std::string text = gear_text(gear);
    const GearSet again = read_gear_set(text, "written", attachments_beside(file.path()));
    EXPECT_EQ(numbers(again), numbers(gear)) << file.path();
    EXPECT_EQ(gear_text(again), text) << file.path();
    EXPECT_EQ(again.name, gear.name);
    EXPECT_EQ(again.range.size(), gear.range.size());
    ASSERT_EQ(again.scatter.size(), gear.scatter.size());
    for (std::size_t i = 0; i < gear.scatter.size(); ++i) {
      EXPECT_EQ(again.scatter[i].path, gear.scatter[i].path);
      EXPECT_EQ(again.scatter[i].distribution, gear.scatter[i].distribution);
    }
  }
  EXPECT_GE(n, 4);
}

/// As in Germany: 1.234,5.
struct DecimalComma : std::numpunct<char> {
  [[nodiscard]] char do_decimal_point() const override { return ','; }
  [[nodiscard]] char do_thousands_sep() const override { return '.'; }
  [[nodiscard]] std::string do_grouping() const override { return "\3"; }
};

TEST(GearWriter, IdentityInALocaleWithDecimalCommas) {
  std::ifstream stream(STRAINWAVE_EXAMPLES "/article.toml");
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  const auto written = [&] {
    return gear_text(read_gear_set(text, "article.toml")) + input_schema() + input_reference();
  };
  const std::string before = written();
  const std::locale old = std::locale::global(std::locale(std::locale(), new DecimalComma));
  const std::string with_commas = written();
  std::locale::global(old);
  EXPECT_EQ(with_commas, before);
}

TEST(GearWriter, IdentityValuesThatAreHardToWrite) {
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/article.toml");
  for (const double value :
       {1.0 / 3, 1e-9, 0.1, 3.0000000000000004e-3, 12345.678, 5e-324 * 1e300}) {
    GearSet changed = gear;
    changed.drive.pitch_diameter = 4 + value;
    changed.drive.radial_displacement = changed.drive.pitch_diameter / 200;
    changed.output_shaft->length = value;
    const GearSet again = read_gear_set(gear_text(changed), "written");
    EXPECT_EQ(numbers(again), numbers(changed)) << value;
  }
}

TEST(GearWriter, BehaviourAMaterialOfTheLibraryIsWrittenOut) {
  // The file is complete, independently of the library of later versions.
  const GearSet gear =
      read_gear_set_file(std::filesystem::path(STRAINWAVE_EXAMPLES) / "library_material.toml");
  const std::string text = gear_text(gear);
  EXPECT_NE(text.find("[material.\"17-4PH H900\"]\nyoungs_modulus = \"196 GPa\"\n"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find("taken from"), std::string::npos);
  const GearSet again = read_gear_set(text, "again.toml");
  EXPECT_EQ(again.material.at("17-4PH H900").origin, "");
  EXPECT_EQ(gear_text(again), text);
}

TEST(GearWriter, BehaviourAMaterialBasedOnTheLibraryKeepsItsOwnNumbers) {
  const std::string own =
      "[material.steel]\nbased_on = \"40CrNiMoA QT\"\nfracture_toughness = \"90 MPa*m^0.5\"\n";
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/solid_shaft.toml");
  gear.material.clear();
  std::string text = gear_text(gear);
  const std::size_t at = text.find("\n[drive]");
  text.insert(at + 1, own + "\n");
  const std::size_t named = text.find("material = \"");
  text.replace(named, text.find('\n', named) - named, "material = \"steel\"");
  const GearSet first = read_gear_set(text, "first.toml");
  const std::string written = gear_text(first);
  EXPECT_NE(written.find(own + "\n"), std::string::npos) << written;
  const GearSet again = read_gear_set(written, "again.toml");
  EXPECT_EQ(numbers(again), numbers(first));
  EXPECT_EQ(again.material.at("steel").origin, first.material.at("steel").origin);
}

TEST(GearWriter, IdentityOfATableOfRates) {
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/growing_shaft.toml");
  const Tabulated table{
      .curve = {{.stress_ratio = -1, .delta_K = {5e6, 1e7}, .rate = {1e-10, 2e-9}},
                {.stress_ratio = 0.1,
                 .delta_K = {3e6, 7.1e6, 4e7},
                 .rate = {1.0 / 3 * 1e-10, 3e-9, 1e-6}}}};
  gear.material.at("steel").growth = {table};
  gear.duty->block[0].temperature = 393.15;
  const std::string text = gear_text(gear);
  EXPECT_NE(text.find(R"(delta_K = ["5 MPa*m^0.5", "10 MPa*m^0.5"])"), std::string::npos) << text;
  EXPECT_NE(text.find(R"(temperature = "393.15 K")"), std::string::npos) << text;
  const GearSet again = read_gear_set(text, "again.toml");
  EXPECT_EQ(numbers(again), numbers(gear));
  EXPECT_EQ(gear_text(again), text);
  // One number of a list is edited in its place.
  const std::string edited = edit(text, "material.steel.growth[0].curve[1].rate[1]", "\"4e-9 m\"");
  EXPECT_EQ(std::get<Tabulated>(read_gear_set(edited, "edited.toml").material.at("steel").growth[0])
                .curve[1]
                .rate[1],
            4e-9);
}

TEST(GearWriter, BehaviourTextsAndMaterialNames) {
  GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/solid_shaft.toml");
  gear.name = R"(a "name" with \ and ü)";
  const std::string odd = "steel 4.3 \"hard\"";
  auto node = gear.material.extract(gear.material.begin());
  node.key() = odd;
  gear.material.insert(std::move(node));
  gear.output_shaft->material = odd;
  const GearSet again = read_gear_set(gear_text(gear), "written");
  EXPECT_EQ(again.name, gear.name);
  EXPECT_TRUE(again.material.contains(odd));
}

TEST(GearWriter, BehaviourUnitsAndComments) {
  const GearSet gear = read_gear_set_file(STRAINWAVE_EXAMPLES "/article.toml");
  const std::string long_comment(60, 'x');
  const std::string text =
      gear_text(gear, {{"drive.ratio", "short"},
                       {"drive.wave_number", "a default that has a comment is written"},
                       {"drive.pitch_diameter", long_comment + " " + long_comment}});
  EXPECT_NE(text.find("pitch_diameter = \"160 mm\"\n"), std::string::npos) << text;
  EXPECT_NE(text.find("ratio = 100                           # short\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("wave_number = 2  "), std::string::npos) << text;
  EXPECT_NE(text.find("# " + long_comment + "\n# " + long_comment + "\npitch_diameter"),
            std::string::npos)
      << text;
  EXPECT_EQ(gear_text(gear).find("wave_number"), std::string::npos);  // its default
}

// Kind: identity.  Only the lines of the numbers that differ change, and the text reads back as the
// other drive to the last bit.
TEST(GearWriter, IdentityOtherNumbersKeepTheRestOfTheText) {
  std::ifstream file(STRAINWAVE_EXAMPLES "/library_material.toml");
  const std::string given{std::istreambuf_iterator<char>(file), {}};
  const GearSet from = read_gear_set(given, "given.toml");
  EXPECT_EQ(with_numbers_of(given, from, from), given);
  GearSet to = from;
  to.wave_generator->inner_ring_thickness = 1.0 / 700;  // has a line
  to.flexspline->stress_nonuniformity = 1.25;           // a default without a line
  const std::string text = with_numbers_of(given, from, to);
  EXPECT_EQ(numbers(read_gear_set(text, "text.toml")), numbers(to));
  std::istringstream lines(given);
  std::size_t n_lost = 0;
  for (std::string line; std::getline(lines, line);)
    n_lost += text.find(line + '\n') == std::string::npos ? 1U : 0U;
  EXPECT_EQ(n_lost, 1U) << text;
}

// A range or a scatter that the other drive lacks is removed, wherever it stands in its list.
TEST(GearWriter, BehaviourOtherNumbersDropLostRangesAndScatters) {
  std::ifstream file(STRAINWAVE_EXAMPLES "/article_scatter.toml");
  const std::string given{std::istreambuf_iterator<char>(file), {}};
  const GearSet from = read_gear_set(given, "given.toml");
  ASSERT_GE(from.scatter.size(), 3U);
  GearSet to = from;
  set_number(to, from.scatter[1].path, 1.01 * number_at(from, from.scatter[1].path).value);
  ASSERT_EQ(to.scatter.size() + 1, from.scatter.size());
  const GearSet read = read_gear_set(with_numbers_of(given, from, to), "text.toml");
  EXPECT_EQ(numbers(read), numbers(to));
  ASSERT_EQ(read.scatter.size(), to.scatter.size());
  for (std::size_t i = 0; i < to.scatter.size(); ++i)
    EXPECT_EQ(read.scatter[i].path, to.scatter[i].path);
}

}  // namespace
}  // namespace strainwave
