// SPDX-License-Identifier: Apache-2.0
#include "strainwave/strength/crack_strength.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>

#include "assessed_crack.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/sif/member/ring_edge.hpp"
#include "strainwave/sif/member/semi_ellipse.hpp"
#include "strainwave/sif/member/shaft_annular.hpp"
#include "strainwave/sif/member/wall_through.hpp"
#include "strainwave/sif/newman_raju.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "strainwave/strength/failure_assessment.hpp"
#include "strainwave/drive_cracks/reference_stress.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr int kFrontPoints = 33;         // as the stiffness takes them: of half a front
constexpr double kNearlyAll = 1 - 1e-6;  // of a length that a crack must not reach
constexpr double kSurfaceRange = 0.8;    // a/t of Newman and Raju's elements

const StrengthNote kResidual = {
    "residual stress (hardening, peening, press fits) is not known and left out; the line is for "
    "steels that yield continuously",
    "FA-1"};
const StrengthNote kLineEnds = {
    "the material gives no ultimate_strength: the line ends at L_r = 1, on the safe side", "FA-2"};
const StrengthNote kAssembly = {
    "the assembly bends the cracked wall by w_0 cos(U theta) in full: an upper bound away from the "
    "open end of a cup, but not for a flattened cam or on the rim; over a turn each face is in "
    "tension once per lobe, so the crack may start from either",
    "FA-12"};
const StrengthNote kThroughBending = {
    "a through crack takes the bending of the assembly in full at the outer fibre, exact for a "
    "crack short against the wall's thickness and up to 1.6 times too much for a long one; contact "
    "of its closed half is left out",
    "FA-14"};
const StrengthNote kFit = {
    "stress of fit and rotation in the ring is not known and left out; the lobe force is taken to "
    "scale the crack's stress in proportion",
    "FA-4"};
const StrengthNote kGroove = {
    "a groove is taken as a sharp crack all round, of its depth: on the safe side", "FA-11"};
const char* const kDiaphragm = "the bending of the diaphragm by the assembly is not known";
const char* const kRim =
    "on the rim the wall's bending is no upper bound: membrane stress of the assembly and tooth "
    "forces are not in it";
const char* const kOrder =
    "the driver orthogonal_shear gives an order of magnitude at best (ST-12)";

std::array<double, 3> modes(const UnitStressIntensity<2>& k, double P, double T) {
  return {k.I[kAxial] * P + k.I[kTorsion] * T, k.II[kAxial] * P + k.II[kTorsion] * T,
          k.III[kAxial] * P + k.III[kTorsion] * T};
}

struct Wall {
  double mean_radius = 0.0;
  double thickness = 0.0;
  double length = 0.0;
};

/// The wall that a crack sits in, as the stiffness takes it.
Wall wall_of(const GearSet& gear, WallSection section) {
  const Flexspline& fs = *gear.flexspline;
  if (fs.crack_free == CrackFree::factor)
    return {(gear.drive.pitch_diameter - fs.wall_thickness) / 2, fs.wall_thickness,
            fs.length};  // (ST-11)
  const TubeSection& tube = section == WallSection::rim ? *fs.rim : *fs.barrel;
  return {(tube.outer_diameter - tube.wall_thickness) / 2, tube.wall_thickness,
          tube.length};  // (ST-11)
}

/// Makes the cracks of a drive fit for assessment.
class Maker {
 public:
  Maker(const GearSet& gear, std::span<const CrackReport> reports)
      : gear_(gear), reports_(reports), P_(gear.load.axial_force), T_(std::abs(gear.load.torque)) {}

  [[nodiscard]] std::vector<CrackStrength> all() {
    if (gear_.wave_generator)
      for_each("wave_generator", gear_.wave_generator->crack, gear_.wave_generator->material);
    if (gear_.flexspline)
      for_each("flexspline", gear_.flexspline->crack, gear_.flexspline->material);
    if (gear_.mesh) for_each("mesh", gear_.mesh->crack, {});
    if (gear_.circular_spline)
      for_each("circular_spline", gear_.circular_spline->crack, gear_.circular_spline->material);
    if (gear_.output_shaft)
      for_each("output_shaft", gear_.output_shaft->crack, gear_.output_shaft->material);
    return std::move(result_);
  }

