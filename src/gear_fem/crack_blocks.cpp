// SPDX-License-Identifier: Apache-2.0
#include "strainwave/gear_fem/crack_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "crack_plan.hpp"
#include "ellipse_template.hpp"
#include "strainwave/core/error.hpp"

namespace strainwave::gear_fem {
namespace {

enum Tag { kTop = 1, kBottom, kFront, kBack, kCrack, kLeft, kRight };

void insert(std::vector<double>& lines, const std::vector<double>& more) {
  lines.insert(lines.end(), more.begin(), more.end());
}

void check_positive(const char* field, double value) {
  require(value > 0 && std::isfinite(value), field, value, "m", "> 0");
}

/// Stress of the block without its crack.
std::function<std::array<fem::Point3, 3>(const fem::Point3&)> far_stress(BlockLoad load,
                                                                         double stress,
                                                                         double width) {
  return [=](const fem::Point3& p) {
    std::array<fem::Point3, 3> s{};
    if (load == BlockLoad::shear)
      s[0][1] = s[1][0] = stress;
    else
      s[1][1] = load == BlockLoad::bending ? stress * p[0] / width : stress;
    return s;
  };
}

/// The loads of both kinds of block, which are in equilibrium.
fem::SolidLoad loads_of(BlockLoad load, double stress, double width) {
  fem::SolidLoad made{.tractions = {}, .stress_without_crack = far_stress(load, stress, width)};
  const auto add = [&](int tag, const fem::Point3& t) {
    made.tractions.push_back({.tag = tag, .value = [t](const fem::Point3&) { return t; }});
  };
  if (load == BlockLoad::tension) {
    add(kTop, {0, stress, 0});
    add(kBottom, {0, -stress, 0});
  } else if (load == BlockLoad::bending) {
    for (const int tag : {kTop, kBottom}) {
      const double outward = tag == kTop ? 1.0 : -1.0;
      made.tractions.push_back({.tag = tag, .value = [=](const fem::Point3& p) {
                                  return fem::Point3{0, outward * stress * p[0] / width, 0};
                                }});
    }
  } else {
    add(kTop, {stress, 0, 0});
    add(kBottom, {-stress, 0, 0});
    add(kRight, {0, stress, 0});
    add(kLeft, {0, -stress, 0});
  }
  return made;
}

}  // namespace

fem::SolidResult straight_crack_block(const StraightCrackBlock& block) {
  check_positive("crack_length", block.crack_length);
  check_positive("half_height", block.half_height);
  check_positive("thickness", block.thickness);
  require(block.width > 1.02 * block.crack_length, "width", block.width, "m",
          "width > 1.02 crack_length");
  require(block.rings >= 3 && block.rings <= 12, "rings", block.rings, "1", "3 <= rings <= 12");
  const double a = block.crack_length;
  const double W = block.width;
  const double H = block.half_height;
  const double b = std::min({0.5 * a, 0.5 * (W - a), 0.5 * H});
  CrackPlan plan;
  plan.rings = block.rings;
  // Make the lines of x >= 0 first.
  std::vector<double> right{a - b, a};
  insert(right, {a + b});
  insert(right, graded_lines(a + b, W, b, 2, (W - a)));
  if (block.centre) {
    for (auto it = right.rbegin(); it != right.rend(); ++it) plan.x.push_back(-*it);
    insert(plan.x, right);
    plan.tips = {{.i = right.size() + 1, .j = 0, .growth = 1},
                 {.i = right.size() - 2, .j = 0, .growth = -1}};
  } else {
    plan.x.push_back(0);
    insert(plan.x, right);
    plan.tips = {{.i = 2, .j = 0, .growth = 1}};
  }
  std::vector<double> up = graded_lines(b, H, b, 2, H);
  for (auto it = up.rbegin(); it != up.rend(); ++it) plan.y.push_back(-*it);
  insert(plan.y, {-b, 0, b});
  insert(plan.y, up);
  for (PlanTip& tip : plan.tips) tip.j = up.size() + 1;

  const double B = block.thickness;
  const double left = block.centre ? -a : 0.0;
  const double tiny = 1e-9 * (W + H);
  const bool centre = block.centre;
  const fem::TemplateBody body{.map = [](const fem::Point3& p) { return p; },
                               .on_crack =
                                   [=](const fem::Point3& p) {
                                     return std::abs(p[1]) < tiny && p[0] < a - tiny &&
                                            (centre ? p[0] > left + tiny : true);
                                   },
                               .face_tag = [=](const fem::Point3& p) -> int {
                                 if (std::abs(p[1] - H) < tiny) return kTop;
                                 if (std::abs(p[1] + H) < tiny) return kBottom;
                                 if (p[2] < tiny) return kFront;
                                 if (p[2] > B - tiny) return kBack;
                                 if (std::abs(p[1]) < tiny)
                                   return p[0] > left && p[0] < a ? kCrack : 0;
                                 if (std::abs(p[0] - W) < tiny) return kRight;
                                 return p[0] < tiny ? kLeft : 0;
                               },
                               .length = W + H};
  const fem::HexMesh mesh = fem::make_hex_mesh(extruded(crack_plan(plan), {0, B}), body);

  fem::SolidProblem problem;
  problem.material = block.material;
  problem.order = block.order;
  problem.crack_tag = kCrack;
  problem.crack_faces = block.crack_faces;
  const auto across = [](const fem::Point3&) { return std::vector<fem::Point3>{{0, 0, 1}}; };
  problem.supports.push_back({.tag = kFront, .directions = across});
  problem.supports.push_back({.tag = kBack, .directions = across});
  // Hold rigid motions in the plane; these supports carry no force, because the loads are in
  // equilibrium.
  problem.supports.push_back({.tag = kRight, .directions = [=](const fem::Point3& p) {
                                std::vector<fem::Point3> held;
                                if (std::abs(p[1]) < tiny) held = {{1, 0, 0}, {0, 1, 0}};
                                if (p[1] > H - tiny) held = {{1, 0, 0}};
                                return held;
                              }});
  return fem::solve_solid(mesh, problem, loads_of(block.load, block.stress, W));
}

fem::SolidResult elliptical_crack_block(const EllipticalCrackBlock& block) {
  check_positive("depth", block.depth);
  check_positive("half_length", block.half_length);
  check_positive("half_height", block.half_height);
  require(block.depth >= 0.2 * block.half_length && block.depth <= 5 * block.half_length, "depth",
          block.depth, "m", "0.2 <= depth/half_length <= 5");
  require(block.thickness > 1.1 * block.depth, "thickness", block.thickness, "m",
          "thickness > 1.1 depth");
  require(block.half_width > 1.1 * block.half_length, "half_width", block.half_width, "m",
          "half_width > 1.1 half_length");
  require(block.rings >= 3 && block.rings <= 12, "rings", block.rings, "1", "3 <= rings <= 12");
  require(block.segments >= 4 && block.segments <= 32 && block.segments % 4 == 0, "segments",
          block.segments, "1", "4 <= segments <= 32, a multiple of 4");
  const double X = block.half_width;
  const double H = block.half_height;
  const double t = block.thickness;
  const double tiny = 1e-9 * (X + H);
  const bool embedded = block.embedded;
  const EllipseTemplate slab{.depth = block.depth,
                             .half_length = block.half_length,
                             .thickness = t,
                             .x = {-X, X},
                             .y = {-H, H},
                             .longest_x = X,
                             .longest_y = H,
                             .rings = block.rings,
                             .segments = block.segments};
  const fem::TemplateBody body{
      .map = [](const fem::Point3& p) { return p; },
      .on_crack = [=](const fem::Point3& p) { return inside_ellipse(slab, p); },
      .face_tag = [=](const fem::Point3& p) -> int {
        if (std::abs(p[1] - H) < tiny) return kTop;
        if (std::abs(p[1] + H) < tiny) return kBottom;
        if (std::abs(p[0] - X) < tiny) return kRight;
        if (std::abs(p[0] + X) < tiny) return kLeft;
        if (p[2] < tiny) return kFront;
        return inside_ellipse(slab, p) ? kCrack : 0;
      },
      .length = X + H};
  const fem::HexMesh mesh = fem::make_hex_mesh(ellipse_template(slab), body);

  fem::SolidProblem problem;
  problem.material = block.material;
  problem.order = block.order;
  problem.crack_tag = kCrack;
  if (embedded)
    problem.supports.push_back({.tag = kFront, .directions = [](const fem::Point3&) {
                                  return std::vector<fem::Point3>{{0, 0, 1}};
                                }});
  problem.supports.push_back({.tag = kRight, .directions = [=](const fem::Point3& p) {
                                std::vector<fem::Point3> held;
                                const bool middle = std::abs(p[1]) < tiny;
                                const bool mouth = p[2] < tiny;
                                if (middle && mouth) held = {{1, 0, 0}, {0, 1, 0}};
                                if (middle && p[2] > t - tiny) held = {{1, 0, 0}};
                                if (p[1] > H - tiny && mouth) held = {{1, 0, 0}};
                                if (!embedded && mouth && (middle || p[1] > H - tiny))
                                  held.push_back({0, 0, 1});
                                return held;
                              }});
  return fem::solve_solid(mesh, problem, loads_of(block.load, block.stress, X));
}

}  // namespace strainwave::gear_fem
