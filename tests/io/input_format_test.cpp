// SPDX-License-Identifier: Apache-2.0
#include "strainwave/io/input_format.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "strainwave/core/described.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/model/input/gear_set.hpp"

namespace strainwave {
namespace {

using Json = nlohmann::json;

/// The message of the reader for a text; "accepted" if it is valid.
std::string verdict(std::string_view text) {
  try {
    (void)read_gear_set(text, "gear.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

bool is_commented_field(const std::string& line) {
  static const std::regex kPattern(R"(# [A-Za-z_0-9]+ = .*)");
  return std::regex_match(line, kPattern);
}

bool is_commented_heading(const std::string& line) { return line.starts_with("# ["); }

bool is_heading(const std::string& line) { return line.starts_with("["); }

/// The key of "# key = value" or "key = value".
std::string key_of(const std::string& line) {
  const std::size_t start = line.starts_with("# ") ? 2 : 0;
  return line.substr(start, line.find(" = ") - start);
}

/// "[drive]" of "# [drive]    # the drive as a whole".
std::string heading_of(const std::string& line) {
  const std::size_t start = line.find('[');
  return line.substr(start, line.find_last_of(']', line.find(" #", start)) - start + 1);
}

// --- Every field of the input, walked without values ---------------------------------------------

enum class Kind { number, integer, flag, text, choice, pair, numbers, table, tables, kinds };

/// What the tests ask of a field.  One list holds all fields: a walk over the types for each test
/// would take the compiler minutes.
struct InputField {
  std::string
      path;  ///< a material is "material.NAME", the cracks of one kind "output_shaft.crack[kind]"
  Field field;
  Kind kind = Kind::table;
  bool optional = false;
  bool required = false;
  bool starts_absent = true;  ///< an optional value or a list is empty in a new struct
  std::vector<std::string_view> choices = {};  ///< the words of a choice
  std::size_t kinds = 0;  ///< the number of kinds that a list of tables can hold
  /// Whether a right-hand side states the value of a new struct.
  std::function<bool(std::string_view)> states_default = {};
  /// The numbers of a right-hand side.  The call fails the test if the text does not suit the
  /// field.
  std::function<std::vector<double>(std::string_view)> numbers_in = {};

  [[nodiscard]] bool is_table() const {
    return kind == Kind::table || kind == Kind::tables || kind == Kind::kinds;
  }
  [[nodiscard]] bool is_number() const { return kind == Kind::number || kind == Kind::integer; }
};

template <class T>
struct Unwrap {
  using type = T;
};
template <class T>
struct Unwrap<std::optional<T>> {
  using type = T;
};

template <class T>
constexpr Kind kind_of() {
  if constexpr (std::is_same_v<T, double>)
    return Kind::number;
  else if constexpr (std::is_same_v<T, int>)
    return Kind::integer;
  else if constexpr (std::is_same_v<T, bool>)
    return Kind::flag;
  else if constexpr (std::is_same_v<T, std::string>)
    return Kind::text;
  else if constexpr (std::is_enum_v<T>)
    return Kind::choice;
  else if constexpr (is_pair_of_numbers<T>)
    return Kind::pair;
  else if constexpr (is_array_of_numbers<T>)
    return Kind::numbers;
  else if constexpr (is_vector<T>)
    return is_variant<typename T::value_type> ? Kind::kinds : Kind::tables;
  else
    return Kind::table;
}

template <class T>
constexpr bool is_required(const Field& field) {
  const bool conditional = !field.unless.front().empty();
  return (!is_optional<T> || conditional) && !is_vector<T> && !is_string_map<T> &&
         field.fallback.empty();
}

std::string unquoted(std::string_view text) {
  EXPECT_GE(text.size(), 2U);
  EXPECT_TRUE(text.front() == '"' && text.back() == '"') << text;
  return std::string(text.substr(1, text.size() - 2));
}

/// A right-hand side of the template as the value of a field.
template <class T>
T parsed(std::string_view text, const Field& field) {
  if constexpr (std::is_same_v<T, double>) {
    if (field.unit != "1") return parse_quantity(field.name, unquoted(text), field.unit);
    return parse_quantity(field.name, text, "1");
  } else if constexpr (std::is_same_v<T, int>) {
    int value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    EXPECT_EQ(result.ptr, text.data() + text.size()) << text;
    return value;
  } else if constexpr (std::is_same_v<T, bool>) {
    EXPECT_TRUE(text == "true" || text == "false") << text;
    return text == "true";
  } else if constexpr (std::is_enum_v<T>) {
    const auto value = enum_value<T>(unquoted(text));
    EXPECT_TRUE(value.has_value()) << text;
    return value.value_or(T{});
  } else if constexpr (is_pair_of_numbers<T>) {
    const std::size_t comma = text.find(", ");
    if (field.unit == "1")
      return {std::stod(std::string(text.substr(1, comma - 1))),
              std::stod(std::string(text.substr(comma + 2)))};
    return {parse_quantity(field.name, unquoted(text.substr(1, comma - 1)), field.unit),
            parse_quantity(field.name, unquoted(text.substr(comma + 2, text.size() - comma - 3)),
                           field.unit)};
  } else if constexpr (is_array_of_numbers<T>) {
    T values;
    for (std::size_t at = 1; at < text.size();) {
      const std::size_t end = std::min(text.find(", ", at), text.size() - 1);
      values.push_back(parsed<double>(text.substr(at, end - at), field));
      at = end + 2;
    }
    return values;
  } else {
    return unquoted(text);
  }
}

template <class T>
std::vector<double> numbers_of(const T& value) {
  if constexpr (std::is_same_v<T, double> || std::is_same_v<T, int>)
    return {static_cast<double>(value)};
  else if constexpr (is_pair_of_numbers<T> || is_array_of_numbers<T>)
    return {value.begin(), value.end()};
  else
    return {};
}

/// Adds what the right-hand sides of a field mean, unless the field is a table.
template <class Inner, class Value>
void add_values(const Value& fallback, InputField& entry) {
  if constexpr (kind_of<Inner>() < Kind::table) {
    entry.numbers_in = [field = entry.field](std::string_view text) {
      return numbers_of(parsed<Inner>(text, field));
    };
    entry.states_default = [field = entry.field, fallback](std::string_view text) {
      return fallback == parsed<Inner>(text, field);
    };
  }
}

/// Adds all fields that a type can hold.
template <class T>
void add_fields(const std::string& path, std::vector<InputField>& fields) {
  if constexpr (is_optional<T>) {
    add_fields<typename T::value_type>(path, fields);
  } else if constexpr (is_string_map<T>) {
    add_fields<typename T::mapped_type>(path + ".NAME", fields);
  } else if constexpr (kind_of<T>() == Kind::kinds) {
    for_each_alternative<typename T::value_type>([&]<class Alternative>() {
      add_fields<Alternative>(path + "[" + std::string(Alternative::kKind) + "]", fields);
    });
  } else if constexpr (kind_of<T>() == Kind::tables) {
    add_fields<typename T::value_type>(path + "[]", fields);
  } else if constexpr (Described<T>) {
    T::describe([&]<class Value, class Owner>(const Field& field, Value Owner::*member) {
      using Inner = typename Unwrap<Value>::type;
      InputField entry{.path = (path.empty() ? "" : path + ".") + std::string(field.name),
                       .field = field,
                       .kind = kind_of<Inner>(),
                       .optional = is_optional<Value>,
                       .required = is_required<Value>(field)};
      const T defaults{};
      if constexpr (is_optional<Value>)
        entry.starts_absent = !(defaults.*member).has_value();
      else if constexpr (is_vector<Value>)
        entry.starts_absent = (defaults.*member).empty();
      if constexpr (std::is_enum_v<Inner>)
        entry.choices.assign(EnumNames<Inner>::names.begin(), EnumNames<Inner>::names.end());
      if constexpr (kind_of<Inner>() == Kind::kinds)
        entry.kinds = std::variant_size_v<typename Inner::value_type>;
      add_values<Inner>(defaults.*member, entry);
      fields.push_back(std::move(entry));
      add_fields<Value>(std::string(fields.back().path), fields);
    });
  }
}

const std::vector<InputField>& input_fields() {
  static const std::vector<InputField> all = [] {
    std::vector<InputField> fields;
    add_fields<GearSet>("", fields);
    return fields;
  }();
  return all;
}

TEST(InputDescriptions, BehaviourFallbacksAreTheDefaultsOfTheStructs) {
  int n = 0;
  for (const InputField& of : input_fields()) {
    if (of.field.fallback.empty()) continue;
    ASSERT_TRUE(!of.is_table() && !of.optional)
        << of.path << " has a fallback, but is a table or optional";
    ++n;
    EXPECT_TRUE(of.states_default(of.field.fallback)) << of.path;
  }
  EXPECT_GE(n, 20);
}

TEST(InputDescriptions, BehaviourFieldsThatMayBeLeftOutStartAbsent) {
  for (const InputField& of : input_fields()) EXPECT_TRUE(of.starts_absent) << of.path;
}

TEST(InputDescriptions, BehaviourExamplesAndFallbacksAreInTheirRanges) {
  for (const InputField& of : input_fields()) {
    if (of.is_table()) continue;
    ASSERT_FALSE(of.field.example.empty()) << of.path;
    for (const std::string_view text : {of.field.example, of.field.fallback}) {
      if (text.empty()) continue;
      const std::vector<double> numbers = of.numbers_in(text);
      if (of.is_number()) {
        EXPECT_EQ(numbers.size(), 1U) << of.path;
      }
      if (of.kind == Kind::pair) {
        EXPECT_EQ(numbers.size(), 2U) << of.path;
      }
      if (of.kind == Kind::numbers) {
        EXPECT_GE(numbers.size(), 2U) << of.path;
      }
      for (const double number : numbers)
        EXPECT_TRUE(of.field.range.contains(number)) << of.path << " = " << text;
    }
  }
}

TEST(InputDescriptions, BehaviourNamesUnitsAndMeaningsAreThere) {
  static const std::regex kBareKey("[A-Za-z][A-Za-z0-9_]*");
  std::set<std::string> paths;
  for (const InputField& of : input_fields()) {
    EXPECT_TRUE(std::regex_match(std::string(of.field.name), kBareKey)) << of.path;
    EXPECT_TRUE(paths.insert(of.path).second) << of.path << " is described twice";
    EXPECT_FALSE(of.field.doc.empty()) << of.path;
    const bool holds_numbers = of.is_number() || of.kind == Kind::pair || of.kind == Kind::numbers;
    EXPECT_EQ(!of.field.unit.empty(), holds_numbers) << of.path;
    if (holds_numbers) {
      EXPECT_EQ(parse_unit(of.field.unit).factor, 1) << of.path << " is not in SI";
    }
  }
  EXPECT_GT(paths.size(), 80U);
}

// --- Template ------------------------------------------------------------------------------------

TEST(InputTemplate, CrosscheckTheReaderAcceptsIt) {
  EXPECT_EQ(verdict(input_template()), "accepted");
  const GearSet gear = read_gear_set(input_template(), "template");
  EXPECT_TRUE(gear.wave_generator && gear.flexspline && gear.output_shaft);
  EXPECT_FALSE(gear.article.has_value());
  EXPECT_EQ(gear.wave_generator->crack.size(), 1U);
}

TEST(InputTemplate, BehaviourShowsEveryField) {
  const std::string text = input_template();
  const std::vector<std::string> lines = lines_of(text);
  for (const InputField& of : input_fields()) {
    if (of.is_table()) continue;
    const Field& field = of.field;
    const std::string start = std::string(field.name) + " = " + std::string(field.example);
    const bool commented = field.in_template == InTemplate::commented;
    EXPECT_TRUE(std::ranges::any_of(lines, [&](const std::string& line) {
      return (!commented && line.starts_with(start)) || line.starts_with("# " + start);
    })) << of.path;
    EXPECT_NE(text.find("# " + std::string(field.doc)), std::string::npos) << of.path;
  }
}

TEST(InputTemplate, BehaviourStatesTheFallbackAsDefault) {
  const std::string text = input_template();
  for (const InputField& of : input_fields()) {
    const std::string fallback(of.field.fallback);
    if (fallback.empty() || fallback == "\"\"") continue;
    EXPECT_NE(text.find("; default " + fallback + "\n"), std::string::npos) << of.path;
  }
}

/// Activates one commented field at a time under an active heading.
TEST(InputTemplate, InputCommentedFieldsCanBeSwitchedOn) {
  // Other fields that a field needs or contradicts, by the heading above it.
  const std::map<std::string, std::string> refused = {
      {"[material.steel] transverse_modulus", "must be given beside transverse_modulus (G12)"},
      {"[material.steel] stacking", "is read only beside ply"},
      {"[material.steel] fracture_energy",
       "is read only beside ply; a metal has a fracture_toughness"},
      {"[material.steel] reference_modulus",
       "is read only beside ply; a metal has a youngs_modulus"},
      {"[[wave_generator.crack]] stress", "is read only with stress_driver = \"given\""},
      {"[[flexspline.crack]] pitch", "must be given with count, the number of cracks, 2 or more"},
      {"[[flexspline.crack]] axial_pitch",
       "must be given with count, the number of cracks, 2 or more"},
      {"[[output_shaft.crack]] pitch", "must be given with count, the number of cracks, 2 or more"},
      {"[[flexspline.crack]] compliance_table", "is not a file beside the input"},
      {"[[flexspline.crack]] turn_table", "is not a file beside the input"},
      {"[[output_shaft.crack]] compliance_table", "is not a file beside the input"}};
  const std::vector<std::string> lines = lines_of(input_template());
  std::string heading = "top";
  int switched = 0;
  std::set<std::string> seen_refused;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (is_heading(lines[i]) || is_commented_heading(lines[i]))
      heading = lines[i].substr(0, 2) == "# " ? "" : heading_of(lines[i]);
    if (heading.empty() || !is_commented_field(lines[i])) continue;
    ++switched;
    std::vector<std::string> changed = lines;
    changed[i].erase(0, 2);
    const std::string result = verdict(joined(changed));
    const std::string name = heading + " " + key_of(lines[i]);
    const auto exception = refused.find(name);
    if (exception == refused.end()) {
      EXPECT_EQ(result, "accepted") << lines[i];
    } else {
      EXPECT_TRUE(result.ends_with(exception->second)) << name << ": " << result;
      seen_refused.insert(name);
    }
  }
  EXPECT_EQ(seen_refused.size(), refused.size());
  EXPECT_GE(switched, 12);
}

/// Activates the table at line `i` with all its fields, up to the empty line below.
void switch_on_table(std::vector<std::string>& lines, std::size_t i) {
  for (; i < lines.size() && !lines[i].empty(); ++i)
    if (lines[i].starts_with("# ")) lines[i].erase(0, 2);
}

void replace_line(std::vector<std::string>& lines, std::string_view start, std::string_view by) {
  for (std::string& line : lines)
    if (line.starts_with(start)) {
      line = by;
      return;
    }
  FAIL() << "no line " << start;
}

/// Activates every commented table, together with the fields that its comment requires.
TEST(InputTemplate, InputCommentedTablesCanBeSwitchedOn) {
  using Lines = std::vector<std::string>;
  const std::function<void(Lines&)> nothing = [](Lines&) {};
  const std::function<void(Lines&)> no_stiffness = [](Lines& lines) {
    replace_line(lines, "radial_stiffness", "");
  };
  const std::function<void(Lines&)> bearing_alone = [](Lines& lines) {
    replace_line(lines, "radial_stiffness", "");
    replace_line(lines, "contact_semi_axes", "");
  };
  const std::function<void(Lines&)> stress_not_read = [](Lines& lines) {
    // The second of the two lines belongs to the edge crack.
    const auto last = std::find_if(lines.rbegin(), lines.rend(), [](const std::string& line) {
      return line.starts_with("stress = ");
    });
    ASSERT_NE(last, lines.rend());
    last->insert(0, "# ");
    replace_line(lines, "# inner_ring_width", "inner_ring_width = \"20 mm\"");
  };
  const std::function<void(Lines&)> all_sections = [](Lines& lines) {
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (lines[i].starts_with("# [flexspline.")) switch_on_table(lines, i);
    replace_line(lines, "crack_free", "crack_free = \"sections\"");
  };
  // A pitch and positions are two ways to give a group.
  const std::function<void(Lines&)> without_group = [](Lines& lines) {
    std::erase_if(lines, [](const std::string& line) {
      return line.starts_with("pitch = ") || line.starts_with("axial_pitch = ") ||
             line.starts_with("positions = ");
    });
  };
  const std::function<void(Lines&)> without_turn_table = [&](Lines& lines) {
    without_group(lines);
    std::erase_if(lines, [](const std::string& line) { return line.starts_with("turn_table = "); });
  };
  const std::function<void(Lines&)> in_the_rim = [&](Lines& lines) {
    all_sections(lines);
    without_turn_table(lines);
  };
  const std::function<void(Lines&)> arc_on_the_diaphragm = [&](Lines& lines) {
    all_sections(lines);
    without_group(lines);
  };
  const std::function<void(Lines&)> groove_on_the_diaphragm = [&](Lines& lines) {
    all_sections(lines);
  };
  const std::function<void(Lines&)> with_spline = [](Lines& lines) {
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (lines[i].starts_with("# [circular_spline]")) switch_on_table(lines, i);
  };
  const std::function<void(Lines&)> with_bearing = [](Lines& lines) {
    replace_line(lines, "radial_stiffness", "");
    replace_line(lines, "contact_semi_axes", "");
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (lines[i].starts_with("# [wave_generator.bearing]")) switch_on_table(lines, i);
  };
  const std::function<void(Lines&)> with_outer_ring = [&](Lines& lines) {
    with_bearing(lines);
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (lines[i].starts_with("# [wave_generator.bearing.outer_ring]")) switch_on_table(lines, i);
  };
  const auto switch_on = [](Lines& lines, const std::string& heading,
                            const std::string& kind = "") {
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (lines[i].starts_with("# " + heading) &&
          (kind.empty() || lines[i + 1].starts_with("# kind = \"" + kind + "\"")))
        switch_on_table(lines, i);
  };
  const std::function<void(Lines&)> nasgro = [&](Lines& lines) {
    switch_on(lines, "[[material.steel.growth]]", "nasgro");
    switch_on(lines, "[material.steel.growth.closure]");
  };
  const std::function<void(Lines&)> tabulated = [&](Lines& lines) {
    switch_on(lines, "[[material.steel.growth]]", "tabulated");
    switch_on(lines, "[[material.steel.growth.curve]]");
  };
  // One of the two speeds, and a block.
  const std::function<void(Lines&)> with_block = [&](Lines& lines) {
    switch_on(lines, "[[duty.block]]");
    std::erase_if(lines, [](const std::string& line) {
      return line.starts_with("input_speed = ") || line.starts_with("history = ");
    });
  };
  const std::function<void(Lines&)> without_error_table = [](Lines& lines) {
    std::erase_if(lines,
                  [](const std::string& line) { return line.starts_with("error_table = "); });
  };
  const std::function<void(Lines&)> with_drivetrain = [&](Lines& lines) {
    switch_on(lines, "[drivetrain]");
    without_error_table(lines);
  };
  // The shares of the load belong to the other friction.
  const std::function<void(Lines&)> with_load_friction = [&](Lines& lines) {
    with_drivetrain(lines);
    std::erase_if(lines, [](const std::string& line) {
      return line.starts_with("load_coulomb = ") || line.starts_with("load_breakaway = ");
    });
  };
  // One of the two ways to move the input.
  const std::function<void(Lines&)> with_speed = [&](Lines& lines) {
    with_drivetrain(lines);
    std::erase_if(lines, [](const std::string& line) {
      return line.starts_with("input_torque = ") || line.starts_with("output_torque = ");
    });
  };
  // An ellipse has no numbers of its own.
  const std::function<void(Lines&)> as_ellipse = [](Lines& lines) {
    std::erase_if(lines, [](const std::string& line) {
      return line.starts_with("arc_angle = ") || line.starts_with("disc_offset = ");
    });
  };
  // A lobe, three points beside it, and the middle between the lobes.
  const std::function<void(Lines&)> with_points = [&](Lines& lines) {
    switch_on(lines, "[wave_generator.cam]");
    as_ellipse(lines);
    std::ranges::replace_if(
        lines, [](const std::string& line) { return line.starts_with("profile = \"ellipse\""); },
        "profile = \"points\"");
    const auto at = std::ranges::find_if(lines, [](const std::string& line) {
      return line.starts_with("[[wave_generator.cam.point]]");
    });
    ASSERT_NE(at, lines.end());
    Lines points;
    for (const auto& [angle, height] : {std::pair{"0 deg", "0.8 mm"},
                                        {"20 deg", "0.6 mm"},
                                        {"45 deg", "0 mm"},
                                        {"70 deg", "-0.6 mm"},
                                        {"90 deg", "-0.8 mm"}}) {
      points.emplace_back("[[wave_generator.cam.point]]");
      points.push_back("angle = \"" + std::string(angle) + '"');
      points.push_back("height = \"" + std::string(height) + '"');
    }
    lines.insert(lines.erase(at, at + 3), points.begin(), points.end());
  };
  // The strengths of a layer, and the plies of a laminate, are those of other materials.
  const std::function<void(Lines&)> of_a_layer = [](Lines& lines) {
    const auto at = std::ranges::find_if(lines, [](const std::string& line) {
      return line.starts_with("[material.steel.ply_strength]");
    });
    ASSERT_NE(at, lines.end());
    *at = "[material.layer.ply_strength]";
    const Lines layer = {"[material.layer]", "youngs_modulus = \"181 GPa\"",
                         "transverse_modulus = \"10.3 GPa\"", "shear_modulus = \"7.17 GPa\"",
                         "poissons_ratio = 0.28"};
    lines.insert(at, layer.begin(), layer.end());
  };
  const std::function<void(Lines&)> endured_by_a_layer = [](Lines& lines) {
    const auto at = std::ranges::find_if(lines, [](const std::string& line) {
      return line.starts_with("[material.steel.ply_endurance]");
    });
    ASSERT_NE(at, lines.end());
    *at = "[material.layer.ply_endurance]";
    const Lines layer = {"[material.layer]", "based_on = \"T300/5208\""};
    lines.insert(at, layer.begin(), layer.end());
  };
  const std::function<void(Lines&)> of_a_laminate = [](Lines& lines) {
    std::ranges::replace_if(
        lines, [](const std::string& line) { return line.starts_with("[[material.steel.ply]]"); },
        "[[material.tube.ply]]");
  };
  // Two quantiles, and no deviation.
  const std::function<void(Lines&)> with_quantiles = [&](Lines& lines) {
    switch_on(lines, "[[scatter]]");
    std::erase_if(lines, [](const std::string& line) {
      return line.starts_with("relative_standard_deviation = ");
    });
    replace_line(lines, "distribution = \"lognormal\"", "distribution = \"table\"");
    replace_line(lines, "probability = ", "probability = 0");
    const auto ratio = std::ranges::find_if(
        lines, [](const std::string& line) { return line.starts_with("ratio = 1.05"); });
    ASSERT_NE(ratio, lines.end());
    const Lines last = {"[[scatter.quantile]]", "probability = 1", "ratio = 1.1"};
    lines.insert(ratio + 1, last.begin(), last.end());
  };
  // A curve has no noise.
  const std::function<void(Lines&)> with_inspection = [&](Lines& lines) {
    switch_on(lines, "[inspection]");
    std::erase_if(lines, [](const std::string& line) { return line.starts_with("noise = "); });
  };
  const std::function<void(Lines&)> with_scatters = [](Lines& lines) {
    for (const char* const path : {"flexspline.wall_thickness", "flexspline.length"}) {
      lines.emplace_back("[[scatter]]");
      lines.push_back("path = \"" + std::string(path) + '"');
      lines.emplace_back("relative_standard_deviation = 0.02");
    }
  };
  struct Table {
    std::string heading;  ///< and the kind, of a crack
    std::string alone;    ///< verdict without anything else
    std::function<void(Lines&)> besides;
  };
  const std::vector<Table> tables = {
      {"[material.steel.fatigue]", "accepted", nothing},
      {"[[material.steel.growth]] paris", "accepted", nothing},
      {"[[material.steel.growth]] two_lines", "accepted", nothing},
      {"[[material.steel.growth]] walker", "accepted", nothing},
      {"[[material.steel.growth]] forman", "accepted", nothing},
      {"[[material.steel.growth]] hartman_schijve", "accepted", nothing},
      {"[[material.steel.growth]] nasgro", "closure: must be given", nasgro},
      {"[material.steel.growth.closure]", "material.steel.growth", nasgro},
      {"[[material.steel.growth]] tabulated", "curve: must be given", tabulated},
      {"[[material.steel.growth.curve]]", "material.steel.growth", tabulated},
      {"[material.steel.growth.over_thickness]", "material.steel.growth", nasgro},
      {"[material.steel.growth_bounds]", "accepted", nothing},
      {"[material.steel.growth_scatter]", "accepted", nothing},
      {"[wave_generator.displacements]", "a second source of the radial stiffness", no_stiffness},
      {"[wave_generator.bearing]", "a second source of the radial stiffness", bearing_alone},
      {"[wave_generator.bearing.outer_ring]", "wave_generator.bearing.ball_diameter: must be given",
       with_bearing},
      {"[[wave_generator.crack]] edge", "is read only with stress_driver = \"given\"",
       stress_not_read},
      {"[[wave_generator.crack]] outer_race",
       "wave_generator.bearing.outer_ring: must be given for wave_generator.crack[1]",
       with_outer_ring},
      {"[flexspline.rim]", "is read only where crack_free = \"sections\"", all_sections},
      {"[flexspline.barrel]", "is read only where crack_free = \"sections\"", all_sections},
      {"[flexspline.diaphragm]", "is read only where crack_free = \"sections\"", all_sections},
      {"[wave_generator.cam]", "wave_generator.cam.arc_angle: must be left out", as_ellipse},
      {"[material.steel.ply_strength]", "is read only beside transverse_modulus", of_a_layer},
      {"[material.steel.ply_endurance]", "is read only beside transverse_modulus",
       endured_by_a_layer},
      {"[[material.steel.ply]]", "is not read beside ply, because the plies give it",
       of_a_laminate},
      {"[[wave_generator.cam.point]]", "wave_generator.cam.profile: must be given", with_points},
      {"[[flexspline.diaphragm.profile]]", "flexspline.diaphragm.outer_diameter: must be given",
       all_sections},
      {"[flexspline.boss]", "is read only where crack_free = \"sections\"", all_sections},
      {"[[flexspline.crack]] surface", "pitch: is given beside positions", without_turn_table},
      {"[[flexspline.crack]] diaphragm_arc", "pitch: is given beside positions",
       arc_on_the_diaphragm},
      {"[[flexspline.crack]] diaphragm_groove",
       "flexspline.diaphragm: must be given for flexspline.crack[1]", groove_on_the_diaphragm},
      {"[[flexspline.crack]] rim_axial", "pitch: is given beside positions", in_the_rim},
      {"[[output_shaft.crack]] surface", "accepted", nothing},
      {"[mesh]", "accepted", nothing},
      {"[mesh.tooth]", "accepted", nothing},
      {"[[mesh.crack]] tooth", "accepted", nothing},
      {"[circular_spline]", "accepted", nothing},
      {"[[circular_spline.crack]] ring", "circular_spline.material: must be given", with_spline},
      {"[flexspline.tooth_root]", "accepted", nothing},
      {"[output_bearing]", "accepted", nothing},
      {"[duty]", "duty", with_block},
      {"[[duty.block]]", "input_speed: must not be given beside output_speed", with_block},
      {"[[duty.peak]]", "duty", with_block},
      {"[duty.resonance]", "duty", with_block},
      {"[drivetrain]", "is not a file beside the input", without_error_table},
      {"[drivetrain.hysteresis]", "drivetrain", with_drivetrain},
      {"[[drivetrain.slip_element]]", "drivetrain", with_drivetrain},
      {"[drivetrain.friction]", "drivetrain", with_drivetrain},
      {"[drivetrain.load_friction]", "drivetrain", with_load_friction},
      {"[drivetrain.servo]", "drivetrain", with_drivetrain},
      {"[[kinematic_error]]", "accepted", nothing},
      {"[[manoeuvre]]", "manoeuvre[0]: needs [drivetrain]", with_speed},
      {"[rating]", "accepted", nothing},
      {"[tolerance]", "accepted", nothing},
      {"[[range]]", "accepted", nothing},
      {"[[scatter]]", "accepted", nothing},
      {"[[scatter.quantile]]", "scatter", with_quantiles},
      {"[[correlation]]", "does not scatter", with_scatters},
      {"[inspection]", "inspection.noise: is read with the methods stiffness", with_inspection},
      {"[inspection.cost]", "inspection.a50: must be given", with_inspection},
      {"[[inspection.place]]", "inspection.a50: must be given", with_inspection},
      {"[article]", "accepted", nothing}};

  const Lines lines = lines_of(input_template());
  std::size_t found = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!is_commented_heading(lines[i])) continue;
    std::string heading = heading_of(lines[i]);
    if (const std::string kind = "# kind = \""; lines.at(i + 1).starts_with(kind))
      heading +=
          " " + lines[i + 1].substr(kind.size(), lines[i + 1].find('"', kind.size()) - kind.size());
    const auto table = std::ranges::find(tables, heading, &Table::heading);
    ASSERT_NE(table, tables.end()) << heading;
    ++found;
    Lines changed = lines;
    switch_on_table(changed, i);
    const std::string alone = verdict(joined(changed));
    EXPECT_NE(alone.find(table->alone), std::string::npos) << heading << ": " << alone;
    table->besides(changed);
    EXPECT_EQ(verdict(joined(changed)), "accepted") << heading;
  }
  EXPECT_EQ(found, tables.size());
}

TEST(InputTemplate, BehaviourItsDimensionsFitTogether) {
  const std::string text = input_template();
  const auto value_below = [&](const std::string& head, const std::string& field) {
    const std::size_t at = text.find(field + " = ", text.find("[" + head + "]"));
    const std::size_t begin = at + field.size() + 3;
    return text.substr(begin, text.find(" #", begin) - begin);
  };
  EXPECT_EQ(std::stod(value_below("flexspline.boss", "outer_diameter").substr(1)),
            std::stod(value_below("flexspline.diaphragm", "inner_diameter").substr(1)));
  EXPECT_LT(2 * std::stod(value_below("flexspline.boss", "wall_thickness").substr(1)),
            std::stod(value_below("flexspline.boss", "outer_diameter").substr(1)));
  // Each kind of crack says what it is.
  int n_kinds = 0;
  for (const InputTable& table : input_tables()) {
    if (table.kind.empty()) continue;
    ++n_kinds;
    EXPECT_NE(text.find("kind = \"" + std::string(table.kind) + "\""), std::string::npos);
    EXPECT_NE(text.find(std::string(table.meaning)), std::string::npos) << table.kind;
    EXPECT_FALSE(table.meaning.empty()) << table.kind;
  }
  EXPECT_EQ(n_kinds, 19);
}

TEST(InputTemplate, BehaviourHasNoLineThatIsNeitherFieldNorHeadingNorComment) {
  const std::vector<std::string> lines = lines_of(input_template());
  int prose = 0;
  for (const std::string& line : lines) {
    EXPECT_TRUE(line.empty() || line.find(" = ") != std::string::npos || is_heading(line) ||
                line.starts_with("# "))
        << line;
    if (line.starts_with("# ") && !is_commented_field(line) && !is_commented_heading(line)) ++prose;
    EXPECT_EQ(line.find_last_not_of(' ') + 1, line.size()) << line;
  }
  EXPECT_EQ(prose, 2);
}

// --- What may be left out ------------------------------------------------------------------------

/// The path of the live line `i` as `input_fields` spells it.
std::string path_of(const std::vector<std::string>& lines, std::size_t i) {
  std::string table;
  std::string kind;
  for (std::size_t j = 0; j <= i; ++j) {
    if (is_heading(lines[j])) {
      table = heading_of(lines[j]);
      kind.clear();
    }
    if (lines[j].starts_with("kind = "))
      kind = "[" + lines[j].substr(8, lines[j].find('"', 8) - 8) + "]";
  }
  std::erase_if(table, [](char c) { return c == '[' || c == ']'; });
  if (table == "material.steel") table = "material.NAME";
  return (table.empty() ? "" : table + kind + ".") + key_of(lines[i]);
}

std::set<std::string> required_paths() {
  std::set<std::string> paths;
  for (const InputField& of : input_fields())
    if (of.required) paths.insert(of.path);
  return paths;
}

TEST(InputFormat, CrosscheckRequiredFieldsAreThoseThatTheReaderMisses) {
  // Optional fields of the template that a rule between fields requires.
  const std::map<std::string, std::string> asked_for = {
      // the template gives E with nu only
      {"material.NAME.poissons_ratio", "must be given, or shear_modulus"},
      // the only source of the radial stiffness
      {"wave_generator.radial_stiffness", "must be given (K_G0 of one lobe [N/m]), or"},
      // the template has a crack in the ring, stressed by the contact
      {"wave_generator.contact_semi_axes", "stress_driver = \"orthogonal_shear\" needs it"},
      {"wave_generator.inner_ring_thickness", "must be given for wave_generator.crack[0]"},
      // the template's cup is a tube with a factor
      {"flexspline.wall_thickness", "must be given where crack_free = \"factor\""},
      {"flexspline.length", "must be given where crack_free = \"factor\""}};
  const std::set<std::string> required = required_paths();
  std::set<std::string> seen;
  const std::vector<std::string> lines = lines_of(input_template());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].empty() || lines[i].front() == '#' || is_heading(lines[i])) continue;
    const std::string path = path_of(lines, i);
    std::vector<std::string> changed = lines;
    changed[i].clear();
    const std::string result = verdict(joined(changed));
    seen.insert(path);
    if (path.ends_with(".kind")) {
      EXPECT_NE(result.find("kind: must be given, one of "), std::string::npos) << result;
    } else if (required.contains(path)) {
      EXPECT_NE(result.find(key_of(lines[i]) + ": must be given ("), std::string::npos)
          << path << ": " << result;
    } else if (asked_for.contains(path)) {
      EXPECT_NE(result.find(asked_for.at(path)), std::string::npos) << path << ": " << result;
    } else {
      EXPECT_EQ(result, "accepted") << path;
    }
  }
  for (const auto& [path, reason] : asked_for) EXPECT_TRUE(seen.contains(path)) << path;
}