 private:
  template <class Variant>
  void for_each(std::string_view member, const std::vector<Variant>& cracks,
                const std::string& material) {
    for (std::size_t i = 0; i < cracks.size(); ++i)
      std::visit(
          [&](const auto& crack) {
            AssessedCrack made;
            made.report.path = fmt::format("{}.crack[{}]", member, i);
            made.report.kind = std::decay_t<decltype(crack)>::kKind;
            made.report.material = material;
            if constexpr (requires { this->make(made, crack); }) {
              answer(made, crack);
            } else {
              made.report.sentence =
                  "cannot tell: it acts in the coupled drive only, where its stress is not "
                  "computed";
              made.report.equations = {"FA-13"};
              result_.push_back(std::move(made.report));
            }
          },
          cracks[i]);
  }

  template <class Crack>
  void answer(AssessedCrack& made, const Crack& crack) {
    const Material& material =
        material_of(gear_, made.report.material, made.report.path + ".material");
    steel_ = elastic_constants(material);
    made.moduli = {.opening = steel_.plane_strain_modulus(), .shear = steel_.G};
    made.report.notes.push_back(kResidual);
    if (material.yield_strength && !material.ultimate_strength)
      made.report.notes.push_back(kLineEnds);
    made.report.equations = {"FA-1", "FA-2", "FA-4", "FA-5", "FA-13"};
    const auto report = std::ranges::find(reports_, made.report.path, &CrackReport::path);
    report_ = report == reports_.end() ? nullptr : &*report;
    if (report_ != nullptr && report_->utilisation)
      made.relative_uncertainty = report_->utilisation->relative_uncertainty;
    make(made, crack);
    if (made.assembly) made.report.equations.emplace_back("FA-3");
    const TorqueSense given = gear_.load.torque > 0 ? TorqueSense::positive : TorqueSense::negative;
    result_.push_back(assess(made, material, given));
  }

  // --- the output shaft
  // ---------------------------------------------------------------------------

  void make(AssessedCrack& made, const AnnularCrack& crack) {
    const OutputShaft& shaft = *gear_.output_shaft;
    const double r_o = shaft.outer_diameter / 2;
    const double r_i = shaft.inner_diameter / 2;
    made.report.size_name = "depth";
    made.report.size = crack.depth;
    made.report.ligament = r_o - r_i - crack.depth;
    made.report.equations.emplace_back("FA-7");
    const double P = P_;
    const double T = T_;
    if (shaft.solid()) {
      const sif::AnnularCrackSolid solid{.depth = crack.depth,
                                         .diameter = shaft.outer_diameter,
                                         .polynomials = crack.solution == AnnularSolution::tada
                                                            ? sif::AnnularPolynomials::tada
                                                            : sif::AnnularPolynomials::improved};
      made.front = [=](double a, double sense) {
        return std::vector<FrontModes>{{modes(solid.stress_intensity(a, 0), P, sense * T), {}}};
      };
      made.range_end = kNearlyAll * r_o;
      made.range_text = "the radius of the shaft";
    } else {
      const double end = sif::AnnularCrackHollow::kMaxDepthRatio * (r_o - r_i);
      // Shared: a std::function may be copied, the table need not.
      const auto hollow =
          std::make_shared<const sif::AnnularCrackHollow>(sif::AnnularCrackHollow::Parameters{
              .depth = end, .outer_radius = r_o, .inner_radius = r_i});
      made.front = [=](double a, double sense) {
        return std::vector<FrontModes>{{modes(hollow->stress_intensity(a, 0), P, sense * T), {}}};
      };
      made.range_end = end;
      made.range_text = "0.8 of the wall, the range of the stress intensity";
    }
    made.reference_stress = [=](double a, double sense) {
      return ring_reference_stress({.outer_radius = r_o - a, .inner_radius = r_i}, P, sense * T);
    };
  }

