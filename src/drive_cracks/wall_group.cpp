// SPDX-License-Identifier: Apache-2.0
#include "strainwave/drive_cracks/wall_group.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <deque>
#include <numbers>
#include <utility>

#include "strainwave/crack_group/response_table.hpp"

namespace strainwave {
namespace {

using std::numbers::pi;

/// Share of jumps or stresses by which faces may overlap or pull [-].
constexpr double kLargestOverlap = 0.05;
/// Largest uncertainty by the curvature, as a share of the compliance of all cracks of a group, and
/// of K of each one, both alone and with open faces [-].
/// @{
constexpr double kLargestOfCompliance = 0.25;
constexpr double kLargestOfIntensity = 0.5;
/// @}
/// Share of a crack's compliance with open faces below which its compliance alone is rounding.
constexpr double kRounding = 1e-20;

/// A direction of the sheet for the angle of a crack from +y toward -x.
double in_sheet(double beta) { return pi / 2 + beta; }

/// Stresses of the sheet: by the axial force, by the torque, and by a hoop stress of 1.
std::array<SheetStress, 3> stresses_of(const WallGroup::Wall& wall) {
  return {SheetStress{.yy = wall.axial}, SheetStress{.xy = wall.shear},
          SheetStress{.xx = 1.0, .yy = wall.poissons_ratio}};
}

/// Responses of a group, with what they follow from.
struct Solved {
  std::vector<FacedCrack> cracks;
  double round = 0.0;
  std::array<SheetStress, 3> stresses;
  std::vector<std::vector<CrackResponse>> response;
};

bool same(const SheetStress& a, const SheetStress& b) {
  return a.xx == b.xx && a.yy == b.yy && a.xy == b.xy;
}

bool same(const FacedCrack& a, const FacedCrack& b) {
  return a.closed == b.closed && a.crack.centre == b.crack.centre &&
         a.crack.half_length == b.crack.half_length && a.crack.angle == b.crack.angle;
}

/// Whether this thread answers pairs from tables, and the tables of the last pairs.
thread_local bool tabulates = false;
thread_local std::deque<ResponseTable> tables;

/// The table of a pair of the same places, angles and faces.
ResponseTable& table_of(const std::vector<FacedCrack>& cracks, double round,
                        const std::array<SheetStress, 3>& stresses) {
  constexpr std::size_t kTables = 4;
  const auto same_pair = [&](const ResponseTable& of) {
    return of.period() == round &&
           std::ranges::equal(of.cracks(), cracks,
                              [](const FacedCrack& a, const FacedCrack& b) {
                                return a.closed == b.closed && a.crack.centre == b.crack.centre &&
                                       a.crack.angle == b.crack.angle;
                              }) &&
           std::ranges::equal(of.stresses(), stresses,
                              [](const auto& a, const auto& b) { return same(a, b); });
  };
  if (const auto found = std::ranges::find_if(tables, same_pair); found != tables.end())
    return *found;
  tables.emplace_front(cracks, std::vector(stresses.begin(), stresses.end()), round);
  if (tables.size() > kTables) tables.pop_back();
  return tables.front();
}

/// The responses, which this thread keeps for the last groups: a study may vary the load alone, and
/// an assessment asks several times at each of some hundred sizes.
std::vector<std::vector<CrackResponse>> solved(const std::vector<FacedCrack>& cracks, double round,
                                               const std::array<SheetStress, 3>& stresses) {
  if (tabulates && cracks.size() == 2)
    return table_of(cracks, round, stresses)
        .at({cracks[0].crack.half_length, cracks[1].crack.half_length});
  constexpr std::size_t kKept = 128;
  thread_local std::deque<Solved> last;
  for (const Solved& of : last)
    if (of.round == round &&
        std::ranges::equal(of.cracks, cracks,
                           [](const auto& a, const auto& b) { return same(a, b); }) &&
        std::ranges::equal(of.stresses, stresses,
                           [](const auto& a, const auto& b) { return same(a, b); }))
      return of.response;
  last.push_front({.cracks = cracks,
                   .round = round,
                   .stresses = stresses,
                   .response = group_response(cracks, stresses, {.period = round})});
  if (last.size() > kKept) last.pop_back();
  return last.front().response;
}

/// A stress on the plane of a crack, by the sheet's convention, in which the shear has the other
/// sign than in (FR-6).
struct OnPlane {
  double normal = 0.0;
  double shear = 0.0;
};
OnPlane on_plane(const SheetStress& s, double angle) {
  const double c = std::cos(2 * angle);
  const double d = std::sin(2 * angle);
  return {.normal = (s.xx + s.yy + c * (s.yy - s.xx) - 2 * d * s.xy) / 2,  // (CG-1)
          .shear = (d * (s.yy - s.xx) + 2 * c * s.xy) / 2};                // (CG-1)
}

/// Replaces rounding of the stress at a tip by zero, because the angle of 45 degrees has a rest of
/// shear.
double without_noise(double stress, const OnPlane& sound) {
  return std::abs(stress) < 1e-14 * std::hypot(sound.normal, sound.shear) ? 0.0 : stress;
}

/// Work of a crack in torsion over that of the crack alone.
double ratio_of(const CrackResponse& of, const FacedCrack& crack, const SheetStress& torsion) {
  const OnPlane plane = on_plane(torsion, crack.crack.angle);
  const double area = 2 * pi * crack.crack.half_length * crack.crack.half_length;
  const double whole = area * (plane.normal * plane.normal + plane.shear * plane.shear);
  const double alone =
      area * ((crack.closed ? 0.0 : plane.normal * plane.normal) + plane.shear * plane.shear);
  if (!(alone > kRounding * whole)) return 1.0;
  return (plane.normal * of.opening + plane.shear * of.sliding) / alone;  // (CG-9)
}

}  // namespace

TabulatedPairs::TabulatedPairs() : before_(std::exchange(tabulates, true)) {}
TabulatedPairs::~TabulatedPairs() { tabulates = before_; }

double GroupEffect::ratio() const {
  const double own = alone(kTorsion, kTorsion);
  return own > 0 ? in_group(kTorsion, kTorsion) / own : 1.0;
}

WallGroup::WallGroup(Wall wall, std::vector<Member> members)
    : wall_(std::move(wall)), members_(std::move(members)) {}

std::vector<StraightCrack> WallGroup::places() const {
  std::vector<StraightCrack> result;
  for (const Member& member : members_) result.push_back(member.place);
  return result;
}

std::array<double, 2> WallGroup::load(TorqueSense sense) const {
  // Without a load, the torque alone decides.
  const double torque = wall_.torque == 0 && wall_.axial_force == 0 ? 1.0 : wall_.torque;
  return {wall_.axial_force, sense == TorqueSense::positive ? torque : -torque};
}

std::string WallGroup::fault_of_places() const {
  if (members_.size() > kMostGroupedCracks)
    return fmt::format(
        "{}: {} through cracks of the {} have a position, and at most {} are solved together; "
        "leave out the position of cracks that are far from the others",
        members_.front().path, members_.size(), wall_.name, kMostGroupedCracks);
  const std::vector<StraightCrack> all = places();
  for (std::size_t j = 0; j < all.size(); ++j) {
    const NearestCrack nearest = nearest_crack(all, j, wall_.round);
    if (nearest.gap >= kLeastGroupGap) continue;
    if (nearest.index == j)
      return fmt::format("{}: the crack reaches almost round the whole {}; give a shorter crack",
                         members_[j].path, wall_.name);
    const auto [first, second] = std::minmax(j, nearest.index);
    return fmt::format(
        "{}: the gap to {} is less than {:g} of the longer half length, where the cracks are about "
        "to grow together; replace both by one crack, or move one of them by position or distance",
        members_[second].path, members_[first].path, kLeastGroupGap);
  }
  return {};
}

std::string WallGroup::fault() const {
  std::string places = fault_of_places();
  if (!places.empty()) return places;
  for (const TorqueSense sense : {TorqueSense::positive, TorqueSense::negative}) {
    const std::vector<GroupEffect> all = under(sense);
    double changed = 0.0;
    double alone = 0.0;
    for (std::size_t j = 0; j < all.size(); ++j) {
      if (all[j].overlap > kLargestOverlap)
        return fmt::format(
            "{}: under {} torque the other cracks of the {} let its faces touch over a part of "
            "their length, and no model tells which part; place the cracks farther apart",
            members_[j].path, enum_name(sense), wall_.name);
      const double of_K = all[j].changed_intensity;
      if (uncertainty() * of_K > kLargestOfIntensity)
        return fmt::format(
            "{}: the other cracks of the {} change its K by {:.2g} % as in a flat sheet, and at so "
            "large a shell parameter the curvature may change K by {:.2g} %; place the cracks "
            "farther apart, or give shorter cracks",
            members_[j].path, wall_.name, 100 * of_K, 100 * uncertainty() * of_K);
      const double square = members_[j].place.half_length * members_[j].place.half_length;
      changed += square * all[j].changed_compliance;
      alone += square;
    }
    if (uncertainty() * changed > kLargestOfCompliance * alone)
      return fmt::format(
          "{}: the cracks of the {} change each other's compliance by {:.2g} % as in a flat sheet, "
          "and at so large a shell parameter the curvature may change it by {:.2g} %; place the "
          "cracks farther apart, or give shorter cracks",
          members_.front().path, wall_.name, 100 * changed / alone,
          100 * uncertainty() * changed / alone);
  }
  return {};
}

double WallGroup::uncertainty() const {
  // Rows, (CG-8): solid elements and the shallow shell differ from the flat sheet by up to this
  // share of the influence.
  constexpr double kPerShellParameter = 0.7;
  constexpr double kMost = 1.5;
  double longest = 0.0;
  for (const Member& member : members_) longest = std::max(longest, member.place.half_length);
  return std::min(kMost, kPerShellParameter * wall_.shell_parameter * longest);  // (CG-9)
}

std::vector<bool> WallGroup::closed_under(TorqueSense sense) const {
  std::vector<bool> closed;
  bool any_touching = false;
  for (const Member& member : members_) {
    const Faces state =
        sense == TorqueSense::positive ? member.faces.positive : member.faces.negative;
    closed.push_back(state == Faces::pressed);
    any_touching = any_touching || state == Faces::touching;
  }
  if (!any_touching) return closed;
  // The load neither opens nor presses these; the other cracks decide.
  std::vector<FacedCrack> cracks;
  for (std::size_t j = 0; j < members_.size(); ++j)
    cracks.push_back({members_[j].place, closed[j]});
  const auto response = solved(cracks, wall_.round, stresses_of(wall_));
  const std::array<double, 2> by = load(sense);
  for (std::size_t j = 0; j < members_.size(); ++j) {
    const Faces state =
        sense == TorqueSense::positive ? members_[j].faces.positive : members_[j].faces.negative;
    if (state != Faces::touching) continue;
    double least = 0.0;
    double most = 0.0;
    for (std::size_t r = 0; r < response[0][j].faces.size(); ++r) {
      const double opened =
          by[kAxial] * response[kAxial][j].faces[r] + by[kTorsion] * response[kTorsion][j].faces[r];
      least = std::min(least, opened);
      most = std::max(most, opened);
    }
    closed[j] = -least > most;
  }
  return closed;
}

std::vector<GroupEffect> WallGroup::under(TorqueSense sense) const {
  return effects(closed_under(sense), load(sense));
}

std::vector<GroupEffect> WallGroup::apart() const {
  return effects(std::vector<bool>(members_.size(), false), load(TorqueSense::positive));
}

std::vector<GroupEffect> WallGroup::effects(const std::vector<bool>& closed,
                                            std::array<double, 2> by) const {
  std::vector<FacedCrack> cracks;
  for (std::size_t j = 0; j < members_.size(); ++j)
    cracks.push_back({members_[j].place, closed[j]});
  const std::array<SheetStress, 3> stresses = stresses_of(wall_);
  const auto response = solved(cracks, wall_.round, stresses);
  std::vector<GroupEffect> result;
  for (std::size_t j = 0; j < members_.size(); ++j) {
    GroupEffect& of = result.emplace_back();
    of.closed = closed[j];
    const StraightCrack& place = members_[j].place;
    const double root = std::sqrt(pi * place.half_length);
    const double area = 2 * pi * place.half_length * place.half_length;
    std::array<OnPlane, 3> plane;
    for (std::size_t load = 0; load < 3; ++load)
      plane[load] = on_plane(stresses[load], place.angle);
    double whole = 0.0;  // in torsion, with open faces
    for (const std::size_t a : {kAxial, kTorsion})
      for (const std::size_t b : {kAxial, kTorsion}) {
        const double open = plane[a].normal * plane[b].normal;
        const double slid = plane[a].shear * plane[b].shear;
        of.alone(a, b) = area * ((closed[j] ? 0.0 : open) + slid);
        if (a == kTorsion && b == kTorsion) whole = area * (open + slid);
      }
    if (!(of.alone(kTorsion, kTorsion) > kRounding * whole)) of.alone(kTorsion, kTorsion) = 0.0;
    // The matrix of all cracks together is symmetric; each crack gets half of both entries.
    const auto work = [&](std::size_t a, std::size_t b) {
      return plane[a].normal * response[b][j].opening + plane[a].shear * response[b][j].sliding;
    };
    for (const std::size_t a : {kAxial, kTorsion})
      for (const std::size_t b : {kAxial, kTorsion})
        if (a <= b) of.in_group(a, b) = (work(a, b) + work(b, a)) / 2;  // (CG-9)
    std::array<OnPlane, 2> at_load{};                                   // of each tip
    OnPlane sound{};
    for (std::size_t load = 0; load < 3; ++load) {
      const std::array<const TipFactors*, 2> tips = {&response[load][j].behind,
                                                     &response[load][j].ahead};
      for (std::size_t tip = 0; tip < 2; ++tip) {
        const double normal = without_noise(tips[tip]->mode_1 / root, plane[load]);
        const double shear = without_noise(-tips[tip]->mode_2 / root, plane[load]);  // (CG-9)
        if (load == 2) {
          of.by_hoop[tip] = {normal, shear};
          continue;
        }
        of.tips[tip].normal[load] = normal;
        of.tips[tip].shear[load] = shear;
        at_load[tip].normal += by[load] * normal;
        at_load[tip].shear += by[load] * shear;
      }
      if (load == 2) continue;
      sound.normal += by[load] * plane[load].normal;
      sound.shear -= by[load] * plane[load].shear;
    }
    const double open = std::hypot(sound.normal, sound.shear);
    if (whole > 0)
      of.changed_compliance =
          std::abs(of.in_group(kTorsion, kTorsion) - of.alone(kTorsion, kTorsion)) / whole;
    if (!(open > 0)) continue;
    if (closed[j]) sound.normal = 0.0;
    double largest = 0.0;
    for (const OnPlane& tip : at_load) {
      largest = std::max(largest, std::hypot(tip.normal, tip.shear));
      of.changed_intensity =
          std::max(of.changed_intensity,
                   std::hypot(tip.normal - sound.normal, tip.shear - sound.shear) / open);
    }
    of.tip = largest / open;
    const double alone = std::hypot(sound.normal, sound.shear);
    constexpr double kNothing = 1e-9;
    if (alone > kNothing * open) of.intensity = largest / alone;
    // Faces that overlap or pull.
    double wrong = 0.0;
    double size = closed[j] ? open : 0.0;
    for (std::size_t r = 0; r < response[0][j].faces.size(); ++r) {
      double of_faces = 0.0;
      double slid = 0.0;
      for (const std::size_t load : {kAxial, kTorsion}) {
        of_faces += by[load] * response[load][j].faces[r];
        slid += by[load] * response[load][j].slid[r];
      }
      wrong = std::max(wrong, closed[j] ? of_faces : -of_faces);
      if (!closed[j]) size = std::max({size, std::abs(of_faces), std::abs(slid)});
    }
    if (size > 0) of.overlap = wrong / size;
  }
  return result;
}

std::vector<UnderBothSenses<double>> WallGroup::ratios(const Places<double>&) const {
  std::vector<UnderBothSenses<double>> result(members_.size());
  if (!fault().empty()) return result;
  const std::vector<GroupEffect> positive = under(TorqueSense::positive);
  const std::vector<GroupEffect> negative = under(TorqueSense::negative);
  for (std::size_t j = 0; j < members_.size(); ++j)
    result[j] = {positive[j].ratio(), negative[j].ratio()};
  return result;
}

std::vector<UnderBothSenses<DualReal>> WallGroup::ratios(const Places<DualReal>& places) const {
  const std::vector<UnderBothSenses<double>> values = ratios(Places<double>{});
  std::vector<UnderBothSenses<DualReal>> result;
  for (const UnderBothSenses<double>& value : values)
    result.push_back({DualReal(value.positive), DualReal(value.negative)});
  if (!fault().empty()) return result;
  const std::vector<StraightCrack> here = this->places();
  const std::vector<int> points = response_points(here, wall_.round);
  const SheetStress torsion{.xy = 1.0};
  std::array<std::vector<bool>, 2> closed = {closed_under(TorqueSense::positive),
                                             closed_under(TorqueSense::negative)};
  double room = wall_.round;  // the smallest gap or half length
  for (std::size_t j = 0; j < here.size(); ++j)
    room = std::min(
        {room, here[j].half_length, nearest_crack(here, j, wall_.round).gap * here[j].half_length});
  for (std::size_t k = 0; k < kDualWidth; ++k) {
    double longest = std::abs(places.round.partial[k]);  // way of any place in a step of 1
    for (const auto& crack : places.cracks)
      longest = std::max({longest, std::abs(crack.round.partial[k]),
                          std::abs(crack.along.partial[k]), std::abs(crack.half_length.partial[k]),
                          std::abs(crack.angle.partial[k]) * value_of(crack.half_length)});
    if (!(longest > 0)) continue;
    constexpr double kShareOfRoom = 2e-3;
    const double step = kShareOfRoom * room / longest;
    const auto moved = [&](double by, std::size_t sense) {
      std::vector<FacedCrack> cracks;
      for (std::size_t j = 0; j < here.size(); ++j) {
        const auto& to = places.cracks[j];
        cracks.push_back(
            {{.centre = here[j].centre +
                        by * std::complex<double>(to.round.partial[k], to.along.partial[k]),
              .half_length = here[j].half_length + by * to.half_length.partial[k],
              .angle = here[j].angle + by * to.angle.partial[k]},
             closed[sense][j]});
      }
      const auto response =
          group_response(cracks, std::span(&torsion, 1),
                         {.period = wall_.round + by * places.round.partial[k], .points = points});
      std::vector<double> ratio;
      for (std::size_t j = 0; j < cracks.size(); ++j)
        ratio.push_back(ratio_of(response[0][j], cracks[j], torsion));
      return ratio;
    };
    for (std::size_t sense = 0; sense < 2; ++sense) {
      const auto one_before = moved(-step, sense);
      const auto one_behind = moved(step, sense);
      const auto two_before = moved(-2 * step, sense);
      const auto two_behind = moved(2 * step, sense);
      for (std::size_t j = 0; j < here.size(); ++j)
        (sense == 0 ? result[j].positive : result[j].negative).partial[k] =
            (8 * (one_behind[j] - one_before[j]) - (two_behind[j] - two_before[j])) / (12 * step);
    }
  }
  return result;
}

std::vector<WallGroup> wall_groups(const GearSet& gear, const CrackLoads<double>& loads) {
  std::vector<WallGroup> result;
  if (!gear.flexspline) return result;
  const Flexspline& fs = *gear.flexspline;
  const bool sections = fs.crack_free == CrackFree::sections;
  for (const WallSection section : {WallSection::barrel, WallSection::rim}) {
    std::vector<std::size_t> placed;
    for (std::size_t i = 0; i < fs.crack.size(); ++i) {
      const auto* const crack = std::get_if<WallThroughCrack>(&fs.crack[i]);
      // A row contains the influence of its own cracks.
      if (crack != nullptr && crack->section == section && crack->position && crack->count == 1)
        placed.push_back(i);
    }
    if (placed.size() < 2) continue;
    const bool rim = section == WallSection::rim;
    if (material_of(gear, material_name(fs, section), "flexspline.material").is_laminate())
      continue;
    const auto wall = loads.wall_of(section);
    const double length = !sections ? *fs.length : rim ? fs.rim->length : fs.barrel->length;
    const double round = 2 * pi * wall.mean_radius;
    const double area = round * wall.thickness;
    const double nu = loads.wall_steel(section).nu;
    WallGroup::Wall of{.name = rim        ? "rim"
                               : sections ? "barrel"
                                          : "wall",
                       .round = round,
                       .axial = 1 / area,
                       .shear = fs.stress_nonuniformity / (area * wall.mean_radius),
                       .poissons_ratio = nu,
                       .shell_parameter = std::sqrt(std::sqrt(12 * (1 - nu * nu)) /
                                                    (wall.mean_radius * wall.thickness)),
                       .axial_force = gear.load.axial_force,
                       .torque = std::abs(gear.load.torque)};
    std::vector<WallGroup::Member> members;
    for (const std::size_t i : placed) {
      const auto& crack = std::get<WallThroughCrack>(fs.crack[i]);
      members.push_back({.index = i,
                         .path = (FieldPath("flexspline") / "crack")[i].text(),
                         .place = {.centre = {wall.mean_radius * *crack.position,
                                              crack.distance.value_or(length / 2)},
                                   .half_length = crack.half_length,
                                   .angle = in_sheet(crack.angle)},
                         .faces = loads.faces_of(crack)});
    }
    result.emplace_back(std::move(of), std::move(members));
  }
  return result;
}

}  // namespace strainwave
