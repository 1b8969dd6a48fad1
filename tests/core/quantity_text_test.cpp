// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/quantity_text.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "support/reference.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// The message that refuses a quantity; "accepted" if none does.
std::string refusal(std::string_view text, std::string_view unit) {
  try {
    (void)parse_quantity("field", text, unit);
  } catch (const InputError& error) {
    EXPECT_EQ(error.field(), "field") << text;
    EXPECT_EQ(error.rule(), "") << text;
    return error.what();
  }
  return "accepted";
}

std::string unit_refusal(std::string_view text) {
  try {
    (void)parse_unit(text);
  } catch (const InputError& error) {
    EXPECT_EQ(error.field(), "unit");
    return error.what();
  }
  return "accepted";
}

// --- Units ---------------------------------------------------------------------------------------

struct NamedUnit {
  std::string_view symbol;
  double factor;
  std::string_view base;  ///< the same dimension in base units
};

TEST(QuantityText, ReferenceFactorsOfUnits) {
  constexpr test::Reference kReference{
      .value = 1.0,
      .unit = "1",
      .relative_tolerance = 1e-15,
      .source = "BIPM, The International System of Units, 9th edition, tables 2, 4, 7 and 8",
      .tolerance_is = "rounding of a few operations; the factors are exact by definition"};
  for (const auto& [symbol, factor, base] : std::vector<NamedUnit>{
           {"1", 1, "1"},
           {"%", 0.01, "1"},
           {"m", 1, "m"},
           {"g", 1e-3, "kg"},
           {"s", 1, "s"},
           {"min", 60, "s"},
           {"h", 3600, "s"},
           {"K", 1, "K"},
           {"rad", 1, "rad"},
           {"deg", pi / 180, "rad"},
           {"arcmin", pi / 10800, "rad"},
           {"arcsec", pi / 648000, "rad"},
           {"Hz", 1, "1/s"},
           {"rpm", pi / 30, "rad/s"},
           {"N", 1, "kg*m/s^2"},
           {"Nm", 1, "N*m"},
           {"Pa", 1, "N/m^2"},
           {"J", 1, "J"},
           {"W", 1, "J/s"},
           {"\u00B0", pi / 180, "rad"},
           {"\u2032", pi / 10800, "rad"},
           {"\u2033", pi / 648000, "rad"},
       }) {
    EXPECT_NEAR(parse_quantity("x", "1 " + std::string(symbol), base) / factor, kReference.value,
                kReference.relative_tolerance)
        << symbol;
  }
}

TEST(QuantityText, ReferenceFactorsOfInchAndPound) {
  constexpr test::Reference kReference{
      .value = 1.0,
      .unit = "1",
      .relative_tolerance = 1e-9,
      .source =
          "NIST Special Publication 811 (2008), appendix B.8, factors for units listed "
          "alphabetically; seven digits and the exact definitions of inch, foot and pound",
      .tolerance_is = "digits of lbf that SP 811 prints, 4.448 221 615 260 5, and of products"};
  for (const auto& [symbol, factor, base] : std::vector<NamedUnit>{
           {"in", 0.0254, "m"},
           {"ft", 0.3048, "m"},
           {"lbf", 4.4482216152605, "N"},
           {"psi", 6894.757293168361, "Pa"},
           {"ksi", 6894757.293168361, "Pa"},
           {"lbf*in", 0.1129848290276167, "N*m"},
           {"lbf*ft", 1.3558179483314004, "N*m"},
           {"lbf/in", 175.12683524647636, "N/m"},
           {"lbf*in/arcmin", 0.1129848290276167 * 10800 / pi, "N*m/rad"},
           {"ksi*in^0.5", 1098843.4941087547, "Pa*m^0.5"},
       })
    EXPECT_NEAR(parse_quantity("x", "1 " + std::string(symbol), base) / factor, kReference.value,
                kReference.relative_tolerance)
        << symbol;
}

