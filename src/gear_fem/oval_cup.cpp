// SPDX-License-Identifier: Apache-2.0
#include "strainwave/gear_fem/oval_cup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "anderson.hpp"
#include "cup_shape.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/fem/complementarity.hpp"

namespace strainwave::gear_fem {
namespace {

using std::numbers::pi;

/// A part of the rim along z [m].
struct Band {
  double from;
  double to;
};

/// The pressed band and the rim, in the coordinates of CupSection.
struct RimPlaces {
  double bore;
  double outer;
  Band rim;
  Band pressed;
};

RimPlaces rim_places(const CupSection& cup, const CamFit& fit) {
  const double start = (cup.diaphragm ? cup.diaphragm->thickness : 0.0) + cup.barrel.length;
  const Band rim{start, start + cup.rim->length};
  const double width =
      fit.band_width > 0 ? std::min(fit.band_width, cup.rim->length) : cup.rim->length;
  const double middle = (rim.from + rim.to) / 2;
  return {.bore = cup.rim->outer_diameter / 2 - cup.rim->wall_thickness,
          .outer = cup.rim->outer_diameter / 2,
          .rim = rim,
          .pressed = {middle - width / 2, middle + width / 2}};
}

/// Adds grid lines toward both ends of a part with this wall, apart from other lines.
void add_fine_lines(std::vector<double>& lines, double from, double to, double wall) {
  const auto add = [&](double line) {
    constexpr double kApart = 0.2;  // walls
    if (std::ranges::none_of(lines,
                             [&](double other) { return std::abs(line - other) < kApart * wall; }))
      lines.push_back(line);
  };
  for (const double walls : {0.15, 0.5, 1.2, 2.5})
    if (walls * wall < 0.4 * (to - from)) {
      add(from + walls * wall);
      add(to - walls * wall);
    }
}

/// The section with grid lines at the ends of the band.
fem::SectionMesh mesh_oval_cup(const CupSection& cup, const Band& pressed, bool fine_corners) {
  CupShape drawn = cup_shape(cup);
  std::vector<double> along_z = {pressed.from, pressed.to};
  std::vector<double> along_r;
  if (fine_corners) {
    const double foot = cup.diaphragm ? cup.diaphragm->thickness : 0.0;
    const double joint = foot + cup.barrel.length;
    add_fine_lines(along_z, foot, joint, cup.barrel.wall_thickness);
    add_fine_lines(along_z, joint, joint + cup.rim->length, cup.rim->wall_thickness);
    if (cup.diaphragm)
      add_fine_lines(along_r, cup.diaphragm->inner_diameter / 2,
                     cup.barrel.outer_diameter / 2 - cup.barrel.wall_thickness,
                     cup.diaphragm->thickness);
  }
  std::ranges::sort(along_z);
  std::ranges::sort(along_r);
  drawn.shape.rectangles = cut_along_r(cut_along_z(drawn.shape.rectangles, along_z), along_r);
  fem::SectionMesh mesh = fem::mesh_section(drawn.shape, drawn.spacing);
  draw_profile(mesh, cup);
  return mesh;
}

/// Values at equal angles over a quarter turn, both ends included, as a sum of cos(2 k angle).
class QuarterTurn {
 public:
  explicit QuarterTurn(int intervals) : intervals_(intervals) {}

  [[nodiscard]] int points() const { return intervals_ + 1; }
  [[nodiscard]] double angle(int j) const { return pi / 2 * j / intervals_; }
  /// Weight of a point in sums over the quarter; the sum of all is `intervals`.
  [[nodiscard]] double weight(int j) const { return j == 0 || j == intervals_ ? 0.5 : 1.0; }
  [[nodiscard]] double cosine(int k, int j) const {
    return std::cos(pi * (k * j % (2 * intervals_)) / intervals_);
  }
  [[nodiscard]] double sine(int k, int j) const { return std::sin(2 * k * angle(j)); }
  /// Amplitude of cos(2 k angle) in a function of weight 1 at point j and 0 elsewhere.
  [[nodiscard]] double amplitude(int k, int j) const {
    return 2.0 / intervals_ * weight(k) * weight(j) * cosine(k, j);
  }