TEST(InputFormat, CrosscheckRequiredTablesAreThoseThatTheReaderMisses) {
  const std::set<std::string> required = required_paths();
  for (const auto& [heading, path] :
       std::vector<std::pair<std::string, std::string>>{{"[material.steel]", "material"},
                                                        {"[drive]", "drive"},
                                                        {"[load]", "load"},
                                                        {"[wave_generator]", "wave_generator"},
                                                        {"[flexspline]", "flexspline"},
                                                        {"[output_shaft]", "output_shaft"}}) {
    // Leave out every table whose heading starts like this one, with its fields.
    std::vector<std::string> kept;
    bool skip = false;
    const std::string inner = heading.substr(0, heading.size() - 1);
    for (const std::string& line : lines_of(input_template())) {
      if (is_heading(line)) skip = line.starts_with(inner) || line.starts_with("[" + inner);
      if (!skip) kept.push_back(line);
    }
    // Without materials of its own, a file can still name those of the library.
    if (path == "material")
      for (std::string& line : kept)
        if (const std::size_t at = line.find("material = \"steel\""); at != std::string::npos)
          line.replace(at, 18, "material = \"52100 hardened\"");
    const std::string result = verdict(joined(kept));
    if (required.contains(path))
      EXPECT_NE(result.find(path + ": must be given ("), std::string::npos) << result;
    else
      EXPECT_EQ(result, "accepted") << path;
  }
}

