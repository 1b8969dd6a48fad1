// SPDX-License-Identifier: Apache-2.0
#include "meridian.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "strainwave/core/error.hpp"

namespace strainwave::meridian {

/// Largest number of elements along a tube; a barrel of a drive needs a few dozen.
constexpr int kMostOfTube = 2000;

double Element::length() const { return std::hypot(r[1] - r[0], z[1] - z[0]); }

namespace {

/// Values and derivatives along the meridian of U, V, W over the unknowns of an element in its own
/// directions: U, V, W, dW/ds at both ends, then the bubbles.
struct Shape {
  using Row = Eigen::Matrix<double, 1, kElementUnknowns>;
  Row U = Row::Zero(), U_s = Row::Zero();
  Row V = Row::Zero(), V_s = Row::Zero();
  Row W = Row::Zero(), W_s = Row::Zero(), W_ss = Row::Zero();

  Shape(double x, double l) {
    const std::array<double, 4> line = {1 - x, x, x * (1 - x), x * (1 - x) * (1 - 2 * x)};
    const std::array<double, 4> line_x = {-1, 1, 1 - 2 * x, 1 - 6 * x + 6 * x * x};
    constexpr std::array kOfU = {0, 4, 8, 9};
    constexpr std::array kOfV = {1, 5, 10, 11};
    for (std::size_t i = 0; i < 4; ++i) {
      U(kOfU[i]) = V(kOfV[i]) = line[i];
      U_s(kOfU[i]) = V_s(kOfV[i]) = line_x[i] / l;
    }
    constexpr std::array kOfW = {2, 3, 6, 7};
    const std::array<double, 4> bend = {1 - 3 * x * x + 2 * x * x * x,
                                        l * (x - 2 * x * x + x * x * x), 3 * x * x - 2 * x * x * x,
                                        l * (x * x * x - x * x)};
    const std::array<double, 4> bend_x = {-6 * x + 6 * x * x, l * (1 - 4 * x + 3 * x * x),
                                          6 * x - 6 * x * x, l * (3 * x * x - 2 * x)};
    const std::array<double, 4> bend_xx = {-6 + 12 * x, l * (-4 + 6 * x), 6 - 12 * x,
                                           l * (6 * x - 2)};
    for (std::size_t i = 0; i < 4; ++i) {
      W(kOfW[i]) = bend[i];
      W_s(kOfW[i]) = bend_x[i] / l;
      W_ss(kOfW[i]) = bend_xx[i] / (l * l);
    }
  }
};

/// Rows over the unknowns of the nodes, from rows over those of an element in its own directions.
template <int kRows>
Eigen::Matrix<double, kRows, kElementUnknowns> over_nodes(
    const Eigen::Matrix<double, kRows, kElementUnknowns>& own, const Element& element, int waves) {
  const double S = element.slope();
  const double C = element.rise();
  Eigen::Matrix<double, kRows, kElementUnknowns> rows = own;
  for (int k = 0; k < 2 * kNodeUnknowns; k += kNodeUnknowns) {
    rows.col(k) = S * own.col(k) + C * own.col(k + 2);
    rows.col(k + 2) = C * own.col(k) - S * own.col(k + 2);
    rows.col(k + 3) = -own.col(k + 3);  // the rotation is -dW/ds
  }
  if (element.arm != 0) {
    const double at_node = element.r[0] - element.arm;
    rows.col(0) += element.arm * waves / at_node * rows.col(1);
    rows.col(1) *= 1 + element.arm / at_node;
    rows.col(3) += element.arm * rows.col(2);
  }
  return rows;
}

}  // namespace

StrainRows Element::strains(int waves, double at) const {
  const Shape f(at, length());
  const double S = slope();
  const double C = rise();
  const double R = radius(at);
  const double n = waves;
  StrainRows own;
  own.row(0) = f.U_s;
  own.row(1) = (n * f.V + S * f.U + C * f.W) / R;
  own.row(2) = f.V_s - (n * f.U + S * f.V) / R;
  own.row(3) = -f.W_ss;
  own.row(4) = (n * n * f.W + n * C * f.V) / (R * R) - S * f.W_s / R;
  own.row(6) = -f.W_s;
  own.row(7) = (n * f.W + C * f.V) / R;
  own.row(8) = (f.V_s + (S * f.V + n * f.U) / R) / 2;
  own.row(5) = 2 * n * f.W_s / R - 2 * n * S * f.W / (R * R) + C * f.V_s / R -
               2 * C * S * f.V / (R * R) + C / R * own.row(8);  // (CU-1)
  return over_nodes(own, *this, waves);
}

Eigen::Matrix<double, 2, kElementUnknowns> Element::displacement(int waves, double at,
                                                                 double outside) const {
  const Shape f(at, length());
  const double S = slope();
  const double C = rise();
  const double R = radius(at);
  Eigen::Matrix<double, 2, kElementUnknowns> own;
  own.row(0) = S * f.U + C * f.W;
  own.row(1) = f.V + outside * (waves * f.W + C * f.V) / R;
  return over_nodes(own, *this, waves);
}

Eigen::Matrix<double, 6, 6> elasticity(const ShellCup& cup, double thickness) {
  const double nu = cup.poissons_ratio;
  const double membrane = cup.youngs_modulus * thickness / (1 - nu * nu);
  Eigen::Matrix3d plane;
  plane << 1, nu, 0, nu, 1, 0, 0, 0, (1 - nu) / 2;
  Eigen::Matrix<double, 6, 6> both = Eigen::Matrix<double, 6, 6>::Zero();
  both.topLeftCorner<3, 3>() = membrane * plane;
  both.bottomRightCorner<3, 3>() = membrane * thickness * thickness / 12 * plane;
  return both;
}

namespace {

Eigen::Matrix<double, kElementUnknowns, kElementUnknowns> stiffness_of(const Element& element,
                                                                       const ShellCup& cup,
                                                                       int waves) {
  Eigen::Matrix<double, kElementUnknowns, kElementUnknowns> stiffness =
      Eigen::Matrix<double, kElementUnknowns, kElementUnknowns>::Zero();
  const Eigen::Matrix<double, 6, 6> D = elasticity(cup, element.thickness);
  for (std::size_t g = 0; g < kGaussAt.size(); ++g) {
    const StrainRows rows = element.strains(waves, kGaussAt[g]);
    const double weight = kGaussWeight[g] * element.length() * element.radius(kGaussAt[g]);
    const Eigen::Matrix<double, 6, kElementUnknowns> B = rows.topRows<6>();
    const Eigen::Matrix<double, 6, kElementUnknowns> stress = (weight * D).lazyProduct(B);
    stiffness += B.transpose().lazyProduct(stress);
  }
  return stiffness;
}

/// Whether two elements have the same stiffness, apart from rounding of their places.
bool alike(const Element& a, const Element& b) {
  return a.r == b.r && a.thickness == b.thickness && a.arm == b.arm && a.rise() == b.rise() &&
         std::abs(a.length() - b.length()) < 1e-9 * a.length();
}

}  // namespace

Equations::Equations(const std::vector<Element>& elements, const ShellCup& cup, int waves) {
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::Index count = 0;
  Eigen::Matrix<double, kElementUnknowns, kElementUnknowns> stiffness;
  const Element* last = nullptr;
  for (const Element& element : elements) {
    // The elements of a tube are alike.
    if (last == nullptr || !alike(element, *last)) stiffness = stiffness_of(element, cup, waves);
    last = &element;
    for (int i = 0; i < kElementUnknowns; ++i)
      for (int j = 0; j <= i; ++j) {
        const Eigen::Index row = element.unknown + place_of(i);
        const Eigen::Index column = element.unknown + place_of(j);
        if (std::min(row, column) < 0) continue;  // held
        entries.emplace_back(static_cast<int>(std::max(row, column)),
                             static_cast<int>(std::min(row, column)), stiffness(i, j));
        count = std::max(count, std::max(row, column) + 1);
      }
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  factor_.compute(matrix);
  if (factor_.info() != Eigen::Success)
    throw SolverError("the equations of the shell are singular");
}

Eigen::VectorXd Equations::solve(const Eigen::VectorXd& load) const { return factor_.solve(load); }

Meridian meridian_of(const ShellCup& cup, double band_width) {
  Meridian meridian;
  std::vector<Element>& elements = meridian.elements;
  const double radius = (cup.barrel.outer_diameter - cup.barrel.wall_thickness) / 2;
  const double rim_radius = (cup.rim.outer_diameter - cup.rim.wall_thickness) / 2;
  double start = 0;
  if (cup.diaphragm) {
    const Diaphragm& plate = *cup.diaphragm;
    start = -plate.thickness / 2;  // the middle of the diaphragm
    const double inner = plate.inner_diameter / 2;
    constexpr int kMostElements = 40;
    // The thickness of an element is constant, so a profile needs many.
    const int count =
        plate.profile.empty()
            ? std::clamp(static_cast<int>(std::ceil((radius - inner) / (0.06 * radius))), 6,
                         kMostElements)
            : kMostElements;
    for (int i = 0; i < count; ++i) {
      const std::array<double, 2> r = {inner + (radius - inner) * i / count,
                                       inner + (radius - inner) * (i + 1) / count};
      elements.push_back({.r = r,
                          .z = {start, start},
                          .thickness = diaphragm_thickness(plate, (r[0] + r[1]) / 2)});
    }
  }
  meridian.barrel_from = elements.size();
  const auto add_tube = [&](double at, double from, double to, double thickness, double arm) {
    // Bending at the ends of a tube falls over sqrt(r t).
    const double step = 0.35 * std::sqrt(at * thickness);
    const double wanted = std::ceil((to - from) / step);
    require(wanted <= kMostOfTube, "length", to - from, "m",
            fmt::format("at most {} elements of 0.35 sqrt(r t); shorten the barrel or the rim, or "
                        "give a thicker wall",
                        kMostOfTube));
    const int count = std::max(2, static_cast<int>(wanted));
    for (int i = 0; i < count; ++i)
      elements.push_back(
          {.r = {at, at},
           .z = {from + (to - from) * i / count, from + (to - from) * (i + 1) / count},
           .thickness = thickness,
           .arm = i == 0 ? arm : 0.0});
  };
  const double rim_from = cup.barrel.length;
  add_tube(radius, start, rim_from, cup.barrel.wall_thickness, 0);
  meridian.rim_from = elements.size();
  const double width = band_width > 0 ? std::min(band_width, cup.rim.length) : cup.rim.length;
  const double clear = (cup.rim.length - width) / 2;
  const double arm = rim_radius - radius;
  if (clear > 1e-9 * cup.rim.length)
    add_tube(rim_radius, rim_from, rim_from + clear, cup.rim.wall_thickness, arm);
  meridian.band_from = elements.size();
  add_tube(rim_radius, rim_from + clear, rim_from + clear + width, cup.rim.wall_thickness,
           meridian.band_from == meridian.rim_from ? arm : 0.0);
  meridian.band_to = elements.size();
  if (clear > 1e-9 * cup.rim.length)
    add_tube(rim_radius, rim_from + clear + width, rim_from + cup.rim.length,
             cup.rim.wall_thickness, 0);
  // The first node is held, so its unknowns are left out.
  Eigen::Index unknown = -kNodeUnknowns;
  for (Element& element : elements) {
    element.unknown = unknown;
    unknown += kNodeUnknowns + kInnerUnknowns;
  }
  meridian.unknowns = unknown + kNodeUnknowns;
  return meridian;
}

}  // namespace strainwave::meridian
