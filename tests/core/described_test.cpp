// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/described.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace strainwave {
namespace {

enum class Paint { red, green };

struct Row {
  double x = 0.0;
  std::optional<double> y;
  std::vector<double> list;
  Quantity amount{2.5, "m", 0.1};

  static constexpr bool kTableRow = true;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"x", "m", "first"}, &Row::x);
    field({"y", "s", "second"}, &Row::y);
    field({"list", "K", "third"}, &Row::list);
    field({"inner", "", "a record of the row"}, [](const Row& r) { return Inner{r.x * 2}; });
    field({"amount", "m", "a quantity"}, &Row::amount);
  }

  struct Inner {
    double twice = 0.0;
    template <class Visitor>
    static void describe(Visitor&& field) {
      field({"twice", "m", "two times x"}, &Inner::twice);
    }
  };
};

struct Square {
  static constexpr std::string_view kKind = "square";
  double side = 3.0;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"side", "m", "of the square"}, &Square::side);
  }
};

struct Circle {
  static constexpr std::string_view kKind = "circle";
  double radius = 4.0;
  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"radius", "m", "of the circle"}, &Circle::radius);
  }
};

struct Everything {
  double number = 1.5;
  Quantity quantity{2.0, "N", 0.25};
  std::optional<double> absent;
  std::optional<double> present = 7.0;
  bool flag = true;
  int whole = -3;
  Paint colour = Paint::green;
  std::string text = "word";
  Square nested;
  std::vector<std::string> names = {"a", "b"};
  std::vector<Square> list = std::vector<Square>(1);
  std::vector<double> numbers = {1.0, 2.0};
  std::vector<std::optional<double>> gaps = {1.0, std::nullopt};
  std::array<double, 2> pair = {5.0, 6.0};
  std::vector<Row> rows = {{.x = 1, .y = 10, .list = {1, 2}}, {.x = 2, .y = {}, .list = {}}};
  std::map<std::string, Square> map = {{"one", {}}, {"two", {}}};
  std::variant<Square, Circle> shape = Circle{};
  double detail = 9.0;

  [[nodiscard]] double doubled() const { return 2 * number; }

  template <class Visitor>
  static void describe(Visitor&& field) {
    using E = Everything;
    field({"number", "m", "a number"}, &E::number);
    field({"quantity", "N", "a quantity"}, &E::quantity);
    field({"absent", "m", "no value"}, &E::absent);
    field({"present", "m", "a value"}, &E::present);
    field({"flag", "", "a flag"}, &E::flag);
    field({"whole", "", "a whole number"}, &E::whole);
    field({"colour", "", "a choice"}, &E::colour);
    field({"text", "", "a text"}, &E::text);
    field({"nested", "", "a record"}, &E::nested);
    field({"names", "", "texts"}, &E::names);
    field({"list", "", "records"}, &E::list);
    field({"numbers", "s", "a column"}, &E::numbers);
    field({"gaps", "s", "a column with a gap"}, &E::gaps);
    field({"pair", "s", "two numbers"}, &E::pair);
    field({"rows", "", "a long table"}, &E::rows);
    field({"map", "", "by name"}, &E::map);
    field({"shape", "", "one of two"}, &E::shape);
    field({.name = "detail", .unit = "m", .doc = "a detail", .detail = true}, &E::detail);
    field({"doubled", "m", "a member function"}, &E::doubled);
    field({"halved", "m", "a lambda"}, [](const E& e) { return e.number / 2; });
  }
};

}  // namespace

template <>
struct EnumNames<Paint> {
  static constexpr std::array<std::string_view, 2> names = {"red", "green"};
};

namespace {

/// Records the calls that it receives, with their fields.
class Transcript : public ValueVisitor {
 public:
  explicit Transcript(bool details = true) : details_(details) {}

