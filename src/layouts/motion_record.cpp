// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/motion_record.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <type_traits>

#include "strainwave/core/described.hpp"
#include "strainwave/present/json.hpp"
#include "strainwave/present/table.hpp"

namespace strainwave {
namespace {

constexpr std::string_view kMagic = "swmotion";
constexpr std::uint32_t kFormVersion = 1;
constexpr std::size_t kAligned = 8;  // bytes

/// Visits the columns of a record with their members.
template <class Visitor>
void each_column(const RecordColumns& columns, const Visitor& visit) {
  SimulationRow::describe([&](const Field& field, auto member) {
    if ((columns.cracked || !field.name.starts_with("cracked_")) &&
        (columns.output_given || !field.name.ends_with("output_torque")))
      visit(field, member);
  });
}

/// Adds the bytes of an integer, the lowest first.
template <class Whole>
void add_bytes(std::string& to, Whole value) {
  std::array<char, sizeof(Whole)> bytes{};
  for (char& byte : bytes) {
    byte = static_cast<char>(static_cast<unsigned char>(value & 0xffU));
    value >>= 8U;
  }
  to.append(bytes.data(), bytes.size());
}

std::string head_text(const RecordOrigin& origin, const RecordColumns& wanted) {
  JsonWriter to;
  const auto named = [](std::string_view name) {
    return Field{.name = name, .unit = {}, .doc = {}};
  };
  to.begin_record();
  to.member("format", "strainwave-motion/1");
  to.member("program", "strainwave");
  to.member("version", origin.version);
  to.member("revision", origin.revision);
  to.member("input_file", origin.input_file);
  to.member("input_sha256", origin.input_sha256);
  if (to.field(named("options"))) {
    to.begin_record();
    for (const auto& [name, text] : origin.options) to.member(name, text);
    to.end_record();
  }
  std::size_t columns = 0;
  if (to.field(named("columns"))) {
    to.begin_list();
    each_column(wanted, [&](const Field& field, auto) {
      to.begin_record();
      to.member("name", field.name);
      to.member("unit", field.unit);
      to.member("doc", field.doc);
      to.end_record();
      ++columns;
    });
    to.end_list();
  }
  if (to.field(named("row_bytes"))) to.whole(static_cast<std::int64_t>(columns * sizeof(double)));
  to.member("absent", "NaN");
  to.end_record();
  return to.document();
}

}  // namespace

std::string record_head(RecordForm form, const RecordOrigin& origin, const RecordColumns& wanted) {
  if (form == RecordForm::csv) {
    std::vector<std::string> head;
    each_column(wanted, [&](const Field& field, auto) {
      head.push_back(fmt::format("{} [{}]", field.name, field.unit));
    });
    return csv_line(head);
  }
  std::string text = head_text(origin, wanted);
  std::string made(kMagic);
  add_bytes(made, kFormVersion);
  const std::size_t before = made.size() + sizeof(std::uint32_t);
  while ((before + text.size()) % kAligned != 0) text += ' ';
  add_bytes(made, static_cast<std::uint32_t>(text.size()));
  return made + text;
}

void add_record_row(std::string& to, RecordForm form, const SimulationRow& row,
                    const RecordColumns& wanted) {
  static_assert(std::numeric_limits<double>::is_iec559);
  each_column(wanted, [&](const Field&, auto member) {
    const std::optional<double> value = row.*member;
    if (form == RecordForm::binary)
      add_bytes(to, std::bit_cast<std::uint64_t>(
                        value.value_or(std::numeric_limits<double>::quiet_NaN())));
    else if (value)
      fmt::format_to(std::back_inserter(to), "{},", *value);
    else
      to += ',';
  });
  if (form == RecordForm::csv) to.back() = '\n';
}

}  // namespace strainwave
