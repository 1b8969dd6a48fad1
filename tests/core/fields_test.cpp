// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/fields.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "strainwave/core/shape.hpp"
#include "support/not_finite.hpp"

namespace strainwave {
namespace {

using test::kInfinity;
using test::kNaN;

enum class Colour { red, dark_blue };

}  // namespace

template <>
struct EnumNames<Colour> {
  static constexpr std::array<std::string_view, 2> names = {"red", "dark-blue"};
};

namespace {

/// A struct with a member of every kind that descriptions allow.
struct Inner {
  double size = 1.0;
  int count = 2;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "size", .unit = "m", .doc = "size", .range = kPositive}, &Inner::size);
    field(Field{.name = "count", .unit = "1", .doc = "not a double"}, &Inner::count);
  }
};

struct Left {
  static constexpr std::string_view kKind = "left";
  double depth = 3.0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "depth", .unit = "m", .doc = "depth"}, &Left::depth);
  }
};

struct Right {
  static constexpr std::string_view kKind = "right";
  double angle = 4.0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "angle", .unit = "rad", .doc = "angle"}, &Right::angle);
  }
};

struct Outer {
  double plain = 0.5;
  std::optional<double> maybe;
  std::array<double, 2> pair{5.0, 6.0};
  Inner inner;
  std::optional<Inner> maybe_inner;
  std::map<std::string, Inner> named;
  std::vector<std::variant<Left, Right>> crack;
  std::string text = "text";
  bool flag = true;
  Colour colour = Colour::red;

  template <class Visitor>
  static void describe(Visitor&& field) {
    const auto add = [&](std::string_view name, auto member) {
      field(Field{.name = name, .unit = "1", .doc = name}, member);
    };
    add("plain", &Outer::plain);
    add("maybe", &Outer::maybe);
    add("pair", &Outer::pair);
    add("inner", &Outer::inner);
    add("maybe_inner", &Outer::maybe_inner);
    add("named", &Outer::named);
    add("crack", &Outer::crack);
    add("text", &Outer::text);
    add("flag", &Outer::flag);
    add("colour", &Outer::colour);
  }
};

static_assert(Described<Outer> && Described<Inner> && !Described<int> && !Described<std::string>);
static_assert(is_optional<std::optional<int>> && !is_optional<int>);
static_assert(is_vector<std::vector<Inner>> && !is_vector<std::string>);
static_assert(is_variant<std::variant<Left, Right>> && !is_variant<Left>);
static_assert(is_string_map<std::map<std::string, Inner>> && !is_string_map<std::map<int, Inner>>);
static_assert(is_pair_of_numbers<std::array<double, 2>> &&
              !is_pair_of_numbers<std::array<double, 3>>);

using Walk = std::vector<std::pair<std::string, double>>;

template <class T>
Walk walk(T& value, const FieldPath& start = {}) {
  Walk found;
  for_each_number(
      value,
      [&](const FieldPath& path, const Field&, const double& number) {
        found.emplace_back(path.text(), number);
      },
      start);
  return found;
}

TEST(Range, LimitBoundsOpenAndClosed) {
  const Range open{.lower = -1, .upper = 2};
  EXPECT_FALSE(open.contains(-1));
  EXPECT_FALSE(open.contains(2));
  EXPECT_TRUE(open.contains(std::nextafter(-1.0, 0.0)));
  EXPECT_TRUE(open.contains(std::nextafter(2.0, 0.0)));
  const Range closed{.lower = -1, .lower_open = false, .upper = 2, .upper_open = false};
  EXPECT_TRUE(closed.contains(-1));
  EXPECT_TRUE(closed.contains(2));
  EXPECT_FALSE(closed.contains(std::nextafter(-1.0, -2.0)));
  EXPECT_FALSE(closed.contains(std::nextafter(2.0, 3.0)));
}

TEST(Range, LimitNeitherNaNNorInfinityIsInAnyRange) {
  for (const Range& range :
       {kFinite, kPositive, kNonNegative, Range{.lower = 0, .upper = 1},
        Range{.lower = 0, .lower_open = false, .upper = 1, .upper_open = false}})
    for (const double value : {kNaN, -kNaN, kInfinity, -kInfinity})
      EXPECT_FALSE(range.contains(value)) << value << " in " << rule_text(range);
}

TEST(Range, LimitLargestAndSmallestNumbers) {
  EXPECT_TRUE(kFinite.contains(std::numeric_limits<double>::max()));
  EXPECT_TRUE(kFinite.contains(std::numeric_limits<double>::lowest()));
  EXPECT_TRUE(kPositive.contains(std::numeric_limits<double>::denorm_min()));
  EXPECT_FALSE(kPositive.contains(0.0));
  EXPECT_FALSE(kPositive.contains(-0.0));
  EXPECT_TRUE(kNonNegative.contains(-0.0));
}

TEST(Range, BehaviourRulesAsTheReaderWouldSayThem) {
  EXPECT_EQ(rule_text(kFinite), "a finite number");
  EXPECT_EQ(rule_text(kPositive), "> 0");
  EXPECT_EQ(rule_text(kNonNegative), ">= 0");
  EXPECT_EQ(rule_text({.lower = -1, .upper = 0.5}), "> -1 and < 0.5");
  EXPECT_EQ(rule_text({.lower = 1, .lower_open = false, .upper = 8, .upper_open = false}),
            ">= 1 and <= 8");
  EXPECT_EQ(rule_text({.upper = 3}), "< 3");
  EXPECT_EQ(rule_text(kPositive, "m"), "> 0");
  EXPECT_EQ(rule_text({.lower = -1.5, .upper = 0.5}, "m"), "> -1.5 m and < 0.5 m");
  EXPECT_EQ(rule_text({.lower = -std::numbers::pi / 2, .upper = std::numbers::pi}, "rad"),
            "> -90 deg and < 180 deg");
}

