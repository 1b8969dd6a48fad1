// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "strainwave/core/fields.hpp"
#include "strainwave/model/input/cam.hpp"
#include "strainwave/model/input/crack.hpp"

namespace strainwave {

/// Conversion of the radial compliance of a lobe to a torsional compliance at the output.
enum class Conversion {
  reciprocity,  ///< energy of the lobe forces, input locked (ST-6)
  cam,          ///< the article's conversion, which turns the cam back over its mean slope (ST-7)
};
template <>
struct EnumNames<Conversion> {
  static constexpr std::array<std::string_view, 2> names = {"reciprocity", "cam"};
};

/// Radial displacements of one lobe at the lobe force of the given torque.
struct LobeDisplacements {
  double bearing = 0.0;  ///< Delta_b of the bearing rings and balls [m]; >= 0
  double cam = 0.0;      ///< Delta_g of the cam [m]; >= 0
  double shaft = 0.0;    ///< Delta_a of the input shaft in bending [m]; >= 0

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "bearing",
                .unit = "m",
                .doc = "displacement Delta_b of the bearing",
                .range = kNonNegative,
                .example = R"("3 um")"},
          &LobeDisplacements::bearing);
    field(Field{.name = "cam",
                .unit = "m",
                .doc = "displacement Delta_g of the cam",
                .range = kNonNegative,
                .example = R"("1 um")",
                .fallback = R"("0 m")"},
          &LobeDisplacements::cam);
    field(Field{.name = "shaft",
                .unit = "m",
                .doc = "displacement Delta_a of the input shaft in bending; 0 for symmetric lobes",
                .range = kNonNegative,
                .example = R"("0 m")",
                .fallback = R"("0 m")"},
          &LobeDisplacements::shaft);
  }
};

/// Outer ring of the bearing, modelled as a thin elastic ring.
struct BearingRing {
  double mean_radius = 0.0;  ///< radius R of the ring's centre line [m]; > 0
  double thickness = 0.0;    ///< radial [m]; > 0, < mean_radius
  double width = 0.0;        ///< axial [m]; > 0
  /// Share of the full section's bending stiffness that remains with the groove [-]; coupled drive
  /// only.
  double groove_factor = 0.8;
  /// mu_o between the ring and the bore of the rim, for hysteresis and running torque [-]; >= 0
  double friction_coefficient = 0.1;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "mean_radius",
                .unit = "m",
                .doc = "radius of the ring's centre line",
                .range = kPositive,
                .example = R"("70 mm")"},
          &BearingRing::mean_radius);
    field(Field{.name = "thickness",
                .unit = "m",
                .doc = "radial thickness",
                .range = kPositive,
                .example = R"("4 mm")"},
          &BearingRing::thickness);
    field(Field{.name = "width",
                .unit = "m",
                .doc = "axial width",
                .range = kPositive,
                .example = R"("20 mm")"},
          &BearingRing::width);
    field(
        Field{
            .name = "groove_factor",
            .unit = "1",
            .doc =
                "share of the bending stiffness that remains beside the groove; coupled drive only",
            .range = {.lower = 0.0, .upper = 1.0, .upper_open = false},
            .example = "0.8",
            .fallback = "0.8"},
        &BearingRing::groove_factor);
    field(
        Field{.name = "friction_coefficient",
              .unit = "1",
              .doc = "friction coefficient mu_o between the ring and the bore of the rim, for the "
                     "hysteresis and the running torque",
              .range = {.lower = 0.0, .lower_open = false, .upper = 0.5, .upper_open = false},
              .example = "0.1",
              .fallback = "0.1",
              .in_template = InTemplate::commented},
        &BearingRing::friction_coefficient);
  }
};

/// Deep groove ball bearing between cam and flexspline.
struct Bearing {
  double ball_diameter = 0.0;           ///< D_w [m]; > 0
  double inner_raceway_diameter = 0.0;  ///< diameter d_i at the bottom of the groove [m]; > 0
  double outer_raceway_diameter = 0.0;  ///< diameter d_o at the bottom of the groove [m]; > d_i
  double inner_conformity = 0.52;       ///< f_i = groove radius / D_w [-]; > 0.5
  double outer_conformity = 0.53;       ///< f_o [-]; > 0.5
  double loaded_balls = 1.0;            ///< balls that share the lobe force equally [-]; >= 1
  std::optional<int> ball_count;  ///< n_b, all round; the coupled drive needs it [-]; 3 to 200
  /// c, radial play at a ball (TC-5) [m]; >= 0.  The cam of a turn lies c inside all round (FE-52).
  double clearance = 0.0;
  double rolling_friction = 0.001;  ///< mu_r, moment over pitch radius and ball force [-]; >= 0
  std::optional<BearingRing> outer_ring;  ///< adds ring bending in series (ST-10)

