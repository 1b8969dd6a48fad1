// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_cracks/drive_cracks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <memory>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/crack_group/crack_row.hpp"
#include "strainwave/drive_cracks/loaded_crack.hpp"
#include "strainwave/drive_cracks/member_loads.hpp"
#include "strainwave/drive_cracks/reference_stress.hpp"
#include "strainwave/sif/bar/bar_annular.hpp"
#include "strainwave/sif/bar/hollow_annular_outer.hpp"
#include "strainwave/sif/newman_raju.hpp"
#include "strainwave/sif/tube/shell_row.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

constexpr int kFrontPoints = 33;         // points on half of a front; K varies slowly along it
constexpr double kNearlyAll = 1 - 1e-6;  // share of a length that a crack must not reach

const StrengthNote kAssembly = {
    "the assembly is assumed to bend the cracked wall by the full w_0 cos(U theta); this is an "
    "upper bound away from the open end of a cup, but not for a flattened cam or on the rim; in a "
    "turn each face is in tension once per lobe, so the crack may start from either face",
    "FA-12"};
const StrengthNote kThroughBending = {
    "a through crack is assessed with the full bending of the assembly at the outer fibre; this is "
    "exact for a crack that is short compared with the wall's thickness, and up to 1.6 times too "
    "much for a long crack; contact of its closed half is left out; strainwave turn computes K "
    "over a turn of a crack of the barrel, and the crack takes its table as turn_table",
    "FA-14"};
const StrengthNote kFit = {
    "stresses of fit and rotation in the ring are unknown and left out; the stress of the crack is "
    "assumed proportional to the lobe force",
    "FA-4"};
const StrengthNote kGroove = {
    "a groove is treated as a sharp crack of its depth all round, which is conservative", "FA-11"};
const char* const kDiaphragm = "the bending of the diaphragm by the assembly is unknown";
const char* const kRim =
    "on the rim the wall's bending is not an upper bound, because membrane stress of the assembly "
    "and tooth forces are left out";
const char* const kRimTeeth =
    "the table of K over a turn is not known to contain the forces of the teeth on the rim";
const char* const kOrder =
    "the driver orthogonal_shear gives an order of magnitude at best (ST-12)";

const char* const kNoField =
    "Assess the crack by finite elements of the part, because no field of the file can give this "
    "stress.";
const char* const kLaminate = "the ligaments beside a crack in a laminate are not assessed";
const StrengthNote kPliesBending = {
    "a through crack of a laminate is assessed with the strain that the assembly causes at a face, "
    "through the whole wall; this is an upper bound of the bending of the plies; contact of the "
    "closed half of the crack is left out",
    "LA-20"};
const char* const kGiveEnergy =
    "Give fracture_energy of the laminate in the file, to compare the energy release rate with.";
const char* const kPliesByElements =
    "Assess the plies beside the crack by finite elements of the part.";
const char* const kOneCrack =
    "Assess both cracks as one crack over their whole length, or by finite elements of the part.";
const char* const kOnlyRisesWithTorque =
    "Assess the crack by finite elements of the part. No driver makes this crack acceptable, "
    "because every stress of a driver, also a given one, counts as proportional to the torque, and "
    "the bending by the cam is constant.";
const char* const kOtherDriver =
    "Choose contact_edge, or give the hoop stress with stress_driver = \"given\".";

/// Marks a stress as unknown, which decides the verdict.
/// @param next_step  what the user can do
void leave_unknown(DriveCrack& made, std::string stress, const char* next_step) {
  if (stress.empty()) return;
  made.unknown = std::move(stress);
  made.next_step = next_step;
}

void use(DriveCrack& made, std::initializer_list<const char*> tags) {
  made.equations.insert(made.equations.end(), tags.begin(), tags.end());
}

/// Fills the parts that every kind has: moduli, constraint and faces.
template <class Solution>
void take_basics(DriveCrack& made, const LoadedCrack<Solution>& loaded) {
  made.moduli = loaded.moduli;
  made.constraint = loaded.constraint;
  made.faces = loaded.faces;
}

void take_size(DriveCrack& made, const char* name, CrackSize size, double ligament) {
  made.size_name = name;
  made.size = size;
  made.ligament = ligament;
}

/// K of a solution over [axial force, torque] at given places of its front.
template <class Solution>
std::vector<FrontIntensity> along(const Solution& solution, double a,
                                  std::initializer_list<double> places) {
  std::vector<FrontIntensity> front;
  if constexpr (LinearFront<Solution>) {
    const auto k = solution.family().linear_stress_intensity(a);
    for (const double s : places) front.push_back({k.at(s), {}});
  } else {
    for (const double s : places) front.push_back({solution.stress_intensity(a, s), {}});
  }
  return front;
}

/// A solution in both states of its faces.
template <class Solution>
struct BothStates {
  explicit BothStates(const Solution& apart) : open(apart), pressed(apart.pressed()) {}
  [[nodiscard]] const Solution& with(Faces state) const {
    return state == Faces::pressed ? pressed : open;
  }
  Solution open;
  Solution pressed;
};

/// The modes of (LA-15), whose squares add up to the energy release rate of a crack in a laminate
/// times the reference modulus.  In an isotropic wall they are the modes themselves.
struct EnergyModes {
  double opening = 1.0;           ///< factor on the first mode [-]
  double opening_by_shear = 0.0;  ///< share of K_II in it [-]
  double sliding = 1.0;           ///< factor on the second mode [-]

  EnergyModes() = default;
  EnergyModes(const CrackModuli& moduli, double reference)
      : opening(std::sqrt(reference / moduli.opening)),
        opening_by_shear(moduli.opening_by_shear()),
        sliding(std::sqrt(reference * moduli.pressed().anisotropic->sliding)) {}
  [[nodiscard]] UnitStressIntensity<2> of(UnitStressIntensity<2> k, Faces faces) const {
    for (std::size_t load = 0; load < 2; ++load) {
      k.I[load] =
          faces == Faces::pressed ? 0.0 : opening * (k.I[load] + opening_by_shear * k.II[load]);
      k.II[load] *= sliding;
    }
    return k;
  }
  /// The modes of K of the assembly, which opens the faces.
  [[nodiscard]] std::array<double, 3> of(const AssemblyStress& stress, double root) const {
    return {opening * (stress.normal + opening_by_shear * stress.shear) * root,
            sliding * stress.shear * root, 0.0};
  }
};