// --- Schema --------------------------------------------------------------------------------------

/// The schema of the value at a path of `input_fields`.
const Json& schema_at(const Json& schema, const std::string& path) {
  const Json* at = &schema;
  std::size_t start = 0;
  while (start < path.size()) {
    const std::size_t end = std::min(path.find('.', start), path.size());
    std::string name = path.substr(start, end - start);
    std::string kind;
    if (const std::size_t bracket = name.find('['); bracket != std::string::npos) {
      kind = name.substr(bracket + 1, name.size() - bracket - 2);
      name.resize(bracket);
    }
    at = name == "NAME" ? &at->at("additionalProperties") : &at->at("properties").at(name);
    if (at->value("type", Json()) == "array" && kind.empty() && path[end - 1] == ']') {
      at = &at->at("items");  // elements of one kind
    } else if (!kind.empty()) {
      const Json& choices = at->at("items").at("oneOf");
      const auto choice = std::ranges::find_if(choices, [&](const Json& one) {
        return one.at("properties").at("kind").at("const") == kind;
      });
      if (choice == choices.end()) throw std::out_of_range("no kind " + kind);
      at = &*choice;
    }
    start = end + 1;
  }
  return *at;
}

Json schema() { return Json::parse(input_schema()); }

TEST(InputSchema, BehaviourIsAJsonSchemaOfTheDeclaredDraft) {
  const Json s = schema();
  EXPECT_EQ(s.at("$schema"), "https://json-schema.org/draft/2020-12/schema");
  EXPECT_EQ(s.at("$id"), "urn:strainwave:drive:1");
  EXPECT_EQ(s.at("type"), "object");
  EXPECT_EQ(s.at("properties").at("format").at("const"), kDriveFormat);
  EXPECT_TRUE(input_schema().ends_with("}\n"));
}