 private:
  int intervals_;
};

}  // namespace

struct OvalCup::Parts {
  fem::HarmonicSection section;
  std::vector<fem::HarmonicSolution> waves;        ///< of 0, 2, 4, ... waves
  std::vector<fem::HarmonicSolution> small_waves;  ///< for small rotations; empty if the same
  fem::HarmonicSolution torque;                    ///< per N*m
  OvalContact contact;
  double residual = 0;
  double second_order = 0;
};

namespace {

using Amplitudes = std::vector<double>;

/// Solves for the contact of the cam with the band.
class OvalSolver {
 public:
  OvalSolver(const fem::HarmonicSection& section, const RimPlaces& places, const CamFit& fit,
             const OvalOptions& options)
      : section_(section),
        places_(places),
        fit_(fit),
        options_(options),
        quarter_(options.most_waves / 2),
        count_(static_cast<std::size_t>(quarter_.points())) {
    // Points of the band whose mean displacement follows the cam.
    constexpr std::array kPoint = {0.9061798459386640, 0.5384693101056831, 0.0};
    constexpr std::array kWeight = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889};
    const double middle = (places.pressed.from + places.pressed.to) / 2;
    const double half = (places.pressed.to - places.pressed.from) / 2;
    std::vector<fem::SectionPoint> points;
    for (std::size_t i = 0; i < 3; ++i)
      for (const double side : {-1.0, 1.0}) {
        points.push_back({.r = places.bore, .z = middle + side * kPoint[i] * half});
        weights_.push_back(kWeight[i] / (kPoint[i] == 0 ? 4 : 2));
      }
    band_ = section.locate(points);
  }

  /// The waves of a unit pressure; returns the torque of 1 N*m as well.
  fem::HarmonicSolution solve_units() {
    const double shear =
        1 / (2 * pi * std::pow(places_.outer, 2) * (places_.rim.to - places_.rim.from));
    const double tiny = 1e-9 * places_.outer;
    const fem::EdgeTraction torque = [=, outer = places_.outer, rim = places_.rim](
                                         const fem::SectionPoint& p, const fem::SectionPoint& out) {
      return std::abs(p.r - outer) < tiny && out.r > 0.5 && within(p.z, rim, tiny)
                 ? fem::WaveVector{0, shear, 0}
                 : fem::WaveVector{};
    };
    fem::HarmonicSolution twisted;
    for (int k = 0; k < quarter_.points(); ++k) {
      std::vector<fem::EdgeTraction> loads{on_band(1, 0)};
      if (k == 0) loads.push_back(torque);
      fem::HarmonicEquations equations = section_.equations(2 * k);
      auto solved = equations.solve(loads);
      if (2 * k <= options_.most_bent_waves) bent_.push_back(std::move(equations));
      for (const fem::HarmonicSolution& one : solved)
        residual_ = std::max(residual_, one.equilibrium_residual);
      if (k == 0) twisted = std::move(solved[1]);
      unit_.push_back(std::move(solved[0]));
      compliance_.push_back(mean(unit_.back())[0]);
    }
    return twisted;
  }

  /// Small rotations.
  void solve_small(const CamCurve& cam) {
    Amplitudes target(count_);
    for (int j = 0; j < quarter_.points(); ++j) target[at(j)] = cam.at(quarter_.angle(j));
    press(target, {});
    for (std::size_t k = 0; k < count_; ++k) waves_.push_back(scaled(unit_[k], amplitude_[k]));
  }

