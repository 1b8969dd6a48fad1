// SPDX-License-Identifier: Apache-2.0
#include "strainwave/oval_shell/oval_shell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <numbers>

#include "meridian.hpp"
#include "strainwave/contact/one_sided.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/model/input/section_materials.hpp"

namespace strainwave {
namespace {

using namespace meridian;
using Eigen::Index;
using Eigen::VectorXd;
using std::numbers::pi;

constexpr int kIntervals = 24;         // of the contact over a quarter turn; 2 kIntervals waves
constexpr int kBentWaves = 7;          // numbers of waves with large rotations: 0 to 12
constexpr int kBentAngles = 16;        // intervals over a quarter turn of what large rotations add
constexpr int kSamples = 4;            // places of each element at which waves are kept
constexpr double kEndRounding = 1e-9;  // share by which rounding may carry a place beyond a part

/// What one place of an element needs to know of large rotations.
struct BentPlace {
  std::size_t element;
  double weight;  ///< length along the meridian times radius [m^2]
  std::array<StrainRows, kBentWaves> rows;
};

/// Solves a cup.
class Solver {
 public:
  Solver(const ShellCup& cup, const CamFit& cam, const ShellOptions& options)
      : cup_(cup), cam_(cam), options_(options), line_(meridian_of(cup, cam.band_width)) {
    bore_ = cup.rim.outer_diameter / 2 - cup.rim.wall_thickness;
    middle_ = (cup.rim.outer_diameter - cup.rim.wall_thickness) / 2;
    for (std::size_t e = line_.band_from; e < line_.band_to; ++e)
      width_ += line_.elements[e].length();
    for (int k = 0; k <= kIntervals; ++k) {
      equations_.emplace_back(line_.elements, cup_, 2 * k);
      load_.push_back(VectorXd::Zero(line_.unknowns));
      round_.push_back(VectorXd::Zero(line_.unknowns));
      axial_tilt_.push_back(VectorXd::Zero(line_.unknowns));
      hoop_tilt_.push_back(VectorXd::Zero(line_.unknowns));
      for (std::size_t e = line_.band_from; e < line_.band_to; ++e) {
        const Element& element = line_.elements[e];
        for (std::size_t g = 0; g < kGaussAt.size(); ++g) {
          const auto rows =
              element.displacement(2 * k, kGaussAt[g], bore_ - element.radius(kGaussAt[g]));
          const double weight = kGaussWeight[g] * element.length() / width_;
          add(load_.back(), element, rows.row(0).transpose() * weight);
          add(round_.back(), element, rows.row(1).transpose() * weight);
          const StrainRows strains = element.strains(2 * k, kGaussAt[g]);
          add(axial_tilt_.back(), element, strains.row(6).transpose() * weight);
          add(hoop_tilt_.back(), element, strains.row(7).transpose() * weight);
        }
      }
      unit_.push_back(equations_.back().solve(load_.back() * (bore_ * width_)));
      compliance_.push_back(load_.back().dot(unit_.back()));
    }
    for (int i = 0; i <= kIntervals; ++i)
      for (int j = 0; j <= kIntervals; ++j) {
        double& entry = matrix_.emplace_back(0.0);
        for (int k = 0; k <= kIntervals; ++k)
          entry +=
              share(i) * compliance_[static_cast<std::size_t>(k)] * cosine(k, i) * amplitude(k, j);
      }
  }

