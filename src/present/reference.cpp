// SPDX-License-Identifier: Apache-2.0
#include "strainwave/present/reference.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace strainwave {
namespace {

/// Writes one line for each field that holds a value; records and lists only extend the path.
class ReferenceWriter : public TypeVisitor {
 public:
  [[nodiscard]] const std::string& table() const { return table_; }

  void begin_record() override { paths_.push_back(path_); }
  void end_record() override { leave(); }
  void field(const Field& field, Presence) override {
    path_ = paths_.back() + (paths_.back().empty() ? "" : ".") + std::string(field.name);
    doc_ = field.doc;
  }
  void begin_list() override { enter("[]"); }
  void end_list() override { leave(); }
  void begin_map() override { enter(".<name>"); }
  void end_map() override { leave(); }
  void begin_alternatives() override { paths_.push_back(path_); }
  void end_alternatives() override { leave(); }
  void kind(std::string_view kind) override {
    table_ += fmt::format("| `{}.kind` | | \"{}\", with: |\n", paths_.back(), kind);
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
  void line(std::string_view unit, std::string_view values) {
    table_ += fmt::format("| `{}` | {} | {}{}{} |\n", path_,
                          unit == kUnitBeside ? "as the field `unit` says" : unit, doc_,
                          values.empty() ? "" : "; ", values);
  }

  std::string table_ = "| field | unit | meaning |\n|---|---|---|\n";
  std::string path_;
  std::string doc_;
  std::vector<std::string> paths_;
};

}  // namespace

std::string fields_reference(TypeWalk walk) {
  ReferenceWriter writer;
  walk({}, writer);
  return writer.table();
}

}  // namespace strainwave