  /// Large rotations, from the waves of small rotations on.  The linear stiffness is kept, and what
  /// the large rotations add acts as a load (FE-53).
  void solve_large(const CamCurve& cam) {
    constexpr int kMost = 80;
    constexpr double kSettled = 1e-7;  // share of w_0
    const std::size_t bent = bent_.size();
    Anderson anderson(5);
    for (iterations_ = 1; iterations_ <= kMost; ++iterations_) {
      const auto added = section_.large_rotation_forces(std::span(waves_).first(bent));
      std::vector<std::array<double, 2>> means;  // of u_r and u_theta
      for (const fem::HarmonicSolution& wave : waves_) means.push_back(mean(wave));
      Amplitudes target(count_);
      Amplitudes radial(count_);  // what the direction of the pressure adds [Pa]
      Amplitudes tangential(count_);
      for (int j = 0; j < quarter_.points(); ++j) {
        double u_r = 0;
        double u_theta = 0;
        for (int k = 0; k < quarter_.points(); ++k) {
          u_r += means[at(k)][0] * quarter_.cosine(k, j);
          if (k > 0) u_theta += means[at(k)][1] * quarter_.sine(k, j);
        }
        const CamGap gap(cam, quarter_.angle(j), u_r, u_theta);
        target[at(j)] = u_r - gap.value;
        radial[at(j)] = pressed_[at(j)] * (gap.by_r - 1);
        tangential[at(j)] = pressed_[at(j)] * gap.by_theta;
      }
      std::vector<fem::HarmonicSolution> free;
      Amplitudes displaced(count_, 0.0);  // without new pressure
      for (std::size_t k = 0; k < bent; ++k) {
        const int wave = static_cast<int>(k);
        free.push_back(
            bent_[k].solve(on_band(even(radial, wave), odd(tangential, wave)), added[k]));
        displaced[k] = mean(free.back())[0];
      }
      press(target, displaced);
      std::vector<double> before;
      std::vector<double> after;
      for (std::size_t k = 0; k < count_; ++k) {
        fem::HarmonicSolution now = scaled(unit_[k], amplitude_[k]);
        if (k < bent)
          for (std::size_t i = 0; i < now.displacement.size(); ++i)
            now.displacement[i] += free[k].displacement[i];
        before.insert(before.end(), waves_[k].displacement.begin(), waves_[k].displacement.end());
        after.insert(after.end(), now.displacement.begin(), now.displacement.end());
        waves_[k] = std::move(now);
      }
      double change = 0;
      for (std::size_t i = 0; i < after.size(); ++i)
        change = std::max(change, std::abs(after[i] - before[i]));
      if (!std::isfinite(change)) break;
      if (change <= kSettled * fit_.radial_displacement) return;
      const std::vector<double> next = anderson.next(before, after);
      auto from = next.begin();
      for (fem::HarmonicSolution& wave : waves_)
        for (double& u : wave.displacement) u = *from++;
    }
    throw SolverError(fmt::format(
        "the large rotations of the oval did not settle in {} iterations; use small rotations, or "
        "a smaller radial_displacement",
        kMost));
  }

  /// Contact of the solution, with the cam that it was solved for.
  [[nodiscard]] OvalContact contact(const CamCurve& cam, bool large) const {
    OvalContact contact;
    contact.steps = steps_;
    contact.large_rotations = large;
    contact.iterations = iterations_;
    for (int j = 0; j < quarter_.points(); ++j) {
      double u_r = 0;
      double u_theta = 0;
      for (int k = 0; k < quarter_.points(); ++k) {
        const auto of = mean(waves_[at(k)]);
        u_r += of[0] * quarter_.cosine(k, j);
        if (k > 0) u_theta += of[1] * quarter_.sine(k, j);
      }
      const double angle = quarter_.angle(j);
      const double gap = large ? CamGap(cam, angle, u_r, u_theta).value : u_r - cam.at(angle);
      contact.overlap = std::max(contact.overlap, -gap / fit_.radial_displacement);
      contact.largest_pressure = std::max(contact.largest_pressure, pressed_[at(j)]);
      if (pressed_[at(j)] > 0) contact.half_arc = angle;
    }
    // Over half a turn round a lobe: int cos 2kx cos x dx from -pi/2 to pi/2.
    for (int k = 0; k < quarter_.points(); ++k)
      contact.lobe_force += amplitude_[at(k)] * 2 * (k % 2 == 0 ? 1 : -1) / (1.0 - 4.0 * k * k) *
                            places_.bore * (places_.pressed.to - places_.pressed.from);
    return contact;
  }

  [[nodiscard]] const std::vector<fem::HarmonicSolution>& waves() const { return waves_; }
  [[nodiscard]] double residual() const { return residual_; }

 private:
  static std::size_t at(int j) { return static_cast<std::size_t>(j); }
  static bool within(double z, const Band& band, double tiny) {
    return z > band.from - tiny && z < band.to + tiny;
  }

  /// Radial and tangential traction on the band [Pa].
  [[nodiscard]] fem::EdgeTraction on_band(double radial, double tangential) const {
    const double tiny = 1e-9 * places_.outer;
    return [=, bore = places_.bore, pressed = places_.pressed](const fem::SectionPoint& p,
                                                               const fem::SectionPoint& out) {
      return std::abs(p.r - bore) < tiny && out.r < -0.5 && within(p.z, pressed, tiny)
                 ? fem::WaveVector{radial, tangential, 0}
                 : fem::WaveVector{};
    };
  }

  /// Mean of u_r and u_theta over the width of the band [m].
  [[nodiscard]] std::array<double, 2> mean(const fem::HarmonicSolution& wave) const {
    std::array<double, 2> sum{};
    for (std::size_t i = 0; i < band_.size(); ++i) {
      const auto u = section_.at(wave, band_[i]).displacement;
      sum[0] += weights_[i] * u[0];
      sum[1] += weights_[i] * u[1];
    }
    return sum;
  }