/// Wall of a flexspline with its length, as the cracked section.
struct LongWall {
  double mean_radius = 0.0;
  double thickness = 0.0;
  double length = 0.0;
};

/// K from a bending moment M of a tube.  It equals K from the axial force 2 M/r, which causes the
/// same stress M/(pi r^2 t) in the middle of the tension side.
/// @param front  K along the front, or at some of its points
template <class Front>
auto tube_bending(const Front& front, double mean_radius) {
  return [front, mean_radius](const CrackSize& size) {
    std::vector<Modes> bent;
    for (const FrontIntensity& at : front(size, Faces::open)) {
      const double force = 2 / mean_radius;
      bent.push_back(
          {at.load.I[kAxial] * force, at.load.II[kAxial] * force, at.load.III[kAxial] * force});
    }
    return bent;
  };
}

/// Makes the cracks of a drive; each kind has an overload of `fill`.
class Maker {
 public:
  explicit Maker(const GearSet& gear) : gear_(gear), loads_(gear) {
    for (WallGroup& group : wall_groups(gear_, loads_))
      groups_.push_back(std::make_shared<WallGroup>(std::move(group)));
    if (ShaftGroup group = shaft_group(gear_); !group.cracks.empty())
      annular_ = std::make_shared<ShaftGroup>(std::move(group));
  }

  [[nodiscard]] std::vector<DriveCrack> all() const {
    std::vector<DriveCrack> result;
    for_each_cracked_member(gear_, [&](std::string_view name, const auto& member) {
      for_each_crack(name, member.crack, [&](const std::string& path, const auto& crack) {
        loads_.load(crack, [&](const auto& loaded) {
          DriveCrack made;
          made.path = path;
          made.kind = std::decay_t<decltype(crack)>::kKind;
          if constexpr (requires { member.material; }) made.material = member.material;
          if (name == "flexspline")
            made.material = material_name(*gear_.flexspline, crack.place().part);
          made.material = solid_name(gear_, made.material);
          made.wave_number = gear_.drive.wave_number;
          fill(made, crack, loaded);
          take_toughness(made);
          if constexpr (requires { crack.turn_table; })
            if (crack.turn_table) {
              auto table = gear_.turn_tables.at(*crack.turn_table);
              if (made.acts_in_coupled_drive)
                made.turn_table = std::move(table);
              else
                take_turn_table(made, std::move(table));
            }
          if (made.group && made.turn_table)
            made.notes.push_back(
                {fmt::format("the table {} leaves out the other cracks of the {}",
                             shown(made.turn_table->file), made.group->wall().name),
                 "CG-9"});
          result.push_back(std::move(made));
        });
      });
    });
    return result;
  }

 private:
  template <class Crack>
  void fill(DriveCrack& made, const Crack&, const ActsInCoupledDrive&) const {
    made.acts_in_coupled_drive = true;
  }

  // --- Output shaft -----------------------------------------------------------------------------

  void fill(DriveCrack& made, const AnnularCrack& crack,
            const LoadedCrack<sif::AnnularCrackSolid>& loaded) const {
    const double d = gear_.output_shaft->outer_diameter;
    fill_annular(made, crack, loaded);
    made.turning = TurningLoad::bending;
    made.bending = [d](const CrackSize& size) {
      const sif::BarAnnularCrack bar{.depth = size.size, .diameter = d};
      return std::vector<Modes>{{bar.stress_intensity(size.size, 0.0).I[sif::kMoment], 0.0, 0.0}};
    };
    made.range_end = kNearlyAll * d / 2;
    made.range_text = "the radius of the shaft";
  }
  void fill(DriveCrack& made, const AnnularCrack& crack,
            const LoadedCrack<sif::AnnularCrackHollow>& loaded) const {
    const double D = gear_.output_shaft->outer_diameter;
    const double d = gear_.output_shaft->inner_diameter;
    fill_annular(made, crack, loaded);
    made.turning = TurningLoad::bending;
    if (d <= sif::AnnularCrackHollow::kMaxTensionRadiusRatio * D) {
      made.bending = [D, d](const CrackSize& size) {
        const sif::HollowAnnularOuterCrack bar{
            .depth = size.size, .outer_diameter = D, .inner_diameter = d};
        return std::vector<Modes>{{bar.stress_intensity(size.size, 0.0).I[sif::kMoment], 0.0, 0.0}};
      };
    } else {
      // The bending stress hardly changes through so thin a wall.  The crack takes the largest one
      // as tension all round.
      made.bending = [D, d, solution = loaded.solution](const CrackSize& size) {
        const double force_per_moment = 8 * D / (D * D + d * d);  // (FR-15), A D/(2 I) [1/m]
        const double K = solution.stress_intensity(size.size, 0.0).I[kAxial];
        return std::vector<Modes>{{force_per_moment * K, 0.0, 0.0}};
      };
    }
    made.range_end = sif::AnnularCrackHollow::kMaxDepthRatio * (D / 2 - d / 2);
    made.range_text = "0.8 of the wall, the range of the stress intensity";
  }
  template <class Solution>
  void fill_annular(DriveCrack& made, const AnnularCrack& crack,
                    const LoadedCrack<Solution>& loaded) const {
    const double r_o = gear_.output_shaft->outer_diameter / 2;
    const double r_i = gear_.output_shaft->inner_diameter / 2;
    take_basics(made, loaded);
    take_size(made, "depth", {.size = crack.depth}, r_o - r_i - crack.depth);
    use(made, {"FA-7"});
    // Share the table, because a std::function may be copied.
    const auto states = std::make_shared<const BothStates<Solution>>(loaded.solution);
    made.front = [states](const CrackSize& size, Faces faces) {
      return along(states->with(faces), size.size, {0.0});
    };
    join_shaft_group(made, crack);
    made.reference_stress = [=](const CrackSize& size, double P, double T) {
      return ring_reference_stress({.outer_radius = r_o - size.size, .inner_radius = r_i}, P, T);
    };
  }

