// SPDX-License-Identifier: Apache-2.0
#include "strainwave/present/field_list.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace strainwave {
namespace {

/// Lists each field that holds a value; records and lists only lengthen the path.
class FieldLister : public TypeVisitor {
 public:
  [[nodiscard]] std::vector<ListedField> fields() && { return std::move(fields_); }

  void begin_record() override { paths_.push_back(path_); }
  void end_record() override { leave(); }
  void field(const Field& field, Presence) override {
    path_ = paths_.back() + (paths_.back().empty() ? "" : ".") + std::string(field.name);
    field_ = field;
  }
  void begin_list() override { enter("[]"); }
  void end_list() override { leave(); }
  void begin_map() override { enter(".<name>"); }
  void end_map() override { leave(); }
  void begin_alternatives() override { paths_.push_back(path_); }
  void end_alternatives() override { leave(); }
  void kind(std::string_view kind) override {
    fields_.push_back({.path = paths_.back() + ".kind",
                       .field = {.name = "kind", .unit = "", .doc = ""},
                       .values = {},
                       .kind = std::string(kind)});
  }
  void column(const Field& field) override { line(field.unit, "one value for each element"); }
  void number(const Field& field) override { line(field.unit, ""); }
  void quantity(const Field& field) override { line(field.unit, "with its uncertainty"); }
  void whole(const Field&) override { line("", "whole number"); }
  void flag() override { line("", "true or false"); }
  void text() override { line("", ""); }
  void choice(std::span<const std::string_view> names) override {
    line("", fmt::format("{}", fmt::join(names, ", ")));
  }

 private:
  void enter(std::string_view step) {
    paths_.push_back(path_);
    path_ += step;
  }
  void leave() {
    path_ = paths_.back();
    paths_.pop_back();
  }
  void line(std::string_view unit, std::string values) {
    field_.unit = unit;
    fields_.push_back({.path = path_, .field = field_, .values = std::move(values), .kind = {}});
  }

  std::vector<ListedField> fields_;
  std::string path_;
  Field field_ = {.name = "", .unit = "", .doc = ""};
  std::vector<std::string> paths_;
};

/// The steps of a path, without the numbers of elements.
std::vector<std::string_view> steps_of(std::string_view path) {
  std::vector<std::string_view> steps;
  for (;;) {
    const std::size_t dot = std::min(path.find('.'), path.size());
    const std::string_view step = path.substr(0, dot);
    steps.push_back(step.substr(0, step.find('[')));
    if (dot == path.size()) return steps;
    path.remove_prefix(dot + 1);
  }
}

}  // namespace

std::vector<ListedField> list_of_fields(TypeWalk walk) {
  FieldLister lister;
  walk({}, lister);
  return std::move(lister).fields();
}

bool is_path(std::string_view written, std::string_view listed) {
  const auto of_writer = steps_of(written);
  const auto of_list = steps_of(listed);
  const bool any_name = of_writer.size() == 1 && of_list.back() == "<name>";
  return of_writer.size() <= of_list.size() && !any_name &&
         std::equal(of_writer.rbegin(), of_writer.rend(), of_list.rbegin(),
                    [](std::string_view a, std::string_view b) { return a == b || b == "<name>"; });
}

}  // namespace strainwave