  static fem::HarmonicSolution scaled(fem::HarmonicSolution wave, double by) {
    for (double& u : wave.displacement) u *= by;
    return wave;
  }

  /// Amplitude of cos(2 k angle) in values at the points.
  [[nodiscard]] double even(const Amplitudes& values, int k) const {
    double sum = 0;
    for (int j = 0; j < quarter_.points(); ++j) sum += quarter_.amplitude(k, j) * values[at(j)];
    return sum;
  }
  /// Amplitude of sin(2 k angle).
  [[nodiscard]] double odd(const Amplitudes& values, int k) const {
    double sum = 0;
    for (int j = 1; j + 1 < quarter_.points(); ++j)
      sum += 2.0 / (quarter_.points() - 1) * quarter_.sine(k, j) * values[at(j)];
    return sum;
  }

  /// Finds the pressure that keeps the band outside of the target.
  /// @param target     radial displacement of the band at the points [m]
  /// @param displaced  waves of the band without pressure; empty: none
  void press(const Amplitudes& target, const Amplitudes& displaced) {
    const int n = quarter_.points();
    Amplitudes gap(count_);  // without pressure
    for (int j = 0; j < n; ++j) {
      gap[at(j)] = -target[at(j)];
      for (std::size_t k = 0; k < displaced.size(); ++k)
        gap[at(j)] += displaced[k] * quarter_.cosine(static_cast<int>(k), j);
    }
    amplitude_.assign(count_, 0.0);
    if (options_.one_sided) {
      if (matrix_.empty()) {
        matrix_.resize(count_ * count_);
        for (int i = 0; i < n; ++i)
          for (int j = 0; j < n; ++j)
            for (int k = 0; k < n; ++k)  // weights make the matrix symmetric
              matrix_[at(i) * count_ + at(j)] += quarter_.weight(i) * compliance_[at(k)] *
                                                 quarter_.cosine(k, i) * quarter_.amplitude(k, j);
      }
      Amplitudes weighted = gap;
      for (int j = 0; j < n; ++j) weighted[at(j)] *= quarter_.weight(j);
      fem::Complementarity answer =
          fem::solve_complementarity(matrix_, weighted, "the wave generator");
      pressed_ = std::move(answer.x);
      steps_ += answer.steps;
      for (int k = 0; k < n; ++k) amplitude_[at(k)] = even(pressed_, k);
      return;
    }
    pressed_.assign(count_, 0.0);
    for (int k = 0; k < n; ++k) amplitude_[at(k)] = -even(gap, k) / compliance_[at(k)];
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) pressed_[at(j)] += amplitude_[at(k)] * quarter_.cosine(k, j);
  }

  const fem::HarmonicSection& section_;
  const RimPlaces& places_;
  const CamFit& fit_;
  const OvalOptions& options_;
  QuarterTurn quarter_;
  std::size_t count_;
  std::vector<fem::SectionPlace> band_;
  Amplitudes weights_;
  std::vector<fem::HarmonicEquations> bent_;  ///< of the waves with large rotations
  std::vector<fem::HarmonicSolution> unit_;
  Amplitudes compliance_;  ///< mean displacement of the band per pressure [m/Pa]
  std::vector<double> matrix_;
  Amplitudes pressed_;    ///< at the points [Pa]
  Amplitudes amplitude_;  ///< of its waves [Pa]
  std::vector<fem::HarmonicSolution> waves_;
  int steps_ = 0;
  int iterations_ = 0;
  double residual_ = 0;
};

void check(const CupSection& cup, const CamFit& fit, const OvalOptions& options) {
  if (!cup.rim)
    throw InputError("flexspline.rim",
                     "must be given, because the wave generator presses on the bore of the rim");
  strainwave::check(fit, *cup.rim);
  require(options.order >= 3 && options.order <= 8, "order", options.order, "1", ">= 3 and <= 8");
  require(options.most_waves >= 8 && options.most_waves <= 96 && options.most_waves % 4 == 0,
          "most_waves", options.most_waves, "1", "a multiple of 4 from 8 to 96");
  require(options.most_bent_waves >= 4 && options.most_bent_waves <= 24 &&
              options.most_bent_waves % 2 == 0,
          "most_bent_waves", options.most_bent_waves, "1", "even, from 4 to 24");
}

}  // namespace

