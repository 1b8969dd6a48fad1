// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "strainwave/core/described.hpp"
#include "strainwave/core/quantity_text.hpp"

namespace strainwave::test {

/// Checks that every field of a type has a readable unit and a description.
class FieldWitness : public TypeVisitor {
 public:
  void begin_record() override { open_.emplace_back(); }
  /// The unit may be in an enclosing record, as one unit for all rows.
  void end_record() override {
    const bool open = open_.back().beside && !open_.back().unit;
    open_.pop_back();
    if (open_.empty()) {
      EXPECT_FALSE(open) << field_.name << ": a number in a unit beside, and no field `unit`";
    } else {
      open_.back().beside = open_.back().beside || open;
    }
  }
  void field(const Field& field, Presence) override {
    field_ = field;
    ++n_fields;
    EXPECT_FALSE(field.doc.empty()) << field.name;
    EXPECT_EQ(field.doc.find('\n'), std::string_view::npos) << field.name;
    if (field.name == "unit" && !open_.empty()) open_.back().unit = true;
  }
  void begin_list() override {}
  void end_list() override {}
  void begin_map() override {}
  void end_map() override {}
  void begin_alternatives() override {}
  void end_alternatives() override {}
  void kind(std::string_view) override {}
  /// A column of words does not need a unit; UnitWitness checks the numbers of a column without
  /// one.
  void column(const Field& field) override {
    if (!field.unit.empty()) number(field);
  }
  void number(const Field& field) override {
    if (field.unit == kUnitBeside)
      open_.back().beside = true;
    else
      expect_unit(field);
  }
  void quantity(const Field& field) override {
    if (field.unit != kUnitBeside) expect_unit(field);
  }
  void whole(const Field& field) override { EXPECT_TRUE(field.unit.empty()) << field.name; }
  void flag() override { EXPECT_TRUE(field_.unit.empty()) << field_.name; }
  void text() override { EXPECT_TRUE(field_.unit.empty()) << field_.name; }
  void choice(std::span<const std::string_view>) override {
    EXPECT_TRUE(field_.unit.empty()) << field_.name;
  }

  int n_fields = 0;

 private:
  struct Open {
    bool beside = false;
    bool unit = false;
  };
  static void expect_unit(const Field& field) {
    EXPECT_FALSE(field.unit.empty()) << field.name;
    EXPECT_NO_THROW((void)parse_unit(field.unit)) << field.name << " " << field.unit;
  }
  Field field_{};
  std::vector<Open> open_;
};

}  // namespace strainwave::test