/// Calls `f` for each object of the schema that describes a table.
void for_each_table(const Json& s, const std::function<void(const Json&)>& f) {
  if (s.is_object() && s.value("type", Json()) == "object" && s.contains("properties")) f(s);
  if (s.is_structured())
    for (const Json& inner : s) for_each_table(inner, f);
}

TEST(InputSchema, BehaviourTablesAreClosedAndRequireOnlyWhatTheyHave) {
  int n = 0;
  for_each_table(schema(), [&](const Json& table) {
    ++n;
    EXPECT_EQ(table.at("additionalProperties"), false) << table;
    for (const Json& name : table.value("required", Json::array()))
      EXPECT_TRUE(table.at("properties").contains(name)) << name;
    std::set<std::string> unique;
    for (const Json& name : table.value("required", Json::array()))
      EXPECT_TRUE(unique.insert(name).second) << name;
  });
  EXPECT_EQ(n, 72);
}

TEST(InputSchema, BehaviourHasEveryFieldAndNoOther) {
  const Json s = schema();
  for (const InputField& of : input_fields()) {
    const Field& field = of.field;
    const auto description = schema_at(s, of.path).at("description").get<std::string>();
    EXPECT_TRUE(description.starts_with(field.doc)) << of.path;
    const bool has_unit = !field.unit.empty() && field.unit != "1";
    EXPECT_EQ(description.find(" [" + std::string(field.unit) + "]; ") != std::string::npos,
              has_unit)
        << of.path;
  }
  std::size_t properties = 0;
  for_each_table(s, [&](const Json& table) {
    for (const auto& [name, property] : table.at("properties").items())
      if (name != "kind") ++properties;
  });
  EXPECT_EQ(properties, input_fields().size());
}

