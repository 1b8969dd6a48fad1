// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "chapters.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/sif/member/semi_ellipse.hpp"
#include "strainwave/stiffness/elastic_members.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr double kSoundSum = 3.407e-10 + 2.359e-10 + 6.906e-10;
constexpr double kCrackedSum = 3.558e-10 + 2.359e-10 + 6.906e-10;

double loss_percent(const StiffnessResult& result) {
  return -100 * result.positive.stiffness_change.value;
}

Rows input_rows() {
  Rows rows;
  const Printed p;
  rows.push_back({.id = "T1",
                  .quantity = "w_0 i_h against d_1/2",
                  .unit = "mm",
                  .own = p.w_0 * p.i_h,
                  .corrected = p.d_1 / 2,
                  .verdict = AuditVerdict::reproduced,
                  .sentence = "deflection, ratio and diameter agree"});
  const double isotropic = p.E / (2 * (1 + p.nu));
  rows.push_back({.id = "T2",
                  .quantity = "shear modulus",
                  .unit = "MPa",
                  .printed = p.mu,
                  .own = isotropic,
                  .corrected = isotropic,
                  .verdict = AuditVerdict::ambiguous,
                  .sentence = fmt::format("E, mu and nu contradict each other by {:.0f} %",
                                          100 * (isotropic / p.mu - 1)),
                  .reproduce = reproducing("nu", "1", p.mu, 0.1, 0.49,
                                           [&](double nu) { return p.E / (2 * (1 + nu)); })});
  rows.push_back({.id = "T3",
                  .quantity = "crack parameter Q",
                  .unit = "1",
                  .printed = p.Q,
                  .verdict = AuditVerdict::reproduced,
                  .sentence = "Q of a semi-ellipse with this aspect ratio",
                  .reproduce = reproducing("a/c", "1", p.Q, 0.1, 1, [](double rho) {
                    return sif::NewmanRaju(rho).shape_parameter();
                  })});
  const Tube tube{.outer_diameter = p.d_1, .inner_diameter = p.d_1 - 2 * p.delta, .length = p.L};
  rows.push_back(
      {.id = "T4",
       .quantity = "1 - (1 - 2 c_delta)^4, c_delta = 0.014",
       .unit = "1",
       .own = 1 - std::pow(1 - 2 * p.delta / p.d_1, 4),
       .corrected = 32 * p.L / (pi * p.mu * torsional_compliance(tube, p.mu) * std::pow(p.d_1, 4)),
       .verdict = AuditVerdict::reproduced,
       .sentence = "wall thickness and diameter agree"});
  rows.push_back({.id = "T5",
                  .quantity = "d_e = d_s - 2a",
                  .unit = "mm",
                  .printed = 59.8,
                  .own = p.d_s - 2 * p.a,
                  .corrected = p.d_s - 2 * p.a,
                  .verdict = AuditVerdict::reproduced,
                  .sentence = "follows from the printed d_s"});
  return rows;
}

Rows sum_rows(const StiffnessResult& result) {
  Rows rows;
  rows.push_back({.id = "T6",
                  .quantity = "total compliance, no cracks",
                  .unit = kCompliance,
                  .printed = 12.672e-10,
                  .own = kSoundSum,
                  .corrected = compliance_in_mm(result.intact.compliance.total),
                  .verdict = AuditVerdict::reproduced,
                  .sentence = "the sum of the printed members"});
  rows.push_back({.id = "T7",
                  .quantity = "total compliance, with cracks",
                  .unit = kCompliance,
                  .printed = 12.823e-10,
                  .own = kCrackedSum,
                  .corrected = compliance_in_mm(result.positive.compliance.total),
                  .verdict = AuditVerdict::reproduced,
                  .sentence = "the sum of the printed members"});
  rows.push_back({.id = "T8",
                  .quantity = "K_HD, no cracks",
                  .unit = "N*mm/rad",
                  .printed = 7.890e10,
                  .own = article::drive_stiffness(3.407e-10, 2.359e-10, 6.906e-10),
                  .corrected = stiffness_in_mm(result.intact.stiffness),
                  .verdict = AuditVerdict::misprint,
                  .sentence = "the exponent is 8, and the last digit rounds to 7.891"});
  rows.push_back({.id = "T9",
                  .quantity = "K_HD, with cracks",
                  .unit = "N*mm/rad",
                  .printed = 7.798e10,
                  .own = article::drive_stiffness(3.558e-10, 2.359e-10, 6.906e-10),
                  .corrected = stiffness_in_mm(result.positive.stiffness),
                  .verdict = AuditVerdict::misprint,
                  .sentence = "the exponent is 8"});
  return rows;
}

Rows loss_rows(const StiffnessResult& result) {
  Rows rows;
  const Printed p;
  rows.push_back(
      {.id = "T10",
       .quantity = "loss of stiffness by cracks of 0.1 mm",
       .unit = "%",
       .printed = 1.2,
       .own = 100 * (1 - kSoundSum / kCrackedSum),
       .corrected = loss_percent(result),
       .verdict = AuditVerdict::physics,
       .sentence = "the arithmetic of the printed sums is right; the input is the depth of an "
                   "annular shaft crack with this effect",
       .reproduce = reproducing("shaft crack depth", "mm", 1.2, 0.1, 9, [&](double depth) {
         return loss_percent(torsional_stiffness(example(p.a * units::mm, depth * units::mm)));
       })});
  const auto share = [&](const char* id, const char* member, double printed, double part,
                         Quantity Compliances::*of) {
    rows.push_back(
        {.id = id,
         .quantity = fmt::format("share of the {}", member),
         .unit = "%",
         .printed = printed,
         .own = 100 * part / kCrackedSum,
         .corrected =
             100 * (result.positive.compliance.*of).value / result.positive.compliance.total.value,
         .verdict = AuditVerdict::reproduced,
         .sentence =
             "follows from the printed members, but these do not follow from the printed inputs"});
  };
  share("T11", "output shaft", 54, 6.906e-10, &Compliances::output_shaft);
  share("T12", "wave generator", 28, 3.558e-10, &Compliances::wave_generator);
  share("T13", "flexspline", 18, 2.359e-10, &Compliances::flexspline);
  rows.push_back({.id = "T14",
                  .quantity = "loss of stiffness by cracks of 2 mm",
                  .unit = "%",
                  .corrected = loss_percent(corrected_example(2)),
                  .verdict = AuditVerdict::physics,
                  .sentence = "\"even small cracks measurably affect the stiffness\" is wrong: "
                              "this is the effect of cracks twenty times larger"});
  return rows;
}

}  // namespace

Rows table_and_text_rows() {
  const StiffnessResult result = corrected_example(Printed{}.a);
  return joined(input_rows(), sum_rows(result), loss_rows(result));
}

}  // namespace strainwave