TEST(QuantityText, BehaviourReadsWhatAReportPrints) {
  EXPECT_EQ(parse_quantity("x", "25 N\u00B7m", "N*m"), 25);
  EXPECT_DOUBLE_EQ(parse_quantity("x", "21.87 N\u00B7m/arcmin", "N*m/rad"), 21.87 * 10800 / pi);
  EXPECT_EQ(parse_quantity("x", "60 MPa\u00B7\u221Am", "Pa*m^0.5"), 60e6);
  EXPECT_EQ(parse_quantity("x", "45\u00B0", "rad"), pi / 4);
  EXPECT_EQ(parse_quantity("x", "2.41\u2032", "rad"), parse_quantity("x", "2.41 arcmin", "rad"));
  EXPECT_EQ(parse_quantity("x", "\u22123.5 mm", "m"), -3.5e-3);
  EXPECT_EQ(parse_quantity("x", "1.03\u00B710\u207B\u2076 rad/(N\u00B7m)", "rad/(N*m)"), 1.03e-6);
  EXPECT_EQ(parse_quantity("x", "7.518\u00D710\u2074 N\u00B7m/rad", "N*m/rad"), 75180);
  EXPECT_EQ(parse_quantity("x", "3\u202Fmm\u00B2", "m^2"), 3e-6);
  EXPECT_EQ(refusal("3\u00B710\u207B mm", "m"),
            "field: \"3\u00B710\u207B mm\" needs a whole number after 10^");
}

TEST(QuantityText, BehaviourReadsUnitsAsPeopleWriteThem) {
  for (const char* const text :
       {"18 MPa\u221Am", "18 MPa \u221Am", "18MPa\u221Am", "18 MPa*\u221Am"})
    EXPECT_EQ(parse_quantity("x", text, "Pa*m^0.5"), 18e6) << text;
  EXPECT_EQ(parse_quantity("x", "3 \u221Am", "m^0.5"), 3);
  EXPECT_EQ(parse_quantity("x", "18 N/mm*\u221Am/m", "Pa*m^0.5"), 18e3);
  for (const char* const text : {"120 Nmm", "120 N*mm", "120 N\u00B7mm"})
    EXPECT_EQ(parse_quantity("x", text, "N*m"), 0.12) << text;
  EXPECT_EQ(refusal("120 N.mm", "N*m"),
            "field: \"120 N.mm\" needs * between units; write N*mm in place of N.mm");
  EXPECT_EQ(refusal("120 N mm", "N*m"),
            "field: \"120 N mm\" needs * between units; write N*mm in place of N mm");
  EXPECT_EQ(refusal("18 MPa*sqrt(m)", "Pa*m^0.5"),
            "field: \"18 MPa*sqrt(m)\" needs ^0.5 for a root, such as MPa*m^0.5");
  EXPECT_EQ(refusal("9 lbf-in/deg", "N*m/rad"),
            "field: \"9 lbf-in/deg\" needs * between units; write lbf*in in place of lbf-in");
}

TEST(QuantityText, RegressionADecimalPointIsMovedWithoutRounding) {
  // 0.4 * 1e-3 is 0.00039999999999999996 or 0.0004, as the multiplication rounds.
  for (int i = 1; i < 2000; ++i) {
    const std::string digits = std::to_string(i);
    const double metres = std::stod(digits + "e-4");
    ASSERT_EQ(parse_quantity("x", digits + "e-1 mm", "m"), metres);
    ASSERT_EQ(parse_quantity("x", digits + "e-7 km", "m"), metres);
    ASSERT_EQ(parse_quantity("x", digits + "e-2 %", "1"), metres);
  }
  EXPECT_EQ(parse_quantity("x", "0.3 MPa*m^0.5", "Pa*m^0.5"), 3e5);
  EXPECT_EQ(parse_quantity("x", "0.7 N/mm", "N/m"), 700);
}

TEST(QuantityText, BehaviourANumberInAUnitIsShort) {
  EXPECT_EQ(number_in(0.0004, parse_unit("mm")), "0.4");
  EXPECT_EQ(number_in(units::arcmin, parse_unit("arcmin")), "1");
  EXPECT_EQ(number_in(parse_quantity("K", "47 N*m/arcmin", "N*m/rad"), parse_unit("N*m/arcmin")),
            "47");
  EXPECT_EQ(number_in(0.0254, parse_unit("in")), "1");
  EXPECT_EQ(number_in(-0.01, parse_unit("%")), "-1");
  EXPECT_EQ(number_in(0.0, parse_unit("mm")), "0");
  // No double near 10.2 gives this one when it is divided by 1000.
  EXPECT_EQ(number_in(0.010199999999999999, parse_unit("mm")), "10.199999999999999");
  EXPECT_EQ(number_in(1.0199999999999999e-20, parse_unit("mm")), "1.0199999999999999e-17");
}