TEST(EnumNames, IdentityNamesAndValuesAreInverse) {
  EXPECT_EQ(enum_name(Colour::red), "red");
  EXPECT_EQ(enum_name(Colour::dark_blue), "dark-blue");
  EXPECT_EQ(enum_value<Colour>("red"), Colour::red);
  EXPECT_EQ(enum_value<Colour>("dark-blue"), Colour::dark_blue);
}

TEST(EnumNames, InputUnknownNamesGiveNothing) {
  for (const std::string_view name : {"", "Red", "red ", "dark_blue", "0"})
    EXPECT_EQ(enum_value<Colour>(name), std::nullopt) << name;
}

TEST(FieldPath, BehaviourPathsAreSpelledAsInMessages) {
  const FieldPath root = FieldPath();
  EXPECT_EQ(root.text(), "");
  EXPECT_EQ((root / "drive").text(), "drive");
  EXPECT_EQ((root / "drive" / "ratio").text(), "drive.ratio");
  EXPECT_EQ(((root / "shaft" / "crack")[0] / "depth").text(), "shaft.crack[0].depth");
  EXPECT_EQ((FieldPath("a.b") / "c").text(), "a.b.c");
  // `is` compares without making the text.
  for (const FieldPath& path :
       {root, root / "drive", root / "drive" / "ratio", (root / "shaft" / "crack")[0] / "depth",
        (root / "shaft" / "crack")[12], FieldPath("a.b") / "c", FieldPath("a.b")}) {
    EXPECT_TRUE(path.is(path.text())) << path.text();
    EXPECT_FALSE(path.is(path.text() + "x"));
    EXPECT_FALSE(path.is("x" + path.text()));
    EXPECT_FALSE(path.is("." + path.text()));
    if (!path.text().empty()) {
      EXPECT_FALSE(path.is(path.text().substr(1)));
      EXPECT_FALSE(path.is(""));
    }
  }
}

TEST(ForEachNumber, BehaviourVisitsWhatTheValueHoldsInOrder) {
  const Outer empty;
  EXPECT_EQ(walk(empty), (Walk{{"plain", 0.5}, {"pair[0]", 5}, {"pair[1]", 6}, {"inner.size", 1}}));

  Outer full;
  full.maybe = 7;
  full.maybe_inner = Inner{.size = 8};
  full.named["b"] = Inner{.size = 10};
  full.named["a"] = Inner{.size = 9};
  full.crack = {Right{.angle = 11}, Left{.depth = 12}, Right{.angle = 13}};
  EXPECT_EQ(walk(full), (Walk{{"plain", 0.5},
                              {"maybe", 7},
                              {"pair[0]", 5},
                              {"pair[1]", 6},
                              {"inner.size", 1},
                              {"maybe_inner.size", 8},
                              {"named.a.size", 9},
                              {"named.b.size", 10},
                              {"crack[0].angle", 11},
                              {"crack[1].depth", 12},
                              {"crack[2].angle", 13}}));
  EXPECT_EQ(walk(full.inner, FieldPath("at")), (Walk{{"at.size", 1}}));
}

TEST(ForEachNumber, BehaviourTheFieldIsThatOfTheNumber) {
  Outer outer;
  outer.maybe_inner.emplace();
  std::map<std::string, std::string_view> units;
  for_each_number(outer, [&](const FieldPath& path, const Field& field, const double&) {
    units[path.text()] = field.unit;
  });
  EXPECT_EQ(units.at("plain"), "1");
  EXPECT_EQ(units.at("inner.size"), "m");
  EXPECT_EQ(units.at("maybe_inner.size"), "m");
}

TEST(ForEachNumber, BehaviourNumbersCanBeChanged) {
  Outer outer;
  outer.maybe = 7;
  outer.crack = {Left{}};
  for_each_number(outer, [](const FieldPath&, const Field&, double& number) { number *= 2; });
  EXPECT_EQ(outer.plain, 1);
  EXPECT_EQ(outer.maybe, 14);
  EXPECT_EQ(outer.pair[1], 12);
  EXPECT_EQ(outer.inner.size, 2);
  EXPECT_EQ(outer.inner.count, 2);
  EXPECT_EQ(std::get<Left>(outer.crack[0]).depth, 6);
}

TEST(ForEachNumber, IdentityTheWalkWithoutPathsVisitsTheSameNumbers) {
  Outer outer;
  outer.maybe = 7;
  outer.crack = {Left{}, Right{}};
  std::vector<double> numbers;
  for_each_plain_number(outer, [&](const Field&, double& number) { numbers.push_back(number); });
  std::vector<double> expected;
  for (const auto& [path, number] : walk(outer)) expected.push_back(number);
  EXPECT_EQ(numbers, expected);
}

TEST(ForEachAlternative, BehaviourVisitsAllInTheirOrder) {
  std::vector<std::string_view> kinds;
  for_each_alternative<std::variant<Left, Right>>(
      [&]<class Alternative>() { kinds.push_back(Alternative::kKind); });
  EXPECT_EQ(kinds, (std::vector<std::string_view>{"left", "right"}));
}

}  // namespace
}  // namespace strainwave