TEST(InputSchema, BehaviourRequiredIsWhatTheReaderDemands) {
  const Json s = schema();
  for (const InputField& of : input_fields()) {
    const std::string& path = of.path;
    const std::size_t dot = path.rfind('.');
    const Json& table = dot == std::string::npos ? s : schema_at(s, path.substr(0, dot));
    const Json names = table.value("required", Json::array());
    EXPECT_EQ(std::ranges::find(names, of.field.name) != names.end(),
              of.required && of.field.unless.front().empty())
        << path;
    // The schema gives a default exactly for fields with a fallback.
    EXPECT_EQ(schema_at(s, path).contains("default"), !of.field.fallback.empty()) << path;
  }
  for (const char* const member : {"wave_generator", "flexspline", "output_shaft"}) {
    const Json& items = s.at("properties").at(member).at("properties").at("crack").at("items");
    for (const Json& kind : items.at("oneOf"))
      EXPECT_EQ(kind.at("required").at(0), "kind") << member;
  }
}

/// Expects the bounds of a range in the schema of a pure number.
void expect_bounds(const Json& property, const Range& range, const std::string& path) {
  const auto expect = [&](const char* key, double value, bool here) {
    EXPECT_EQ(property.contains(key), here && std::isfinite(value)) << path << " " << key;
    if (property.contains(key)) {
      EXPECT_EQ(property.at(key).get<double>(), value) << path << " " << key;
    }
  };
  expect("minimum", range.lower, !range.lower_open);
  expect("exclusiveMinimum", range.lower, range.lower_open);
  expect("maximum", range.upper, !range.upper_open);
  expect("exclusiveMaximum", range.upper, range.upper_open);
}