  /// What the strength of an annular crack takes from the others.
  [[nodiscard]] static std::string shielding_words(const ShaftGroup& group) {
    const std::string alone =
        "K is that of the crack alone, which is an upper bound in torsion, because the other "
        "annular cracks of the shaft shield it; ";
    if (const std::string fault = group.fault(); !fault.empty()) return alone + fault;
    if (group.stretched())
      return alone + fmt::format(
                         "two of them are nearer than {:g} of the deeper one, where their "
                         "influence on K is not known",
                         kLeastAnnularDistance);
    return "K_III contains that the other annular cracks of the shaft shield this one in torsion, "
           "as long as the faces of the others slide freely; friction there raises K up to that "
           "of the crack alone, which the answer without distances contains; K_I of an axial "
           "force or a bending moment, and the collapse of the section, are those of the crack "
           "alone";
  }

  /// Gives an annular crack the others that shield it in torsion (CG-12).
  void join_shaft_group(DriveCrack& made, const AnnularCrack& crack) const {
    if (!annular_) return;
    for (std::size_t j = 0; j < annular_->index.size(); ++j)
      if (&crack == std::get_if<AnnularCrack>(&gear_.output_shaft->crack[annular_->index[j]])) {
        made.shaft_group = annular_;
        made.in_shaft_group = j;
      }
    if (!made.shaft_group) return;
    use(made, {"CG-12"});
    made.notes.push_back({shielding_words(*annular_), "CG-12"});
    made.front = [alone = made.front, group = annular_, j = made.in_shaft_group](
                     const CrackSize& size, Faces faces) {
      std::vector<FrontIntensity> front = alone(size, faces);
      // Pressed faces may hold each other by friction, and then the others do not shield.
      if (faces == Faces::pressed) return front;
      const double ratio = group->intensity(j, size.size);
      for (FrontIntensity& at : front) at.load.III[kTorsion] *= ratio;  // (CG-12)
      return front;
    };
  }

  void fill(DriveCrack& made, const ShaftSurfaceCrack& crack,
            const LoadedCrack<sif::ShaftSurfaceSolid>& loaded) const {
    const double r = gear_.output_shaft->outer_diameter / 2;
    fill_shaft_surface(made, crack, loaded, 0.1);  // (GR-35)
    made.ligament = 2 * r - crack.depth;
    // A longer crack would have a front that is hollow toward its mouth (FR-22).
    made.longest = [r](double depth) { return std::max(depth, r * std::acos(1 - depth / r)); };
    made.reference_stress = [r](const CrackSize& size, double P, double T) {
      return one_sided_reference_stress(
          {.outer_radius = r, .inner_radius = 0.0, .depth = size.size, .chord_depth = size.size}, P,
          T);
    };
    made.range_end = kNearlyAll * 2 * r * sif::ShaftSurfaceSolid::kMaxDepthRatio;
    made.range_text = "half of the diameter, the range of the stress intensity";
    use(made, {"SB-7"});
  }
  void fill(DriveCrack& made, const ShaftSurfaceCrack& crack,
            const LoadedCrack<sif::ShaftSurfaceHollow>& loaded) const {
    const double r_o = gear_.output_shaft->outer_diameter / 2;
    const double r_i = gear_.output_shaft->inner_diameter / 2;
    fill_shaft_surface(made, crack, loaded, 0.0);
    made.length_end = kNearlyAll * pi * r_o;
    made.reference_stress = [=](const CrackSize& size, double P, double T) {
      return one_sided_reference_stress({.outer_radius = r_o,
                                         .inner_radius = r_i,
                                         .depth = size.size,
                                         .chord_depth = chord_depth(size, r_o)},
                                        P, T);
    };
    made.range_end = sif::ShaftSurfaceHollow::kMaxDepthRatio * (r_o - r_i);
    made.range_text = "0.6 of the wall, the range of the stress intensity";
    use(made, {"SB-10", "SB-11"});
  }
  /// Fills the parts that do not depend on the bore.
  /// @param first  share of the front beside the surface that is left out [-]
  template <class Solution>
  void fill_shaft_surface(DriveCrack& made, const ShaftSurfaceCrack& crack,
                          const LoadedCrack<Solution>& loaded, double first) const {
    take_basics(made, loaded);
    take_size(made, "depth", CrackSize::of(crack.depth, crack.half_length),
              gear_.output_shaft->outer_diameter / 2 - gear_.output_shaft->inner_diameter / 2 -
                  crack.depth);
    const auto states = std::make_shared<const BothStates<Solution>>(loaded.solution);
    const auto place = [first, end = loaded.solution.front().end](std::size_t i, std::size_t of) {
      return end * (first + (1 - first) * static_cast<double>(i) / static_cast<double>(of - 1));
    };
    const auto at_points = [states, place](const CrackSize& size, Faces faces, std::size_t points) {
      const Solution solution = states->with(faces).with_size(size.size, size.half_length());
      std::vector<FrontIntensity> front(points);
      for (std::size_t i = 0; i < points; ++i)
        front[i].load = solution.stress_intensity(size.size, place(i, points));
      return front;
    };
    made.front = [at_points](const CrackSize& size, Faces faces) {
      return at_points(size, faces, kFrontPoints);
    };
    made.front_ends = [at_points](const CrackSize& size, Faces faces) {
      return at_points(size, faces, 2);
    };
    made.turning = TurningLoad::bending;
    const auto bent_points = [states, place](const CrackSize& size, std::size_t points) {
      const Solution solution = states->open.with_size(size.size, size.half_length());
      std::vector<Modes> bent(points);
      for (std::size_t i = 0; i < points; ++i)
        bent[i] = {solution.turning_bending(size.size, place(i, points)), 0.0, 0.0};
      return bent;
    };
    made.bending = [bent_points](const CrackSize& size) { return bent_points(size, kFrontPoints); };
    made.bending_ends = [bent_points](const CrackSize& size) { return bent_points(size, 2); };
    use(made, {"FR-22", "FA-15"});
  }
  /// Depth of the segment that contains a semi-ellipse along the arc (FA-15).
  static double chord_depth(const CrackSize& size, double radius) {
    double deepest = size.size;
    for (int i = 0; i < kFrontPoints; ++i) {
      const double share = static_cast<double>(i) / (kFrontPoints - 1);
      const double depth = size.size * std::sqrt((1 - share) * (1 + share));
      deepest = std::max(deepest,
                         radius - (radius - depth) * std::cos(share * size.half_length() / radius));
    }
    return deepest;
  }