  template <class Visitor>
  static void describe(Visitor&& field) {
    const Range conformity{.lower = 0.5, .upper = 1.0};
    field(Field{.name = "ball_diameter",
                .unit = "m",
                .doc = "D_w",
                .range = kPositive,
                .example = R"("12.7 mm")"},
          &Bearing::ball_diameter);
    field(Field{.name = "inner_raceway_diameter",
                .unit = "m",
                .doc = "diameter at the groove's bottom",
                .range = kPositive,
                .example = R"("110 mm")"},
          &Bearing::inner_raceway_diameter);
    field(Field{.name = "outer_raceway_diameter",
                .unit = "m",
                .doc = "diameter at the groove's bottom",
                .range = kPositive,
                .example = R"("135.4 mm")"},
          &Bearing::outer_raceway_diameter);
    field(Field{.name = "inner_conformity",
                .unit = "1",
                .doc = "groove radius / ball diameter",
                .range = conformity,
                .example = "0.52",
                .fallback = "0.52"},
          &Bearing::inner_conformity);
    field(Field{.name = "outer_conformity",
                .unit = "1",
                .doc = "groove radius / ball diameter",
                .range = conformity,
                .example = "0.53",
                .fallback = "0.53"},
          &Bearing::outer_conformity);
    field(Field{.name = "loaded_balls",
                .unit = "1",
                .doc = "balls that share the force of a lobe; 1 is the worst case",
                .range = {.lower = 1.0, .lower_open = false},
                .example = "3",
                .fallback = "1"},
          &Bearing::loaded_balls);
    field(Field{.name = "ball_count",
                .unit = "1",
                .doc = "balls all round; the coupled drive needs it",
                .range = {.lower = 3.0, .lower_open = false, .upper = 200.0, .upper_open = false},
                .example = "23",
                .in_template = InTemplate::commented},
          &Bearing::ball_count);
    field(Field{.name = "clearance",
                .unit = "m",
                .doc = "radial play c at a ball: in the coupled drive the balls press c later; for "
                       "turn and oval the whole cam lies c further inside",
                .range = kNonNegative,
                .example = R"("0 um")",
                .fallback = R"("0 m")",
                .in_template = InTemplate::commented},
          &Bearing::clearance);
    field(
        Field{.name = "rolling_friction",
              .unit = "1",
              .doc = "rolling friction mu_r, the bearing's moment over the sum of its ball forces "
                     "and its pitch radius; for the running torque",
              .range = {.lower = 0.0, .lower_open = false, .upper = 0.1, .upper_open = false},
              .example = "0.001",
              .fallback = "0.001",
              .in_template = InTemplate::commented},
        &Bearing::rolling_friction);
    field(Field{.name = "outer_ring",
                .unit = "",
                .doc = "outer ring, bent by the lobe forces",
                .in_template = InTemplate::commented},
          &Bearing::outer_ring);
  }
};