TEST(QuantityText, IdentityANumberInAUnitReadsBackBitForBit) {
  std::mt19937_64 random(20261122);
  std::uniform_real_distribution<double> exponent(-12.0, 12.0);
  for (const char* const unit : {"mm", "um", "GPa", "%", "MPa*m^0.5", "rad/(N*mm)"}) {
    const Unit to = parse_unit(unit);
    for (int i = 0; i < 2000; ++i) {
      const double value = std::pow(10.0, exponent(random));
      std::string si = "m";
      for (const char* const base : {"m", "Pa", "1", "Pa*m^0.5", "rad/(N*m)"})
        if (same_dimension(to, parse_unit(base))) si = base;
      ASSERT_EQ(parse_quantity("x", number_in(value, to) + " " + unit, si), value) << unit;
    }
  }
}

TEST(QuantityText, ReferencePrefixes) {
  constexpr test::Reference kReference{.value = 1.0,
                                       .unit = "1",
                                       .relative_tolerance = 1e-15,
                                       .source = "BIPM, SI brochure, 9th edition, table 7",
                                       .tolerance_is = "rounding of one product"};
  for (const auto& [prefix, factor] :
       std::vector<std::pair<std::string, double>>{{"n", 1e-9},
                                                   {"u", 1e-6},
                                                   {"\u00B5", 1e-6},  // micro sign
                                                   {"\u03BC", 1e-6},  // Greek letter mu
                                                   {"m", 1e-3},
                                                   {"c", 1e-2},
                                                   {"k", 1e3},
                                                   {"M", 1e6},
                                                   {"G", 1e9}})
    for (const std::string base : {"m", "g", "s", "K", "rad", "Hz", "N", "Nm", "Pa", "J", "W"})
      EXPECT_NEAR(parse_unit(prefix + base).factor / parse_unit(base).factor / factor,
                  kReference.value, kReference.relative_tolerance)
          << prefix << base;
}

TEST(QuantityText, IdentityFactorsOfHeaderAndTextAgree) {
  for (const auto& [symbol, factor] :
       std::vector<std::pair<std::string_view, double>>{{"m", units::m},
                                                        {"mm", units::mm},
                                                        {"N", units::N},
                                                        {"MPa", units::MPa},
                                                        {"GPa", units::GPa},
                                                        {"rad", units::rad},
                                                        {"deg", units::deg},
                                                        {"arcmin", units::arcmin},
                                                        {"arcsec", units::arcsec},
                                                        {"rpm", units::rpm}})
    EXPECT_DOUBLE_EQ(parse_unit(symbol).factor, factor) << symbol;
}

TEST(QuantityText, BehaviourDifferentSpellingsOfOneUnit) {
  for (const auto& [one, other] : std::vector<std::pair<std::string_view, std::string_view>>{
           {"N*m/rad", "Nm/rad"},
           {"N*m/rad", "N/rad*m"},
           {"rad/(N*m)", "rad/N/m"},
           {"rad/(N*m)", "1/(N*m/rad)"},
           {"rad/(N*m)", "1/((N*m)/rad)"},
           {"rad/(N*m)", "(N*m/rad)^-1"},
           {"MPa*m^0.5", "MPa*m/m^0.5"},
           {"Pa*m^0.5", "N*m^-1.5"},
           {"Pa", "N/m^2"},
           {"kN/mm", "N/um"},
           {"mm^2", "(mm)^2"},
           {"mm^2", "mm*mm"},
           {"J", "W*s"},
           {"1", "m/m"},
           {"1", "m^0"},
           {"N*mm", "mNm"},
           {"m", "((((((((m))))))))"},
       }) {
    const Unit a = parse_unit(one);
    const Unit b = parse_unit(other);
    EXPECT_NEAR(a.factor / b.factor, 1, 1e-14) << one << " and " << other;
    for (std::size_t i = 0; i < a.dimension.size(); ++i)
      EXPECT_NEAR(a.dimension[i], b.dimension[i], 1e-12) << one << " and " << other;
  }
}

TEST(QuantityText, InputAWordThatIsPrefixAndUnitIsReadAsTheUnit) {
  EXPECT_EQ(parse_unit("min").factor, 60);        // minute, not milli-inch
  EXPECT_EQ(parse_unit("m").factor, 1);           // metre, not a bare prefix
  EXPECT_EQ(parse_unit("Nm").factor, 1);          // newton metre
  EXPECT_EQ(parse_unit("nm").factor, 1e-9);       // nanometre
  EXPECT_EQ(parse_unit("mNm").factor, 1e-3);      // millinewton metre
  EXPECT_EQ(parse_unit("MNm").factor, 1e6);       // meganewton metre
  EXPECT_EQ(parse_unit("mm").factor, 1e-3);       // millimetre, not metre squared
  EXPECT_EQ(parse_unit("ms").dimension[2], 1);    // millisecond, not metre second
  EXPECT_EQ(parse_unit("mrad").dimension[4], 1);  // milliradian, not metre radian
}