  // --- Flexspline -------------------------------------------------------------------------------

  /// The wall that contains a crack, with its length.
  [[nodiscard]] LongWall long_wall(WallSection section) const {
    const Flexspline& fs = *gear_.flexspline;
    const Wall<double> wall = loads_.wall_of(section);
    const double length = fs.crack_free == CrackFree::factor ? *fs.length
                          : section == WallSection::rim      ? fs.rim->length
                                                             : fs.barrel->length;
    return {wall.mean_radius, wall.thickness, length};
  }

  void fill(DriveCrack& made, const WallThroughCrack& crack,
            const LoadedCrack<sif::ThroughCrackInTube>& loaded) const {
    const LongWall wall = long_wall(crack.section);
    take_basics(made, loaded);
    const EnergyModes energy_modes = take_reference_modulus(made);
    const AssemblyStress bending = assembly_of(made, crack.section, wall, crack.angle);
    if (on_rim(crack.section)) leave_unknown(made, kRim, kNoField);
    if (made.laminate) {
      const bool energy = material_of_crack(made).fracture_energy.has_value();
      leave_unknown(made, kLaminate, energy ? kPliesByElements : kGiveEnergy);
      use(made, {"LA-9", "LA-15"});
    }
    made.front = [states = BothStates(loaded.solution), bending, energy_modes,
                  in_laminate = made.laminate](const CrackSize& size, Faces faces) {
      const double root = std::sqrt(pi * size.size);
      const sif::ThroughCrackInTube& solution = states.with(faces);
      auto front = along(solution, size.size, {-1.0, 0.0, 1.0});
      for (FrontIntensity& at : front) at.load = energy_modes.of(at.load, faces);
      if (in_laminate) {
        for (FrontIntensity& at : front) at.assembly = energy_modes.of(bending, root);  // (LA-20)
        return front;
      }
      // (FA-14): the full stress of the outer fibre, and in a row the neighbours under the same
      // stress (CG-7).
      RowFactors row{1.0, 0.0, 0.0, 1.0};
      if (solution.count > 1) row = row_factors(solution.row_share(size.size), solution.angle);
      // Few neighbours are under the whole stress at once, so what they shield does not count.
      const double opened = std::max(1.0, row.opening_by_normal);
      const double slid = std::max(1.0, row.sliding_by_shear);
      for (FrontIntensity& at : front)
        at.assembly = {(opened * bending.normal + row.opening_by_shear * bending.shear) * root,
                       (row.sliding_by_normal * bending.normal + slid * bending.shear) * root, 0.0};
      return front;
    };
    made.bending = tube_bending(made.front, wall.mean_radius);
    made.through_thickness = wall.thickness;
    const double round = 2 * pi * wall.mean_radius;
    const double place = crack.distance.value_or(wall.length / 2);
    const double sine = std::abs(std::sin(crack.angle));
    const double cosine = std::abs(std::cos(crack.angle));
    through_section(made, crack.angle, wall, gear_.flexspline->stress_nonuniformity);
    take_size(made, "half_length", {.size = crack.half_length},
              std::min(round / 2 - crack.half_length * sine,
                       std::min(place, wall.length - place) - crack.half_length * cosine));
    sif::ThroughCrackInTube curved = loaded.solution;
    if (made.laminate) curved.poissons_ratio = kMetalPoissonsRatio;
    const double shell = sif::ThroughCrackInTube::kMaxShellParameter /
                         std::sqrt(curved.shell_parameter_squared(1.0));
    const double half_round = kNearlyAll * pi * wall.mean_radius / (2 * sine);
    const double length = kNearlyAll * std::min(place, wall.length - place) / cosine;
    made.range_end = std::min({shell, half_round, length});
    made.range_text = made.range_end == shell
                          ? "a shell parameter of 4"
                          : "the length of the tube, or half of its circumference";
    if (crack.count > 1) {
      in_row(made, {crack.count, crack.angle}, wall, gear_.flexspline->stress_nonuniformity);
      end_where_row_is_known(made, crack, wall.mean_radius);
    }
    join_group(made, crack, loaded.solution, bending);
    use(made, {"FA-6", "FA-8"});
    if (made.assembly) {
      if (!made.laminate) use(made, {"FA-14"});
      made.notes.push_back(made.laminate ? kPliesBending : kThroughBending);
    }
  }