TEST(InputSchema, BehaviourTypesRangesAndDefaults) {
  const Json s = schema();
  for (const InputField& of : input_fields()) {
    const auto& [path, field] = std::tie(of.path, of.field);
    if (path == "format") continue;
    const Json& property = schema_at(s, path);
    const Json type = property.value("type", Json());
    const std::string of_number = field.unit == "1" ? "number" : "string";
    switch (of.kind) {
      case Kind::number:
      case Kind::integer:
        if (field.unit == "1") {
          EXPECT_EQ(type, of.kind == Kind::integer ? "integer" : "number") << path;
          expect_bounds(property, field.range, path);
        } else {
          EXPECT_EQ(type, "string") << path;
          EXPECT_TRUE(property.contains("pattern")) << path;
        }
        break;
      case Kind::flag:
        EXPECT_EQ(type, "boolean") << path;
        break;
      case Kind::text:
        EXPECT_EQ(type, field.number_text ? Json({"string", "number"}) : Json("string")) << path;
        break;
      case Kind::choice:
        EXPECT_EQ(property.at("enum"), Json(of.choices)) << path;
        break;
      case Kind::pair:
        EXPECT_EQ(property.at("minItems"), 2) << path;
        EXPECT_EQ(property.at("maxItems"), 2) << path;
        [[fallthrough]];
      case Kind::numbers:
        EXPECT_EQ(type, "array") << path;
        EXPECT_EQ(property.at("items").at("type"), of_number) << path;
        break;
      case Kind::kinds:
        EXPECT_EQ(type, "array") << path;
        EXPECT_EQ(property.at("items").at("oneOf").size(), of.kinds) << path;
        break;
      case Kind::tables:
        EXPECT_EQ(type, "array") << path;
        EXPECT_EQ(property.at("items").at("type"), "object") << path;
        break;
      case Kind::table:
        EXPECT_EQ(type, "object") << path;
        break;
    }
    if (property.contains("default")) {
      EXPECT_EQ(property.at("default"), Json::parse(field.fallback)) << path;
    }
  }
}

