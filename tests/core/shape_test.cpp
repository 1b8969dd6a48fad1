// SPDX-License-Identifier: Apache-2.0
#include "strainwave/core/shape.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace strainwave {
namespace {

enum class Finish { rough, ground };

}  // namespace

template <>
struct EnumNames<Finish> {
  static constexpr std::array<std::string_view, 2> names = {"rough", "ground"};
};

namespace {

struct Base {
  std::string source = "none";

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "source", .unit = "", .doc = "a text"}, &Base::source);
  }
};

struct Notch {
  static constexpr std::string_view kKind = "notch";
  static constexpr std::string_view kMeaning = "a notch";
  double depth = 1;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "depth", .unit = "m", .doc = "depth"}, &Notch::depth);
  }
};

struct Hole : Base {
  static constexpr std::string_view kKind = "hole";
  static constexpr std::string_view kMeaning = "a hole";
  int count = 2;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "count", .unit = "1", .doc = "count"}, &Hole::count);
    Base::describe(field);
  }
};

struct Part {
  double size = 3;
  std::optional<double> wanted;
  std::optional<double> either;
  double known = 4;
  bool flag = false;
  Finish finish = Finish::ground;
  std::array<double, 2> pair = {5, 6};
  std::vector<std::variant<Notch, Hole>> fault;
  std::map<std::string, Notch> named;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "size", .unit = "m", .doc = "size"}, &Part::size);
    field(Field{.name = "wanted", .unit = "m", .doc = "wanted"}, &Part::wanted);
    field(Field{.name = "either", .unit = "m", .doc = "either", .unless = {"wanted"}},
          &Part::either);
    field(Field{.name = "known", .unit = "1", .doc = "known", .fallback = "4"}, &Part::known);
    field(Field{.name = "flag", .unit = "", .doc = "flag"}, &Part::flag);
    field(Field{.name = "finish", .unit = "", .doc = "finish"}, &Part::finish);
    field(Field{.name = "pair", .unit = "1", .doc = "pair"}, &Part::pair);
    field(Field{.name = "fault", .unit = "", .doc = "fault"}, &Part::fault);
    field(Field{.name = "named", .unit = "", .doc = "named"}, &Part::named);
  }
};

const ShapeField& field_of(std::string_view name) {
  const ShapeField* const found = shape_of<Part>().find(name);
  EXPECT_NE(found, nullptr) << name;
  return *found;
}

// Kind: identity.  The shape has the fields of the description, in its order, and is made once.
TEST(Shape, IdentityOfTheDescription) {
  const Shape& shape = shape_of<Part>();
  EXPECT_EQ(&shape, &shape_of<Part>());
  std::vector<std::string_view> described;
  Part::describe([&](const Field& field, auto) { described.push_back(field.name); });
  std::vector<std::string_view> shaped;
  for (const ShapeField& one : shape.fields) shaped.push_back(one.field.name);
  EXPECT_EQ(shaped, described);
  EXPECT_EQ(shape.find("colour"), nullptr);
  using Kind = Shape::Kind;
  const std::vector<std::pair<std::string_view, Kind>> kinds = {
      {"size", Kind::number},   {"wanted", Kind::optional}, {"flag", Kind::flag},
      {"finish", Kind::choice}, {"pair", Kind::pair},       {"fault", Kind::list},
      {"named", Kind::map}};
  for (const auto& [name, kind] : kinds) EXPECT_EQ(field_of(name).shape->kind, kind) << name;
  EXPECT_EQ(*static_cast<const double*>(value_in(shape.unset, field_of("known"))), 4);
}

// Kind: behaviour.  What a file may leave out.
TEST(Shape, BehaviourWhatAFileMustGive) {
  const auto required = [](std::string_view name) {
    return std::pair(is_required(field_of(name)), is_always_required(field_of(name)));
  };
  EXPECT_EQ(required("size"), std::pair(true, true));
  EXPECT_EQ(required("wanted"), std::pair(false, false));
  EXPECT_EQ(required("either"), std::pair(true, false));
  for (const char* const name : {"known", "fault", "named"})
    EXPECT_EQ(required(name), std::pair(false, false)) << name;
  EXPECT_TRUE(is_section(*field_of("fault").shape));
  EXPECT_TRUE(is_section(*field_of("named").shape));
  EXPECT_FALSE(is_section(*field_of("pair").shape));
  EXPECT_EQ(&unwrapped(*field_of("pair").shape), field_of("pair").shape);
}

// Kind: behaviour.  Every part of a value is reached and changed through the shape.
TEST(Shape, BehaviourReachesAllParts) {
  Part part;
  const auto at = [&](std::string_view name) { return value_in(&part, field_of(name)); };
  const auto shape = [](std::string_view name) -> const Shape& { return *field_of(name).shape; };
  *static_cast<double*>(at("size")) = 7;
  EXPECT_EQ(part.size, 7);
  EXPECT_EQ(shape("wanted").size(at("wanted")), 0U);
  *static_cast<double*>(shape("wanted").add(at("wanted"))) = 8;
  EXPECT_EQ(part.wanted, 8);
  EXPECT_EQ(*static_cast<const double*>(element_of(shape("wanted"), at("wanted"), 0)), 8);
  EXPECT_EQ(shape("finish").names[shape("finish").index(at("finish"))], "ground");
  shape("finish").take(at("finish"), 0);
  EXPECT_EQ(part.finish, Finish::rough);
  EXPECT_EQ(shape("pair").size(at("pair")), 2U);
  *static_cast<double*>(shape("pair").at(at("pair"), 1)) = 9;
  EXPECT_EQ(part.pair[1], 9);

  const Shape& faults = shape("fault");
  void* const fault = faults.add(at("fault"));
  EXPECT_EQ(faults.element->index(fault), 0U);
  void* const hole = faults.element->take(fault, 1);
  ASSERT_TRUE(std::holds_alternative<Hole>(part.fault[0]));
  const Shape& of_hole = *faults.element->alternatives[1];
  EXPECT_EQ(of_hole.kind_name, "hole");
  EXPECT_EQ(of_hole.meaning, "a hole");
  // The member of a base class has its place in the derived struct.
  EXPECT_EQ(*static_cast<const std::string*>(value_in(hole, *of_hole.find("source"))), "none");
  *static_cast<int*>(value_in(hole, *of_hole.find("count"))) = 3;
  EXPECT_EQ(std::get<Hole>(part.fault[0]).count, 3);
  EXPECT_EQ(faults.element->at(fault, 0), hole);

  static_cast<Notch*>(shape("named").entry(at("named"), "b"))->depth = 2;
  static_cast<Notch*>(shape("named").entry(at("named"), "a"))->depth = 1;
  std::vector<std::string> names;
  each_element(shape("named"), at("named"), [&](const std::string& name, const void* element) {
    names.push_back(name);
    EXPECT_EQ(static_cast<const Notch*>(element)->depth, part.named.at(name).depth);
  });
  EXPECT_EQ(names, (std::vector<std::string>{"a", "b"}));
}

}  // namespace
}  // namespace strainwave