  /// Gives a crack of a group the others, if they can be solved together (CG-9).
  void join_group(DriveCrack& made, const WallThroughCrack& crack,
                  const sif::ThroughCrackInTube& solution, const AssemblyStress& bending) const {
    for (const std::shared_ptr<WallGroup>& group : groups_)
      for (std::size_t j = 0; j < group->members().size(); ++j)
        if (&crack ==
            std::get_if<WallThroughCrack>(&gear_.flexspline->crack[group->members()[j].index])) {
          made.group = group;
          made.in_group = j;
        }
    if (!made.group) return;
    use(made, {"CG-6", "CG-9"});
    const auto at_tips = [solution, peak = made.assembly_peak, bending](const GroupEffect& effect,
                                                                        const CrackSize& size) {
      const double root = std::sqrt(pi * size.size);
      std::vector<FrontIntensity> front;
      for (std::size_t end = 0; end < 2; ++end) {
        sif::ThroughCrackInTube tip = solution;
        tip.open = !effect.closed;
        tip.tip_stress = effect.tips[end];  // (CG-9)
        // As if all cracks were under the whole stress of the assembly at once; what the others
        // shield does not count (FA-14).
        const auto [opened, slid] = effect.by_hoop[end];
        const double normal = std::max(bending.normal, peak * opened);
        const double shear =
            std::abs(peak * slid) > std::abs(bending.shear) ? peak * slid : bending.shear;
        for (FrontIntensity& at : along(tip, size.size, {-1.0, 0.0, 1.0})) {
          at.assembly = {normal * root, shear * root, 0.0};
          front.push_back(at);
        }
      }
      return front;
    };
    const auto grown = [group = made.group, j = made.in_group](const CrackSize& size) {
      WallGroup at = *group;
      at.set_half_length(j, size.size);
      return at;
    };
    made.front = [alone = made.front, grown, at_tips, j = made.in_group](const CrackSize& size,
                                                                         Faces faces) {
      const WallGroup at = grown(size);
      if (!at.fault_of_places().empty()) {  // a trial beyond the end of the range
        std::vector<FrontIntensity> front = alone(size, faces);
        const std::size_t points = front.size();
        for (std::size_t i = 0; i < points; ++i) front.push_back(FrontIntensity(front[i]));
        return front;
      }
      GroupEffect effect = at.apart()[j];
      effect.closed = faces == Faces::pressed;
      return at_tips(effect, size);
    };
    made.front_in_group = [grown, at_tips, j = made.in_group, bent = made.assembly](
                              const CrackSize& size, TorqueSense sense) {
      const WallGroup at = grown(size);
      GroupEffect effect = at.under(sense)[j];
      if (bent) effect.by_hoop = at.apart()[j].by_hoop;  // the assembly opens all of them
      return at_tips(effect, size);
    };
    made.bending = tube_bending(made.front, solution.mean_radius);
    take_ligaments(made, solution.mean_radius);
  }

  /// The sections that the other cracks of a group take, and the ligaments between the cracks.
  void take_ligaments(DriveCrack& made, double radius) const {
    const Flexspline& fs = *gear_.flexspline;
    const WallGroup& group = *made.group;
    double taken = 0.0;
    std::vector<StraightCrack> places;
    for (std::size_t j = 0; j < group.members().size(); ++j) {
      const auto& other = std::get<WallThroughCrack>(fs.crack[group.members()[j].index]);
      places.push_back(group.members()[j].place);
      if (j == made.in_group) continue;
      const LongWall wall = long_wall(other.section);
      taken += std::max(other.half_length * std::abs(std::sin(other.angle)) / (pi * radius),
                        2 * other.half_length * std::abs(std::cos(other.angle)) / wall.length);
    }
    constexpr double kMostTaken = 0.5;
    made.reference_stress = [alone = made.reference_stress, left = std::max(1 - taken, kMostTaken)](
                                const CrackSize& size, double P, double T) {
      return alone(size, P, T) / left;  // (CG-9)
    };
    if (!made.unknown.empty()) return;
    const NearestCrack nearest = nearest_crack(places, made.in_group, group.wall().round);
    if (taken > kMostTaken)
      leave_unknown(made,
                    fmt::format("the other cracks of the {} take more than half of a section, "
                                "whose collapse is not assessed",
                                group.wall().name),
                    kNoField);
    else if (nearest.gap < 1)
      leave_unknown(made,
                    fmt::format("the ligament to {} is narrower than the longer half length, and "
                                "its collapse is not assessed",
                                group.members()[nearest.index].path),
                    kOneCrack);
  }

  /// The solutions for a surface crack of one shape in the wall.
  struct SurfaceFits {
    explicit SurfaceFits(const sif::SurfaceCrack<2>& crack, double poissons_ratio)
        : wall(crack), plate(crack.aspect_ratio()), sheared(crack.aspect_ratio(), poissons_ratio) {}
    BothStates<sif::SurfaceCrack<2>> wall;
    sif::NewmanRajuPlate plate;
    sif::KassirSih sheared;
  };

  void fill(DriveCrack& made, const WallSurfaceCrack& crack,
            const LoadedCrack<sif::SurfaceCrack<2>>& loaded) const {
    const LongWall wall = long_wall(crack.section);
    const double nu = loads_.wall_steel(crack.section).nu;
    const double t = wall.thickness;
    take_basics(made, loaded);
    const AssemblyStress bending = assembly_of(made, crack.section, wall, crack.angle);
    if (on_rim(crack.section)) leave_unknown(made, kRim, kNoField);
    const auto at_points = [=, given = SurfaceFits(loaded.solution, nu)](const CrackSize& size,
                                                                         Faces faces, int points) {
      const double a = size.size;
      const SurfaceFits fits =
          size.aspect_ratio == given.wall.open.aspect_ratio()
              ? given
              : SurfaceFits(given.wall.open.with_aspect_ratio(size.aspect_ratio), nu);
      const sif::SurfaceCrack<2>& surface = fits.wall.with(faces);
      std::vector<FrontIntensity> front(static_cast<std::size_t>(points));
      const double root = std::sqrt(pi * a);
      for (int i = 0; i < points; ++i) {
        const double phi = pi / 2 * i / (points - 1);
        FrontIntensity& at = front[static_cast<std::size_t>(i)];
        at.load = surface.stress_intensity(a, phi);
        // (SP-3) for the bending; the shear at the surface is assumed constant through the wall.
        at.assembly = {bending.normal * root * fits.plate.tension(a / t, phi) *
                           fits.plate.bending_ratio(a / t, phi),
                       bending.shear * root * fits.sheared.factor_II(phi),
                       bending.shear * root * fits.sheared.factor_III(phi)};  // (FA-12)
      }
      return front;
    };
    made.front = [at_points](const CrackSize& size, Faces faces) {
      return at_points(size, faces, kFrontPoints);
    };
    made.front_ends = [at_points](const CrackSize& size, Faces faces) {
      return at_points(size, faces, 2);
    };
    made.bending = tube_bending(made.front, wall.mean_radius);
    made.bending_ends = tube_bending(made.front_ends, wall.mean_radius);
    const double r = wall.mean_radius;
    const double K_u = gear_.flexspline->stress_nonuniformity;
    made.reference_stress = [=](const CrackSize& size, double P, double T) {
      const double sigma_vM = von_mises(P / (2 * pi * r * t), K_u * T / (2 * pi * r * r * t));
      return ligament_reference_stress(SectionLoading::membrane, sigma_vM, size.size / t);
    };
    take_size(made, "depth", CrackSize::of(crack.depth, crack.half_length), t - crack.depth);
    made.range_end = sif::kFittedDepthRatio * t;
    made.range_text = "0.8 of the wall, the range of the stress intensity";
    use(made, {"FA-6", "FA-9"});
    if (made.assembly) use(made, {"SP-3"});
    const double place = crack.distance.value_or(wall.length / 2);
    made.length_end =
        kNearlyAll * std::min(pi * wall.mean_radius / std::abs(std::sin(crack.angle)),
                              std::min(place, wall.length - place) / std::cos(crack.angle));
    if (crack.count > 1) {
      made.count = crack.count;
      made.length_end = std::min(made.length_end, longest_in_row(crack, wall));
      use(made, {"CG-7"});
    }
  }