  // --- the flexspline
  // -----------------------------------------------------------------------------

  void make(AssessedCrack& made, const WallThroughCrack& crack) {
    const Wall wall = wall_of(gear_, crack.section);
    const double K_u = gear_.flexspline->stress_nonuniformity;
    const sif::ThroughCrackInTube through{.half_length = crack.half_length,
                                          .mean_radius = wall.mean_radius,
                                          .wall_thickness = wall.thickness,
                                          .angle = crack.angle,
                                          .stress_nonuniformity = K_u,
                                          .poissons_ratio = steel_.nu,
                                          .shell_correction = crack.shell_correction};
    const sif::CrackPlaneStress plane =
        sif::crack_plane_stress(wall.mean_radius, wall.thickness, crack.angle, K_u);
    const AssemblyStress bending = assembly_of(made, wall, crack.angle);
    if (on_rim(crack.section)) made.undecided = kRim;
    made.moduli.opening = steel_.E;
    made.plane_stress = true;
    const double P = P_;
    const double T = T_;
    made.front = [=](double a, double sense) {
      const double root = std::sqrt(pi * a);
      sif::ThroughCrackInTube pressed = through;
      pressed.open = false;
      const bool faces_pressed = plane.normal[kAxial] * P + plane.normal[kTorsion] * sense * T < 0;
      std::vector<FrontModes> front;
      for (const double s : {-1.0, 0.0, 1.0}) {
        std::array<double, 3> load = modes(through.stress_intensity(a, s), P, sense * T);
        if (faces_pressed) {  // (FR-17): they carry what presses them, and slide by the shear alone
          load[0] = std::min(load[0], 0.0);
          load[1] = modes(pressed.stress_intensity(a, s), P, sense * T)[1];
        }
        // (FA-14): the whole of the outer fibre's stress.
        front.push_back({load, {bending.normal * root, bending.shear * root, 0.0}});
      }
      return front;
    };
    const double round = 2 * pi * wall.mean_radius;
    const double sine = std::abs(std::sin(crack.angle));
    const double cosine = std::abs(std::cos(crack.angle));
    through_section(made, crack.half_length, crack.angle, wall, K_u);
    made.report.ligament = std::min(round / 2 - crack.half_length * sine,
                                    wall.length / 2 - crack.half_length * cosine);
    const double shell = sif::ThroughCrackInTube::kMaxShellParameter /
                         std::sqrt(through.shell_parameter_squared(1.0));
    const double half_round = kNearlyAll * pi * wall.mean_radius / (2 * sine);
    const double length = kNearlyAll * wall.length / (2 * cosine);
    made.range_end = std::min({shell, half_round, length});
    made.range_text = made.range_end == shell
                          ? "a shell parameter of 4"
                          : "the length of the tube, or half of its circumference";
    for (const char* const tag : {"FA-6", "FA-8"}) made.report.equations.emplace_back(tag);
    if (made.assembly) {
      made.report.equations.emplace_back("FA-14");
      made.report.notes.push_back(kThroughBending);
    }
  }