// --- Quantities that are read --------------------------------------------------------------------

TEST(QuantityText, BehaviourReadsToStrainwaveUnits) {
  EXPECT_DOUBLE_EQ(parse_quantity("t", "0.8 mm", "m"), 0.8e-3);
  EXPECT_DOUBLE_EQ(parse_quantity("t", "0.8mm", "m"), 0.8e-3);
  EXPECT_DOUBLE_EQ(parse_quantity("t", "  0.8   mm  ", "m"), 0.8e-3);
  EXPECT_DOUBLE_EQ(parse_quantity("t", "3 \u00B5m", "m"), 3e-6);
  EXPECT_DOUBLE_EQ(parse_quantity("t", "3 \u03BCm", "m"), 3e-6);
  EXPECT_DOUBLE_EQ(parse_quantity("K_G0", "1.2e5 N/mm", "N/m"), 1.2e8);
  EXPECT_DOUBLE_EQ(parse_quantity("k", "12 kN*m/rad", "N*m/rad"), 12e3);
  EXPECT_DOUBLE_EQ(parse_quantity("k", "1 N*m/arcmin", "N*m/rad"), 10800 / pi);
  EXPECT_DOUBLE_EQ(parse_quantity("k_ic", "60 MPa*m^0.5", "Pa*m^0.5"), 60e6);
  EXPECT_DOUBLE_EQ(parse_quantity("n", "3000 rpm", "rad/s"), 100 * pi);
  EXPECT_DOUBLE_EQ(parse_quantity("lambda", "1.5e-9 rad/(N*m)", "rad/(N*m)"), 1.5e-9);
  EXPECT_DOUBLE_EQ(parse_quantity("lambda", "3 1/(N*m)", "1/(N*m)"), 3);
  EXPECT_EQ(parse_quantity("angle", "90 deg", "rad"), pi / 2);
  EXPECT_EQ(parse_quantity("angle", "-90 deg", "rad"), -pi / 2);
}

TEST(QuantityText, BehaviourPureNumbersMayBeBareOrPercent) {
  EXPECT_EQ(parse_quantity("ratio", "100", "1"), 100);
  EXPECT_EQ(parse_quantity("ratio", "100 1", "1"), 100);
  EXPECT_DOUBLE_EQ(parse_quantity("ratio", "30 %", "1"), 0.3);
  EXPECT_DOUBLE_EQ(parse_quantity("ratio", "30 mm/m", "1"), 0.03);
}

TEST(QuantityText, BehaviourNumbersInAllTheirForms) {
  for (const auto& [text, value] : std::vector<std::pair<std::string_view, double>>{
           {"1 m", 1},
           {"01 m", 1},
           {"1. m", 1},
           {".5 m", 0.5},
           {"-2 m", -2},
           {"+2 m", 2},
           {"+.5 m", 0.5},
           {"1e3 m", 1000},
           {"1E3 m", 1000},
           {"1e+3 m", 1000},
           {"1e-3 m", 0.001},
           {"0 m", 0},
           {"1e-320 m", 1e-320},  // denormal
           {"1.7976931348623157e308 m", std::numeric_limits<double>::max()}})
    EXPECT_EQ(parse_quantity("x", text, "m"), value) << text;
  EXPECT_TRUE(std::signbit(parse_quantity("x", "-0 m", "m")));
}

// --- Quantities that are refused -----------------------------------------------------------------

