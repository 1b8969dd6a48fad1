// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "strainwave/core/fields.hpp"

/// @file
/// Torques that lose energy and remember the path: hysteresis of the twist, friction of the ends.

namespace strainwave {

/// Hysteresis torque parallel to the spring, z' = A v - beta |v| |z|^(n-1) z - gamma v |z|^n, by
/// Bouc and Wen (MO-8).  v is the rate of the twist.
struct BoucWen {
  double stiffness = 0.0;  ///< A, slope where z is zero [N*m/rad]; > 0
  double limit = 0.0;      ///< F_c, largest torque, (A/(beta + gamma))^(1/n) [N*m]; > 0
  double exponent = 1.0;   ///< n [-]; >= 1
  /// gamma/(beta + gamma) [-]; <= 1/2, so that every closed path loses energy; 0 and n = 1: Dahl
  double asymmetry = 0.0;

  /// dz/dt [N*m/s].
  [[nodiscard]] double rate(double torque, double twist_rate) const;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "stiffness",
                .unit = "N*m/rad",
                .doc = "slope over the twist where the torque of the hysteresis is zero; behind a "
                       "full reversal Dahl's model is twice as stiff",
                .range = kPositive,
                .example = R"("1e5 N*m/rad")"},
          &BoucWen::stiffness);
    field(Field{.name = "limit",
                .unit = "N*m",
                .doc = "largest torque of the hysteresis, at the output",
                .range = kPositive,
                .example = R"("3 N*m")"},
          &BoucWen::limit);
    field(Field{.name = "exponent",
                .unit = "1",
                .doc = "n, sharpness of the bend before the limit",
                .range = {.lower = 1.0, .lower_open = false},
                .example = "1",
                .fallback = "1",
                .in_template = InTemplate::commented},
          &BoucWen::exponent);
    field(Field{.name = "asymmetry",
                .unit = "1",
                .doc = "gamma/(beta + gamma); 0 with n = 1 is Dahl's model",
                .range = {.upper = 0.5, .upper_open = false},
                .example = "0",
                .fallback = "0",
                .in_template = InTemplate::commented},
          &BoucWen::asymmetry);
  }
};

/// Dahl's model, z' = sigma_0 v (1 - z/F_c sgn v): Bouc and Wen with n = 1 and gamma = 0 (MO-9).
/// @param stiffness  sigma_0 [N*m/rad]; > 0
/// @param limit      F_c [N*m]; > 0
[[nodiscard]] BoucWen dahl(double stiffness, double limit);
/// z of Dahl after a monotonic change of the twist, exact (MO-9) [N*m].
[[nodiscard]] double dahl_after(const BoucWen& model, double torque, double change);

/// An elastic, perfectly plastic element of a hysteresis: a spring behind a block that slips
/// (MO-44).
struct SlipElement {
  double stiffness = 0.0;  ///< k [N*m/rad]; > 0
  double limit = 0.0;      ///< F, torque at which the element slips [N*m]; > 0

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "stiffness",
                .unit = "N*m/rad",
                .doc = "stiffness of the element while it sticks",
                .range = kPositive,
                .example = R"("5e4 N*m/rad")"},
          &SlipElement::stiffness);
    field(Field{.name = "limit",
                .unit = "N*m",
                .doc = "torque at which the element slips, at the output",
                .range = kPositive,
                .example = R"("1 N*m")"},
          &SlipElement::limit);
  }
};

/// What slip elements in parallel remember: their torques at a twist.
struct SlipState {
  double twist = 0.0;               ///< phi_0 [rad]
  std::vector<double> torque = {};  ///< z_j of each element there [N*m]; |z_j| <= F_j

  friend bool operator==(const SlipState&, const SlipState&) = default;
};
/// Elements that bear no torque at a twist [rad].
[[nodiscard]] SlipState relaxed(const std::vector<SlipElement>& elements, double twist);
/// The state after a monotonic change of the twist, exact (MO-44).
/// @param elements  with numbers in their range
/// @param state     where the change begins; one torque for each element
/// @param twist     where the change ends [rad]
[[nodiscard]] SlipState slip_after(const std::vector<SlipElement>& elements, const SlipState& state,
                                   double twist);
/// The torque of all elements after a monotonic change of the twist (MO-44) [N*m].
[[nodiscard]] double slip_torque(const std::vector<SlipElement>& elements, const SlipState& state,
                                 double twist);
/// Elastic energy of the elements after a monotonic change of the twist (MO-45) [J].
[[nodiscard]] double slip_energy(const std::vector<SlipElement>& elements, const SlipState& state,
                                 double twist);
/// Power that the elements lose after a monotonic change of the twist, if they slip at its
/// beginning already (MO-45) [W].  A change must therefore end where an element begins to slip.
/// @param elements    with numbers in their range
/// @param state       where the change begins; one torque for each element
/// @param twist       where the change ends [rad]
/// @param twist_rate  of the twist, to the side of the change [rad/s]
[[nodiscard]] double slip_loss(const std::vector<SlipElement>& elements, const SlipState& state,
                               double twist, double twist_rate);

