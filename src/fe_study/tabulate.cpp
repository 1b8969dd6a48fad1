// SPDX-License-Identifier: Apache-2.0
#include "strainwave/fe_study/tabulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <sstream>

#include "along_front.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/core/sha256.hpp"
#include "strainwave/core/version.hpp"
#include "strainwave/fe_study/memory.hpp"
#include "strainwave/fem/memory_error.hpp"
#include "strainwave/io/gear_writer.hpp"
#include "strainwave/model/input/crack_parameters.hpp"
#include "strainwave/model/input/vary_option.hpp"

namespace strainwave::fe_study {
namespace {

constexpr std::string_view kOver = "--over";
constexpr std::string_view kComplianceUnit = "rad/(N*m)";
constexpr std::array<std::string_view, 2> kSenses = {"positive", "negative"};
constexpr std::array<std::string_view, 3> kModes = {"I", "II", "III"};

// (FE-42): error that remains if all checks agree, measured against other programs.
constexpr double kTubeErrorAtBest = 2e-3;  // order 3 and 4
constexpr double kTubeErrorAtBestOrder2 = 2e-2;
constexpr double kShaftErrorAtBest = 2e-4;  // five depths of (FE-8)

/// A kind of crack in a table.  Another kind needs another value of this type.
struct Family {
  int order = 0;  ///< default order p
  std::string_view equations;
  std::string_view held;
  std::vector<TableColumn> columns;
  /// The row of the only crack of a run, without place and time.
  std::function<TablePoint(const RunResult&)> row;
};

// ---------------------------------------------------------------------------------------------
// Through crack of a tube

TablePoint tube_row(const RunResult& result) {
  const auto& run = std::get<TubeCrackRun>(result.flexspline.cracks.front());
  const double T = run.tube.torque;
  const std::array<const gear_fem::TubeCrackResult*, 2> senses = {&run.positive, &run.negative};
  TablePoint row;
  for (const auto* const one : senses) row.values.emplace_back(one->added_compliance);
  for (const auto* const one : senses) row.values.emplace_back(one->energy_release_rate / (T * T));
  for (const auto* const one : senses) {
    const fem::CrackFront& front = one->solid.fronts.front();
    const bool closed = one->closed;
    const std::array<AlongFront, 3> K = {
        along(front, [&](const fem::FrontStation& s) { return closed ? 0.0 : s.K_I / T; }),
        along(front, [&](const fem::FrontStation& s) { return s.K_II / T; }),
        along(front, [&](const fem::FrontStation& s) { return s.K_III / T; })};
    for (const AlongFront& mode : K)
      for (const double v : {mode.mean, mode.least, mode.largest}) row.values.emplace_back(v);
  }
  row.relative_error = table_error(run);
  row.unknowns = run.positive.solid.dofs;
  return row;
}

Family tube_family() {
  Family family{.order = kSolidOrder,
                .equations = "FE-23 FE-24 FE-26 FE-28 FE-42",
                .held =
                    "alone in a tube that is clamped at one end and twisted at the other, at its "
                    "distance or halfway; K of the tip toward +z, from the inner face to the "
                    "outer",
                .columns = {},
                .row = tube_row};
  const auto add = [&](const std::string& name, std::string_view unit) {
    family.columns.push_back({name, std::string(unit)});
  };
  for (const auto sense : kSenses) add(fmt::format("added_compliance_{}", sense), kComplianceUnit);
  for (const auto sense : kSenses)
    add(fmt::format("energy_release_rate_{}", sense), "J/(m^2*N^2*m^2)");
  for (const auto sense : kSenses)
    for (const auto mode : kModes)
      for (const char* const which : {"mean", "min", "max"})
        add(fmt::format("K_{}_{}_{}", mode, which, sense), "Pa*m^0.5/(N*m)");
  return family;
}

// ---------------------------------------------------------------------------------------------
// Annular crack of a shaft

TablePoint shaft_row(const RunResult& result) {
  const ShaftCrackRun& run = result.output_shaft.cracks.front();
  const gear_fem::ShaftCrackLoad& torsion = run.result.torsion;
  const gear_fem::ShaftCrackLoad& tension = run.result.tension;
  TablePoint row;
  row.values = {torsion.added_compliance,
                tension.added_compliance,
                torsion.tip.energy_release_rate,
                tension.tip.energy_release_rate,
                torsion.tip.K_III,
                tension.tip.K_I,
                tension.tip.K_II};
  row.relative_error = table_error(run);
  row.unknowns = tension.dofs;
  return row;
}

Family shaft_family() {
  return {.order = kSectionOrder,
          .equations = "FE-3 FE-6 FE-7 FE-8 FE-9 FE-42",
          .held = "alone, halfway along the shaft; K is the same all round",
          .columns = {{"added_compliance_torsion", std::string(kComplianceUnit)},
                      {"added_compliance_tension", "m/N"},
                      {"energy_release_rate_torsion", "J/(m^2*N^2*m^2)"},
                      {"energy_release_rate_tension", "J/(m^2*N^2)"},
                      {"K_III_torsion", "Pa*m^0.5/(N*m)"},
                      {"K_I_tension", "Pa*m^0.5/N"},
                      {"K_II_tension", "Pa*m^0.5/N"}},
          .row = shaft_row};
}

Family family_of(std::string_view kind) {
  if (kind == WallThroughCrack::kKind) return tube_family();
  if (kind == AnnularCrack::kKind) return shaft_family();
  throw InputError("--crack", fmt::format("tables do not support cracks of kind \"{}\"", kind));
}

// ---------------------------------------------------------------------------------------------

/// The selected crack: the named one, or the only one that can have a table.
std::string chosen_crack(const GearSet& gear, const RunOptions& run) {
  std::vector<std::string> known;
  for_each_tabulated_kind(gear,
                          [&](const std::string& path, const auto&) { known.push_back(path); });
  const std::string list = known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "));
  if (!run.crack) {
    if (known.size() == 1) return known.front();
    throw InputError("--crack",
                     fmt::format("must name one crack that a table can describe: {}", list));
  }
  if (std::ranges::find(known, *run.crack) == known.end())
    throw InputError("--crack", fmt::format("\"{}\" is not a crack that a table can describe: {}",
                                            shown(*run.crack), list));
  return *run.crack;
}

/// Kind and numbers of a crack by its path.
struct Tabulated {
  std::string_view kind;
  std::vector<BasicCrackParameter<double>> numbers;
};
Tabulated tabulated(const GearSet& gear, std::string_view path) {
  Tabulated result;
  for_each_tabulated_kind(gear, [&](const std::string& at, const auto& crack) {
    if (at != path) return;
    result = {std::decay_t<decltype(crack)>::kKind, crack_parameters(Lift<double>(), gear, crack)};
  });
  return result;
}

/// The single number of the crack that a variation changes.
TableParameter parameter_of(const GearSet& gear, const std::string& crack,
                            const Variation& variation) {
  const auto with = [&](double value) {
    GearSet varied = gear;
    set_number(varied, variation.path, value);
    return tabulated(varied, crack).numbers;
  };
  const auto from = with(variation.from);
  const auto to = with(variation.to);
  std::vector<std::string_view> changed;
  std::vector<std::string_view> known;
  TableParameter result;
  for (std::size_t i = 0; i < from.size(); ++i) {
    known.push_back(from[i].name);
    if (from[i].value == to[i].value) continue;
    changed.push_back(from[i].name);
    result = {.name = std::string(from[i].name), .unit = std::string(from[i].unit), .value = 0.0};
  }
  const std::string option = vary_option(variation.path, kOver);
  if (changed.empty())
    throw InputError(option, fmt::format("does not affect the finite elements of {}: {}", crack,
                                         fmt::join(known, ", ")));
  if (changed.size() > 1)
    throw InputError(option, fmt::format("changes {} at once; vary one number at a time",
                                         fmt::join(changed, " and ")));
  return result;
}

/// The drive without ranges, scatter and tables, which do not affect a run.
GearSet plain(GearSet gear) {
  gear.range.clear();
  gear.scatter.clear();
  gear.correlation.clear();
  gear.compliance_tables.clear();
  gear.turn_tables.clear();
  gear.error_table.reset();
  if (gear.drivetrain) gear.drivetrain->error_table.reset();
  const auto forget = [](auto& cracks) {
    for (auto& any : cracks)
      std::visit(
          [](auto& crack) {
            if constexpr (requires { crack.compliance_table; }) crack.compliance_table.reset();
            if constexpr (requires { crack.turn_table; }) crack.turn_table.reset();
          },
          any);
  };
  if (gear.flexspline) forget(gear.flexspline->crack);
  if (gear.output_shaft) forget(gear.output_shaft->crack);
  return gear;
}

GearSet at_point(const TableStudy& study, std::size_t point) {
  GearSet gear = study.gear;
  for (std::size_t a = 0; a < study.head.ranges.size(); ++a)
    set_number(gear, study.head.ranges[a].variation.path, study.points[point][a]);
  return gear;
}

/// Throws with the first line in which two heads differ.
void refuse_other_head(const std::string& there, const std::string& here, const std::string& file) {
  if (there == here) return;
  std::istringstream a(there);
  std::istringstream b(here);
  std::string old_line;
  std::string new_line;
  for (std::size_t line = 1;; ++line) {
    const bool old_ends = !std::getline(a, old_line);
    const bool new_ends = !std::getline(b, new_line);
    if (old_ends) old_line = "(nothing)";
    if (new_ends) new_line = "(nothing)";
    if (old_line == new_line && !old_ends) continue;
    throw InputError(fmt::format("{}:{}", file, line),
                     fmt::format("belongs to another run: the file has \"{}\", but this run has "
                                 "\"{}\"; name another file",
                                 shown(old_line), shown(new_line)));
  }
}

/// The rows that a table has already.  Begins the table if it is new, and drops an incomplete last
/// line.
std::vector<TablePoint> rows_of(const TableStudy& study, Journal& table, const Progress& progress) {
  const std::string head = table_head_text(study.head);
  const std::optional<std::string> there = table.text();
  if (!there) {
    table.begin(head);
    return {};
  }
  const std::string name = table.name();
  const TableFile found = parse_table_file(*there, name);
  refuse_other_head(found.head, head, name);
  if (found.rows.size() > study.points.size())
    throw InputError(name, fmt::format("has {} points, but this family has {}", found.rows.size(),
                                       study.points.size()));
  for (std::size_t i = 0; i < found.rows.size(); ++i)
    if (found.rows[i].at != study.points[i])
      throw InputError(name, fmt::format("point {} differs from the point of this family", i + 1));
  if (found.torn) {
    table.begin(there->substr(0, found.whole));
    progress.say(
        fmt::format("{}: dropped an incomplete last line that an interrupted run left", name));
  }
  progress.say(
      fmt::format("{}: {} of {} points are done", name, found.rows.size(), study.points.size()));
  return found.rows;
}

}  // namespace

double table_error(const TubeCrackRun& run) {
  double error = run.tube.order > 2 ? kTubeErrorAtBest : kTubeErrorAtBestOrder2;
  for (const auto* const one : {&run.positive, &run.negative}) {
    if (std::abs(one->energy_release_rate) <= one->closed_release_rate) continue;
    error = std::max(error, std::abs(one->growth_check));
    for (const fem::CrackFront& front : one->solid.fronts)
      error = std::max(error, front.ring_spread);
  }
  return error;  // (FE-42)
}

double table_error(const ShaftCrackRun& run) {
  double error = kShaftErrorAtBest;
  for (const auto* const load : run.result.loads())
    error = std::max({error, std::abs(load->growth_check), load->tip.ring_spread});
  return error;  // (FE-42)
}

TableStudy table_study(const GearSet& gear, const std::string& input, const RunOptions& run,
                       std::span<const Variation> over) {
  TableStudy study{.gear = plain(gear), .run = run, .head = {}, .points = {}};
  const std::string crack = chosen_crack(study.gear, run);
  study.run.crack = crack;
  study.run.surroundings = Surroundings::none;  // as stated in the head of the table
  if (over.empty()) throw InputError(kOver, "must be given for each number that varies");
  const Tabulated base = tabulated(study.gear, crack);
  const Family family = family_of(base.kind);
  TableHead& head = study.head;
  std::size_t n_points = 1;
  for (const Variation& variation : over) {
    check_variation(variation, kOver);
    const TableParameter parameter = parameter_of(study.gear, crack, variation);
    for (const TableRange& other : head.ranges)
      if (other.parameter.name == parameter.name)
        throw InputError(vary_option(variation.path, kOver),
                         fmt::format("varies {} twice; vary it once", parameter.name));
    head.ranges.push_back({parameter, variation});
    n_points *= static_cast<std::size_t>(variation.n_points);
    if (n_points > static_cast<std::size_t>(kMaxSweepPoints))
      throw InputError(kOver, fmt::format("more than {} points", kMaxSweepPoints));
  }
  for (std::size_t i = 0; i < n_points; ++i) {
    std::vector<double> at(over.size());
    std::size_t rest = i;
    for (std::size_t a = over.size(); a-- > 0;) {
      const auto n = static_cast<std::size_t>(over[a].n_points);
      at[a] = over[a].value(static_cast<int>(rest % n));
      rest /= n;
    }
    study.points.push_back(std::move(at));
  }
  for (const auto& number : base.numbers)
    if (std::ranges::none_of(head.ranges, [&](const TableRange& range) {
          return range.parameter.name == number.name;
        }))
      head.fixed.push_back({std::string(number.name), std::string(number.unit), number.value});
  head.kind = base.kind;
  head.crack = crack;
  head.program = fmt::format("strainwave-fe {} ({})", version(), git_revision());
  head.input = input;
  head.digest = sha256_hex(gear_text(at_point(study, 0)));
  head.order = run.order.value_or(family.order);
  head.equations = family.equations;
  head.held = family.held;
  head.columns = family.columns;
  return study;
}

TableSize table_size(const TableStudy& study) {
  TableSize size;
  size.points = study.points.size();
  for (std::size_t i = 0; i < study.points.size(); ++i) {
    try {
      for (const RunSize& one : plan(at_point(study, i), study.run).plan) {
        if (one.memory > size.largest.memory) size.largest = one;
        size.least_unknowns =
            size.least_unknowns == 0 ? one.dofs : std::min(size.least_unknowns, one.dofs);
        size.seconds += one.seconds;
      }
    } catch (const InputError& error) {
      size.misfits.push_back(fmt::format("point {}: {}", i + 1, error.what()));
    }
  }
  return size;
}

std::string table_size_text(const TableSize& size) {
  std::string text = fmt::format(
      "Plan, with estimates:\n  {} points of {} to {} unknowns, at most {:.2g} GB, {:.2g} s "
      "in all\n",
      size.points - size.misfits.size(), size.least_unknowns, size.largest.dofs,
      size.largest.memory / 1e9, size.seconds);
  for (const std::string& misfit : size.misfits) text += "  refused: " + misfit + '\n';
  return text;
}

TablePoint table_point(const TableStudy& study, std::size_t point, const Ranks& ranks) {
  const auto start = std::chrono::steady_clock::now();
  TablePoint row;
  const auto refuse = [&](const Error& error) {
    row.values.resize(study.head.columns.size());
    row.reason = error.what();
  };
  try {
    const RunResult result = run(at_point(study, point), study.run, ranks);
    if (ranks.first()) {
      row = family_of(study.head.kind).row(result);
      row.usable = result.usable();
      row.reason = result.reason();
    }
  } catch (const MemoryRefusal&) {
    throw;
  } catch (const fem::MemoryError&) {
    throw;
  } catch (const InputError& error) {  // an impossible geometry, or one that cannot be meshed
    refuse(error);
  } catch (const SolverError& error) {
    refuse(error);
  }
  row.at = study.points[point];
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  row.seconds = taken.count();
  return row;
}

ResultEvidence evidence_of(const TableOutcome& outcome) {
  ResultEvidence evidence;
  evidence.refused = !outcome.refused.empty();
  evidence.unusable_because = evidence.refused ? outcome.refused : outcome.unusable_because;
  evidence.verdict = verdict_of(evidence.unusable_because, {});
  return evidence;
}

TableOutcome run_table(const TableStudy& study, Journal& table, const Ranks& ranks,
                       const Progress& progress) {
  const TableSize size = table_size(study);
  if (!size.misfits.empty() && size.misfits.size() == size.points)
    throw InputError(kOver, "no point can be computed; " + size.misfits.front());
  require_memory({size.largest}, ranks);
  // All ranks use the rows that the first rank reads.  A fault of the first rank ends all ranks.
  std::vector<TablePoint> rows;
  ranks.together([&] {
    if (ranks.first()) rows = rows_of(study, table, progress);
  });
  const auto found =
      static_cast<std::size_t>(std::stoul(ranks.from_first(fmt::format("{}", rows.size()))));
  if (found < study.points.size())
    progress.say(fmt::format("{} points to do, at most {:.2g} GB and about {:.2g} s in all",
                             study.points.size() - found, size.largest.memory / 1e9,
                             size.seconds * static_cast<double>(study.points.size() - found) /
                                 static_cast<double>(study.points.size())));
  for (std::size_t i = found; i < study.points.size(); ++i) {
    // For bodies of revolution, only the first rank has the fault.
    ranks.together([&] {
      const TablePoint row = table_point(study, i, ranks);
      if (!ranks.first()) return;
      table.append(table_row_text(row));
      rows.push_back(row);
      progress.say(fmt::format("point {} of {}: {:.1f} s{}{}", i + 1, study.points.size(),
                               row.seconds, row.usable ? "" : ", NOT usable: ", row.reason));
    });
  }
  TableOutcome outcome{.plan = size,
                       .calculated = true,
                       .refused = {},
                       .table = table.name(),
                       .found = found,
                       .unusable = 0,
                       .unusable_because = {}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].usable) continue;
    if (outcome.unusable++ == 0)
      outcome.unusable_because = fmt::format("point {}: {}", i + 1, rows[i].reason);
  }
  return outcome;
}

}  // namespace strainwave::fe_study