  /// Ends the range of a row at the end of its table (CG-8), or where neighbours open or press its
  /// faces (CG-7).
  void end_where_row_is_known(DriveCrack& made, WallThroughCrack crack, double radius) const {
    constexpr const char* kText = "the end of what is known of the cracks' influence on each other";
    const double table =
        kNearlyAll * sif::largest_tabulated_share(crack.angle) * pi * radius / crack.count;
    if (crack.shell_correction && table < made.range_end) {
      made.range_end = table;
      made.range_text = kText;
    }
    const auto known = [&](double half_length) {
      crack.half_length = half_length;
      return loads_.row_state(crack) == CrackLoads<double>::RowState::holds;
    };
    if (known(made.range_end)) return;
    made.range_end = last_known(made.range_end, known);
    made.range_text = kText;
  }

  /// The largest number up to `end` for which something is known, by halving.
  template <class Known>
  [[nodiscard]] static double last_known(double end, const Known& known) {
    constexpr int kHalvings = 40;
    double inside = 0.0;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (inside + end) / 2;
      (known(middle) ? inside : end) = middle;
    }
    return inside;
  }

  /// Half length at which the influence of surface cracks of a row on each other is no longer small
  /// [m].
  [[nodiscard]] double longest_in_row(WallSurfaceCrack crack, const LongWall& wall) const {
    const double end = largest_row_share(crack.angle) * pi * wall.mean_radius / crack.count;
    return last_known(end, [&](double half_length) {
      crack.half_length = half_length;
      return loads_.row_bound(crack) <= kLargestRowBound;
    });
  }

  void fill(DriveCrack& made, const DiaphragmArcCrack& crack,
            const LoadedCrack<sif::ThroughCrackInTube>& loaded) const {
    const double r = loaded.solution.mean_radius;
    take_basics(made, loaded);
    made.through_thickness = loaded.solution.wall_thickness;
    made.front = [states = BothStates(loaded.solution)](const CrackSize& size, Faces faces) {
      return along(states.with(faces), size.size, {0.0});
    };
    through_section(made, pi / 2,
                    {r, loaded.solution.wall_thickness, std::numeric_limits<double>::infinity()},
                    1.0);
    take_size(made, "half_length", {.size = crack.half_length}, pi * r - crack.half_length);
    made.range_end = r / 2;
    made.range_text = "half of the arc's radius";
    if (crack.count > 1)
      in_row(made, {crack.count, pi / 2},
             {r, loaded.solution.wall_thickness, std::numeric_limits<double>::infinity()}, 1.0);
    // Only the torque stresses the arc.
    made.reference_stress = [of_both = made.reference_stress](const CrackSize& size, double,
                                                              double T) {
      return of_both(size, 0.0, T);
    };
    leave_unknown(made, kDiaphragm, kNoField);
    use(made, {"FA-6", "FA-8"});
  }

  void fill(DriveCrack& made, const DiaphragmGroove& groove, const LoadedGroove&) const {
    const Diaphragm& diaphragm = *gear_.flexspline->diaphragm;
    const ElasticConstants steel = loads_.diaphragm_steel();
    made.moduli = {.opening = steel.plane_strain_modulus(), .shear = steel.G};
    // The law is linear between the stations, so the worst place is at an end or at a station.
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
    made.front = [places](const CrackSize& size, Faces) {
      std::vector<FrontIntensity> front;
      for (const auto& [r, h] : places) {
        FrontIntensity& at = front.emplace_back();
        at.load.III[kTorsion] = groove_intensity(annulus_shear(1.0, r, h), size.size, h);
      }
      return front;
    };
    made.reference_stress = [places](const CrackSize& size, double, double T) {
      double worst = 0.0;
      for (const auto& [r, h] : places)
        worst = std::max(worst, ligament_reference_stress(SectionLoading::membrane,
                                                          von_mises(0.0, annulus_shear(T, r, h)),
                                                          size.size / h));
      return worst;  // (FA-11)
    };
    take_size(made, "depth", {.size = groove.depth}, thinnest - groove.depth);
    made.range_end = kNearlyAll * thinnest;
    made.range_text = "the thickness of the diaphragm";
    leave_unknown(made, kDiaphragm, kNoField);
    made.notes.push_back(kGroove);
    use(made, {"FA-6", "FA-9", "FA-11"});
  }

  /// Reference stress of a crack through a wall.
  static void through_section(DriveCrack& made, double angle, const LongWall& wall, double K_u) {
    made.reference_stress = [=, field = made.path + ".half_length"](const CrackSize& size, double P,
                                                                    double T) {
      const auto share = through_wall_share({.half_length = size.size,
                                             .angle = angle,
                                             .mean_radius = wall.mean_radius,
                                             .length = wall.length});
      require(share.has_value(), field, size.size, "m",
              "2 half_length |sin(angle)| < half of the circumference, and "
              "2 half_length |cos(angle)| < length of the tube");
      const double section = 2 * pi * wall.mean_radius * wall.thickness;
      return von_mises(P / section, K_u * T / (section * wall.mean_radius)) / *share;  // (FA-8)
    };
  }

  /// Equal cracks of a row and their angle from its normal.
  struct RowOfCracks {
    int count = 1;
    double angle = 0.0;
  };
  /// Gives a crack its neighbours (CG-7), which end the range of its sizes, and the reference
  /// stress of their row.
  static void in_row(DriveCrack& made, RowOfCracks row, const LongWall& wall, double K_u) {
    const double round = pi * wall.mean_radius;  // 2 a/p = a count/(pi r)
    const double pitch = 2 * round / row.count;
    made.count = row.count;
    made.reference_stress = [=, field = made.path + ".half_length"](const CrackSize& size, double P,
                                                                    double T) {
      const double section = 2 * pi * wall.mean_radius * wall.thickness;
      const double sigma = P / section;
      const double tau = K_u * T / (section * wall.mean_radius);
      const auto of_row = row_reference_stress(
          {.half_length = size.size, .angle = row.angle, .pitch = pitch}, sigma, tau);
      // One crack in the length of the tube, as for a crack alone.
      const double along = 1 - 2 * size.size * std::abs(std::cos(row.angle)) / wall.length;
      require(of_row.has_value() && along > 0, field, size.size, "m",
              "the cracks of a row must not touch, and 2 half_length |cos(angle)| < length of the "
              "tube");
      return std::max(*of_row, von_mises(sigma, tau) / along);  // (FA-8), (FA-16)
    };
    const double end = kNearlyAll * largest_row_share(row.angle) * pitch / 2;
    use(made, {"CG-7", "FA-16"});
    if (end >= made.range_end) return;
    made.range_end = end;
    made.range_text = "where the gap to the next crack of the row is a fifth of the half length";
  }

  [[nodiscard]] const Material& material_of_crack(const DriveCrack& made) const {
    return material_of(gear_, made.material, made.path + ".material");
  }

  /// Gives a crack of a laminate the modulus of its equivalent K (LA-15).
  /// @return  what turns K into the modes whose energies add up
  [[nodiscard]] EnergyModes take_reference_modulus(DriveCrack& made) const {
    if (!made.moduli.anisotropic) return {};
    const double reference =
        material_of_crack(made).reference_modulus.value_or(made.moduli.opening);
    const EnergyModes modes(made.moduli, reference);
    made.laminate = true;
    made.moduli = {.opening = reference, .shear = made.moduli.shear};
    return modes;
  }

  /// The equivalent K at which the crack fractures; eqs. (FR-20), (LA-15).
  void take_toughness(DriveCrack& made) const {
    if (made.material.empty()) return;
    const Material& material = material_of_crack(made);
    if (!made.laminate)
      made.toughness = material.fracture_toughness;
    else if (material.fracture_energy)
      made.toughness = std::sqrt(*material.fracture_energy * made.moduli.opening);
  }

  [[nodiscard]] bool on_rim(WallSection section) const {
    return gear_.flexspline->crack_free != CrackFree::factor && section == WallSection::rim;
  }

  [[nodiscard]] AssemblyStress assembly_of(DriveCrack& made, WallSection section,
                                           const LongWall& wall, double angle) const {
    if (gear_.drive.wave_number < 2) return {};  // one lobe shifts the ring without bending it
    made.assembly = true;
    made.turning = TurningLoad::wave;
    made.notes.push_back(kAssembly);
    if (made.laminate) {
      use(made, {"LA-6", "LA-20"});
      const auto plies =
          wall_laminate(Lift<double>(), gear_, material_of_crack(made), wall.thickness);
      made.assembly_peak =
          assembly_stress(gear_.drive, plies.value(), wall.mean_radius, 0.0).normal;
      return assembly_stress(gear_.drive, plies.value(), wall.mean_radius, angle);
    }
    const ElasticConstants steel = loads_.wall_steel(section);
    use(made, {"ST-17", "FA-12"});
    made.assembly_peak =
        assembly_stress(gear_.drive, steel, wall.mean_radius, wall.thickness, 0.0).normal;
    return assembly_stress(gear_.drive, steel, wall.mean_radius, wall.thickness, angle);
  }

  // --- Wave generator ---------------------------------------------------------------------------

  void fill(DriveCrack& made, const RaceSurfaceCrack& crack,
            const LoadedCrack<sif::SurfaceCrack<1>>& loaded) const {
    take_size(made, "depth", {.size = crack.depth, .aspect_ratio = crack.aspect_ratio},
              *gear_.wave_generator->inner_ring_thickness - crack.depth);
    fill_race(made, crack, loaded);
    made.front = [states = BothStates(loaded.solution), f = lobe_force_per_torque()](
                     const CrackSize& size, Faces faces) {
      const sif::SurfaceCrack<1> surface = states.with(faces).with_aspect_ratio(size.aspect_ratio);
      std::vector<FrontIntensity> front(kFrontPoints);
      for (int i = 0; i < kFrontPoints; ++i)
        front[static_cast<std::size_t>(i)].load.I[kTorsion] =
            surface.stress_intensity(size.size, pi / 2 * i / (kFrontPoints - 1)).I[0] * f;
      return front;
    };
    const WaveGenerator& wg = *gear_.wave_generator;
    made.range_end = sif::kFittedDepthRatio * *wg.inner_ring_thickness;
    made.range_text = "0.8 of the ring, the range of the stress intensity";
    if (!wg.inner_ring_width) return;
    use(made, {"SP-1"});
    const double as_long_as_wide = crack.aspect_ratio * *wg.inner_ring_width / 2;
    if (as_long_as_wide >= made.range_end) return;
    made.range_end = as_long_as_wide;
    made.range_text = "where the crack is as long as the ring is wide";
  }

  void fill(DriveCrack& made, const RaceEdgeCrack& crack,
            const LoadedCrack<sif::EdgeCrack>& loaded) const {
    const double t = *gear_.wave_generator->inner_ring_thickness;
    take_size(made, "depth", {.size = crack.depth}, t - crack.depth);
    fill_race(made, crack, loaded);
    made.front = [states = BothStates(loaded.solution), f = lobe_force_per_torque()](
                     const CrackSize& size, Faces faces) {
      std::vector<FrontIntensity> front(1);
      front[0].load.I[kTorsion] = states.with(faces).stress_intensity(size.size, 0.0).I[0] * f;
      return front;
    };
    made.range_end = sif::kUsableDepthRatio * t;
    made.range_text = "0.9 of the ring, the range of the edge crack";
  }

  [[nodiscard]] double lobe_force_per_torque() const {
    return strainwave::lobe_force_per_torque(gear_.drive, *gear_.wave_generator);
  }

  /// Fills the parts that all cracks of the inner ring share; the lobe force stresses them.
  template <class Crack, class Solution>
  void fill_race(DriveCrack& made, const Crack& crack, const LoadedCrack<Solution>& loaded) const {
    const SectionLoading loading = crack.stress_driver == StressDriver::ring_bending
                                       ? SectionLoading::bending
                                       : SectionLoading::membrane;
    take_basics(made, loaded);
    made.reverses = false;
    if (crack.stress_driver == StressDriver::contact_edge ||
        crack.stress_driver == StressDriver::orthogonal_shear)
      made.turning = TurningLoad::balls;
    const double t = *gear_.wave_generator->inner_ring_thickness;
    // A ring in compression cannot reach its limit load in tension.
    const double stress = std::max(loads_.unit_stress(crack), 0.0) * lobe_force_per_torque();
    made.reference_stress = [=](const CrackSize& size, double, double T) {
      return ligament_reference_stress(loading, stress * std::abs(T), size.size / t);
    };
    leave_unknown(made, missing_stress(crack.stress_driver),
                  gear_.drive.wave_number < 2 ? kOtherDriver : kOnlyRisesWithTorque);
    if (crack.stress_driver == StressDriver::ring_bending)
      made.upper_bound = "the bending of a free ring (ST-13)";
    if (crack.stress_driver == StressDriver::contact_edge)
      made.upper_bound = "the tension at the edge of the contact (CO-7)";
    made.notes.push_back(kFit);
    use(made, {loading == SectionLoading::membrane ? "FA-9" : "FA-10"});
    if (gear_.drive.wave_number >= 2) use(made, {"SW-9"});
  }

  /// Names the stress that no driver contains, or a driver that cannot decide; empty if nothing is
  /// missing.
  [[nodiscard]] std::string missing_stress(StressDriver driver) const {
    std::string text = driver == StressDriver::orthogonal_shear ? kOrder : "";
    if (gear_.drive.wave_number < 2) return text;  // one lobe shifts the ring without bending it
    const WaveGenerator& wg = *gear_.wave_generator;
    const double t = *wg.inner_ring_thickness;
    std::optional<double> R = wg.inner_ring_mean_radius;
    if (!R && wg.bearing) R = (wg.bearing->inner_raceway_diameter - t) / 2;
    std::string size;
    if (R)
      size = fmt::format(
          ", about {:.3g} MPa at the lobe",
          bending_to_shape(gear_.drive, loads_.ring_steel(), *R, t) / units::MPa);  // (SW-9)
    if (!text.empty()) text += ", and ";
    return text +
           fmt::format("the stress of this driver leaves out the bending of the ring by its cam{}",
                       size);
  }

  const GearSet& gear_;
  CrackLoads<double> loads_;
  std::vector<std::shared_ptr<WallGroup>> groups_;
  std::shared_ptr<ShaftGroup> annular_;  ///< null: none
};

}  // namespace