  void make(AssessedCrack& made, const WallSurfaceCrack& crack) {
    const Wall wall = wall_of(gear_, crack.section);
    const double K_u = gear_.flexspline->stress_nonuniformity;
    const double rho = crack.depth / crack.half_length;
    const sif::CrackPlaneStress stress =
        sif::crack_plane_stress(wall.mean_radius, wall.thickness, crack.angle, K_u);
    const sif::SurfaceCrack<2> surface({.depth = crack.depth,
                                        .aspect_ratio = rho,
                                        .thickness = wall.thickness,
                                        .poissons_ratio = steel_.nu,
                                        .normal_stress = stress.normal,
                                        .shear_stress = stress.shear});
    const sif::NewmanRajuPlate plate(rho);
    const sif::KassirSih sheared(rho, steel_.nu);
    const AssemblyStress bending = assembly_of(made, wall, crack.angle);
    if (on_rim(crack.section)) made.undecided = kRim;
    const double t = wall.thickness;
    const double P = P_;
    const double T = T_;
    made.front = [=](double a, double sense) {
      std::vector<FrontModes> front(kFrontPoints);
      const double root = std::sqrt(pi * a);
      for (int i = 0; i < kFrontPoints; ++i) {
        const double phi = pi / 2 * i / (kFrontPoints - 1);
        FrontModes& at = front[static_cast<std::size_t>(i)];
        at.load = modes(surface.stress_intensity(a, phi), P, sense * T);
        // (SP-3) for the bending; the shear of the surface, as if it went through the wall.
        at.assembly = {
            bending.normal * root * plate.tension(a / t, phi) * plate.bending_ratio(a / t, phi),
            bending.shear * root * sheared.factor_II(phi),
            bending.shear * root * sheared.factor_III(phi)};  // (FA-12)
      }
      return front;
    };
    const double r = wall.mean_radius;
    made.reference_stress = [=](double a, double sense) {
      const double sigma_vM =
          von_mises(P / (2 * pi * r * t), K_u * sense * T / (2 * pi * r * r * t));
      return ligament_reference_stress(SectionLoading::membrane, sigma_vM, a / t);
    };
    made.report.size_name = "depth";
    made.report.size = crack.depth;
    made.report.ligament = t - crack.depth;
    made.range_end = kSurfaceRange * t;
    made.range_text = "0.8 of the wall, the range of the stress intensity";
    for (const char* const tag : {"FA-6", "FA-9"}) made.report.equations.emplace_back(tag);
    if (made.assembly) made.report.equations.emplace_back("SP-3");
  }

  void make(AssessedCrack& made, const DiaphragmArcCrack& crack) {
    const Diaphragm& diaphragm = *gear_.flexspline->diaphragm;
    const double r = crack.radius.value_or(diaphragm.inner_diameter / 2);
    const double h = diaphragm_thickness(diaphragm, r);
    const sif::ThroughCrackInTube through{.half_length = crack.half_length,
                                          .mean_radius = r,
                                          .wall_thickness = h,
                                          .angle = 0,
                                          .poissons_ratio = steel_.nu,
                                          .shell_correction = false};
    made.moduli.opening = steel_.E;
    made.plane_stress = true;
    const double T = T_;
    made.front = [=](double a, double sense) {
      return std::vector<FrontModes>{{modes(through.stress_intensity(a, 0), 0, sense * T), {}}};
    };
    const Wall annulus{r, h, std::numeric_limits<double>::infinity()};
    through_section(made, crack.half_length, pi / 2, annulus, 1.0, 0.0);
    made.report.ligament = pi * r - crack.half_length;
    made.range_end = r / 2;
    made.range_text = "half of the arc's radius";
    made.undecided = kDiaphragm;
    for (const char* const tag : {"FA-6", "FA-8"}) made.report.equations.emplace_back(tag);
  }

