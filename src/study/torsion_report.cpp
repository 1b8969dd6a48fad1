// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/torsion_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <random>

#include "drawn_drive.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/parallel.hpp"
#include "strainwave/core/quantile.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/io/result_writer.hpp"
#include "strainwave/study/plot.hpp"

namespace strainwave {
namespace {

constexpr int kRimPositions = 180;
constexpr int kCurvePoints = 40;  // on each side, evenly spaced in the root of the torque

std::vector<double> curve_torques(const MakersTorques& at) {
  const double most = std::max(at.T3, at.rated);
  std::vector<double> torques = {at.T1, at.T2, at.T3, at.rated};
  for (int i = 1; i <= kCurvePoints; ++i) {
    const double share = static_cast<double>(i) / kCurvePoints;
    torques.push_back(most * share * share);
  }
  std::ranges::sort(torques);
  const auto same = [&](double a, double b) { return b - a < 1e-9 * most; };
  torques.erase(std::unique(torques.begin(), torques.end(), same), torques.end());
  return torques;
}

TorsionCurve usable_curve(const AssembledDrive& drive, std::vector<double> torques, double sense) {
  for (double& torque : torques) torque *= sense;
  TorsionCurve curve = torsion_curve(drive, torques);
  if (!curve.usable()) throw SolverError(curve.unusable_because);
  return curve;
}

void add_once(std::vector<Note>& notes, const std::vector<Note>& more) {
  for (const Note& note : more)
    if (std::ranges::find(notes, note) == notes.end()) notes.push_back(note);
}

struct Limits {
  double lower = 0.0;
  double upper = 0.0;
};

std::vector<Limits> limits_of(const GearSet& gear) {
  std::vector<Limits> limits;
  for (const InputRange& range : gear.range) {
    const std::string_view unit = number_at(gear, range.path).field.unit;
    limits.push_back({.lower = parse_quantity("lower", range.lower, unit),
                      .upper = parse_quantity("upper", range.upper, unit)});
  }
  return limits;
}

Band band(std::vector<double> values) {
  return {quantile(values, 0.05), quantile(values, 0.5), quantile(values, 0.95)};
}

bool has_cracks(const GearSet& gear) {
  return (gear.wave_generator && !gear.wave_generator->crack.empty()) ||
         (gear.flexspline && !gear.flexspline->crack.empty()) ||
         (gear.output_shaft && !gear.output_shaft->crack.empty()) ||
         (gear.mesh && !gear.mesh->crack.empty()) ||
         (gear.circular_spline && !gear.circular_spline->crack.empty());
}

// --- text ---------------------------------------------------------------------------------------

std::string stiffness_text(double K) { return fmt::format("{:.4g}", K); }
std::string arcmin_text(double angle) { return fmt::format("{:.4g}", angle / units::arcmin); }
/// Changes below rounding are none.
std::string percent_text(double change) {
  return std::abs(change) < 1e-9 ? "0 %" : fmt::format("{:+.2g} %", 100 * change);
}

std::string line_row(std::string_view label, const TorsionReport& report, double MakersLines::*line,
                     const Band* range, double unit) {
  std::string text = fmt::format("  {:<24}{:>14}{:>14}", label,
                                 fmt::format("{:.4g}", report.positive.*line / unit),
                                 fmt::format("{:.4g}", report.negative.*line / unit));
  if (range != nullptr)
    text += fmt::format("{:>24}",
                        fmt::format("{:.3g} .. {:.3g}", range->low / unit, range->high / unit));
  return text + '\n';
}

std::string changes_row(std::string_view label, const LineChanges& positive,
                        const LineChanges& negative) {
  return fmt::format("  {:<18}{:>11}{:>11}{:>11}   {:>11}{:>11}{:>11}\n", label,
                     percent_text(positive.K1), percent_text(positive.K2),
                     percent_text(positive.K3), percent_text(negative.K1),
                     percent_text(negative.K2), percent_text(negative.K3));
}

std::string comparison_text(const CurveComparison& c) {
  std::string text = fmt::format(
      "\nWith cracks against without, {} over a turn of the wave generator\n"
      "  {:<18}{:>33}   {:>33}\n  {:<18}{:>11}{:>11}{:>11}   {:>11}{:>11}{:>11}\n",
      c.angles.size() == 1 ? std::string("1 position")
                           : fmt::format("{} positions", c.angles.size()),
      "", "T > 0", "T < 0", "", "K1", "K2", "K3", "K1", "K2", "K3");
  text += changes_row("as in the file", c.positive.as_given, c.negative.as_given);
  text += changes_row("mean", c.positive.mean, c.negative.mean);
  text += changes_row("worst", c.positive.worst, c.negative.worst);
  text += changes_row("best", c.positive.best, c.negative.best);
  text += changes_row("ripple", c.positive.ripple, c.negative.ripple);
  text += fmt::format("  lost motion {} -> {} arcmin, largest width of the loop {} -> {} arcmin\n",
                      arcmin_text(c.lost_motion_sound), arcmin_text(c.lost_motion_cracked),
                      arcmin_text(c.hysteresis_sound), arcmin_text(c.hysteresis_cracked));
  text += "  " +
          wrapped(fmt::format("where the crack is: {}; {} (TC-26)",
                              c.crack_class == CrackClass::series ? "a member in series"
                              : c.crack_class == CrackClass::contact_path
                                  ? "in the path of the contacts"
                              : c.crack_class == CrackClass::none ? "cannot tell"
                                                                  : "cannot tell, or several",
                              c.evidence),
                  kTextWidth - 2, 4) +
          '\n';
  return text;
}

double largest_force(const std::vector<ContactForce>& forces) {
  double largest = 0.0;
  for (const ContactForce& contact : forces) largest = std::max(largest, contact.force);
  return largest;
}

}  // namespace

LineBands line_bands(const AssembledDrive& drive, const BandOptions& options,
                     const Progress& progress) {
  const GearSet& gear = drive.gear();
  const std::vector<Limits> limits = limits_of(gear);
  std::mt19937_64 random(20240607);
  // Not std::uniform_real_distribution, whose sequence differs between libraries.
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const auto draws = static_cast<std::size_t>(options.draws);
  std::vector<double> values;  // of all draws, one draw after the other
  for (std::size_t n = 0; n < draws; ++n)
    for (const Limits& limit : limits)
      values.push_back(limit.lower + (limit.upper - limit.lower) * uniform());

  std::vector<std::optional<MakersLines>> lines(draws);
  for_each_index(draws, {.threads = options.threads}, progress, [&] {
    return [&, drawn = std::make_unique<DrawnDrive>(gear, gear.range)](std::size_t n) {
      for (std::size_t i = 0; i < limits.size(); ++i)
        drawn->number(i) = values[n * limits.size() + i];
      try {
        lines[n] = makers_lines(AssembledDrive(drawn->gear(), drive.options()));
      } catch (const Error&) {  // this combination cannot be built
      }
    };
  });
  const auto rejected = std::erase(lines, std::nullopt);
  if (lines.empty())
    throw SolverError("none of the drives drawn from the ranges can be built or assembled");
  const auto band_of = [&](double MakersLines::*line) {
    std::vector<double> drawn;
    for (const auto& of_draw : lines) drawn.push_back((*of_draw).*line);
    return band(std::move(drawn));
  };
  return {.K1 = band_of(&MakersLines::K1),
          .K2 = band_of(&MakersLines::K2),
          .K3 = band_of(&MakersLines::K3),
          .draws = static_cast<int>(lines.size()),
          .rejected = static_cast<int>(rejected)};
}

TorsionReport torsion_report(const GearSet& gear, const TorsionReportOptions& options,
                             const Progress& progress) {
  // Shares of the time: a drive without ranges and cracks takes it all for its curve.
  const bool draws = !gear.range.empty() && options.draws > 0;
  const double curve_ends = draws || options.compare ? 0.2 : 1.0;
  const double draws_end = !draws ? curve_ends : options.compare ? 0.5 : 1.0;
  TorsionReport report;
  const AssembledDrive drive(gear);
  const SlidingDrive sliding(gear);
  report.torques = makers_torques(gear);
  const std::vector<double> torques = curve_torques(report.torques);
  const std::array<std::function<void()>, 3> parts = {
      [&] { report.curve = usable_curve(drive, torques, +1); },
      [&] { report.curve_negative = usable_curve(drive, torques, -1); },
      [&] {
        report.loop =
            hysteresis_loop(Hysteresis(sliding, report.torques.rated), report.torques.rated);
      }};
  for_each_index(parts.size(), {}, progress.part(0.0, curve_ends),
                 [&] { return [&](std::size_t i) { parts[i](); }; });
  for (const double at : {report.torques.T1, report.torques.T2, report.torques.rated}) {
    const auto point = std::ranges::min_element(
        report.curve.points, {}, [&](const CurvePoint& p) { return std::abs(p.torque - at); });
    const auto index = static_cast<std::size_t>(point - report.curve.points.begin());
    if (std::ranges::find(report.shown, index) == report.shown.end()) report.shown.push_back(index);
  }
  report.positive = makers_lines(drive, +1);
  report.negative = makers_lines(drive, -1);
  report.lost_motion = lost_motion(drive);
  report.rim = rim_states(drive, report.torques.rated, kRimPositions);
  if (draws)
    report.bands =
        line_bands(drive, {.draws = options.draws}, progress.part(curve_ends, draws_end));
  if (options.compare) {
    report.comparison =
        compare_curves(drive, sliding, options.angles, progress.part(draws_end, 1.0));
    report.sound = usable_curve(drive.without_cracks(), torques, +1);
  }
  if (report.torques.by_convention)
    report.notes.push_back({"rating.convention",
                            "not given: T1 and T2 are taken as 0.0517 and 0.187 N/mm^2 times the "
                            "cube of the pitch diameter, as catalogues choose them",
                            "rating", "TC-14", Severity::information,
                            "Give rating.T1 and rating.T2 to use the maker's torques."});
  add_once(report.notes, report.curve.notes);
  if (gear.mesh->friction_coefficient > 0 && (!gear.rating || gear.rating->friction_torque == 0))
    report.notes.push_back({"hysteresis.no_load",
                            "flank friction vanishes with the load, so the loop closes at zero "
                            "torque; a maker's hysteresis loss there is of seal, grease and "
                            "bearings: give friction_torque",
                            "rating.friction_torque", "TC-17", Severity::care,
                            "Give rating.friction_torque."});
  if (has_cracks(gear) && !options.compare)
    report.notes.push_back({"torsion.compare",
                            "the drive has cracks; --compare shows what they change, and over a "
                            "turn of the wave generator",
                            "", "TC-26", Severity::information, "Run the command with --compare."});
  if (options.compare && !has_cracks(gear))
    report.notes.push_back({"torsion.no_cracks",
                            "the file has no cracks: there is nothing to compare", "", "TC-26",
                            Severity::information});
  report.equations = report.curve.equations;
  for (const char* const tag : {"TC-16", "TC-17", "TC-18", "TC-24"})
    report.equations.emplace_back(tag);
  if (options.compare) report.equations.emplace_back("TC-26");
  return report;
}

std::string torsion_text(const TorsionReport& report, const GearSet& gear) {
  const MakersTorques& at = report.torques;
  std::string text =
      fmt::format("{}\nTorsion curve of the coupled drive, output against locked input\n\n",
                  gear.name.empty() ? "Strain wave gear" : gear.name);
  text += fmt::format("T1 = {:.5g}, T2 = {:.5g}, T3 = {:.5g}, rated {:.5g} N*m{}\n\n", at.T1, at.T2,
                      at.T3, at.rated, at.by_convention ? " (by convention)" : "");
  const LineBands* const bands = report.bands ? &*report.bands : nullptr;
  text += fmt::format("  {:<24}{:>14}{:>14}{:>24}\n", "", "T > 0", "T < 0",
                      bands != nullptr ? "90 % of the ranges" : "");
  while (text.ends_with(" \n")) text.erase(text.size() - 2, 1);
  const auto both = [&](std::string_view name, double MakersLines::*line, const Band* range) {
    text += line_row(fmt::format("{} [N*m/rad]", name), report, line, range, 1.0);
  };
  both("K1", &MakersLines::K1, bands != nullptr ? &bands->K1 : nullptr);
  both("K2", &MakersLines::K2, bands != nullptr ? &bands->K2 : nullptr);
  both("K3", &MakersLines::K3, bands != nullptr ? &bands->K3 : nullptr);
  text += line_row("phi1 [arcmin]", report, &MakersLines::phi1, nullptr, units::arcmin);
  text += line_row("phi2 [arcmin]", report, &MakersLines::phi2, nullptr, units::arcmin);
  text += fmt::format("  {:<24}{:>14}   at +-{:.4g} N*m\n", "lost motion [arcmin]",
                      arcmin_text(report.lost_motion), at.lost_motion);
  text += fmt::format("  {:<24}{:>14}   largest, at {:.4g} N*m; {} at zero torque\n",
                      "loop width [arcmin]", arcmin_text(report.loop.largest_width),
                      report.loop.torque_of_largest_width, arcmin_text(report.loop.width_at_zero));
  if (bands != nullptr)
    text += fmt::format("  {} drives drawn from {} ranges{}\n", bands->draws, gear.range.size(),
                        bands->rejected > 0
                            ? fmt::format(", {} more could not be built", bands->rejected)
                            : std::string());

  text += fmt::format("\n  {:<26}", "at T [N*m]");
  const auto shown = [&](const auto& cell) {
    for (const std::size_t i : report.shown)
      text += fmt::format("{:>14}", cell(report.curve.points[i]));
    text += '\n';
  };
  shown([](const CurvePoint& p) { return fmt::format("{:.5g}", p.torque); });
  text += fmt::format("  {:<26}", "twist [arcmin]");
  shown([](const CurvePoint& p) { return arcmin_text(p.twist); });
  text += fmt::format("  {:<26}", "tangent K [N*m/rad]");
  shown([](const CurvePoint& p) { return stiffness_text(1 / p.tangent_compliance); });
  text += fmt::format("  {:<26}", fmt::format("teeth in contact of {}", report.curve.teeth));
  shown([](const CurvePoint& p) { return fmt::format("{}", p.teeth_in_contact); });
  text += fmt::format("  {:<26}", "balls in contact");
  shown([](const CurvePoint& p) { return fmt::format("{}", p.balls_in_contact); });
  text += fmt::format("  {:<26}", "largest ball force [N]");
  shown([](const CurvePoint& p) { return fmt::format("{:.4g}", largest_force(p.balls)); });
  text += fmt::format("  {:<26}", "largest flank force [N]");
  shown([](const CurvePoint& p) {
    return fmt::format("{:.4g}",
                       std::max(largest_force(p.drive_flanks), largest_force(p.coast_flanks)));
  });
  text += "  share of the tangent compliance\n";
  for (std::size_t m = 0; m < kCurveMembers; ++m) {
    const bool any = std::ranges::any_of(report.shown, [&](std::size_t i) {
      return std::abs(report.curve.points[i].share[m]) > 5e-5;
    });
    if (!any) continue;
    std::string name(EnumNames<CurveMember>::names[m]);
    std::ranges::replace(name, '_', ' ');
    text += fmt::format("    {:<24}", name);
    shown([&](const CurvePoint& p) { return fmt::format("{:.1f} %", 100 * p.share[m]); });
  }
  const auto extremes = [&](double RimState::*stress) {
    const auto [least, most] = std::ranges::minmax_element(report.rim, {}, stress);
    return fmt::format("{:>8.4g} .. {:.4g} MPa", (*least).*stress / units::MPa,
                       (*most).*stress / units::MPa);
  };
  text += fmt::format(
      "\nStress over a turn of the wave generator at {:.5g} N*m, without concentration (TC-24)\n"
      "  {:<34}{}\n  {:<34}{}\n  {:<34}{}\n  {:<34}{:>8.4g} MPa\n",
      report.torques.rated, "rim at the tooth roots, hoop", extremes(&RimState::rim_outside_stress),
      "rim at its bore, hoop", extremes(&RimState::rim_inside_stress),
      "barrel at the rim, hoop bending", extremes(&RimState::barrel_bending_stress),
      "barrel, shear of the torque", report.rim.front().barrel_shear_stress / units::MPa);
  if (report.comparison) text += comparison_text(*report.comparison);
  if (!report.notes.empty()) text += "\nNotes\n";
  text += notes_text(report.notes);
  text +=
      "\n" +
      wrapped(fmt::format("Equations of the theory manual: {}", fmt::join(report.equations, ", ")),
              kTextWidth, 2) +
      "\n";
  return text;
}

std::string torsion_csv(const TorsionReport& report) {
  std::string text =
      "torque [N*m],twist [rad],tangent_stiffness [N*m/rad],teeth_in_contact,balls_in_contact\n";
  const auto add = [&](const CurvePoint& p) {
    text += fmt::format("{},{},{},{},{}\n", p.torque, p.twist, 1 / p.tangent_compliance,
                        p.teeth_in_contact, p.balls_in_contact);
  };
  for (auto p = report.curve_negative.points.rbegin(); p != report.curve_negative.points.rend();
       ++p)
    add(*p);
  for (const CurvePoint& p : report.curve.points) add(p);
  return text;
}

std::vector<PlotPanel> torsion_panels(const TorsionReport& report, const GearSet& gear) {
  const auto in_arcmin = [](std::vector<double> values) {
    for (double& value : values) value /= units::arcmin;
    return values;
  };
  const MakersTorques& at = report.torques;
  PlotSeries curve{.label = report.comparison ? "with cracks" : "predicted"};
  PlotSeries sound{.label = "sound"};
  PlotSeries tangent{.label = curve.label};
  PlotSeries tangent_sound{.label = "sound"};
  const auto add = [](PlotSeries& series, double x, double y) {
    series.x.push_back(x);
    series.y.push_back(y);
  };
  for (auto p = report.curve_negative.points.rbegin(); p != report.curve_negative.points.rend();
       ++p)
    add(curve, p->torque, p->twist / units::arcmin);
  add(curve, 0.0, 0.0);
  for (const CurvePoint& p : report.curve.points) {
    add(curve, p.torque, p.twist / units::arcmin);
    add(tangent, p.torque, units::arcmin / p.tangent_compliance);
  }
  for (const CurvePoint& p : report.sound.points) {
    add(sound, p.torque, p.twist / units::arcmin);
    add(tangent_sound, p.torque, units::arcmin / p.tangent_compliance);
  }
  const double phi3 = report.positive.phi2 + (at.T3 - at.T2) / report.positive.K3;
  const PlotSeries lines{.label = "K1, K2, K3",
                         .x = {0.0, at.T1, at.T2, at.T3},
                         .y = in_arcmin({0.0, report.positive.phi1, report.positive.phi2, phi3})};
  const PlotSeries loop{
      .label = "loop, friction", .x = report.loop.torque, .y = in_arcmin(report.loop.twist)};
  std::vector<PlotPanel> panels;
  panels.push_back(
      {.title = gear.name.empty() ? "Torsion curve" : gear.name,
       .subtitle = fmt::format("K1 = {:.3g}, K2 = {:.3g}, K3 = {:.3g} N·m/rad", report.positive.K1,
                               report.positive.K2, report.positive.K3),
       .x_label = "torque T at the output [N·m]",
       .y_label = "twist φ, input locked [arcmin]",
       .series = {curve, lines, loop}});
  if (report.comparison) panels.back().series.insert(panels.back().series.begin() + 1, sound);
  panels.push_back({.title = "Tangent stiffness",
                    .x_label = "torque T at the output [N·m]",
                    .y_label = "dT/dφ [N·m/arcmin]",
                    .series = {tangent}});
  if (report.comparison) {
    panels.back().series.push_back(tangent_sound);
    PlotPanel turn{.title = "Change of stiffness over a turn of the wave generator",
                   .subtitle = "T > 0",
                   .x_label = "wave generator turned by [deg]",
                   .y_label = "cracked/sound − 1 [%]"};
    const auto series = [&](const char* label, double LineChanges::*line) {
      PlotSeries s{.label = label};
      for (std::size_t i = 0; i < report.comparison->angles.size(); ++i)
        add(s, report.comparison->angles[i] / units::deg,
            100 * report.comparison->positive.at_angle[i].*line);
      return s;
    };
    turn.series = {series("K1", &LineChanges::K1), series("K2", &LineChanges::K2),
                   series("K3", &LineChanges::K3)};
    panels.push_back(std::move(turn));
  }
  return panels;
}

std::string torsion_plot(const TorsionReport& report, const GearSet& gear) {
  return svg_plot(torsion_panels(report, gear));
}

}  // namespace strainwave