/// The wave generator: cam, flexible bearing, and cracks in the bearing's inner ring.
///
/// Its radial stiffness comes from exactly one of `radial_stiffness`, `displacements`, `bearing`.
/// The Hertz contact at the inner race comes from `contact_semi_axes` or from `bearing`.
struct WaveGenerator {
  std::string material;
  double force_transmission_coefficient = 0.0;  ///< k_r [-]; > 0
  double load_factor = 1.15;                    ///< c_F of the lobe force [-]; > 0
  Conversion conversion = Conversion::reciprocity;
  std::optional<double> radial_stiffness;                  ///< K_G0 of one lobe [N/m]; > 0
  std::optional<LobeDisplacements> displacements;          ///< alternative to radial_stiffness
  std::optional<Bearing> bearing;                          ///< alternative to radial_stiffness
  std::optional<std::array<double, 2>> contact_semi_axes;  ///< a', b' of the contact [m]; a' >= b'
  std::optional<double> inner_ring_thickness;              ///< t_i, radial [m]; > 0
  std::optional<double> inner_ring_width;                  ///< B, axial [m]; > 0
  std::optional<double> inner_ring_mean_radius;  ///< R, centre line [m]; > inner_ring_thickness
  /// Flattening c_cam [-]: the cam lies c_cam (w_0^2/R) sin^2(2 psi) inside the cosine; 1.5 for an
  /// ellipse; coupled drive and K over a turn only.
  double cam_flattening = 0.0;
  std::optional<Cam> cam;  ///< alternative to cam_flattening; absent: a flattened cosine
  /// Perimeter of the cam, as the bore of the flexspline sees it through the bearing, minus that of
  /// the round bore [m]; > 0 stretches the rim; K over a turn only.  Absent: 0.
  std::optional<double> cam_perimeter_excess;
  std::vector<WaveGeneratorCrack> crack;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field(Field{.name = "material",
                .unit = "",
                .doc = "name of a [material], or of a record of the library",
                .example = R"("steel")"},
          &WaveGenerator::material);
    field(Field{.name = "force_transmission_coefficient",
                .unit = "1",
                .doc = "k_r",
                .range = kPositive,
                .example = "0.35"},
          &WaveGenerator::force_transmission_coefficient);
    field(Field{.name = "load_factor",
                .unit = "1",
                .doc = "c_F of the lobe force",
                .range = kPositive,
                .example = "1.15",
                .fallback = "1.15"},
          &WaveGenerator::load_factor);
    field(Field{.name = "conversion",
                .unit = "",
                .doc = "conversion of radial into torsional compliance: by reciprocity, or by the "
                       "article's turning of the cam",
                .example = R"("reciprocity")",
                .fallback = R"("reciprocity")",
                .in_template = InTemplate::commented},
          &WaveGenerator::conversion);
    field(Field{.name = "radial_stiffness",
                .unit = "N/m",
                .doc = "radial stiffness K_G0 of one lobe; give this, displacements or bearing",
                .range = kPositive,
                .example = R"("1.2e5 N/mm")"},
          &WaveGenerator::radial_stiffness);
    field(Field{.name = "contact_semi_axes",
                .unit = "m",
                .doc = "a', b' of the Hertz contact at the inner race; from bearing if left out",
                .range = kPositive,
                .example = R"(["5 mm", "2 mm"])"},
          &WaveGenerator::contact_semi_axes);
    field(Field{.name = "inner_ring_thickness",
                .unit = "m",
                .doc = "t_i; cracks need it",
                .range = kPositive,
                .example = R"("10 mm")"},
          &WaveGenerator::inner_ring_thickness);
    field(Field{.name = "inner_ring_width",
                .unit = "m",
                .doc = "axial width of the inner ring; edge cracks and ring_bending need it, and "
                       "surface cracks must fit into it",
                .range = kPositive,
                .example = R"("20 mm")",
                .in_template = InTemplate::commented},
          &WaveGenerator::inner_ring_width);
    field(Field{.name = "inner_ring_mean_radius",
                .unit = "m",
                .doc = "radius of the inner ring's centre line; ring_bending needs it",
                .range = kPositive,
                .example = R"("60 mm")",
                .in_template = InTemplate::commented},
          &WaveGenerator::inner_ring_mean_radius);
    field(Field{.name = "cam_flattening",
                .unit = "1",
                .doc = "c_cam, how far the cam lies inside the cosine; 1.5 for an ellipse; coupled "
                       "drive and K over a turn only",
                .range = kNonNegative,
                .example = "0",
                .fallback = "0",
                .in_template = InTemplate::commented},
          &WaveGenerator::cam_flattening);
    field(
        Field{.name = "cam_perimeter_excess",
              .unit = "m",
              .doc = "perimeter of the cam, as the flexspline's bore sees it through the bearing, "
                     "minus that of the round bore; > 0 stretches the rim; K over a turn only; "
                     "equal perimeters if left out",
              .example = R"("0.02 mm")",
              .in_template = InTemplate::commented},
        &WaveGenerator::cam_perimeter_excess);
    field(Field{.name = "cam",
                .unit = "",
                .doc = "shape of the cam; give this or cam_flattening",
                .in_template = InTemplate::commented},
          &WaveGenerator::cam);
    field(Field{.name = "displacements",
                .unit = "",
                .doc = "displacements of one lobe at the force of the given torque",
                .in_template = InTemplate::commented},
          &WaveGenerator::displacements);
    field(Field{.name = "bearing",
                .unit = "",
                .doc = "balls and raceways",
                .in_template = InTemplate::commented},
          &WaveGenerator::bearing);
    field(Field{.name = "crack", .unit = "", .doc = "cracks of the bearing's rings"},
          &WaveGenerator::crack);
  }
};

/// c_cam of a cam that is a flattened cosine [-]; absent for another shape.
[[nodiscard]] inline std::optional<double> cam_flattening(const WaveGenerator& generator) {
  if (!generator.cam) return generator.cam_flattening;
  if (generator.cam->profile == CamProfile::cosine) return 0.0;
  if (generator.cam->profile == CamProfile::ellipse) return 1.5;
  return std::nullopt;
}

}  // namespace strainwave