  void make(AssessedCrack& made, const DiaphragmGroove& groove) {
    const Diaphragm diaphragm = *gear_.flexspline->diaphragm;
    // The law is linear between the stations: what is worst is at an end or at one of them.
    std::vector<std::array<double, 2>> places;  // radius, thickness
    const double inner = groove.radius - groove.width / 2;
    const double outer = groove.radius + groove.width / 2;
    double thinnest = std::numeric_limits<double>::infinity();
    const auto add = [&](double r) {
      places.push_back({r, diaphragm_thickness(diaphragm, r)});
      thinnest = std::min(thinnest, places.back()[1]);
    };
    add(inner);
    add(outer);
    for (const DiaphragmStation& station : diaphragm.profile)
      if (station.radius > inner && station.radius < outer) add(station.radius);
    const double T = T_;
    made.front = [=](double d, double sense) {
      std::vector<FrontModes> front;
      for (const auto& [r, h] : places)
        front.push_back({{0, 0, groove_intensity(annulus_shear(sense * T, r, h), d, h)}, {}});
      return front;
    };
    made.reference_stress = [=](double d, double sense) {
      double worst = 0.0;
      for (const auto& [r, h] : places)
        worst = std::max(worst, ligament_reference_stress(
                                    SectionLoading::membrane,
                                    von_mises(0.0, annulus_shear(sense * T, r, h)), d / h));
      return worst;  // (FA-11)
    };
    made.report.size_name = "depth";
    made.report.size = groove.depth;
    made.report.ligament = thinnest - groove.depth;
    made.range_end = kNearlyAll * thinnest;
    made.range_text = "the thickness of the diaphragm";
    made.undecided = kDiaphragm;
    made.report.notes.push_back(kGroove);
    for (const char* const tag : {"FA-6", "FA-9", "FA-11"}) made.report.equations.emplace_back(tag);
  }

  /// Reference stress and size of a crack through a wall.
  void through_section(AssessedCrack& made, double half_length, double angle, const Wall& wall,
                       double K_u) {
    through_section(made, half_length, angle, wall, K_u, P_);
  }
  void through_section(AssessedCrack& made, double half_length, double angle, const Wall& wall,
                       double K_u, double P) {
    const double T = T_;
    made.reference_stress = [=](double a, double sense) {
      const auto share = through_wall_share({.half_length = a,
                                             .angle = angle,
                                             .mean_radius = wall.mean_radius,
                                             .length = wall.length});
      const double section = 2 * pi * wall.mean_radius * wall.thickness;
      return von_mises(P / section, K_u * sense * T / (section * wall.mean_radius)) /
             share.value();  // (FA-8); the range ends before nothing is left
    };
    made.report.size_name = "half_length";
    made.report.size = half_length;
  }

  [[nodiscard]] bool on_rim(WallSection section) const {
    return gear_.flexspline->crack_free != CrackFree::factor && section == WallSection::rim;
  }

  AssemblyStress assembly_of(AssessedCrack& made, const Wall& wall, double angle) {
    if (gear_.drive.wave_number < 2) return {};  // one lobe shifts the ring, it does not bend it
    made.assembly = true;
    made.report.notes.push_back(kAssembly);
    for (const char* const tag : {"ST-17", "FA-12"}) made.report.equations.emplace_back(tag);
    made.assembly_peak = assembly_stress(gear_, wall.mean_radius, wall.thickness, 0.0).normal;
    return assembly_stress(gear_, wall.mean_radius, wall.thickness, angle);
  }

  // --- the wave generator
  // -------------------------------------------------------------------------

  void make(AssessedCrack& made, const RaceSurfaceCrack& crack) {
    const sif::NewmanRaju fit(crack.aspect_ratio);
    const double t = *gear_.wave_generator->inner_ring_thickness;
    race(
        made, crack.stress_driver, crack.depth, kSurfaceRange * t,
        [=](double a, double phi) { return fit.factor(a / t, phi); }, kFrontPoints,
        SectionLoading::membrane);
    made.range_text = "0.8 of the ring, the range of the stress intensity";
  }

  void make(AssessedCrack& made, const RaceEdgeCrack& crack) {
    const double t = *gear_.wave_generator->inner_ring_thickness;
    const bool bent = crack.stress_driver == StressDriver::ring_bending;
    const sif::StripLoading loading =
        bent ? sif::StripLoading::bending : sif::StripLoading::tension;
    race(
        made, crack.stress_driver, crack.depth, kNearlyAll * t,
        [=](double a, double) { return sif::edge_crack_factor(loading, a / t); }, 1,
        bent ? SectionLoading::bending : SectionLoading::membrane);
    made.range_text = "the thickness of the ring";
  }