  [[nodiscard]] OvalShell solve() {
    OvalShell result;
    result.cup = cup_;
    const double w0 = cam_.radial_displacement;
    const double bending = 1.5 * w0 * cup_.rim.wall_thickness / (middle_ * middle_) /
                           (1 - cup_.poissons_ratio * cup_.poissons_ratio);
    result.large_rotations = options_.large_rotations == LargeRotations::automatic
                                 ? std::pow(w0 / middle_, 2) > 0.02 * bending
                                 : options_.large_rotations == LargeRotations::on;
    const CamCurve curve(cam_, bore_, middle_, result.large_rotations);
    if (!(curve.farthest() > 0))
      throw InputError("wave_generator",
                       fmt::format("the cam is smaller than the bore of the rim by {:.4g} mm, so "
                                   "it does not touch; give a smaller clearance",
                                   -curve.farthest() / units::mm));
    std::vector<double> target;
    for (int j = 0; j <= kIntervals; ++j)
      target.push_back(CamCurve(cam_, bore_, middle_, false).at(angle(j)));
    press(target, {});
    for (std::size_t k = 0; k < unit_.size(); ++k) waves_.push_back(unit_[k] * pressure_[k]);
    if (result.large_rotations) result.contact.iterations = bend(curve);
    take_contact(result.contact);
    result.pressure = touching_;
    take_places(result);
    return result;
  }

 private:
  static double angle(int j) { return pi / 2 * j / kIntervals; }
  static double cosine(int k, int j) { return circle()[turned(k, j)][0]; }
  static double sine(int k, int j) { return circle()[turned(k, j)][1]; }
  static constexpr std::size_t kSteps = std::size_t{2} * kIntervals;
  /// 2 k angle(j) in steps of pi/kIntervals, within a turn.
  static std::size_t turned(int k, int j) {
    return static_cast<std::size_t>(k) * static_cast<std::size_t>(j) % kSteps;
  }
  /// Cosine and sine of these steps.
  static const std::array<std::array<double, 2>, kSteps>& circle() {
    static const auto table = [] {
      std::array<std::array<double, 2>, kSteps> filled;
      for (std::size_t i = 0; i < filled.size(); ++i) {
        const double at = pi * static_cast<double>(i) / kIntervals;
        filled[i] = {std::cos(at), std::sin(at)};
      }
      return filled;
    }();
    return table;
  }
  static double share(int j) { return j == 0 || j == kIntervals ? 0.5 : 1.0; }
  /// Amplitude of wave 2 k in a function that is 1 at angle j and 0 at the others.
  static double amplitude(int k, int j) {
    return 2.0 / kIntervals * share(k) * share(j) * cosine(k, j);
  }

  static void add(VectorXd& to, const Element& element,
                  const Eigen::Matrix<double, kElementUnknowns, 1>& part) {
    for (int i = 0; i < kElementUnknowns; ++i)
      if (const Index at = element.unknown + place_of(i); at >= 0) to[at] += part[i];
  }
  static Eigen::Matrix<double, kElementUnknowns, 1> of(const VectorXd& from,
                                                       const Element& element) {
    Eigen::Matrix<double, kElementUnknowns, 1> part;
    for (int i = 0; i < kElementUnknowns; ++i) {
      const Index at = element.unknown + place_of(i);
      part[i] = at >= 0 ? from[at] : 0.0;
    }
    return part;
  }

  /// Finds the waves of the pressure that keeps the band outside of the target (CU-2).
  /// @param free  radial displacement of the band without pressure, by waves
  void press(const std::vector<double>& target, const std::vector<double>& free) {
    std::vector<double> gap;
    for (int j = 0; j <= kIntervals; ++j) {
      double open = -target[static_cast<std::size_t>(j)];
      for (std::size_t k = 0; k < free.size(); ++k)
        open += free[k] * cosine(static_cast<int>(k), j);
      gap.push_back(share(j) * open);
    }
    touching_ = solve_one_sided(matrix_, gap, touching_).pressure;
    pressure_.assign(gap.size(), 0.0);
    for (int k = 0; k <= kIntervals; ++k)
      for (int j = 0; j <= kIntervals; ++j)
        pressure_[static_cast<std::size_t>(k)] +=
            amplitude(k, j) * touching_[static_cast<std::size_t>(j)];
  }