OvalCup::OvalCup(const CupSection& cup, const fem::Elasticity& steel, const CamFit& fit,
                 const OvalOptions& options) {
  check(cup, fit, options);
  const RimPlaces places = rim_places(cup, fit);
  parts_ = std::make_unique<Parts>(Parts{
      .section = fem::HarmonicSection(mesh_oval_cup(cup, places.pressed, options.fine_corners),
                                      steel, {.order = options.order}),
      .waves = {},
      .small_waves = {},
      .torque = {},
      .contact = {},
      .residual = 0,
      .second_order = 0});
  Parts& parts = *parts_;
  const double middle = (places.bore + places.outer) / 2;
  const double w0 = fit.radial_displacement;
  parts.second_order = steel.youngs_modulus * std::pow(w0 / middle, 2);
  const double nu = steel.poissons_ratio;
  const double bending = steel.youngs_modulus / (1 - nu * nu) * 1.5 * w0 *
                         (places.outer - places.bore) / (middle * middle);
  const bool large =
      options.large_rotations == LargeRotations::on ||
      (options.large_rotations == LargeRotations::automatic && parts.second_order > 0.02 * bending);
  const CamCurve small(fit, places.bore, middle, false);
  const CamCurve exact(fit, places.bore, middle, true);
  const CamCurve& cam = large ? exact : small;
  if (cam.farthest() <= 0)
    throw InputError("wave_generator",
                     fmt::format("the cam is smaller than the bore of the rim by {:.4g} mm, so it "
                                 "does not touch; give a smaller clearance",
                                 -cam.farthest() / units::mm));
  OvalSolver solver(parts.section, places, fit, options);
  parts.torque = solver.solve_units();
  solver.solve_small(small);
  if (large) {
    parts.small_waves = solver.waves();
    solver.solve_large(cam);
  }
  parts.waves = solver.waves();
  parts.residual = solver.residual();
  parts.contact = solver.contact(cam, large);
}

OvalCup::~OvalCup() = default;
OvalCup::OvalCup(OvalCup&&) noexcept = default;
OvalCup& OvalCup::operator=(OvalCup&&) noexcept = default;

const OvalContact& OvalCup::contact() const { return parts_->contact; }
std::size_t OvalCup::unknowns() const { return parts_->section.unknowns(); }
double OvalCup::equilibrium_residual() const { return parts_->residual; }
double OvalCup::second_order_stress() const { return parts_->second_order; }

OvalPlace OvalCup::at(double r, double z, double beyond) const {
  const std::array<fem::SectionPoint, 1> point{{{.r = r, .z = z}}};
  const fem::SectionPlace place = parts_->section.locate(point, beyond).front();
  OvalPlace result{.r = r,
                   .of_waves = {},
                   .of_small_waves = {},
                   .of_torque = parts_->section.at(parts_->torque, place)};
  for (const fem::HarmonicSolution& wave : parts_->waves)
    result.of_waves.push_back(parts_->section.at(wave, place));
  for (const fem::HarmonicSolution& wave : parts_->small_waves)
    result.of_small_waves.push_back(parts_->section.at(wave, place));
  return result;
}

namespace {

/// Adds a field of waves whose even components vary by `even` and the others by `odd`.
void add(OvalField& field, const fem::HarmonicPoint& point, double even, double odd) {
  for (std::size_t i = 0; i < 3; ++i)
    field.displacement[i] += (i == 1 ? odd : even) * point.displacement[i];
  for (std::size_t i = 0; i < 6; ++i)
    field.stress[i] += (i == 3 || i == 5 ? odd : even) * point.stress[i];
}

OvalField of_small(const std::vector<fem::HarmonicPoint>& waves, double from_lobe) {
  OvalField field;
  for (std::size_t k = 0; k < waves.size(); ++k) {
    const double angle = 2 * static_cast<double>(k) * from_lobe;
    add(field, waves[k], std::cos(angle), std::sin(angle));
  }
  return field;
}

}  // namespace

OvalField OvalCup::field(const OvalPlace& place, double from_lobe, double torque) const {
  OvalField field = of_small(place.of_waves, from_lobe);
  if (!place.of_small_waves.empty()) {
    fem::CylinderGradient gradient{};
    for (std::size_t k = 0; k < place.of_waves.size(); ++k)
      fem::add_gradient(gradient, place.of_waves[k], static_cast<int>(2 * k), place.r, from_lobe);
    field.stress = parts_->section.large_rotation_stress(gradient);  // (FE-53)
  }
  add(field, place.of_torque, torque, torque);
  return field;
}

OvalField OvalCup::small_field(const OvalPlace& place, double from_lobe, double torque) const {
  OvalField field =
      of_small(place.of_small_waves.empty() ? place.of_waves : place.of_small_waves, from_lobe);
  add(field, place.of_torque, torque, torque);
  return field;
}

}  // namespace strainwave::gear_fem