/// Whether the reader accepts a text as a quantity of a field, without regard to other fields.
bool reader_takes(const Field& field, const std::string& text) {
  try {
    return field.range.contains(parse_quantity("field", text, field.unit));
  } catch (const InputError&) {
    return false;
  }
}

TEST(InputSchema, CrosscheckThePatternsOfQuantitiesAgreeWithTheReader) {
  const Json s = schema();
  std::vector<std::string> texts = {"",        " ",      "2",       "2.24",   "100",    "-1",
                                    "1e5",     "1.5e-3", "1e5 ",    "mm",     "nan mm", "inf mm",
                                    "thick",   "0.",     "12 3",    "5 mm^2", "5 J",    "5 kg",
                                    "0x1p3 m", "1,5 mm", "5 mm mm", "5 /m",   "5 m/",   "2 (mm"};
  for (const char* const number :
       {"2.24 ", "2.24", " 2.24 ", "+2.24 ", ".5 ", "5. ", "1e-3 ", "1E+3 ", "-45 ", "0 "})
    for (const char* const unit :
         {"mm",        "m",         "\u00B5m",     "um",        "km",      "mm ",
          "deg",       "rad",       "mrad",        "arcmin",    "N",       "kN",
          "N*m",       "Nm",        "N*mm",        "mm*N",      "kN*m",    "Pa",
          "MPa",       "GPa",       "N/mm^2",      "N/mm/mm",   "N/mm",    "N/m",
          "MPa*m^0.5", "MPa*mm^.5", "N/mm^1.5",    "rad/(N*m)", "1/(N*m)", "arcmin/Nm",
          "Hz",        "s",         "K",           "%",         "1",       "kg/m^3",
          "g/cm^3",    "kg*m^2",    "g*cm^2",      "cm^2*kg",   "kg*m",    "N*m/rad",
          "Nm/arcmin", "N*m*s/rad", "N*m/(rad/s)", "mNm*s/rad"})
      texts.push_back(std::string(number) + unit);
  int fields = 0;
  for (const InputField& of : input_fields()) {
    const auto& [path, field] = std::tie(of.path, of.field);
    if (of.kind != Kind::number || field.unit == "1") continue;
    ++fields;
    const std::regex pattern(schema_at(s, path).at("pattern").get<std::string>());
    EXPECT_TRUE(std::regex_search(unquoted(field.example), pattern)) << path;
    for (const std::string& text : texts) {
      // Bounds other than 0 are in the description.
      const bool in_pattern = std::regex_search(text, pattern);
      if (field.range.lower <= 0 && !std::isfinite(field.range.upper)) {
        EXPECT_EQ(in_pattern, reader_takes(field, text)) << path << ": " << text;
      } else if (!in_pattern) {
        EXPECT_FALSE(reader_takes(field, text)) << path << ": " << text;
      }
    }
  }
  EXPECT_GT(fields, 50);
}