TEST(QuantityText, InputRefusalsSayWhatIsWrong) {
  for (const auto& [text, unit, message] :
       std::vector<std::tuple<std::string_view, std::string_view, std::string_view>>{
           // no unit, or one of another dimension
           {"0.8", "m", "field: \"0.8\" has no unit; it must be convertible to m"},
           {"0", "m", "field: \"0\" has no unit; it must be convertible to m"},
           {"45", "rad", "field: \"45\" has no unit; it must be convertible to rad"},
           {"50 Hz", "rad/s", "field: \"50 Hz\" is not convertible to rad/s"},
           {"50 1/s", "rad/s", "field: \"50 1/s\" is not convertible to rad/s"},
           {"100 J", "N*m", "field: \"100 J\" is not convertible to N*m"},
           {"100 N*m", "J", "field: \"100 N*m\" is not convertible to J"},
           {"12 kN*m", "N*m/rad", "field: \"12 kN*m\" is not convertible to N*m/rad"},
           {"12 N*m/rad", "N*m", "field: \"12 N*m/rad\" is not convertible to N*m"},
           {"45 %", "rad", "field: \"45 %\" is not convertible to rad"},
           {"1 rad", "1", "field: \"1 rad\" is not convertible to 1"},
           {"60 MPa*m", "Pa*m^0.5", "field: \"60 MPa*m\" is not convertible to Pa*m^0.5"},
           {"1 m^0.999999", "m", "field: \"1 m^0.999999\" is not convertible to m"},
           // a unit that does not exist
           {"2 furlong", "m",
            "field: \"2 furlong\" has the unknown unit \"furlong\"; write a unit such as mm, "
            "N*m/rad or MPa*m^0.5; strainwave units lists all units"},
           {"0x10 mm", "m",
            "field: \"0x10 mm\" has the unknown unit \"x10 mm\"; write a unit such as mm, N*m/rad "
            "or MPa*m^0.5; strainwave units lists all units"},
           {"1,5 mm", "m", "field: \"1,5 mm\" has a comma; write a decimal point"},
           {"100\tN*m", "N*m",
            "field: \"100\\tN*m\" has the unknown unit \"\\tN\"; write a unit such as mm, N*m/rad "
            "or MPa*m^0.5; strainwave units lists all units"},
           // no number, or one that no measurement gives
           {"", "m", "field: \"\" must start with a finite number, such as 2.24 or 1.2e5"},
           {" ", "m", "field: \" \" must start with a finite number, such as 2.24 or 1.2e5"},
           {"thick", "m",
            "field: \"thick\" must start with a finite number, such as 2.24 or 1.2e5"},
           {"mm", "m", "field: \"mm\" must start with a finite number, such as 2.24 or 1.2e5"},
           {"nan mm", "m",
            "field: \"nan mm\" must start with a finite number, such as 2.24 or 1.2e5"},
           {"inf mm", "m",
            "field: \"inf mm\" must start with a finite number, such as 2.24 or 1.2e5"},
           {"-inf mm", "m",
            "field: \"-inf mm\" must start with a finite number, such as 2.24 or 1.2e5"},
           {"+-1 mm", "m",
            "field: \"+-1 mm\" must start with a finite number, such as 2.24 or 1.2e5"},
           {"1e999 mm", "m", "field: \"1e999 mm\" has a number that is too large or too small"},
           {"1e-999 mm", "m", "field: \"1e-999 mm\" has a number that is too large or too small"},
           {"1e305 GPa", "Pa", "field: \"1e305 GPa\" is too large"},
           // malformed products
           {"1 m)", "m", "field: \"1 m)\" has text after the unit; remove this text"},
           {"1 (m", "m", "field: \"1 (m\" has an opening parenthesis without a closing one"},
           {"1 m^", "m", "field: \"1 m^\" needs an exponent between -12 and 12 after ^"},
           {"1 m^13", "m", "field: \"1 m^13\" needs an exponent between -12 and 12 after ^"},
           {"1 m^nan", "m", "field: \"1 m^nan\" needs an exponent between -12 and 12 after ^"},
           {"1 m^1^1", "m",
            "field: \"1 m^1^1\" may contain only * / ^ and parentheses between units"},
           {"1 m(m)", "m^2",
            "field: \"1 m(m)\" may contain only * / ^ and parentheses between units"},
           {"1 m*", "m", "field: \"1 m*\" lacks a unit where the text needs one"},
           {"1 *m", "m", "field: \"1 *m\" lacks a unit where the text needs one"},
           {"1 m//m", "1", "field: \"1 m//m\" lacks a unit where the text needs one"},
           {"1 ()", "1", "field: \"1 ()\" lacks a unit where the text needs one"},
           {"1 (((((((((m)))))))))", "m",
            "field: \"1 (((((((((m)))))))))\" has too many nested parentheses"},
       })
    EXPECT_EQ(refusal(text, unit), message);
}

