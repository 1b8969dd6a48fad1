// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <type_traits>
#include <variant>
#include <vector>

#include "lazy_path.hpp"
#include "strainwave/core/compare.hpp"
#include "strainwave/core/error.hpp"
#include "strainwave/core/quantity_text.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/model/input/cam_curve.hpp"
#include "strainwave/model/input/check_rules.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/input/placed_group.hpp"
#include "strainwave/model/input/section_materials.hpp"
#include "strainwave/model/input/turn_table.hpp"

// Rules between fields.  The rule of a single field is its Range.

namespace strainwave {
namespace {

void check_tube(const LazyPath& path, const TubeSection& tube) {
  require(tube.wall_thickness < tube.outer_diameter / 2, path / "wall_thickness",
          tube.wall_thickness, "m", "wall_thickness < outer_diameter/2");
}

void check_temperatures(const LazyPath& path, const std::optional<std::array<double, 2>>& range) {
  if (range)
    require((*range)[0] <= (*range)[1], path, (*range)[1], "K",
            "not below the first one of the pair");
}

void check_one_line(const LazyPath& path, std::string_view field, std::string_view text) {
  if (std::ranges::any_of(text, [](unsigned char c) { return c < 0x20 || c == 0x7F; }))
    throw InputError((path / field).text(), "must be one line, without control characters");
}

void check_growth_scatter(const LazyPath& path, const GrowthScatter& scatter) {
  check_one_line(path, "source", scatter.source);
  const auto needs = [&](bool given, const char* field, bool other, std::string_view name) {
    if (given && !other)
      throw InputError((path / field).text(), fmt::format("is read only beside {}", name));
  };
  if (!scatter.differs() && !scatter.varies_along_path())
    throw InputError(path.text(), "must give at least one of level, exponent, wander and white");
  needs(scatter.level_correlation.has_value(), "level_correlation", scatter.differs(),
        "level or exponent");
  needs(scatter.exponent_correlation.has_value(), "exponent_correlation",
        scatter.level && scatter.exponent, "level and exponent");
  needs(scatter.pivot.has_value(), "pivot", scatter.exponent.has_value(), "exponent");
  if (scatter.exponent && !scatter.pivot)
    throw InputError((path / "pivot").text(),
                     "must be given beside exponent: the range of K at which the level holds");
  needs(scatter.wander_length.has_value(), "wander_length", scatter.wander.has_value(), "wander");
  if (scatter.wander && !scatter.wander_length)
    throw InputError((path / "wander_length").text(),
                     "must be given beside wander: the correlation length in ln(size)");
  needs(scatter.white_step.has_value(), "white_step", scatter.white.has_value(), "white");
  if (scatter.white && !scatter.white_step)
    throw InputError(
        (path / "white_step").text(),
        "must be given beside white, whose deviation is that of a step of this length");
}

void check_material(const LazyPath& path, const Material& material) {
  try {
    if (material.is_isotropic()) (void)elastic_constants(material);
  } catch (const InputError& error) {
    const std::string field = (path / error.field()).text();
    const std::string what = error.what();
    if (error.rule().empty()) throw InputError(field, what.substr(error.field().size() + 2));
    throw InputError(field, material.shear_modulus.value_or(0.0), "Pa", error.rule());
  }
  if (material.growth.size() > 1)
    throw InputError((path / "growth")[1].text(),
                     "is a second law; give one law, and two_lines for a law of two branches");
  if (!material.growth.empty()) {
    try {
      require_constants(material.growth.front());
    } catch (const InputError& error) {
      const std::string what = error.what();
      throw InputError(((path / "growth")[0] / error.field()).text(),
                       error.rule().empty() ? what.substr(error.field().size() + 2)
                                            : "contradicts the other constants: " + what);
    }
  }
  if (material.fatigue)
    check_temperatures(path / "fatigue.temperature", material.fatigue->temperature);
  if (const auto& bounds = material.growth_bounds) {
    check_temperatures(path / "growth_bounds.temperature", bounds->temperature);
    if (const auto& R = bounds->stress_ratio)
      require((*R)[0] <= (*R)[1], path / "growth_bounds.stress_ratio", (*R)[1], "1",
              "not below the first one of the pair");
    if (bounds->from && bounds->to)
      require(*bounds->from < *bounds->to, path / "growth_bounds.to", *bounds->to, "Pa*m^0.5",
              "to > from");
  }
  if (material.growth_scatter)
    check_growth_scatter(path / "growth_scatter", *material.growth_scatter);
  if (material.fatigue && material.fatigue->slope && !material.fatigue->cycles)
    throw InputError((path / "fatigue.cycles").text(),
                     "must be given beside slope: the line goes through the knee");
  if (material.yield_strength && material.ultimate_strength)
    require(*material.ultimate_strength >= *material.yield_strength, path / "ultimate_strength",
            *material.ultimate_strength, "Pa", "ultimate_strength >= yield_strength");
}

template <class Moving>
void check_speed(const LazyPath& at, const Moving& moving) {
  if (moving.output_speed && moving.input_speed)
    throw InputError((at / "input_speed").text(), "must not be given beside output_speed");
  if (!moving.output_speed && !moving.input_speed)
    throw InputError((at / "output_speed").text(), "must be given, or input_speed; 0 for a pause");
}

void check_duty(const Duty& duty) {
  const LazyPath blocks("duty.block");
  const LazyPath peaks("duty.peak");
  if (duty.history && !duty.block.empty())
    throw InputError("duty.history", "must not be given beside [[duty.block]]");
  if (!duty.history && duty.block.empty())
    throw InputError("duty.block", "must be given, or duty.history");
  for (std::size_t i = 0; i < duty.block.size(); ++i) check_speed(blocks[i], duty.block[i]);
  for (std::size_t i = 0; i < duty.peak.size(); ++i) {
    const LazyPath peak = peaks[i];
    check_speed(peak, duty.peak[i]);
    require(duty.peak[i].interval >= duty.peak[i].duration, peak / "interval",
            duty.peak[i].interval, "s", "not shorter than the peak's duration");
  }
  const bool moves =
      duty.history || std::ranges::any_of(duty.block, [](const DutyBlock& block) {
        return block.output_speed.value_or(0.0) != 0 || block.input_speed.value_or(0.0) != 0;
      });
  if (!moves) throw InputError("duty.block", "does not move; give at least one block with a speed");
}

void check_drivetrain(const GearSet& gear) {
  const Drivetrain& of = *gear.drivetrain;
  if (of.coupling_stiffness && !of.wave_generator_inertia)
    throw InputError(
        "drivetrain.coupling_stiffness",
        "needs drivetrain.wave_generator_inertia, the inertia behind the coupling; give "
        "it, or leave out the coupling");
  if (of.curve_torque && of.spring != RestoringTorque::computed &&
      of.contact_friction != ContactFriction::computed)
    throw InputError(
        "drivetrain.curve_torque",
        "needs drivetrain.spring = \"computed\", whose table it bounds, or "
        "drivetrain.contact_friction = \"computed\"; give one, or leave out the torque");
  if (gear.duty && gear.duty->fixed != of.fixed)
    throw InputError("drivetrain.fixed",
                     fmt::format("contradicts duty.fixed; write \"{}\" here, or change duty.fixed",
                                 enum_name(gear.duty->fixed)));
  if (of.hysteresis && !of.slip_element.empty())
    throw InputError("drivetrain.slip_element",
                     "is read in place of drivetrain.hysteresis; give one of the two");
  if (of.error_table && !gear.error_table)
    throw InputError("drivetrain.error_table",
                     fmt::format("\"{}\" has not been read", shown(*of.error_table)));
  if (of.friction) require_constants(*of.friction, FieldPath("drivetrain.friction"));
  if (of.load_friction) {
    const FieldPath at("drivetrain.load_friction");
    require_constants(*of.load_friction, at);
    for (const auto& [given, field] :
         {std::pair{of.load_friction->load_coulomb != 0, "load_coulomb"},
          std::pair{of.load_friction->load_breakaway.has_value(), "load_breakaway"}})
      if (given)
        throw InputError((at / field).text(),
                         "is a share of the torque through the drive, whose friction is "
                         "drivetrain.friction; give it there, or leave it out");
  }
  if (of.servo)
    require_constants(*of.servo, of.motor_inertia + of.wave_generator_inertia.value_or(0.0),
                      LazyPath("drivetrain") / "servo");
}

/// A motor with a limit must be able to speed up itself and the load that hangs on it.
void check_reachable(const GearSet& gear, const LazyPath& at, double before,
                     const Manoeuvre& piece) {
  const Drivetrain& train = *gear.drivetrain;
  if (!train.servo || train.gravity_torque != 0) return;
  const Servo& servo = *train.servo;
  // Losses help to brake.
  const bool faster = std::abs(*piece.input_speed) > std::abs(before);
  if (!faster &&
      (train.friction || train.load_friction || train.motor_damping > 0 || train.load_damping > 0))
    return;
  // Against the speed a voltage gives more than the stall torque.
  const bool by_voltage = servo.stall_torque && faster && before * *piece.input_speed >= 0 &&
                          *servo.stall_torque < servo.torque_limit.value_or(HUGE_VAL);
  if (!by_voltage && !servo.torque_limit) return;
  const double limit = by_voltage ? *servo.stall_torque : *servo.torque_limit;
  const double inertia = train.motor_inertia + train.wave_generator_inertia.value_or(0.0) +
                         train.load_inertia / std::pow(gear.drive.ratio + 1, 2);
  const double torque = inertia * std::abs(*piece.input_speed - before) / piece.duration;
  if (torque > limit)
    throw InputError((at / "input_speed").text(),
                     fmt::format("needs at least {} to speed the drive up or down within the "
                                 "piece, more than drivetrain.servo.{}; give the piece more time",
                                 shown_quantity(torque, "N*m", 4),
                                 by_voltage ? "stall_torque" : "torque_limit"));
}

void check_manoeuvres(const GearSet& gear) {
  const LazyPath pieces("manoeuvre");
  double time = 0.0;
  double before = 0.0;  // speed at the beginning of the piece
  bool loaded = false;  // an external torque may help the motor
  if (!gear.manoeuvre.empty() && !gear.drivetrain)
    throw InputError(pieces[0].text(),
                     "needs [drivetrain], the inertias that the manoeuvres move; give it");
  for (std::size_t i = 0; i < gear.manoeuvre.size(); ++i) {
    const Manoeuvre& piece = gear.manoeuvre[i];
    const LazyPath at = pieces[i];
    require(time + piece.duration > time, at / "duration", piece.duration, "s",
            "long enough to move the time of the pieces before");
    time += piece.duration;
    if (piece.input_speed.has_value() == piece.input_torque.has_value())
      throw InputError(at.text(), "must have either input_speed or input_torque");
    if (piece.input_speed.has_value() != gear.manoeuvre.front().input_speed.has_value())
      throw InputError(at.text(),
                       "must give what the pieces before give: input_speed in all, or input_torque "
                       "in all");
    if (piece.input_torque && gear.drivetrain->servo)
      throw InputError((at / "input_torque").text(),
                       "contradicts drivetrain.servo, which follows input_speed; give "
                       "input_speed, or leave out the servo");
    if (piece.output_speed && piece.output_torque)
      throw InputError((at / "output_speed").text(),
                       "needs whatever torque the output has, so output_torque cannot be given "
                       "beside it; give one of the two");
    if (piece.output_speed.has_value() != gear.manoeuvre.front().output_speed.has_value())
      throw InputError((at / "output_speed").text(),
                       "must be given in all pieces or in none; write output_speed = \"0 rpm\" for "
                       "an output that stands");
    if (piece.output_speed || (piece.output_torque && *piece.output_torque != 0)) loaded = true;
    if (piece.input_speed && !loaded) check_reachable(gear, at, before, piece);
    before = piece.input_speed.value_or(0.0);
  }
}

// Rules of the cracks.  Each kind has an overload of check_crack.

void need(bool given, std::string_view field, const LazyPath& at, std::string_view why) {
  if (!given) throw InputError(field, fmt::format("must be given for {}{}", at.text(), why));
}

void check_depth(const LazyPath& at, double depth, double thickness, std::string_view rule) {
  require(clearly_less(depth, thickness), at / "depth", depth, "m", rule);
}

void check_waves_that_bend(const GearSet& gear) {
  require(gear.drive.wave_number >= 2, "drive.wave_number", gear.drive.wave_number, "1",
          "wave_number >= 2 where a ring bends between lobes");
}

/// Checks the fields that all cracks of the inner ring share: depth and stress.
template <class Crack>
void check_race_crack(const LazyPath& at, const GearSet& gear, const Crack& crack) {
  const WaveGenerator& wg = *gear.wave_generator;
  const StressDriver driver = crack.stress_driver;
  need(wg.inner_ring_thickness.has_value(), "wave_generator.inner_ring_thickness", at,
       " (inner ring thickness t_i [m])");
  check_depth(at, crack.depth, *wg.inner_ring_thickness, "depth < inner_ring_thickness");
  const auto need_of_driver = [&](bool given, const LazyPath& field) {
    if (given) return;
    need(false, field.text(), at,
         fmt::format(" (stress_driver = \"{}\" needs it)", enum_name(driver)));
  };
  switch (driver) {
    case StressDriver::orthogonal_shear:
    case StressDriver::contact_edge:
      need_of_driver(wg.contact_semi_axes || wg.bearing,
                     LazyPath("wave_generator.contact_semi_axes"));
      break;
    case StressDriver::ring_bending:
      need_of_driver(wg.inner_ring_width.has_value(), LazyPath("wave_generator.inner_ring_width"));
      need_of_driver(wg.inner_ring_mean_radius.has_value(),
                     LazyPath("wave_generator.inner_ring_mean_radius"));
      break;
    case StressDriver::given:
      need_of_driver(crack.stress.has_value(), at / "stress");
      break;
  }
  if (crack.stress && driver != StressDriver::given)
    throw InputError((at / "stress").text(), "is read only with stress_driver = \"given\"");
  if (crack.contact_factor && driver != StressDriver::orthogonal_shear)
    throw InputError((at / "contact_factor").text(),
                     "is read only with stress_driver = \"orthogonal_shear\"");
}

/// A crack of the inner ring lies across the hoop stress that opens it, so its length runs along
/// the axis of the drive, over the width of the ring.  If the file gives no width, assume that the
/// ring is not wider than its circumference.
void check_length_in_ring(const LazyPath& at, const GearSet& gear, const RaceSurfaceCrack& crack) {
  const WaveGenerator& wg = *gear.wave_generator;
  const double length = 2 * crack.depth / crack.aspect_ratio;
  const double radius = wg.inner_ring_mean_radius ? *wg.inner_ring_mean_radius
                        : wg.bearing              ? wg.bearing->inner_raceway_diameter / 2
                                                  : gear.drive.pitch_diameter / 2;
  const double room = wg.inner_ring_width.value_or(2 * std::numbers::pi * radius);
  if (!clearly_less(room, length)) return;
  throw InputError(
      (at / "aspect_ratio").text(), crack.aspect_ratio, "1",
      fmt::format(">= {:.4g}: the crack runs along the axis, and its length 2c = 2 "
                  "depth/aspect_ratio = {:.4g} mm must fit into the ring, {:.4g} mm {}",
                  2 * crack.depth / room, length / units::mm, room / units::mm,
                  wg.inner_ring_width ? "wide (inner_ring_width)"
                                      : "round (no inner_ring_width is given)"));
}

void check_crack(const LazyPath& at, const GearSet& gear, const RaceSurfaceCrack& crack) {
  check_race_crack(at, gear, crack);
  check_length_in_ring(at, gear, crack);
  if (crack.stress_driver == StressDriver::ring_bending) check_waves_that_bend(gear);
}

void check_crack(const LazyPath& at, const GearSet& gear, const RaceEdgeCrack& crack) {
  check_race_crack(at, gear, crack);
  if (!gear.wave_generator->inner_ring_width)
    throw InputError("wave_generator.inner_ring_width",
                     "must be given for an edge crack (axial width of the ring [m])");
  if (crack.stress_driver == StressDriver::ring_bending) check_waves_that_bend(gear);
}

void check_crack(const LazyPath& at, const GearSet& gear, const OuterRaceCrack& crack) {
  const auto& bearing = gear.wave_generator->bearing;
  need(bearing && bearing->outer_ring, "wave_generator.bearing.outer_ring", at,
       " (the ring that it is in)");
  check_depth(at, crack.depth, bearing->outer_ring->thickness,
              "depth < wave_generator.bearing.outer_ring.thickness");
}

void check_crack(const LazyPath& at, const GearSet& gear, const RimAxialCrack& crack) {
  const auto& rim = gear.flexspline->rim;
  need(rim.has_value(), "flexspline.rim", at, " (the ring that it is in)");
  check_depth(at, crack.depth, rim->wall_thickness, "depth < flexspline.rim.wall_thickness");
}

void check_crack(const LazyPath& at, const GearSet& gear, const CircularSplineRingCrack& crack) {
  const CircularSpline& ring = *gear.circular_spline;
  check_depth(at, crack.depth, (ring.outer_diameter - ring.inner_diameter) / 2,
              "depth < (outer_diameter - inner_diameter)/2");
}

void check_crack(const LazyPath&, const GearSet&, const ToothCrack&) {
}  // its Ranges are its only rules

/// Refuses a row whose cracks touch: they lie on one line, and each is as long as the pitch.
/// @param round  length of the row [m]
void check_row(const LazyPath& at, double half_length, double angle, int count, double round) {
  require(kCrackCountField.range.contains(count), at / "count", count, "1",
          rule_text(kCrackCountField.range));
  constexpr double kOneLine = 1e-9;  // cosine of a crack along the row [-]
  const bool in_line = std::abs(std::cos(angle)) < kOneLine;
  require(!in_line || 2 * half_length * count < round, at / "count", count, "1", [&] {
    return fmt::format("2 half_length count < {:.4g} mm, the circumference, or the cracks touch",
                       round / units::mm);
  });
}

/// Refuses a table of one crack for a row.
void require_alone(const LazyPath& at, bool given, int count) {
  if (given)
    throw InputError(at.text(), fmt::format("is of one crack, but count is {}; leave out the table "
                                            "or give count = 1",
                                            count));
}

// A crack of the diaphragm must lie on it, and must not be deeper or longer than it.

const Diaphragm& diaphragm_for(const LazyPath& at, const GearSet& gear) {
  need(gear.flexspline->diaphragm.has_value(), "flexspline.diaphragm", at, "");
  return *gear.flexspline->diaphragm;
}

void check_crack(const LazyPath& at, const GearSet& gear, const DiaphragmArcCrack& crack) {
  const Diaphragm& diaphragm = diaphragm_for(at, gear);
  const double radius = crack.radius.value_or(diaphragm.inner_diameter / 2);
  require(radius >= diaphragm.inner_diameter / 2 && radius < diaphragm.outer_diameter / 2,
          at / "radius", radius, "m", "on the diaphragm");
  if (crack.count != 1)
    check_row(at, crack.half_length, std::numbers::pi / 2, crack.count,
              2 * std::numbers::pi * radius);
  require(crack.half_length < std::numbers::pi * radius, at / "half_length", crack.half_length, "m",
          "2 half_length < circumference at its radius");
}

void check_crack(const LazyPath& at, const GearSet& gear, const DiaphragmGroove& groove) {
  const Diaphragm& diaphragm = diaphragm_for(at, gear);
  const double inner = groove.radius - groove.width / 2;
  const double outer = groove.radius + groove.width / 2;
  require(!clearly_less(inner, diaphragm.inner_diameter / 2) &&
              !clearly_less(diaphragm.outer_diameter / 2, outer),
          at / "radius", groove.radius, "m", "radius +- width/2 on the diaphragm");
  const auto thick_enough = [&](double r) {
    check_depth(at, groove.depth, diaphragm_thickness(diaphragm, r),
                "depth < thickness of the diaphragm");
  };
  thick_enough(inner);
  thick_enough(outer);
  // The law is linear between the stations, so the thinnest place inside the groove is at a station
  // or an end.
  for (const DiaphragmStation& station : diaphragm.profile)
    if (station.radius > inner && station.radius < outer) thick_enough(station.radius);
}

/// Refuses a crack of the wall that is longer than the tube or meets itself round the
/// circumference.
/// @return  thickness of the wall [m]
template <class Crack>
double check_wall_crack(const LazyPath& at, const GearSet& gear, const Crack& crack) {
  const Flexspline& fs = *gear.flexspline;
  double wall = fs.ring_thickness();
  double length = fs.tube_length();
  double diameter = gear.drive.pitch_diameter;
  if (fs.crack_free == CrackFree::sections) {
    if (crack.section == WallSection::rim && !fs.rim)
      throw InputError((at / "section").text(), "\"rim\" needs a [flexspline.rim]");
    const TubeSection& tube = crack.section == WallSection::rim ? *fs.rim : *fs.barrel;
    wall = tube.wall_thickness;
    length = tube.length;
    diameter = tube.outer_diameter;
  } else if (crack.section != WallSection::barrel) {
    throw InputError((at / "section").text(), "is read only where crack_free = \"sections\"");
  }
  const double reach = crack.half_length * std::cos(crack.angle);
  require(2 * reach < length, at / "half_length", crack.half_length, "m",
          "2 half_length cos(angle) < length of the tube");
  if (crack.distance)
    require(*crack.distance > reach && *crack.distance < length - reach, at / "distance",
            *crack.distance, "m", [&] {
              return fmt::format(
                  "half_length cos(angle) < distance < length of the tube - half_length "
                  "cos(angle), that is, between {:.4g} mm and {:.4g} mm",
                  reach / units::mm, (length - reach) / units::mm);
            });
  const double round = std::numbers::pi * (diameter - wall);
  require(2 * crack.half_length * std::abs(std::sin(crack.angle)) < round, at / "half_length",
          crack.half_length, "m", "2 half_length |sin(angle)| < circumference of the tube");
  if (crack.count != 1) {  // a crack alone costs nothing
    check_row(at, crack.half_length, crack.angle, crack.count, round);
    if constexpr (requires { crack.compliance_table; })
      require_alone(at / "compliance_table", crack.compliance_table.has_value(), crack.count);
    require_alone(at / "turn_table", crack.turn_table.has_value(), crack.count);
  }
  return wall;
}

void check_crack(const LazyPath& at, const GearSet& gear, const WallThroughCrack& crack) {
  (void)check_wall_crack(at, gear, crack);
}

void check_crack(const LazyPath& at, const GearSet& gear, const WallSurfaceCrack& crack) {
  check_depth(at, crack.depth, check_wall_crack(at, gear, crack), "depth < wall_thickness");
  require(crack.depth <= crack.half_length, at / "half_length", crack.half_length, "m",
          "half_length >= depth");
}

void check_depth_in_shaft(const LazyPath& at, const OutputShaft& shaft, double depth) {
  check_depth(at, depth, (shaft.outer_diameter - shaft.inner_diameter) / 2,
              shaft.solid() ? "depth < outer_diameter/2"
                            : "depth < (outer_diameter - inner_diameter)/2, the wall");
}

void check_crack(const LazyPath& at, const GearSet& gear, const AnnularCrack& crack) {
  const OutputShaft& shaft = *gear.output_shaft;
  check_depth_in_shaft(at, shaft, crack.depth);
  if (crack.solution == AnnularSolution::tada && !shaft.solid())
    throw InputError((at / "solution").text(),
                     "\"tada\" is for solid shafts; a hollow one has a table");
  if (crack.distance)
    require(*crack.distance < shaft.length, at / "distance", *crack.distance, "m",
            "distance < length of the shaft");
}

void check_crack(const LazyPath& at, const GearSet& gear, const ShaftSurfaceCrack& crack) {
  const OutputShaft& shaft = *gear.output_shaft;
  check_depth_in_shaft(at, shaft, crack.depth);
  require(crack.depth <= crack.half_length, at / "half_length", crack.half_length, "m",
          "half_length >= depth");
  require(2 * crack.half_length < std::numbers::pi * shaft.outer_diameter, at / "half_length",
          crack.half_length, "m", "2 half_length < circumference of the shaft");
}

/// Checks that cracks of one ring do not soften the same length (TC-22).
template <class Crack, class Cracks>
void check_hinges(const LazyPath& path, const Cracks& cracks, double thickness,
                  double mean_radius) {
  const double length = Crack::softened_length(thickness);
  for (std::size_t i = 0; i < cracks.size(); ++i)
    for (std::size_t other = 0; other < i; ++other) {
      const auto* const here = std::get_if<Crack>(&cracks[i]);
      const auto* const there = std::get_if<Crack>(&cracks[other]);
      if (here == nullptr || there == nullptr) continue;
      const double apart =
          std::abs(std::remainder(here->position - there->position, 2 * std::numbers::pi)) *
          mean_radius;
      if (clearly_less(apart, length))
        throw InputError(
            (path[i] / "position").text(),
            fmt::format("{:.4g} deg is {:.3g} mm along the ring from {} at {:.4g} deg, and each "
                        "crack softens {:.3g} mm: combine them into one crack, or place them "
                        "that far apart",
                        here->position / units::deg, apart / units::mm, path[other].text(),
                        there->position / units::deg, length / units::mm));
    }
}

/// The section that contains a crack of the wall, as a tube.
TubeSection wall_of(const GearSet& gear, WallSection section) {
  const Flexspline& fs = *gear.flexspline;
  if (fs.crack_free == CrackFree::factor)
    return {.outer_diameter = gear.drive.pitch_diameter,
            .wall_thickness = fs.ring_thickness(),
            .length = fs.tube_length()};
  return section == WallSection::rim ? *fs.rim : *fs.barrel;
}

double mean_radius(const TubeSection& tube) {
  return (tube.outer_diameter - tube.wall_thickness) / 2;
}

/// A crack of a wall on the unrolled section.
struct UnrolledCrack {
  WallSection section;
  double round;   ///< place of its middle round the axis [m]
  double along;   ///< and along it [m]
  double across;  ///< from the middle to its end, round the axis [m]
  double up;      ///< and along it [m]
  int count;      ///< equal cracks of its row [-]
};

/// The place of a crack of a wall; absent if it is of another kind or its position is not given.
std::optional<UnrolledCrack> unrolled(const GearSet& gear, const FlexsplineCrack& crack) {
  return std::visit(
      [&](const auto& one) -> std::optional<UnrolledCrack> {
        if constexpr (requires { one.section; }) {
          if (!one.position) return std::nullopt;
          const TubeSection tube = wall_of(gear, one.section);
          const double turn = 2 * std::numbers::pi;
          const double angle = *one.position - turn * std::floor(*one.position / turn);
          return UnrolledCrack{
              .section = one.section,
              .round = angle * mean_radius(tube),
              .along = one.distance.value_or(tube.length / 2),
              .across = -one.half_length * std::sin(one.angle),  // the angle runs toward -theta
              .up = one.half_length * std::cos(one.angle),
              .count = one.count};
        } else {
          return std::nullopt;
        }
      },
      crack);
}

/// Whether two straight cracks touch or cross, one of them shifted round the axis.
bool touch(const UnrolledCrack& a, const UnrolledCrack& b, double shift) {
  struct Point {
    double x, y;
  };
  const auto ends = [](const UnrolledCrack& c, double by) {
    return std::array{Point{c.round + by - c.across, c.along - c.up},
                      Point{c.round + by + c.across, c.along + c.up}};
  };
  const auto p = ends(a, 0);
  const auto q = ends(b, shift);
  const double size = std::hypot(a.across, a.up) + std::hypot(b.across, b.up);
  const double tiny = 1e-9 * size;
  /// Distance of a point from a crack.
  const auto distance = [](const Point& of, const std::array<Point, 2>& from) {
    const Point along{from[1].x - from[0].x, from[1].y - from[0].y};
    const Point to{of.x - from[0].x, of.y - from[0].y};
    const double share = std::clamp(
        (to.x * along.x + to.y * along.y) / (along.x * along.x + along.y * along.y), 0.0, 1.0);
    return std::hypot(to.x - share * along.x, to.y - share * along.y);
  };
  const auto side = [](const Point& of, const std::array<Point, 2>& line) {
    return (line[1].x - line[0].x) * (of.y - line[0].y) -
           (line[1].y - line[0].y) * (of.x - line[0].x);
  };
  if (side(p[0], q) * side(p[1], q) < 0 && side(q[0], p) * side(q[1], p) < 0) return true;
  return std::min({distance(p[0], q), distance(p[1], q), distance(q[0], p), distance(q[1], p)}) <=
         tiny;
}

/// Whether all fields of two values agree.
template <class T>
bool same(const T& a, const T& b) {
  bool all = true;
  T::describe([&](const Field&, auto member) {
    const auto& of_a = a.*member;
    const auto& of_b = b.*member;
    if constexpr (requires { of_a == of_b; })
      all = all && of_a == of_b;
    else
      all = all && same(of_a, of_b);
  });
  return all;
}

/// Refuses a crack of the flexspline's wall that repeats another one without saying where it lies.
void check_repeated(const LazyPath& path, const std::vector<FlexsplineCrack>& cracks) {
  for (std::size_t i = 0; i < cracks.size(); ++i)
    for (std::size_t other = 0; other < i; ++other)
      std::visit(
          [&](const auto& one) {
            using Crack = std::remove_cvref_t<decltype(one)>;
            if constexpr (requires { one.section; })
              if (const auto* const before = std::get_if<Crack>(&cracks[other]);
                  before != nullptr && !one.position && same(one, *before))
                throw InputError(path[i].text(),
                                 fmt::format("repeats {}; give both a position, or leave one out",
                                             path[other].text()));
          },
          cracks[i]);
}

/// Refuses cracks of the flexspline's wall that touch or cross.
void check_apart(const LazyPath& path, const GearSet& gear) {
  const auto& cracks = gear.flexspline->crack;
  for (std::size_t i = 0; i < cracks.size(); ++i)
    for (std::size_t other = 0; other < i; ++other) {
      const auto here = unrolled(gear, cracks[i]);
      const auto there = unrolled(gear, cracks[other]);
      if (!here || !there || here->section != there->section) continue;
      // The wall closes round the axis, and a row repeats its crack.
      const double round = 2 * std::numbers::pi * mean_radius(wall_of(gear, here->section));
      const int images = std::lcm(here->count, there->count);
      for (int image = -images; image <= images; ++image)
        if (touch(*here, *there, round * image / images))
          throw InputError((path[i] / "position").text(),
                           fmt::format("the crack touches or crosses {}; place the two apart, or "
                                       "give one crack",
                                       path[other].text()));
    }
}

template <class Cracks>
void check_cracks(const GearSet& gear, const LazyPath& member, const Cracks& cracks) {
  const LazyPath list = member / "crack";
  for (std::size_t i = 0; i < cracks.size(); ++i)
    std::visit(
        [&](const auto& crack) {
          if constexpr (GroupableCrack<std::decay_t<decltype(crack)>>)
            if (is_group(crack))
              throw InputError(list[i].text(),
                               "stands for a group whose cracks are not made; call place_groups "
                               "before check");
          check_crack(list[i], gear, crack);
        },
        cracks[i]);
}

/// Checks that the balls fit side by side on the pitch circle, and that no more balls carry a lobe
/// than there are.
void check_balls(const LazyPath& path, const Bearing& bearing) {
  if (!bearing.ball_count) return;
  const int count = *bearing.ball_count;
  const double pitch_radius = (bearing.inner_raceway_diameter + bearing.outer_raceway_diameter) / 4;
  const double half_angle = std::asin(std::min(1.0, bearing.ball_diameter / (2 * pitch_radius)));
  const double room = std::numbers::pi / half_angle;
  require(!clearly_less(room, count), path / "ball_count", count, "1", [&] {
    return fmt::format(
        "<= {:.0f}: more balls of {:.4g} mm overlap on their pitch circle of {:.4g} mm",
        std::floor(room), bearing.ball_diameter / units::mm, 2 * pitch_radius / units::mm);
  });
  require(!clearly_less(count, bearing.loaded_balls), path / "loaded_balls", bearing.loaded_balls,
          "1", [&] { return fmt::format("<= ball_count, {}", count); });
}

/// Checks that a ring of the bearing is at least as wide as the groove of a ball, which is half of
/// the ball's diameter.
void check_groove(const LazyPath& path, double width, const Bearing& bearing) {
  require(!clearly_less(width, bearing.ball_diameter / 2), path, width, "m", [&] {
    return fmt::format(
        ">= wave_generator.bearing.ball_diameter/2, {:.4g} mm: the balls run in a "
        "groove of the ring",
        bearing.ball_diameter / 2 / units::mm);
  });
}

/// A cam has the numbers of its own profile and no others.
void check_cam(const GearSet& gear, const Cam& cam, const LazyPath& path) {
  const auto belongs = [&](CamProfile profile, bool given, const char* field) {
    const std::string_view own = EnumNames<CamProfile>::names[static_cast<std::size_t>(profile)];
    if (given == (cam.profile == profile)) return;
    throw InputError(
        (path / field).text(),
        fmt::format("{} profile = \"{}\"",
                    given ? "must be left out; it belongs to" : "must be given for", own));
  };
  belongs(CamProfile::two_arcs, cam.arc_angle.has_value(), "arc_angle");
  belongs(CamProfile::two_discs, cam.disc_offset.has_value(), "disc_offset");
  belongs(CamProfile::points, !cam.point.empty(), "point");
  const WaveGenerator& wg = *gear.wave_generator;
  if (wg.cam_flattening != 0)
    throw InputError("wave_generator.cam_flattening",
                     "is a second shape of the cam; give only one of cam_flattening and cam");
  const CamShape shape = cam_shape(wg);
  check(shape, gear.drive.radial_displacement, gear.drive.pitch_diameter / 2, path.path());
  if (wg.cam_perimeter_excess && !follows_perimeter(shape))
    throw InputError("wave_generator.cam_perimeter_excess",
                     "must be left out, because the heights of the cam are given by its profile");
}

void check_cracks_of_wave_generator(const GearSet& gear) {
  const WaveGenerator& wg = *gear.wave_generator;
  const LazyPath path("wave_generator");
  check_cracks(gear, path, wg.crack);
  if (wg.bearing && wg.bearing->outer_ring)
    check_hinges<OuterRaceCrack>(path / "crack", wg.crack, wg.bearing->outer_ring->thickness,
                                 wg.bearing->outer_ring->mean_radius);
}

void check_wave_generator(const GearSet& gear) {
  const WaveGenerator& wg = *gear.wave_generator;
  const LazyPath path("wave_generator");
  (void)material_of(gear, wg.material, path / "material");
  const int sources = int{wg.radial_stiffness.has_value()} + int{wg.displacements.has_value()} +
                      int{wg.bearing.has_value()};
  if (sources == 0)
    throw InputError((path / "radial_stiffness").text(),
                     "must be given (K_G0 of one lobe [N/m]), or displacements, or bearing");
  if (sources > 1)
    throw InputError(
        (path / (wg.radial_stiffness && wg.displacements ? "displacements" : "bearing")).text(),
        "is a second source of the radial stiffness; give only one of radial_stiffness, "
        "displacements, bearing");
  if (wg.displacements) {
    const LobeDisplacements& d = *wg.displacements;
    require(d.bearing + d.cam + d.shaft > 0, path / "displacements.bearing", d.bearing, "m",
            "bearing + cam + shaft > 0");
  }
  if (wg.contact_semi_axes) {
    const double a = (*wg.contact_semi_axes)[0];
    const double b = (*wg.contact_semi_axes)[1];
    require(b <= a, path / "contact_semi_axes[1]", b, "m", "second semi-axis <= first semi-axis");
    if (wg.inner_ring_width)
      require(!clearly_less(*wg.inner_ring_width, 2 * b), path / "inner_ring_width",
              *wg.inner_ring_width, "m", [&] {
                return fmt::format(
                    ">= 2 contact_semi_axes[1], {:.4g} mm: the contact lies on the ring",
                    2 * b / units::mm);
              });
  }
  if (wg.inner_ring_thickness && wg.inner_ring_mean_radius)
    require(*wg.inner_ring_thickness < *wg.inner_ring_mean_radius, path / "inner_ring_thickness",
            *wg.inner_ring_thickness, "m", "inner_ring_thickness < inner_ring_mean_radius");
  if (wg.cam) check_cam(gear, *wg.cam, path / "cam");
  if (wg.cam_perimeter_excess) {
    const double most = 0.005 * std::numbers::pi * gear.drive.pitch_diameter;
    require(std::abs(*wg.cam_perimeter_excess) < most, path / "cam_perimeter_excess",
            *wg.cam_perimeter_excess, "m", [&] {
              return fmt::format("less than 0.5 % of the pitch circle, {:.4g} mm, in magnitude",
                                 most / units::mm);
            });
  }
  if (wg.bearing) {
    const LazyPath bearing = path / "bearing";
    require(wg.bearing->outer_raceway_diameter > wg.bearing->inner_raceway_diameter,
            bearing / "outer_raceway_diameter", wg.bearing->outer_raceway_diameter, "m",
            "outer_raceway_diameter > inner_raceway_diameter");
    const double gap =
        (wg.bearing->outer_raceway_diameter - wg.bearing->inner_raceway_diameter) / 2;
    require(!clearly_less(gap, wg.bearing->ball_diameter), bearing / "ball_diameter",
            wg.bearing->ball_diameter, "m",
            "ball_diameter <= (outer_raceway_diameter - inner_raceway_diameter)/2");
    if (wg.contact_semi_axes)
      throw InputError(
          (path / "contact_semi_axes").text(),
          "is a second source of the contact, which follows from bearing; remove one of them");
    if (wg.bearing->ball_count)
      require(*wg.bearing->ball_count >= 3 && *wg.bearing->ball_count <= 200,
              bearing / "ball_count", *wg.bearing->ball_count, "1", ">= 3 and <= 200");
    check_balls(bearing, *wg.bearing);
    if (wg.inner_ring_width)
      check_groove(path / "inner_ring_width", *wg.inner_ring_width, *wg.bearing);
    if (wg.bearing->outer_ring) {
      const BearingRing& ring = *wg.bearing->outer_ring;
      require(ring.thickness < ring.mean_radius, bearing / "outer_ring.thickness", ring.thickness,
              "m", "thickness < mean_radius");
      check_groove(bearing / "outer_ring.width", ring.width, *wg.bearing);
      check_waves_that_bend(gear);
    }
  }
  check_cracks_of_wave_generator(gear);
}

void check_diaphragm(const LazyPath& path, const Diaphragm& diaphragm) {
  require(diaphragm.inner_diameter < diaphragm.outer_diameter, path / "inner_diameter",
          diaphragm.inner_diameter, "m", "inner_diameter < outer_diameter");
  double last = 0.0;
  const LazyPath stations = path / "profile";
  for (std::size_t i = 0; i < diaphragm.profile.size(); ++i) {
    const LazyPath station = stations[i];
    const LazyPath at = station / "radius";
    const double r = diaphragm.profile[i].radius;
    require(r > last, at, r, "m", "radius > that of the station before");
    require(r >= diaphragm.inner_diameter / 2 && clearly_less(r, diaphragm.outer_diameter / 2), at,
            r, "m", "inner_diameter/2 <= radius < outer_diameter/2");
    last = r;
  }
}

/// Refuses arcs of one circle of the diaphragm that touch.
void check_arcs(const LazyPath& path, const Flexspline& fs) {
  const auto arc_at = [&](std::size_t n) {
    const auto* const arc = std::get_if<DiaphragmArcCrack>(&fs.crack[n]);
    return arc != nullptr && arc->position ? arc : nullptr;
  };
  const auto radius_of = [&](const DiaphragmArcCrack& arc) {
    return arc.radius.value_or(fs.diaphragm->inner_diameter / 2);
  };
  for (std::size_t i = 0; i < fs.crack.size(); ++i) {
    const DiaphragmArcCrack* const here = arc_at(i);
    for (std::size_t other = 0; here != nullptr && other < i; ++other) {
      const DiaphragmArcCrack* const there = arc_at(other);
      if (there == nullptr || clearly_less(radius_of(*here), radius_of(*there)) ||
          clearly_less(radius_of(*there), radius_of(*here)))
        continue;
      const double turn = 2 * std::numbers::pi / std::lcm(here->count, there->count);
      const double apart =
          std::abs(std::remainder(*here->position - *there->position, turn)) * radius_of(*here);
      if (!clearly_less(here->half_length + there->half_length, apart))
        throw InputError((path[i] / "position").text(),
                         fmt::format("the arc touches {}; place the two apart, or give one arc",
                                     path[other].text()));
    }
  }
}

/// Refuses cracks of the diaphragm at the same place.
void check_overlaps(const LazyPath& path, const Flexspline& fs) {
  for (std::size_t i = 0; i < fs.crack.size(); ++i)
    for (std::size_t other = 0; other < i; ++other) {
      // The range of radii that a groove or an arc takes.
      const auto taken = [&](std::size_t n) -> std::optional<std::array<double, 2>> {
        if (const auto* const groove = std::get_if<DiaphragmGroove>(&fs.crack[n]))
          return {{groove->radius - groove->width / 2, groove->radius + groove->width / 2}};
        if (const auto* const arc = std::get_if<DiaphragmArcCrack>(&fs.crack[n])) {
          const double radius = arc->radius.value_or(fs.diaphragm->inner_diameter / 2);
          return {{radius, radius}};
        }
        return std::nullopt;
      };
      const auto here = taken(i);
      const auto there = taken(other);
      // Two arcs may lie one behind the other on one circle, but a groove goes all round.
      const bool groove = std::holds_alternative<DiaphragmGroove>(fs.crack[i]) ||
                          std::holds_alternative<DiaphragmGroove>(fs.crack[other]);
      if (here && there && groove && clearly_less((*here)[0], (*there)[1]) &&
          clearly_less((*there)[0], (*here)[1]))
        throw InputError((path[i] / "radius").text(),
                         fmt::format("overlaps {}: combine the two cracks into one, because the "
                                     "model adds cracks without interaction",
                                     path[other].text()));
    }
}

/// Sections of a cup are joined wall to wall.  Teeth, steps and fillets lie within this share of
/// the diameter.  A fillet of 2 mm at a diaphragm of size 14 takes 0.13 of it, and a barrel of size
/// 25 that is necked to 56 mm takes 0.11.
constexpr double kJoined = 0.25;

bool can_join(double diameter, double other) {
  return std::abs(diameter - other) <= kJoined * std::max(diameter, other);
}

/// Checks that a cup has its diaphragm inside of the barrel, and a hat outside.
void check_side_of_diaphragm(const LazyPath& path, const Flexspline& fs) {
  const Diaphragm& plate = *fs.diaphragm;
  const double barrel = fs.barrel->outer_diameter;
  const bool outside =
      std::abs(plate.inner_diameter - barrel) < std::abs(plate.outer_diameter - barrel);
  if (outside == (fs.shape == FlexsplineShape::hat)) return;
  throw InputError(
      (path / "shape").text(),
      fmt::format("is \"{}\", but the diaphragm, {:.4g} to {:.4g} mm in diameter, lies "
                  "{} of the barrel, {:.4g} mm; give shape = \"{}\" or correct the "
                  "diameters",
                  enum_name(fs.shape), plate.inner_diameter / units::mm,
                  plate.outer_diameter / units::mm, outside ? "outside" : "inside",
                  barrel / units::mm, outside ? "hat" : "cup"));
}

/// Checks that rim, barrel and diaphragm can be one body.
void check_joints(const LazyPath& path, const Flexspline& fs) {
  const double barrel = fs.barrel->outer_diameter;
  if (fs.rim)
    require(can_join(barrel, fs.rim->outer_diameter), path / "barrel.outer_diameter", barrel, "m",
            [&] {
              return fmt::format(
                  "within {:.4g} % of rim.outer_diameter, {:.4g} mm, because the barrel "
                  "joins the rim",
                  100 * kJoined, fs.rim->outer_diameter / units::mm);
            });
  if (!fs.diaphragm) return;
  check_side_of_diaphragm(path, fs);
  const bool hat = fs.shape == FlexsplineShape::hat;
  const double edge = hat ? fs.diaphragm->inner_diameter : fs.diaphragm->outer_diameter;
  require(can_join(edge, barrel),
          path / (hat ? "diaphragm.inner_diameter" : "diaphragm.outer_diameter"), edge, "m", [&] {
            return fmt::format(
                "within {:.4g} % of barrel.outer_diameter, {:.4g} mm, because the "
                "diaphragm joins the barrel",
                100 * kJoined, barrel / units::mm);
          });
}

/// No tooth is taller than this many modules [-].
constexpr double kMostRootDistance = 4;
/// Shifted teeth have their roots at most this many modules outside of the pitch circle [-].
constexpr double kMostRootShift = 1;

/// Checks that the rim ends at the roots of the teeth.
void check_rim_at_teeth(const LazyPath& path, const GearSet& gear, const TubeSection& rim) {
  const Transmission& drive = gear.drive;
  const double module = drive.pitch_diameter / (drive.wave_number * drive.ratio);
  const double least = drive.pitch_diameter - 2 * kMostRootDistance * module;
  const double most = drive.pitch_diameter + 2 * kMostRootShift * module;
  require(least < rim.outer_diameter && rim.outer_diameter < most, path / "outer_diameter",
          rim.outer_diameter, "m", [&] {
            return fmt::format("between {:.4g} and {:.4g} mm: the rim ends at the tooth roots",
                               least / units::mm, most / units::mm);
          });
}

void check_cracks_of_flexspline(const GearSet& gear) {
  const Flexspline& fs = *gear.flexspline;
  const LazyPath path("flexspline");
  check_cracks(gear, path, fs.crack);
  check_repeated(path / "crack", fs.crack);
  check_apart(path / "crack", gear);
  check_overlaps(path / "crack", fs);
  check_arcs(path / "crack", fs);
  if (fs.rim)
    check_hinges<RimAxialCrack>(path / "crack", fs.crack, fs.rim->wall_thickness,
                                (fs.rim->outer_diameter - fs.rim->wall_thickness) / 2);
}

void check_flexspline(const GearSet& gear) {
  const Flexspline& fs = *gear.flexspline;
  const LazyPath path("flexspline");
  (void)material_of(gear, fs.material, path / "material");
  if (fs.wall_thickness)
    require(*fs.wall_thickness < gear.drive.pitch_diameter / 2, path / "wall_thickness",
            *fs.wall_thickness, "m", "wall_thickness < drive.pitch_diameter/2");
  if (fs.rim) check_tube(path / "rim", *fs.rim);
  if (fs.barrel) check_tube(path / "barrel", *fs.barrel);
  if (fs.boss) check_tube(path / "boss", *fs.boss);
  if (fs.diaphragm) check_diaphragm(path / "diaphragm", *fs.diaphragm);
  if (fs.crack_free == CrackFree::sections) {
    if (!fs.barrel)
      throw InputError((path / "barrel").text(),
                       "must be given where crack_free = \"sections\" (smooth tube)");
    if (fs.length)
      require(!clearly_less(*fs.length, fs.tube_length()), path / "length", *fs.length, "m",
              "length >= barrel.length + rim.length");
    if (fs.shape_factor)
      throw InputError((path / "shape_factor").text(),
                       "is read only where crack_free = \"factor\"");
    if (fs.shape != FlexsplineShape::cylinder && !fs.diaphragm)
      throw InputError(
          (path / "diaphragm").text(),
          fmt::format("must be given for a {} where crack_free = \"sections\" (bottom)",
                      enum_name(fs.shape)));
    if (fs.shape == FlexsplineShape::hat && fs.boss)
      throw InputError((path / "boss").text(),
                       "is not read for a hat, whose output is the flange around the diaphragm; "
                       "remove the boss");
    if (fs.rim) check_rim_at_teeth(path / "rim", gear, *fs.rim);
    check_joints(path, fs);
  } else if (fs.rim || fs.barrel || fs.diaphragm || fs.boss || fs.flange_compliance != 0) {
    const char* const given = fs.rim         ? "rim"
                              : fs.barrel    ? "barrel"
                              : fs.diaphragm ? "diaphragm"
                              : fs.boss      ? "boss"
                                             : "flange_compliance";
    throw InputError((path / given).text(), "is read only where crack_free = \"sections\"");
  }
  if (fs.crack_free == CrackFree::factor && fs.shape == FlexsplineShape::hat)
    throw InputError((path / "crack_free").text(),
                     "must be \"sections\" for a hat, because no factor is known for it");
  if (fs.crack_free == CrackFree::factor)
    for (const auto& [field, value] :
         {std::pair{"wall_thickness", fs.wall_thickness}, {"length", fs.length}})
      if (!value)
        throw InputError((path / field).text(), "must be given where crack_free = \"factor\" [m]");
  check_cracks_of_flexspline(gear);
}

void check_cracks_of_circular_spline(const GearSet& gear) {
  const CircularSpline& ring = *gear.circular_spline;
  const LazyPath path("circular_spline");
  check_cracks(gear, path, ring.crack);
  check_hinges<CircularSplineRingCrack>(path / "crack", ring.crack,
                                        (ring.outer_diameter - ring.inner_diameter) / 2,
                                        (ring.outer_diameter + ring.inner_diameter) / 4);
}

void check_circular_spline(const GearSet& gear) {
  const CircularSpline& ring = *gear.circular_spline;
  const LazyPath path("circular_spline");
  (void)material_of(gear, ring.material, path / "material");
  require(ring.inner_diameter < ring.outer_diameter, path / "inner_diameter", ring.inner_diameter,
          "m", "inner_diameter < outer_diameter");
  require(ring.inner_diameter > gear.drive.pitch_diameter, path / "inner_diameter",
          ring.inner_diameter, "m", "inner_diameter > drive.pitch_diameter");
  check_cracks_of_circular_spline(gear);
}

void check_rating(const Rating& rating) {
  require(rating.T1 < rating.T2, "rating.T2", rating.T2, "N*m", "T2 > T1");
  if (rating.T3) require(*rating.T3 > rating.T2, "rating.T3", *rating.T3, "N*m", "T3 > T2");
}

/// The number that the entry at `path` names in its field `path`.
NumberAt number_named(const GearSet& gear, const LazyPath& path, const std::string& named) {
  try {
    return number_at(gear, named);
  } catch (const InputError& error) {
    // The problem, which follows the field and a colon.
    const std::string problem = std::string(error.what()).substr(error.field().size() + 2);
    throw InputError((path / "path").text(), fmt::format("\"{}\" {}", shown(named), problem));
  }
}

/// Refuses the numbers that tell how others vary.
void require_of_drive(const LazyPath& path, std::string_view named) {
  for (const std::string_view list : {"range[", "scatter[", "correlation["})
    if (named.starts_with(list))
      throw InputError((path / "path").text(),
                       "must be a number of the drive, not of its ranges, scatter or "
                       "correlations; name another number or remove this entry");
  if (named.starts_with("inspection."))
    throw InputError((path / "path").text(),
                     "must be a number of the drive, not of its inspection; name another number or "
                     "remove this entry");
}

void check_range(const GearSet& gear, const LazyPath& path, const InputRange& range) {
  check_one_line(path, "path", range.path);
  check_one_line(path, "source", range.source);
  const NumberAt number = number_named(gear, path, range.path);
  require_of_drive(path, range.path);
  const double lower = parse_quantity((path / "lower").text(), range.lower, number.field.unit);
  const double upper = parse_quantity((path / "upper").text(), range.upper, number.field.unit);
  require(lower < upper, path / "upper", upper, number.field.unit, "upper > lower");
  for (const auto& [field, value] : {std::pair{"lower", lower}, {"upper", upper}})
    require(number.field.range.contains(value), path / field, value, number.field.unit,
            [&] { return rule_text(number.field.range, number.field.unit); });
  if (number.value < lower || number.value > upper)
    throw InputError(
        (path / "path").text(),
        fmt::format("{} is {} in the file, outside of this range from {} to {}; correct the range "
                    "or the value",
                    range.path, shown_quantity(number.value, number.field.unit), range.lower,
                    range.upper));
}

/// Checks that a scatter has what its distribution needs, and nothing else.
void check_distribution(const LazyPath& path, const InputScatter& scatter) {
  const bool table = scatter.distribution == ScatterDistribution::table;
  if (table != !scatter.quantile.empty())
    throw InputError((path / "quantile").text(),
                     table ? "must be given for distribution = \"table\""
                           : "is read with distribution = \"table\" only; remove it or change the "
                             "distribution");
  if (table == scatter.relative_standard_deviation.has_value())
    throw InputError((path / "relative_standard_deviation").text(),
                     table ? "must not be given with distribution = \"table\", whose quantiles "
                             "contain it"
                           : "must be given");
  if (!table) return;
  const std::vector<ScatterQuantile>& points = scatter.quantile;
  const LazyPath list = path / "quantile";
  if (points.size() < 2)
    throw InputError(list.text(), "needs at least two entries, of probability 0 and 1");
  for (const auto& [i, end] : {std::pair<std::size_t, double>{0, 0.0}, {points.size() - 1, 1.0}})
    require(points[i].probability == end, list[i] / "probability", points[i].probability, "1",
            i == 0 ? "0 in the first entry" : "1 in the last entry");
  for (std::size_t i = 1; i < points.size(); ++i) {
    require(points[i - 1].probability < points[i].probability, list[i] / "probability",
            points[i].probability, "1", "larger than that of the entry before");
    require(points[i - 1].ratio <= points[i].ratio, list[i] / "ratio", points[i].ratio, "1",
            "not smaller than that of the entry before");
  }
  require(points.front().ratio < points.back().ratio, list[points.size() - 1] / "ratio",
          points.back().ratio, "1", "larger than that of the first entry");
}

void check_scatter(const GearSet& gear, std::size_t which) {
  const InputScatter& scatter = gear.scatter[which];
  const LazyPath list("scatter");
  const LazyPath path = list[which];
  check_one_line(path, "path", scatter.path);
  check_one_line(path, "source", scatter.source);
  const NumberAt number = number_named(gear, path, scatter.path);
  require_of_drive(path, scatter.path);
  if (scatter.path.starts_with("material.") &&
      scatter.path.find(".growth_scatter.") != std::string::npos)
    throw InputError(
        (path / "path").text(),
        fmt::format("{} is a scatter itself; name a number of the drive", scatter.path));
  if (number.value == 0)
    throw InputError((path / "path").text(),
                     fmt::format("{} is 0, so a relative scatter has no effect; give a value other "
                                 "than 0 or remove the scatter",
                                 scatter.path));
  for (std::size_t i = 0; i < which; ++i)
    if (gear.scatter[i].path == scatter.path)
      throw InputError((path / "path").text(),
                       fmt::format("{} already has a scatter, scatter[{}]; remove one of them",
                                   scatter.path, i));
  check_distribution(path, scatter);
}

void check_correlation(const GearSet& gear, std::size_t which) {
  const InputCorrelation& pair = gear.correlation[which];
  const LazyPath list("correlation");
  const LazyPath path = list[which];
  check_one_line(path, "source", pair.source);
  for (std::size_t i = 0; i < pair.paths().size(); ++i) {
    const std::string_view key = InputCorrelation::kPathKeys.at(i);
    check_one_line(path, key, pair.paths().at(i));
    const auto names = [&](const auto& entry) { return entry.path == pair.paths().at(i); };
    if (std::ranges::none_of(gear.scatter, names) &&
        std::ranges::none_of(growth_levels(gear), names))
      throw InputError((path / key).text(),
                       fmt::format("\"{}\" does not scatter; add a [[scatter]] with this path, or "
                                   "remove the correlation",
                                   shown(pair.paths().at(i))));
  }
  if (pair.path == pair.with)
    throw InputError((path / "with").text(), "must be another number than path");
  for (std::size_t i = 0; i < which; ++i) {
    const InputCorrelation& earlier = gear.correlation[i];
    if (std::ranges::is_permutation(earlier.paths(), pair.paths()))
      throw InputError((path / "with").text(),
                       fmt::format("{} and {} already have a correlation, correlation[{}]; remove "
                                   "one of them",
                                   pair.path, pair.with, i));
  }
}

/// Checks that an inspection has what its method needs, and nothing else.
void check_method(const Inspection& inspection) {
  const LazyPath path("inspection");
  const bool measured = is_measurement(inspection.method);
  const auto needed = [&](std::string_view field, bool given, bool by_measurement) {
    if (given && by_measurement != measured)
      throw InputError(
          (path / field).text(),
          fmt::format("is read {} only; remove it or change the method",
                      by_measurement
                          ? "with the methods stiffness, one_sided_stiffness and resonance"
                          : "with method = \"curve\""));
    if (!given && by_measurement == measured)
      throw InputError((path / field).text(), fmt::format("must be given for method = \"{}\"",
                                                          enum_name(inspection.method)));
  };
  needed("a50", inspection.a50.has_value(), false);
  needed("a90", inspection.a90.has_value(), false);
  needed("noise", inspection.noise.has_value(), true);
  if (measured) {
    if (inspection.detection) needed("detection", true, false);
    if (!inspection.place.empty()) needed("place", true, false);
    if (!inspection.false_calls)
      throw InputError("inspection.false_calls",
                       fmt::format("must be given for method = \"{}\", whose threshold follows "
                                   "from it",
                                   enum_name(inspection.method)));
    require(*inspection.false_calls > 0 && *inspection.false_calls < 0.5, path / "false_calls",
            *inspection.false_calls, "1",
            "> 0 and < 0.5 with a measurement, whose threshold follows from it");
  } else {
    require(*inspection.a50 < *inspection.a90, path / "a90", *inspection.a90, "m",
            "> a50: a larger crack is found more often");
  }
}

void check_inspection(const GearSet& gear) {
  const Inspection& inspection = *gear.inspection;
  const LazyPath path("inspection");
  check_method(inspection);
  const bool repairs = inspection.find == FindLeadsTo::repair;
  if (repairs != inspection.repaired_to.has_value())
    throw InputError((path / "repaired_to").text(),
                     repairs ? "must be given for find = \"repair\""
                             : "is read with find = \"repair\" only; remove it or change find");
  if (inspection.place.empty()) return;
  std::vector<std::string> cracks;
  for_each_crack(gear, [&](const CrackPath& crack, const auto&) { cracks.push_back(crack); });
  const LazyPath places = path / "place";
  for (std::size_t i = 0; i < inspection.place.size(); ++i) {
    const LazyPath at = places[i];
    const std::string& crack = inspection.place[i].crack;
    check_one_line(at, "crack", crack);
    if (std::ranges::find(cracks, crack) == cracks.end())
      throw InputError((at / "crack").text(),
                       fmt::format("\"{}\" is not a crack of this drive{}{}", shown(crack),
                                   cracks.empty() ? "" : ": ", fmt::join(cracks, ", ")));
    for (std::size_t k = 0; k < i; ++k)
      if (inspection.place[k].crack == crack)
        throw InputError(
            (at / "crack").text(),
            fmt::format("{} is already inspection.place[{}]; remove one of them", crack, k));
  }
}

void check_output_shaft(const GearSet& gear) {
  const OutputShaft& shaft = *gear.output_shaft;
  const LazyPath path("output_shaft");
  (void)material_of(gear, shaft.material, path / "material");
  require(shaft.inner_diameter < shaft.outer_diameter, path / "inner_diameter",
          shaft.inner_diameter, "m", "inner_diameter < outer_diameter");
  check_cracks(gear, path, shaft.crack);
}

/// A limit far beyond the size of any drive.  Beyond this limit, sums and differences of lengths
/// lose their digits.
constexpr double kLongest = 1e6;  // m

bool too_long(const Field& field, double value) {
  return field.unit == "m" && std::abs(value) > kLongest;
}

void check_ranges(const GearSet& gear) {
  bool all_inside = true;
  for_each_plain_number(gear, [&](const Field& field, const double& value) {
    all_inside = all_inside && in_range(field, value);
  });
  if (all_inside) return;
  // Build paths only after a fault, because a drive without faults is checked without them.
  for_each_number(gear, [](const FieldPath& path, const Field& field, const double& value) {
    require(field.range.contains(value), path, value, field.unit,
            std::isfinite(value) ? rule_text(field.range, field.unit) : "a finite number");
    require(!too_long(field, value), path, value, field.unit, "at most 1000 km");
  });
}

/// Checks that the wave lifts the teeth by about the height of a tooth.  The kinematics of every
/// wave number gives pitch_diameter/(2 ratio).
void check_displacement(const Transmission& drive) {
  constexpr double kLeast = 0.3;
  constexpr double kMost = 2;
  const double nominal = drive.pitch_diameter / (2 * drive.ratio);
  require(
      !clearly_less(drive.radial_displacement, kLeast * nominal) &&
          !clearly_less(kMost * nominal, drive.radial_displacement),
      LazyPath("drive") / "radial_displacement", drive.radial_displacement, "m", [&] {
        return fmt::format(
            "between {:.4g} and {:.4g} times pitch_diameter/(2 ratio), {:.4g} mm; otherwise the "
            "teeth cannot engage and disengage",
            kLeast, kMost, nominal / units::mm);
      });
}

}  // namespace

bool in_range(const Field& field, double value) {
  return field.range.contains(value) && !too_long(field, value);
}

void check(const GearSet& gear) {
  if (gear.format != kDriveFormat)
    throw InputError("format", fmt::format("\"{}\" is not known; this version reads \"{}\"",
                                           shown(gear.format), kDriveFormat));
  if (std::ranges::any_of(gear.name, [](unsigned char c) { return c < 0x20 || c == 0x7F; }))
    throw InputError("name", "must be one line, without control characters");
  check_ranges(gear);
  check_rules(gear);
}

void check_rules(const GearSet& gear) {
  const LazyPath materials("material");
  for (const auto& [name, material] : gear.material) check_material(materials / name, material);
  check_laminates(gear);
  require(gear.drive.wave_number >= 1 && gear.drive.wave_number <= 8, "drive.wave_number",
          gear.drive.wave_number, "1", ">= 1 and <= 8");
  require(gear.drive.radial_displacement < gear.drive.pitch_diameter / 2,
          LazyPath("drive") / "radial_displacement", gear.drive.radial_displacement, "m",
          "radial_displacement < pitch_diameter/2");
  check_displacement(gear.drive);
  require(gear.load.torque != 0, "load.torque", gear.load.torque, "N*m", "torque != 0");
  if (!gear.wave_generator && !gear.flexspline && !gear.output_shaft)
    throw InputError("flexspline",
                     "at least one of wave_generator, flexspline, output_shaft must be given");
  if (gear.wave_generator) check_wave_generator(gear);
  if (gear.flexspline) check_flexspline(gear);
  if (gear.output_shaft) check_output_shaft(gear);
  if (gear.mesh) check_cracks(gear, LazyPath("mesh"), gear.mesh->crack);
  if (gear.circular_spline) check_circular_spline(gear);
  if (gear.rating) check_rating(*gear.rating);
  if (gear.duty) check_duty(*gear.duty);
  if (gear.drivetrain) check_drivetrain(gear);
  check_manoeuvres(gear);
  if (gear.tolerance)
    require(gear.tolerance->grade >= 1 && gear.tolerance->grade <= 11, "tolerance.grade",
            gear.tolerance->grade, "1", ">= 1 and <= 11");
  check_compliance_tables(gear);
  check_turn_tables(gear);
  const LazyPath ranges("range");
  for (std::size_t i = 0; i < gear.range.size(); ++i) check_range(gear, ranges[i], gear.range[i]);
  for (std::size_t i = 0; i < gear.scatter.size(); ++i) check_scatter(gear, i);
  for (std::size_t i = 0; i < gear.correlation.size(); ++i) check_correlation(gear, i);
  if (!gear.correlation.empty()) (void)life_normals(gear);
  if (gear.inspection) check_inspection(gear);
}

void check_crack_rules(const GearSet& gear) {
  if (gear.wave_generator) check_cracks_of_wave_generator(gear);
  if (gear.flexspline) check_cracks_of_flexspline(gear);
  if (gear.output_shaft) check_cracks(gear, LazyPath("output_shaft"), gear.output_shaft->crack);
  if (gear.mesh) check_cracks(gear, LazyPath("mesh"), gear.mesh->crack);
  if (gear.circular_spline) check_cracks_of_circular_spline(gear);
  check_compliance_tables(gear);
  check_turn_tables(gear);
}

}  // namespace strainwave