  /// What no driver contains, and the driver that decides nothing; empty: all is there.
  [[nodiscard]] std::string missing(StressDriver driver) const {
    std::string text = driver == StressDriver::orthogonal_shear ? kOrder : "";
    const int U = gear_.drive.wave_number;
    if (U < 2) return text;  // one lobe shifts the ring, it does not bend it
    const WaveGenerator& wg = *gear_.wave_generator;
    const double t = *wg.inner_ring_thickness;
    std::optional<double> R = wg.inner_ring_mean_radius;
    if (!R && wg.bearing) R = (wg.bearing->inner_raceway_diameter - t) / 2;
    std::string size;
    if (R) {
      const double stress = steel_.plane_strain_modulus() * t / 2 * (U * U - 1) *
                            gear_.drive.radial_displacement / (*R * *R);  // (SW-9)
      size = fmt::format(", about {:.3g} MPa at the lobe,", stress / units::MPa);
    }
    if (!text.empty()) text += ", and ";
    return text +
           fmt::format("the ring's bending by its cam{} is not in the driver's stress", size);
  }

  /// A crack of the inner ring; `factor(a, phi)` is K_I/(sigma sqrt(pi a)).
  template <class Factor>
  void race(AssessedCrack& made, StressDriver driver, double depth, double range,
            const Factor& factor, int points, SectionLoading loading) {
    const double t = *gear_.wave_generator->inner_ring_thickness;
    // The stress is the driver's: what the stiffness made K of, at the deepest point.
    const double K = report_ != nullptr && report_->deepest ? report_->deepest->K_I.value : 0.0;
    const double stress = K / (factor(depth, pi / 2) * std::sqrt(pi * depth));
    made.front = [=](double a, double) {
      std::vector<FrontModes> front;
      for (int i = 0; i < points; ++i) {
        const double phi = points == 1 ? pi / 2 : pi / 2 * i / (points - 1);
        front.push_back({{stress * factor(a, phi) * std::sqrt(pi * a), 0, 0}, {}});
      }
      return front;
    };
    made.reference_stress = [=](double a, double) {
      return ligament_reference_stress(loading, std::abs(stress), a / t);
    };
    made.report.size_name = "depth";
    made.report.size = depth;
    made.report.ligament = t - depth;
    made.range_end = range;
    made.undecided = missing(driver);
    made.report.notes.push_back(kFit);
    made.report.equations.emplace_back(loading == SectionLoading::membrane ? "FA-9" : "FA-10");
    if (gear_.drive.wave_number >= 2) made.report.equations.emplace_back("SW-9");
  }

  const GearSet& gear_;
  std::span<const CrackReport> reports_;
  double P_, T_;
  ElasticConstants steel_;
  const CrackReport* report_ = nullptr;
  std::vector<CrackStrength> result_;
};

}  // namespace

AssemblyStress assembly_stress(const GearSet& gear, double mean_radius, double thickness,
                               double angle) {
  if (!gear.flexspline) throw InputError("flexspline", "must be given (its assembly bends it)");
  require(mean_radius > 0, "mean_radius", mean_radius, "m", "mean_radius > 0");
  require(thickness > 0, "thickness", thickness, "m", "thickness > 0");
  const ElasticConstants steel =
      elastic_constants(material_of(gear, gear.flexspline->material, "flexspline.material"));
  const int U = gear.drive.wave_number;
  const double curvature =
      (U * U - 1) * gear.drive.radial_displacement / (mean_radius * mean_radius);
  const double hoop = steel.plane_strain_modulus() * thickness / 2 * curvature;  // (ST-17)
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  return {.normal = hoop * (c * c + steel.nu * s * s),
          .shear = -(1 - steel.nu) * hoop * s * c};  // (FA-12)
}

std::vector<CrackStrength> crack_strength(const GearSet& gear,
                                          std::span<const CrackReport> reports) {
  check(gear);
  return Maker(gear, reports).all();
}

std::vector<CrackStrength> crack_strength(const GearSet& gear) {
  const StiffnessResult result = torsional_stiffness(gear);
  return crack_strength(gear, result.cracks);
}

}  // namespace strainwave