// --- Reference -----------------------------------------------------------------------------------

TEST(InputReference, BehaviourHasARowForEveryField) {
  const std::string text = input_reference();
  int tables = 0;
  for (const std::string& line : lines_of(text)) {
    if (line.starts_with("## ")) ++tables;
    // A bar inside a cell would break the table.
    if (line.starts_with("|")) {
      EXPECT_EQ(std::ranges::count(line, '|'), 6) << line;
    }
  }
  EXPECT_EQ(tables, 72);
  for (const InputField& of : input_fields()) {
    const std::string doc(of.field.doc);
    if (of.is_table()) {
      EXPECT_NE(text.find("`: " + doc + "\n\n| field |"), std::string::npos) << of.path;
    } else {
      EXPECT_NE(text.find("| `" + std::string(of.field.name) + "` | "), std::string::npos)
          << of.path;
      EXPECT_NE(text.find("| " + doc + " |\n"), std::string::npos) << of.path;
    }
  }
}

TEST(InputReference, BehaviourThePageOfTheGuideIsUpToDate) {
  const std::filesystem::path page =
      std::filesystem::path(STRAINWAVE_EXAMPLES) / ".." / "docs" / "guide" / "input_file.md";
  ASSERT_TRUE(std::filesystem::exists(page)) << page;
  std::ostringstream text;
  text << std::ifstream(page, std::ios::binary).rdbuf();
  EXPECT_EQ(text.str(), input_reference())
      << "write it anew: strainwave schema --format markdown > docs/guide/input_file.md";
}

TEST(InputFormat, BehaviourAMaterialNeedsYoungsModulusOrARecord) {
  const auto schema = nlohmann::json::parse(input_schema());
  const auto& material = schema["properties"]["material"]["additionalProperties"];
  EXPECT_EQ(
      material["anyOf"],
      nlohmann::json::parse(
          R"([{"required":["youngs_modulus"]},{"required":["based_on"]},{"required":["ply"]}])"));
  EXPECT_FALSE(material.contains("required"));
  EXPECT_NE(input_reference().find("required unless `based_on` or `ply` is given"),
            std::string::npos);
}

}  // namespace
}  // namespace strainwave