TEST(QuantityText, InputNothingLaxIsAccepted) {
  for (const std::string_view text :
       {"1e mm",     "1 e3 mm",   "0x1p3 mm",  "1_000 mm", "1'000 mm", "1 000 mm",    "1.2.3 mm",
        "--1 mm",    "1 mm mm",   "1 mm 2",    "1 mm;",    "1 mm\n",   "\n1 mm",      "1 m m",
        "1 N m",     "1 MM",      "1 Mm^",     "1 mmm",    "1 km/h",   "infinity mm", "INF mm",
        "NaN mm",    "nan(1) mm", "1 m^2",     "1 m^-1",   "1 m**1",   "1 m^(1)",     "1 m^1/2",
        "1 inch",    "1 \"",      "1 Ohm",     "1 kmin",   "1 kdeg",   "1 k",         "1 \u00B5",
        "1 u",       "1 \u00B0",  "1 m\u00B2", "1 \xC2",   "1 \xFF",   "\xFF",        "1 mm\xC2",
        "\u0661 mm", "1 kk m",    "1 mkg",     "mm 1",     "1..5 mm",  "1 / m",       "(1 m)",
        "1 m^1e300", "1 m^-inf",  "e5 mm",     ".e5 mm",   ". mm",     "+ 1 mm",      "++1 mm",
        "- 1 mm",    "1 m*m/m*",  "1 1e3m",    "1 2m"})
    EXPECT_NE(refusal(text, "m"), "accepted") << text;
  const std::string with_nul("1\0 mm", 5);
  EXPECT_NE(refusal(with_nul, "m"), "accepted");
  EXPECT_NE(refusal(std::string("1 mm\0", 5), "m"), "accepted");
}

TEST(QuantityText, InputHostileLengthsAreRefusedBriefly) {
  const std::string deep = "1 " + std::string(100000, '(') + "m" + std::string(100000, ')');
  EXPECT_LT(refusal(deep, "m").size(), 300U);
  std::string powers = "1 m";
  for (int i = 0; i < 10000; ++i) powers += "*m";
  EXPECT_LT(refusal(powers, "m").size(), 300U);
  EXPECT_LT(refusal("1 " + std::string(100000, 'x'), "m").size(), 600U);
  EXPECT_LT(refusal(std::string(100000, ' '), "m").size(), 300U);
  EXPECT_NE(refusal("1" + std::string(1000, '0') + " m", "m"), "accepted");
  // A factor that overflows is refused even for zero, because 0 * inf is not a number.
  EXPECT_EQ(refusal("0 Gm^12*Gm^12*Gm^12", "m^12*m^12*m^12"),
            "field: \"0 Gm^12*Gm^12*Gm^12\" is too large");
}

TEST(QuantityText, InputRefusedUnitsNameThemselves) {
  EXPECT_EQ(unit_refusal("parsec/s"),
            "unit: \"parsec/s\" has the unknown unit \"parsec\"; write a unit such as mm, N*m/rad "
            "or MPa*m^0.5; strainwave units lists all units");
  EXPECT_EQ(unit_refusal(""), "unit: \"\" lacks a unit where the text needs one");
  EXPECT_EQ(unit_refusal("2"),
            "unit: \"2\" has the unknown unit \"2\"; write a unit such as mm, N*m/rad or "
            "MPa*m^0.5; strainwave units lists all units");
  EXPECT_EQ(unit_refusal("m "),
            "unit: \"m \" has the unknown unit \"m \"; write a unit such as mm, N*m/rad or "
            "MPa*m^0.5; strainwave units lists all units");
}

// --- Writing -------------------------------------------------------------------------------------

TEST(QuantityText, IdentityWrittenQuantitiesReadBackBitForBit) {
  std::mt19937_64 random(20261121);
  const std::vector<std::string_view> units = {
      "m", "N", "N*m", "Pa", "Pa*m^0.5", "N/m", "rad", "rad/(N*m)", "N*m/rad", "1/N", "m/N", "1"};
  int finite = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto value = std::bit_cast<double>(static_cast<std::uint64_t>(random()));
    if (!std::isfinite(value)) continue;
    ++finite;
    const std::string_view unit = units[static_cast<std::size_t>(i) % units.size()];
    const double read = parse_quantity("x", quantity_text(value, unit), unit);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(read), std::bit_cast<std::uint64_t>(value))
        << quantity_text(value, unit);
  }
  EXPECT_GT(finite, 19000);
}

TEST(QuantityText, BehaviourWrittenFormIsShort) {
  EXPECT_EQ(quantity_text(0.00224, "m"), "0.00224 m");
  EXPECT_EQ(quantity_text(0.1, "1"), "0.1");
  EXPECT_EQ(quantity_text(-45, "N*m/rad"), "-45 N*m/rad");
  EXPECT_EQ(quantity_text(1.6705498e-9, "rad/(N*m)"), "1.6705498e-09 rad/(N*m)");
}

}  // namespace
}  // namespace strainwave