double DriveCrack::assembly_phase(double wave_angle) const {
  return std::cos(wave_number * wave_angle);
}

void take_turn_table(DriveCrack& crack, std::shared_ptr<const TurnTable> table) {
  // The table contains the bending by the assembly, so what bounds it or leaves it out is gone.
  std::erase_if(crack.notes, [](const StrengthNote& note) {
    return note.text == kAssembly.text || note.text == kThroughBending.text;
  });
  for (const std::string_view tag : {"ST-17", "FA-12", "FA-14", "SP-3"})
    std::erase(crack.equations, tag);
  if (crack.unknown == kRim) crack.unknown = kRimTeeth;
  crack.assembly = true;
  crack.turning = TurningLoad::wave;
  crack.notes.push_back(
      {"K of the load alone is that of the closed form, because the table contains "
       "the wave",
       "GR-30"});
  use(crack, {"GR-30"});
  crack.notes.push_back(
      {fmt::format("K over the turn of the wave generator is that of the table {}",
                   shown(table->file)),
       "GR-30"});
  if (table->sizes.size() > 1) {
    crack.range_begin = table->sizes.front();
    if (table->sizes.back() < crack.range_end) {
      crack.range_end = table->sizes.back();
      crack.range_text = fmt::format("the end of the table {}", shown(table->file));
      crack.ends_in_table = true;
    }
  } else {
    crack.notes.push_back(
        {fmt::format("the table {} has one size, so K/sqrt(pi a) counts as constant",
                     shown(table->file)),
         "GR-30"});
  }
  crack.turn_table = std::move(table);
}

std::vector<DriveCrack> drive_cracks(const GearSet& gear) { return Maker(gear).all(); }

}  // namespace strainwave
