// SPDX-License-Identifier: Apache-2.0
#include "strainwave/command/options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "strainwave/core/nearest.hpp"
#include "strainwave/core/quantity_text.hpp"

namespace strainwave {

double option_quantity(std::string_view option, std::string_view text, std::string_view unit) {
  return from_option([&] { return parse_quantity(option, text, unit); });
}

std::string Option::spelled() const {
  std::string name(field.name);
  std::ranges::replace(name, '_', '-');
  return name;
}

namespace detail {

double number_option(const Field& field, std::string_view text) {
  return from_option([&] {
    const double value = parse_quantity(field.name, text, field.unit);
    require(field.range.contains(value), field.name, value, field.unit,
            rule_text(field.range, field.unit));
    return value;
  });
}

std::int64_t whole_option(const Field& field, std::string_view text, std::int64_t least,
                          std::int64_t most) {
  std::int64_t value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool too_large = fault == std::errc::result_out_of_range;
  if ((fault != std::errc() && !too_large) || end != text.data() + text.size())
    throw OptionError(field.name, fmt::format("{} is not a whole number, such as 100",
                                              text.empty() ? "\"\"" : shown(text)));
  if (!too_large && value >= least && value <= most &&
      field.range.contains(static_cast<double>(value)))
    return value;
  std::string rule = rule_text(field.range);
  if (!std::isfinite(field.range.upper))
    rule = fmt::format("{} and <= {}",
                       std::isfinite(field.range.lower) ? rule : fmt::format(">= {}", least), most);
  throw OptionError(field.name, fmt::format("{} violates: {}", shown(text), rule));
}

bool flag_option(const Field& field, std::string_view text) {
  if (text == "true") return true;
  if (text == "false") return false;
  throw OptionError(field.name, fmt::format("{} must be true or false", shown(text)));
}

void refuse_choice(const Field& field, std::string_view text,
                   std::span<const std::string_view> choices) {
  throw OptionError(field.name, fmt::format("{} is not a choice here; choose one of {}",
                                            shown(text), fmt::join(choices, ", ")));
}

void refuse_unknown_option(std::string_view name, std::span<const Option> known) {
  std::vector<std::string> names;
  for (const Option& option : known) names.emplace_back(option.field.name);
  const std::string near = nearest_word(name, names);
  throw OptionError(shown(name),
                    near.empty() ? fmt::format("is not an option here; known options are {}",
                                               fmt::join(names, ", "))
                                 : fmt::format("is not an option here; did you mean {}?", near));
}

}  // namespace detail

bool OptionValues::given(std::string_view name) const {
  return std::ranges::find(given_, name, &std::pair<std::string, std::string>::first) !=
         given_.end();
}

void OptionValues::set(std::string_view name, std::string_view text) {
  const auto found = std::ranges::find(type_->options, name,
                                       [](const Option& option) { return option.field.name; });
  if (found == type_->options.end()) detail::refuse_unknown_option(name, type_->options);
  if (given(name) && !found->repeatable) throw OptionError(name, "is given twice; give it once");
  type_->set(values_.get(), name, text);
  given_.emplace_back(name, text);
}

void OptionValues::set_from_json(std::string_view json) {
  const auto options = nlohmann::ordered_json::parse(json, nullptr, false);
  if (!options.is_object()) throw OptionError("options", "the text must be a JSON object");
  const auto one = [&](const std::string& name, const nlohmann::ordered_json& value) {
    if (value.is_structured() || value.is_null())
      throw OptionError(name, "must be text, a number, true or false");
    set(name, value.is_string() ? value.get<std::string>() : value.dump());
  };
  for (const auto& [name, value] : options.items())
    if (value.is_array())
      for (const auto& element : value) one(name, element);
    else
      one(name, value);
}

void OptionValues::require_complete() const {
  for (const Option& option : type_->options)
    if (option.required && !given(option.field.name))
      throw OptionError(option.field.name, fmt::format("must be given ({})", option.field.doc));
}

}  // namespace strainwave
