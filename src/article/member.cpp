// SPDX-License-Identifier: Apache-2.0
#include "member.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <variant>

#include "strainwave/article/as_printed.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/model/input/crack_parameters.hpp"

namespace strainwave::article {
namespace {

constexpr std::string_view kComplianceUnit = "rad/(N*m)";
constexpr std::string_view kStiffness = "N*m/rad";
constexpr std::string_view kStressIntensityUnit = "Pa*m^0.5";
constexpr std::string_view kSumEquation = "AP-18";

[[noreturn]] void refuse(std::string_view path, Method method, std::string_view why) {
  throw InputError(path,
                   fmt::format("the method {} cannot treat this: {}; use the method corrected",
                               enum_name(method), why));
}

template <class Crack, class AnyCrack>
const Crack* only_crack(const std::vector<AnyCrack>& cracks, std::string_view member,
                        Method method) {
  if (cracks.empty()) return nullptr;
  if (cracks.size() > 1)
    refuse(fmt::format("{}.crack[1]", member), method,
           "the article treats only one crack in a member");
  const auto* const crack = std::get_if<Crack>(&cracks.front());
  if (crack == nullptr) {
    const std::string_view kind = std::visit(
        [](const auto& other) { return std::decay_t<decltype(other)>::kKind; }, cracks.front());
    refuse(fmt::format("{}.crack[0]", member), method,
           fmt::format("the article does not treat a {} crack in this member", kind));
  }
  return crack;
}

void refuse_unknown_race(const WaveGenerator& wg, const RaceSurfaceCrack& crack, Method method) {
  if (crack.stress_driver != StressDriver::orthogonal_shear)
    refuse("wave_generator.crack[0].stress_driver", method,
           "the article treats only the driver orthogonal_shear");
  if (!crack.contact_factor)
    throw InputError("wave_generator.crack[0].contact_factor",
                     fmt::format("must be given for the method {}: the article uses beta as a "
                                 "given number and does not state a formula for it",
                                 enum_name(method)));
  if (!wg.contact_semi_axes)
    throw InputError("wave_generator.contact_semi_axes",
                     fmt::format("must be given for the method {}", enum_name(method)));
}

double stiffness(const Compliances& compliance) {
  return drive_stiffness(compliance.wave_generator.value, compliance.flexspline.value,
                         compliance.output_shaft.value);
}

CrackedDrive cracked_drive(const IntactDrive& intact, const Compliances& compliance, double added,
                           double torque) {
  const double total = compliance.total.value;
  return {.compliance = compliance,
          .stiffness = {stiffness(compliance), kStiffness},
          // K/K_0 - 1 = -Delta lambda/lambda.  The difference of two nearly equal stiffnesses would
          // lose the digits of a small crack.
          .stiffness_change = {-added / total, "1"},
          .wind_up = {total * std::abs(torque), intact.wind_up.unit}};
}

void append(StiffnessResult& result, const Member& member) {
  if (member.crack) result.cracks.push_back(*member.crack);
  result.notes.insert(result.notes.end(), member.notes.begin(), member.notes.end());
  result.equations.insert(result.equations.end(), member.equations.begin(), member.equations.end());
}

void note_negative(std::vector<Note>& notes, double compliance, std::string_view path,
                   std::string_view equation) {
  if (compliance >= 0) return;
  notes.push_back(
      {.code = "article.negative_compliance",
       .text = fmt::format("the cracked compliance of {} is negative, {:.4g} rad/(N*m): it follows "
                           "from the printed equations, but a compliance cannot be negative",
                           path.empty() ? "the drive" : path, compliance),
       .path = std::string(path),
       .equation = std::string(equation),
       .severity = Severity::critical,
       .next_step = "Use the method corrected."});
}

std::vector<Note> general_notes(const GearSet& gear, Method method) {
  std::vector<Note> notes;
  notes.push_back(
      {.code = "article.accuracy",
       .text = method == Method::as_printed
                   ? "the accuracy cannot be stated: several printed equations are dimensionally "
                     "or physically wrong, so the numbers show what the article says, not a drive"
                   : "the accuracy cannot be stated: the article's models are kept even where "
                     "their physics is wrong (race stress, cam conversion), not only their print",
       .path = "",
       .equation = "",
       .severity = Severity::care,
       .next_step = "Use the method corrected for a drive of your own."});
  notes.push_back({.code = "article.no_closure",
                   .text = "both senses of torque give the same values, because the article treats "
                           "every crack as open under either",
                   .path = "",
                   .equation = "",
                   .severity = Severity::care});
  if (method == Method::repaired && gear.article)
    notes.push_back({.code = "article.ignored",
                     .text = "only the method as-printed reads the printed intermediate values",
                     .path = "article",
                     .equation = "",
                     .severity = Severity::information});
  for_each_tabulated_kind(gear, [&](const std::string& path, const auto& crack) {
    if (crack.compliance_table)
      notes.push_back({.code = "article.compliance_table",
                       .text = "the article uses its own formula, so the table is not read",
                       .path = path + ".compliance_table",
                       .equation = "",
                       .severity = Severity::care});
  });
  if (gear.load.axial_force != 0)
    notes.push_back({.code = "article.axial_force",
                     .text = "the axial force affects only K_I of the shaft's crack",
                     .path = "load.axial_force",
                     .equation = method == Method::as_printed ? "AP-13" : "AR-8",
                     .severity = Severity::care});
  if (gear.wave_generator && gear.drive.wave_number != 2)
    notes.push_back(
        {.code = "article.wave_number",
         .text = "the article's force F_r on a lobe is valid for two lobes; it is used unchanged",
         .path = "drive.wave_number",
         .equation = method == Method::as_printed ? "AP-4" : "AR-1",
         .severity = Severity::care});
  return notes;
}

}  // namespace

Member absent_member(std::string_view path) {
  Member member;
  member.notes.push_back(
      {.code = "member.absent",
       .text = fmt::format("[{}] is not given, so it does not add compliance", path),
       .path = std::string(path),
       .equation = "",
       .severity = Severity::information});
  return member;
}

Cracks treatable_cracks(const GearSet& gear, Method method) {
  Cracks cracks;
  if (gear.wave_generator) {
    const WaveGenerator& wg = *gear.wave_generator;
    cracks.race = only_crack<RaceSurfaceCrack>(wg.crack, "wave_generator", method);
    if (wg.bearing)
      refuse("wave_generator.bearing", method,
             "the article needs radial_stiffness or displacements as given numbers");
    if (cracks.race != nullptr) refuse_unknown_race(wg, *cracks.race, method);
  }
  if (gear.flexspline) {
    const Flexspline& fs = *gear.flexspline;
    if (fs.crack_free != CrackFree::factor)
      refuse("flexspline.crack_free", method, "the article treats only \"factor\"");
    cracks.wall = only_crack<WallThroughCrack>(fs.crack, "flexspline", method);
    if (cracks.wall != nullptr && cracks.wall->count > 1)
      refuse("flexspline.crack[0].count", method, "the article treats only one crack in a member");
  }
  if (gear.output_shaft)
    cracks.shaft = only_crack<AnnularCrack>(gear.output_shaft->crack, "output_shaft", method);
  return cracks;
}

CrackReport crack_report(std::string_view path, std::string_view kind, double added_compliance,
                         const StressIntensities& deepest, bool uniform_front) {
  const AddedCompliance added{.at_output = {added_compliance, kComplianceUnit},
                              .axial_torsion = std::nullopt};
  CrackReport report;
  report.path = path;
  report.kind = kind;
  report.opens_under = OpensUnder::both;
  report.positive = added;
  report.negative = added;
  report.deepest = deepest;
  if (uniform_front) report.largest = deepest;
  return report;
}

StressIntensities stress_intensities(double K_I, double K_II, double K_III) {
  return {.K_I = {K_I, kStressIntensityUnit},
          .K_II = {K_II, kStressIntensityUnit},
          .K_III = {K_III, kStressIntensityUnit}};
}

Note not_read(std::string_view path, std::string_view equation, std::string_view what_is_done) {
  return {.code = "article.not_read",
          .text = fmt::format("{} is not read: {}", path, what_is_done),
          .path = std::string(path),
          .equation = std::string(equation),
          .severity = Severity::care};
}

StiffnessResult drive_result(const GearSet& gear, Method method, const Member& wave_generator,
                             const Member& flexspline, const Member& output_shaft) {
  StiffnessResult result;
  result.method = method;
  result.notes = general_notes(gear, method);
  for (const Member* member : {&wave_generator, &flexspline, &output_shaft})
    append(result, *member);
  result.equations.emplace_back(kSumEquation);

  const auto compliances = [&](double Member::*of) {
    const double H = wave_generator.*of;
    const double f = flexspline.*of;
    const double so = output_shaft.*of;
    return Compliances{.wave_generator = {H, kComplianceUnit},
                       .flexspline = {f, kComplianceUnit},
                       .output_shaft = {so, kComplianceUnit},
                       .total = {H + f + so, kComplianceUnit}};
  };
  const Compliances sound = compliances(&Member::sound);
  result.intact = {.compliance = sound,
                   .stiffness = {stiffness(sound), kStiffness},
                   .wind_up = {sound.total.value * std::abs(gear.load.torque), "rad"}};
  const double added = wave_generator.added + flexspline.added + output_shaft.added;
  result.positive =
      cracked_drive(result.intact, compliances(&Member::cracked), added, gear.load.torque);
  result.negative = result.positive;

  note_negative(result.notes, wave_generator.cracked, "wave_generator", "AP-8");
  note_negative(result.notes, result.positive.compliance.total.value, "", kSumEquation);
  if (!std::isfinite(result.positive.stiffness.value) ||
      !std::isfinite(result.positive.compliance.total.value))
    result.unusable_because =
        "the printed equations divide by zero for this drive: the stiffness that the crack removes "
        "equals the sound stiffness";
  return result;
}

}  // namespace strainwave::article
