// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/fracture/erased_crack.hpp"
#include "strainwave/sif/library.hpp"

// Turns a solution into a row of the library.

namespace strainwave::sif {

template <Solution S>
class CrackOf final : public AnyCrack {
 public:
  explicit CrackOf(const S& solution) : solution_(solution) {
    S::describe([&](const Field&, auto member) { values_.push_back(solution_.*member); });
  }

  [[nodiscard]] double size() const override { return solution_.size(); }
  [[nodiscard]] FrontRange front() const override { return solution_.front(); }
  [[nodiscard]] PointIntensity unit_intensity(std::size_t load, double a, double s) const override {
    const auto k = solution_.stress_intensity(a, s);
    return {.name = {}, .s = s, .K_I = k.I[load], .K_II = k.II[load], .K_III = k.III[load]};
  }
  [[nodiscard]] double swept_area(double a, double s) const override {
    return solution_.swept_area(a, s);
  }
  [[nodiscard]] double gross_stress(std::size_t load, double a) const override {
    if constexpr (requires { solution_.gross_stress(load, a); })
      return solution_.gross_stress(load, a);
    else
      return solution_.gross_stress(load);
  }
  [[nodiscard]] std::vector<ValidityLimit> validity() const override {
    std::vector<ValidityLimit> limits;
    solution_.validity([&](bool inside, std::string_view text) {
      limits.push_back({inside, text});
    });
    return limits;
  }
  [[nodiscard]] std::vector<std::string_view> rules() const override {
    std::vector<std::string_view> texts;
    solution_.check([&](bool, std::string_view, double, std::string_view, std::string_view rule) {
      texts.push_back(rule);
    });
    return texts;
  }
  [[nodiscard]] Compliance compliance(const CrackModuli& moduli) const override {
    const auto result = compliance_of(ErasedCrack<S::kLoads>(solution_), moduli);
    return {.upper = {result.matrix.upper.begin(), result.matrix.upper.end()},
            .relative_error = result.relative_error,
            .converged = result.converged};
  }
  [[nodiscard]] const std::vector<double>& values() const override { return values_; }

 private:
  S solution_;
  std::vector<double> values_;
};

/// The value of a field's example, a quantity text or a bare number.
[[nodiscard]] double example_value(const Field& field);

/// Throws InputError unless a number is inside the range of its field.
void require_in_range(const Field& field, double value);

/// "; do you mean half_length?", or an empty text if no known word is near.
[[nodiscard]] std::string near_text(std::string_view word, std::span<const std::string> known);

/// Row of a solution.
template <Solution S>
[[nodiscard]] Row row() {
  Row result{.info = S::kInfo,
             .loads = {S::kLoadInfo.begin(), S::kLoadInfo.end()},
             .points = {S::kPoints.begin(), S::kPoints.end()},
             .fields = {},
             .make = {}};
  S::describe([&](const Field& field, auto member) {
    static_assert(std::is_same_v<decltype(member), double S::*>, "numbers only");
    result.fields.push_back(field);
  });
  result.make = [](const Assignments& values) -> std::unique_ptr<AnyCrack> {
    S solution;
    std::vector<std::string> known;
    S::describe([&](const Field& field, auto member) {
      known.emplace_back(field.name);
      const auto given = values.find(field.name);
      solution.*member = given != values.end() ? given->second : example_value(field);
      require_in_range(field, solution.*member);
    });
    for (const auto& [name, value] : values)
      if (std::ranges::find(known, name) == known.end())
        throw InputError(
            name, "is not a field of " + std::string(S::kInfo.name) + near_text(name, known));
    solution.check([](bool ok, std::string_view field, double value, std::string_view unit,
                      std::string_view rule) { require(ok, field, value, unit, rule); });
    return std::make_unique<CrackOf<S>>(solution);
  };
  return result;
}

/// The families, each in a source of its own: one row for each solution.
[[nodiscard]] std::vector<Row> plate_rows();
[[nodiscard]] std::vector<Row> tube_rows();
[[nodiscard]] std::vector<Row> bar_rows();
[[nodiscard]] std::vector<Row> gradient_rows();

}  // namespace strainwave::sif