  /// Large rotations: the stiffness stays, and what they add acts as a load (CU-3).
  int bend(const CamCurve& curve) {
    constexpr int kMost = 100;
    constexpr double kSettled = 1e-6;  // share of w_0
    prepare_places();
    for (int step = 1; step <= kMost; ++step) {
      std::vector<VectorXd> added = rotation_loads();
      std::vector<double> target;
      std::vector<double> tangential;  // the pressure acts along the normal of the cam
      for (int j = 0; j <= kIntervals; ++j) {
        double outward = 0;
        double round = 0;
        double axial_tilt = 0;
        double hoop_tilt = 0;
        for (int k = 0; k <= kIntervals; ++k) {
          const auto at = static_cast<std::size_t>(k);
          outward += load_[at].dot(waves_[at]) * cosine(k, j);
          round += round_[at].dot(waves_[at]) * sine(k, j);
          axial_tilt += axial_tilt_[at].dot(waves_[at]) * cosine(k, j);
          hoop_tilt += hoop_tilt_[at].dot(waves_[at]) * sine(k, j);
        }
        // The bore hangs on the tilted normal, so it lies further out than the middle surface says.
        const double lift =
            (middle_ - bore_) / 2 * (axial_tilt * axial_tilt + hoop_tilt * hoop_tilt);
        const CamGap gap(curve, angle(j), outward + lift, round);
        target.push_back(outward - gap.value);
        tangential.push_back(touching_[static_cast<std::size_t>(j)] * gap.by_theta);
      }
      std::vector<VectorXd> free;
      std::vector<double> displaced;
      for (std::size_t k = 0; k < kBentWaves; ++k) {
        double amplitude = 0;
        for (int j = 0; j <= kIntervals; ++j)
          amplitude += 2.0 / kIntervals * tangential[static_cast<std::size_t>(j)] *
                       sine(static_cast<int>(k), j);
        added[k] += amplitude * bore_ * width_ * round_[k];
        free.push_back(equations_[k].solve(added[k]));
        displaced.push_back(load_[k].dot(free.back()));
      }
      press(target, displaced);
      double change = 0;
      for (std::size_t k = 0; k < waves_.size(); ++k) {
        VectorXd now = unit_[k] * pressure_[k];
        if (k < kBentWaves) now += free[k];
        change = std::max(change, std::abs(load_[k].dot(now - waves_[k])));
        waves_[k] = std::move(now);
      }
      if (!std::isfinite(change)) break;
      if (change <= kSettled * cam_.radial_displacement) return step;
    }
    throw SolverError(
        fmt::format("the large rotations of the oval did not settle in {} iterations; give a "
                    "smaller radial_displacement",
                    kMost));
  }

  void prepare_places() {
    for (std::size_t e = 0; e < line_.elements.size(); ++e) {
      const Element& element = line_.elements[e];
      for (std::size_t g = 0; g < kGaussAt.size(); ++g) {
        BentPlace& place = places_.emplace_back();
        place.element = e;
        place.weight = kGaussWeight[g] * element.length() * element.radius(kGaussAt[g]);
        for (int k = 0; k < kBentWaves; ++k)
          place.rows[static_cast<std::size_t>(k)] = element.strains(2 * k, kGaussAt[g]);
      }
    }
  }