  void begin_record() override { say("{"); }
  void end_record() override { say("}"); }
  bool field(const Field& field) override {
    if (field.detail && !details_) return false;
    say(std::string(field.name) + ":");
    return true;
  }
  void begin_list() override { say("["); }
  void end_list() override { say("]"); }
  void begin_column(const Field& field) override { say("(" + std::string(field.unit)); }
  void end_column() override { say(")"); }
  void number(double value, const Field& field) override {
    say(std::to_string(value).substr(0, 4) + std::string(field.unit));
  }
  void quantity(const Quantity& q) override {
    say("Q" + std::to_string(q.value).substr(0, 4) + std::string(q.unit));
  }
  void whole(std::int64_t value) override { say("i" + std::to_string(value)); }
  void flag(bool value) override { say(value ? "yes" : "no"); }
  void text(std::string_view value) override { say("'" + std::string(value) + "'"); }
  void nothing() override { say("nothing"); }

  std::string said;

 private:
  void say(const std::string& word) { said += (said.empty() ? "" : " ") + word; }
  bool details_;
};

template <class T>
std::string transcript(const T& value, const Field& field = {}) {
  Transcript to;
  visit_value(value, field, to);
  return to.said;
}

/// All field paths below a type.
class TypePaths : public TypeVisitor {
 public:
  void begin_record() override { open_.push_back(path_); }
  void end_record() override { close(); }
  void field(const Field& field, Presence presence) override {
    path_ = open_.back() + "." + std::string(field.name);
    paths.push_back(path_);
    if (presence == Presence::sometimes) sometimes.push_back(path_);
  }
  void begin_list() override { open_.push_back(path_); }
  void end_list() override { close(); }
  void begin_map() override { open_.push_back(path_); }
  void end_map() override { close(); }
  void begin_alternatives() override { open_.push_back(path_); }
  void end_alternatives() override { close(); }
  void kind(std::string_view kind) override { kinds.emplace_back(kind); }
  void column(const Field& field) override { leaf("column", field); }
  void number(const Field& field) override { leaf("number", field); }
  void quantity(const Field& field) override { leaf("quantity", field); }
  void whole(const Field& field) override { leaf("whole", field); }
  void flag() override { leaves[path_] = "flag"; }
  void text() override { leaves[path_] = "text"; }
  void choice(std::span<const std::string_view> names) override {
    leaves[path_] = "choice of " + std::to_string(names.size());
  }

  std::vector<std::string> paths;
  std::vector<std::string> sometimes;
  std::vector<std::string> kinds;
  std::map<std::string, std::string> leaves;

 private:
  void leaf(const std::string& what, const Field& field) {
    leaves[path_] = what + " " + std::string(field.unit);
  }
  void close() {
    path_ = open_.back();
    open_.pop_back();
  }
  std::string path_;
  std::vector<std::string> open_;
};

/// The field paths of a value, without names from maps and variants.
class ValuePaths : public Transcript {
 public:
  void begin_record() override { open_.push_back(path_); }
  void end_record() override {
    path_ = open_.back();
    open_.pop_back();
  }
  bool field(const Field& field) override {
    path_ = open_.back() + "." + std::string(field.name);
    paths.push_back(path_);
    return true;
  }
  std::vector<std::string> paths;