/// Friction of an end of the drive by bristles, with sticking (MO-10); that of the input also in
/// proportion to the load (MO-40): state u, deflection of the bristles,
///
///     u' = w - sigma_0 |w| u/g(w),   g = G_c + (G_s - G_c) exp(-(w/w_s)^2),
///     G_c = F_c + kappa_c L,  G_s = F_s + kappa_s L,   T_f = sigma_0 u + sigma_1 u' + sigma_2 w,
///
/// where L is the magnitude of the torque on the load over the ratio.
struct LuGre {
  double bristle_stiffness = 0.0;             ///< sigma_0 [N*m/rad]; > 0
  double bristle_damping = 0.0;               ///< sigma_1 [N*m*s/rad]; >= 0
  double viscous = 0.0;                       ///< sigma_2 [N*m*s/rad]; >= 0
  double coulomb = 0.0;                       ///< F_c [N*m]; > 0
  double breakaway = 0.0;                     ///< F_s [N*m]; >= F_c
  double stribeck_speed = 1.0;                ///< w_s [rad/s]; > 0
  double load_coulomb = 0.0;                  ///< kappa_c [-]; >= 0
  std::optional<double> load_breakaway = {};  ///< kappa_s [-]; >= 0; absent: as load_coulomb
  double thinning = 0.0;  ///< beta, share of sigma_2 lost per kelvin of warming [1/K]; >= 0
  double warming = 0.0;   ///< temperature above that at which sigma_2 was measured [K]; -200 to 200

  /// sigma_2 at the temperature of the motion (MO-55) [N*m*s/rad].
  [[nodiscard]] double viscous_when_warm() const {
    return warming == 0 ? viscous : viscous * std::exp(-thinning * warming);  // (MO-55)
  }
  /// Largest sigma_1 with which the friction never pushes (MO-10) [N*m*s/rad].
  [[nodiscard]] double largest_passive_damping() const;
  /// Whether the friction depends on the load.
  [[nodiscard]] bool by_load() const { return load_coulomb > 0 || load_breakaway.value_or(0) > 0; }
  /// g, the torque of the bristles at constant speed (MO-40) [N*m].
  /// @param speed  w [rad/s]; either sign
  /// @param load   L, torque on the load over the ratio [N*m]; >= 0
  [[nodiscard]] double sliding(double speed, double load = 0.0) const;
  /// The friction at one state.
  struct At {
    double rate = 0.0;    ///< u' [rad/s]
    double torque = 0.0;  ///< T_f, against the speed [N*m]
  };
  /// Rate of the bristles and torque of the friction (MO-10, MO-40).
  /// @param deflection  u [rad]
  /// @param speed       w [rad/s]
  /// @param load        L, torque on the load over the ratio [N*m]; >= 0
  [[nodiscard]] At at(double deflection, double speed, double load = 0.0) const;
  /// T_f at constant speed [N*m].
  [[nodiscard]] double steady(double speed, double load = 0.0) const;

  template <class Visitor>
  static void describe(Visitor&& field) {
    const auto add = [&](std::string_view name, std::string_view unit, std::string_view doc,
                         const Range& range, std::string_view example, auto member) {
      field(Field{.name = name, .unit = unit, .doc = doc, .range = range, .example = example},
            member);
    };
    add("coulomb", "N*m", "friction torque while it turns", kPositive, R"("0.03 N*m")",
        &LuGre::coulomb);
    add("breakaway", "N*m", "torque that moves it from rest; at least coulomb", kPositive,
        R"("0.05 N*m")", &LuGre::breakaway);
    add("stribeck_speed", "rad/s", "speed over which breakaway falls to coulomb", kPositive,
        R"("2 rad/s")", &LuGre::stribeck_speed);
    add("bristle_stiffness", "N*m/rad", "stiffness while it sticks", kPositive, R"("100 N*m/rad")",
        &LuGre::bristle_stiffness);
    const auto optional = [&](std::string_view name, std::string_view doc, auto member) {
      field(Field{.name = name,
                  .unit = "N*m*s/rad",
                  .doc = doc,
                  .range = kNonNegative,
                  .example = R"("0 N*m*s/rad")",
                  .fallback = R"("0 N*m*s/rad")",
                  .in_template = InTemplate::commented},
            member);
    };
    optional("bristle_damping", "damping while it sticks", &LuGre::bristle_damping);
    optional("viscous", "friction torque over the speed", &LuGre::viscous);
    field(Field{.name = "load_coulomb",
                .unit = "1",
                .doc = "share of the torque on the load, over the ratio, that adds to coulomb; in "
                       "drivetrain.friction only",
                .range = kNonNegative,
                .example = "0.07",
                .fallback = "0",
                .in_template = InTemplate::commented},
          &LuGre::load_coulomb);
    field(Field{.name = "thinning",
                .unit = "1/K",
                .doc = "share of viscous that is lost per kelvin of warming, as the grease thins",
                .range = kNonNegative,
                .example = R"("0.03 1/K")",
                .fallback = R"("0 1/K")",
                .in_template = InTemplate::commented},
          &LuGre::thinning);
    field(Field{.name = "warming",
                .unit = "K",
                .doc = "temperature of the grease above that at which viscous was measured",
                .example = R"("20 K")",
                .fallback = R"("0 K")",
                .in_template = InTemplate::commented},
          &LuGre::warming);
    field(Field{.name = "load_breakaway",
                .unit = "1",
                .doc = "share of the torque on the load, over the ratio, that adds to breakaway; "
                       "load_coulomb if left out; in drivetrain.friction only",
                .range = kNonNegative,
                .example = "0.05",
                .in_template = InTemplate::commented},
          &LuGre::load_breakaway);
  }
};

/// Throws InputError, which names the constant, unless each constant is in its range.
void require_constants(const BoucWen& model);
/// The same for each of the elements.
void require_constants(const std::vector<SlipElement>& elements);
/// @param model  the friction
/// @param at     its path in messages
void require_constants(const LuGre& model, const FieldPath& at = FieldPath("friction"));

}  // namespace strainwave