  /// Loads of the waves 0 to 12 by which large rotations act on the linear stiffness.
  [[nodiscard]] std::vector<VectorXd> rotation_loads() const {
    std::vector<VectorXd> loads(kBentWaves, VectorXd::Zero(line_.unknowns));
    std::array<Eigen::Matrix<double, kElementUnknowns, 1>, kBentWaves> part;
    std::size_t last = line_.elements.size();
    for (const BentPlace& place : places_) {
      const Element& element = line_.elements[place.element];
      const Eigen::Matrix3d D = elasticity(cup_, element.thickness).topLeftCorner<3, 3>();
      if (place.element != last) {  // the places of an element follow each other
        last = place.element;
        for (std::size_t k = 0; k < kBentWaves; ++k) part[k] = of(waves_[k], element);
      }
      std::array<Strains, kBentWaves> wave;
      for (std::size_t k = 0; k < kBentWaves; ++k) wave[k] = place.rows[k].lazyProduct(part[k]);
      std::array<Strains, kBentWaves> force;
      force.fill(Strains::Zero());
      for (int j = 0; j <= kBentAngles; ++j) {
        Strains sum = Strains::Zero();
        for (int k = 0; k < kBentWaves; ++k)
          sum += wave[static_cast<std::size_t>(k)].cwiseProduct(trigonometric(k, j));
        const double axial = sum[6];
        const double hoop = sum[7];
        const double spin = sum[8];
        const Eigen::Vector3d second{(axial * axial + spin * spin) / 2,
                                     (hoop * hoop + spin * spin) / 2, axial * hoop};
        const Eigen::Vector3d added = D * second;
        const Eigen::Vector3d N = D * (sum.head<3>() + second);
        Strains f = Strains::Zero();
        f.head<3>() = added;
        f[6] = N[0] * axial + N[2] * hoop;
        f[7] = N[1] * hoop + N[2] * axial;
        f[8] = (N[0] + N[1]) * spin;
        const double ends = j == 0 || j == kBentAngles ? 0.5 : 1.0;
        for (int k = 0; k < kBentWaves; ++k)
          force[static_cast<std::size_t>(k)] +=
              f.cwiseProduct(trigonometric(k, j)) * (ends * (k == 0 ? 1.0 : 2.0) / kBentAngles);
      }
      for (std::size_t k = 0; k < kBentWaves; ++k)
        add(loads[k], element, -place.weight * place.rows[k].transpose().lazyProduct(force[k]));
    }
    return loads;
  }

  /// The factors by which the amplitudes of wave 2 k vary round the axis, at angle j.
  static const Strains& trigonometric(int k, int j) {
    using Table = std::array<std::array<Strains, kBentAngles + 1>, kBentWaves>;
    static const Table table = [] {
      Table filled;
      for (std::size_t wave = 0; wave < kBentWaves; ++wave)
        for (std::size_t i = 0; i <= kBentAngles; ++i) {
          const double at = static_cast<double>(wave * i) * pi / kBentAngles;
          const double c = std::cos(at);
          const double s = std::sin(at);
          filled[wave][i] << c, c, s, c, c, s, c, s, s;
        }
      return filled;
    }();
    return table[static_cast<std::size_t>(k)][static_cast<std::size_t>(j)];
  }

  void take_contact(ShellContact& contact) const {
    for (int j = 0; j <= kIntervals; ++j) {
      const double pressure = touching_[static_cast<std::size_t>(j)];
      if (pressure > 0) contact.half_arc = angle(j);
      contact.largest_pressure = std::max(contact.largest_pressure, pressure);
    }
    for (int k = 0; k <= kIntervals; ++k)
      contact.lobe_force += pressure_[static_cast<std::size_t>(k)] * 2 * (k % 2 == 0 ? 1 : -1) /
                            (1.0 - 4.0 * k * k) * bore_ * width_;
  }

  void take_places(OvalShell& result) const {
    if (options_.whole_meridian) take_part(result, WallPart::diaphragm, 0, line_.barrel_from);
    take_part(result, WallPart::barrel, line_.barrel_from, line_.rim_from);
    if (options_.whole_meridian)
      take_part(result, WallPart::rim, line_.rim_from, line_.elements.size());
  }

  void take_part(OvalShell& result, WallPart part, std::size_t from, std::size_t to) const {
    for (std::size_t e = from; e < to; ++e) {
      const Element& element = line_.elements[e];
      const bool last = e + 1 == to;
      for (int i = 0; i < kSamples + (last ? 1 : 0); ++i) {
        const double along = static_cast<double>(i) / kSamples;
        const double z = element.z[0] + along * (element.z[1] - element.z[0]);
        ShellPlace& place = result.places.emplace_back();
        place.part = part;
        place.radius = element.radius(along);
        place.at = part == WallPart::diaphragm ? place.radius : z;
        place.thickness = element.thickness;
        // The torque acts evenly over the length of the rim.
        place.torque_share =
            part == WallPart::rim ? 1 - (z - cup_.barrel.length) / cup_.rim.length : 1;
        for (std::size_t k = 0; k < waves_.size(); ++k) {
          const Strains q =
              element.strains(static_cast<int>(2 * k), along) * of(waves_[k], element);
          place.waves.push_back({q[0], q[1], q[2], q[3], q[4], q[5], q[6], q[7], q[8]});
        }
      }
    }
  }