 private:
  std::string path_;
  std::vector<std::string> open_;
};

TEST(Described, ReferenceEveryKindOfValueIsWalkedInOrder) {
  EXPECT_EQ(transcript(Everything{}),
            "{ number: 1.50m quantity: Q2.00N present: 7.00m flag: yes whole: i-3 colour: 'green' "
            "text: 'word' nested: { side: 3.00m } names: [ 'a' 'b' ] list: [ { side: 3.00m } ] "
            "numbers: (s 1.00s 2.00s ) gaps: (s 1.00s nothing ) pair: (s 5.00s 6.00s ) "
            "rows: { x: (m 1.00m 2.00m ) y: (s 10.0s nothing ) list: (K [ 1.00K 2.00K ] [ ] ) "
            "inner: { twice: (m 2.00m 4.00m ) } amount: (m Q2.50m Q2.50m ) } "
            "map: { one: { side: 3.00m } two: { side: 3.00m } } "
            "shape: { kind: 'circle' radius: 4.00m } detail: 9.00m doubled: 3.00m halved: 0.75m }");
}

TEST(Described, LimitNestedListsOfATableStayInTheirColumn) {
  const std::vector<std::vector<std::vector<double>>> rows = {{{1}, {2, 3}}, {}};
  Transcript to;
  detail::visit_columns<std::vector<std::vector<double>>>(
      {"deep", "m", ""},
      [&](const auto& leaf) {
        for (const auto& row : rows) leaf(row);
      },
      to);
  EXPECT_EQ(to.said, "(m [ [ 1.00m ] [ 2.00m 3.00m ] ] [ ] )");
}

TEST(Described, LimitEmptyContainersAreWalked) {
  EXPECT_EQ(transcript(std::vector<Row>()),
            "{ x: (m ) y: (s ) list: (K ) inner: { twice: (m ) } amount: (m ) }");
  EXPECT_EQ(transcript(std::vector<Square>()), "[ ]");
  EXPECT_EQ(transcript(std::vector<double>(), {"n", "s", ""}), "(s )");
  EXPECT_EQ(transcript(std::map<std::string, Square>()), "{ }");
  EXPECT_EQ(transcript(std::optional<double>()), "nothing");
}

TEST(Described, InputAVisitorMaySkipAField) {
  Transcript to(/*details=*/false);
  visit_value(Everything{}, {}, to);
  EXPECT_EQ(to.said.find("detail"), std::string::npos);
  EXPECT_EQ(to.said.find("9.00"), std::string::npos);
  EXPECT_NE(to.said.find("doubled: 3.00m"), std::string::npos);
}

TEST(Described, IdentityTheTypeNamesTheFieldsOfTheValue) {
  Everything all;
  all.absent = 1.0;
  all.map = {{"one", {}}};
  TypePaths type;
  visit_type<Everything>({}, type);
  std::vector<std::string> expected;
  for (const bool circle : {false, true}) {
    if (circle)
      all.shape = Circle{};
    else
      all.shape = Square{};
    ValuePaths value;
    visit_value(all, {}, value);
    for (const std::string& path : value.paths) {
      if (path.ends_with(".kind") || path == ".map.one") continue;
      const std::string in_type = path.starts_with(".map.one") ? ".map" + path.substr(8) : path;
      EXPECT_EQ(std::ranges::count(type.paths, in_type), 1) << path;
      expected.push_back(in_type);
    }
  }
  for (const std::string& path : type.paths)
    EXPECT_GE(std::ranges::count(expected, path), 1) << path;
  EXPECT_EQ(type.sometimes, (std::vector<std::string>{".absent", ".present"}));
  EXPECT_EQ(type.kinds, (std::vector<std::string>{"square", "circle"}));
}

TEST(Described, ReferenceTheTypeTellsKindAndUnitOfEachField) {
  TypePaths type;
  visit_type<Everything>({}, type);
  const std::map<std::string, std::string> expected = {{".number", "number m"},
                                                       {".quantity", "quantity N"},
                                                       {".absent", "number m"},
                                                       {".present", "number m"},
                                                       {".flag", "flag"},
                                                       {".whole", "whole "},
                                                       {".colour", "choice of 2"},
                                                       {".text", "text"},
                                                       {".nested.side", "number m"},
                                                       {".names", "text"},
                                                       {".list.side", "number m"},
                                                       {".numbers", "column s"},
                                                       {".gaps", "column s"},
                                                       {".pair", "column s"},
                                                       {".rows.x", "column m"},
                                                       {".rows.y", "column s"},
                                                       {".rows.list", "column K"},
                                                       {".rows.inner.twice", "column m"},
                                                       {".rows.amount", "column m"},
                                                       {".map.side", "number m"},
                                                       {".shape.side", "number m"},
                                                       {".shape.radius", "number m"},
                                                       {".detail", "number m"},
                                                       {".doubled", "number m"},
                                                       {".halved", "number m"}};
  EXPECT_EQ(type.leaves, expected);
}

}  // namespace
}  // namespace strainwave
