// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fe_study/influence.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/gear_fem/crack_influence.hpp"

namespace strainwave::fe_study {
namespace {

using gear_fem::ContactGrid;
using gear_fem::CrackInfluence;
using gear_fem::kUnitTractions;

/// Numbers are whole multiples of the scale of their block over this one.
constexpr double kScaleSteps = 1e6;

std::string head_text(const InfluenceGrid& grid, std::span<const double> stations) {
  const ContactGrid contact = gear_fem::contact_grid();
  std::vector<double> degrees;
  for (const double angle : grid.angles) degrees.push_back(angle / units::deg);
  return fmt::format(
      "# A through crack of a tube under unit tractions on its faces (FE-56).\n"
      "# Written by strainwave fe influence.\n"
      "steps {:.0f}\npoissons_ratio 0.3\nstations {:.10g}\ncontact_along {:.10g}\n"
      "contact_across {:.10g}\nhalf_lengths {:.10g}\nradii {:.10g}\nangles {:.10g}\n",
      kScaleSteps, fmt::join(stations, " "), fmt::join(contact.along, " "),
      fmt::join(contact.across, " "), fmt::join(grid.half_lengths, " "), fmt::join(grid.radii, " "),
      fmt::join(degrees, " "));
}

/// The stations of a front, which the number and order of the layers give.
constexpr std::array kStations = {-1.0, -0.5, 0.0, 0.5, 1.0};

/// A block of numbers: its scale, then whole multiples of scale/kScaleSteps.
std::string block_text(std::string_view name, const std::vector<double>& numbers) {
  double scale = 0;
  for (const double number : numbers) scale = std::max(scale, std::abs(number));
  std::string text = fmt::format(" {} {:.8g}", name, scale);
  for (const double number : numbers)
    text += fmt::format(" {}", std::lround(number / scale * kScaleSteps));
  return text;
}

/// The hat at the mirrored place along the crack.
std::size_t mirrored(const ContactGrid& grid, std::size_t hat) {
  const std::size_t n = grid.across.size();
  return (grid.along.size() - 1 - hat / n) * n + hat % n;
}

std::string case_text(double half_length, double radius, double angle,
                      const CrackInfluence& crack) {
  const ContactGrid grid = gear_fem::contact_grid();
  std::vector<double> K;
  for (const std::vector<double>& row : crack.K) K.insert(K.end(), row.begin(), row.end());
  // Half a turn about the radius through its middle maps the crack onto itself, so the gaps of the
  // upper half follow from those of the lower half.
  std::vector<double> gap;
  std::vector<double> pressed;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (i <= mirrored(grid, i))
      gap.insert(gap.end(), crack.gap[i].begin(), crack.gap[i].begin() + kUnitTractions);
    for (std::size_t j = i; j < grid.size(); ++j) {
      const auto [one, other] = std::minmax({mirrored(grid, i), mirrored(grid, j)});
      if (std::pair(i, j) <= std::pair(one, other))
        pressed.push_back(crack.gap[i][kUnitTractions + j]);
    }
  }
  return fmt::format("case {:.10g} {:.10g} {:.10g}", half_length, radius, angle / units::deg) +
         block_text("K", K) + block_text("gap", gap) + block_text("pressed", pressed) + "\n";
}

/// The whole lines of a case in the text of a table.
std::size_t cases_in(const std::string& text, const std::string& head, const std::string& name,
                     std::size_t& whole) {
  if (!text.starts_with(head))
    throw InputError(name, "is a table of other cracks; remove it or give another file");
  std::size_t count = 0;
  whole = head.size();
  for (std::size_t end = text.find('\n', whole); end != std::string::npos;
       end = text.find('\n', whole)) {
    ++count;
    whole = end + 1;
  }
  return count;
}

}  // namespace

InfluenceGrid influence_grid() {
  return {.half_lengths = {0.5, 1, 2, 4, 8, 16},
          .radii = {30, 60, 120},
          .angles = {0, 22.5 * units::deg, 45 * units::deg, 67.5 * units::deg, 90 * units::deg}};
}

InfluenceOutcome run_influence(const InfluenceGrid& grid, Journal* table, const Ranks& ranks,
                               const Progress& progress) {
  InfluenceOutcome outcome{.table = {}, .cracks = grid.size()};
  const std::string head = head_text(grid, kStations);
  ranks.together([&] {
    if (table == nullptr) return;
    outcome.table = table->name();
    const auto there = table->text();
    if (!there || there->empty()) {
      table->begin(head);
      return;
    }
    std::size_t whole = 0;
    outcome.found = std::min(cases_in(*there, head, table->name(), whole), grid.size());
    if (whole < there->size()) table->begin(there->substr(0, whole));
  });
  outcome.found =
      static_cast<std::size_t>(std::stoul(ranks.from_first(fmt::format("{}", outcome.found))));
  std::size_t n = 0;
  for (const double half_length : grid.half_lengths)
    for (const double radius : grid.radii)
      for (const double angle : grid.angles) {
        if (n++ < outcome.found) continue;
        const auto start = std::chrono::steady_clock::now();
        const CrackInfluence crack =
            gear_fem::crack_influence(gear_fem::influence_tube(half_length, radius, angle));
        outcome.unknowns = std::max(outcome.unknowns, crack.unknowns);
        outcome.asymmetry = std::max(outcome.asymmetry, crack.asymmetry);
        if (!std::ranges::equal(crack.stations, kStations))
          throw SolverError("the stations of the fronts are not those of the table");
        ranks.together([&] {
          if (table != nullptr) table->append(case_text(half_length, radius, angle, crack));
        });
        progress.say(fmt::format(
            "crack {} of {}: {:.1f} s", n, grid.size(),
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()));
      }
  return outcome;
}

ResultEvidence evidence_of(const InfluenceOutcome& outcome) {
  ResultEvidence evidence{.unusable_because = {},
                          .refused = false,
                          .verdict = {},
                          .notes = {},
                          .equations = {"FE-54", "FE-56"},
                          .accuracies = {},
                          .requirement = {}};
  // Reciprocity is exact for exact integrals of the hats; the lumped areas of the nodes leave this.
  if (!(outcome.asymmetry <= 0.05))
    evidence.unusable_because =
        fmt::format("the gaps differ from reciprocity by {:.2g}", outcome.asymmetry);
  evidence.verdict = verdict_of(evidence.unusable_because, evidence.notes);
  return evidence;
}

std::string influence_text(const InfluenceOutcome& outcome) {
  return fmt::format("{}: {} cracks, {} of them there before\n", outcome.table, outcome.cracks,
                     outcome.found);
}

}  // namespace strainwave::fe_study