  const ShellCup& cup_;
  const CamFit& cam_;
  const ShellOptions& options_;
  Meridian line_;
  double bore_ = 0;
  double middle_ = 0;
  double width_ = 0;
  // Over the numbers of waves 0, 2, 4, ...
  std::deque<Equations> equations_;
  std::vector<VectorXd> load_;        ///< mean radial displacement of the band over the unknowns
  std::vector<VectorXd> round_;       ///< the same round the axis, at the bore
  std::vector<VectorXd> axial_tilt_;  ///< mean rotations of the band's normal
  std::vector<VectorXd> hoop_tilt_;
  std::vector<VectorXd> unit_;  ///< of a unit pressure
  std::vector<double> compliance_;
  std::vector<double> matrix_;
  std::vector<double> touching_;  ///< pressure at the angles [Pa]
  std::vector<double> pressure_;  ///< of the waves [Pa]
  std::vector<VectorXd> waves_;
  std::vector<BentPlace> places_;
};

void check(const ShellCup& cup, const CamFit& cam) {
  const auto length = [](double value, const char* name, bool zero) {
    require((zero ? value >= 0 : value > 0) && std::isfinite(value), name, value, "m",
            zero ? ">= 0" : "> 0");
  };
  for (const TubeSection* const tube : {&cup.barrel, &cup.rim}) {
    length(tube->length, "length", false);
    length(tube->wall_thickness, "wall_thickness", false);
    require(tube->outer_diameter > 4 * tube->wall_thickness, "outer_diameter", tube->outer_diameter,
            "m", "more than four walls");
  }
  check(cam, cup.rim);
  require(cup.youngs_modulus > 0 && std::isfinite(cup.youngs_modulus), "youngs_modulus",
          cup.youngs_modulus, "Pa", "> 0");
  require(cup.poissons_ratio >= 0 && cup.poissons_ratio < 0.5, "poissons_ratio", cup.poissons_ratio,
          "1", ">= 0 and < 0.5");
}

}  // namespace

OvalShell oval_shell(const ShellCup& cup, const CamFit& cam, const ShellOptions& options) {
  check(cup, cam);
  return Solver(cup, cam, options).solve();
}

ShellCup shell_cup(const GearSet& gear) {
  const Flexspline& flexspline = *gear.flexspline;
  const ElasticConstants steel = elastic_constants(only_material(gear, flexspline));
  return {.barrel = *flexspline.barrel,
          .rim = *flexspline.rim,
          .diaphragm = flexspline.diaphragm,
          .youngs_modulus = steel.E,
          .poissons_ratio = steel.nu};
}

std::array<double, 2> ShellCup::ends(WallPart part) const {
  if (part == WallPart::barrel) return {0, barrel.length};
  if (part == WallPart::rim) return {barrel.length, barrel.length + rim.length};
  if (!diaphragm) return {0, 0};
  return {diaphragm->inner_diameter / 2, (barrel.outer_diameter - barrel.wall_thickness) / 2};
}

std::span<const ShellPlace> OvalShell::part(WallPart part) const {
  const auto first = std::ranges::lower_bound(places, part, {}, &ShellPlace::part);
  const auto last = std::ranges::upper_bound(places, part, {}, &ShellPlace::part);
  return {first, last};
}

ShellPlace OvalShell::at(WallPart part, double at) const {
  const auto [from, to] = cup.ends(part);
  const double slack = kEndRounding * to;
  const std::span<const ShellPlace> of_part = this->part(part);
  require(!of_part.empty() && at >= from - slack && at <= to + slack, enum_name(part), at, "m",
          fmt::format(">= {:.6g} mm and <= {:.6g} mm", from / units::mm, to / units::mm));
  std::size_t above = 1;
  while (above + 1 < of_part.size() && of_part[above].at <= at) ++above;
  const ShellPlace& below = of_part[above - 1];
  const ShellPlace& beyond = of_part[above];
  const double share = (at - below.at) / (beyond.at - below.at);
  const auto between = [share](double a, double b) { return a + share * (b - a); };
  ShellPlace result = below;
  result.at = at;
  result.radius = between(below.radius, beyond.radius);
  result.torque_share = between(below.torque_share, beyond.torque_share);
  for (std::size_t k = 0; k < below.waves.size(); ++k) {
    const ShellWave& a = below.waves[k];
    const ShellWave& b = beyond.waves[k];
    result.waves[k] = {between(a.axial_strain, b.axial_strain),
                       between(a.hoop_strain, b.hoop_strain),
                       between(a.shear_strain, b.shear_strain),
                       between(a.axial_bend, b.axial_bend),
                       between(a.hoop_bend, b.hoop_bend),
                       between(a.twist, b.twist),
                       between(a.axial_rotation, b.axial_rotation),
                       between(a.hoop_rotation, b.hoop_rotation),
                       between(a.spin, b.spin)};
  }
  return result;
}

WallStress OvalShell::stress(const ShellPlace& place, double zeta, double from_lobe,
                             double torque) const {
  ShellWave sum;
  for (std::size_t k = 0; k < place.waves.size(); ++k) {
    const double c = std::cos(2 * static_cast<double>(k) * from_lobe);
    const double s = std::sin(2 * static_cast<double>(k) * from_lobe);
    const ShellWave& of = place.waves[k];
    sum.axial_strain += c * of.axial_strain;
    sum.hoop_strain += c * of.hoop_strain;
    sum.shear_strain += s * of.shear_strain;
    sum.axial_bend += c * of.axial_bend;
    sum.hoop_bend += c * of.hoop_bend;
    sum.twist += s * of.twist;
    sum.axial_rotation += c * of.axial_rotation;
    sum.hoop_rotation += s * of.hoop_rotation;
    sum.spin += s * of.spin;
  }
  if (large_rotations) {
    const double spin = sum.spin * sum.spin / 2;
    sum.axial_strain += sum.axial_rotation * sum.axial_rotation / 2 + spin;
    sum.hoop_strain += sum.hoop_rotation * sum.hoop_rotation / 2 + spin;
    sum.shear_strain += sum.axial_rotation * sum.hoop_rotation;
  }
  const double t = place.thickness;
  const double r = place.radius;
  const double outside = zeta * t / 2;
  const bool flat = place.part == WallPart::diaphragm;
  const double nu = cup.poissons_ratio;
  const double axial = sum.axial_strain + outside * sum.axial_bend;
  const double hoop = (sum.hoop_strain + outside * sum.hoop_bend) / (flat ? 1 : 1 + outside / r);
  const double shear = sum.shear_strain + outside * sum.twist;
  const double plate = cup.youngs_modulus / (1 - nu * nu);
  const double J = pi / 2 * (std::pow(r + t / 2, 4) - std::pow(r - t / 2, 4));
  const double of_torque = flat ? 1 / (2 * pi * r * r * t) : (r + outside) / J;
  return {.axial = plate * (axial + nu * hoop),
          .hoop = plate * (hoop + nu * axial),
          .shear = cup.youngs_modulus / (2 * (1 + nu)) * shear +
                   place.torque_share * torque * of_torque};
}

WallStress OvalShell::stress(double z, double zeta, double from_lobe, double torque) const {
  return stress(barrel_at(z), zeta, from_lobe, torque);
}

}  // namespace strainwave
