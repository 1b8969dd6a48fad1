// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "strainwave/fem/elasticity.hpp"
#include "strainwave/fem/section_mesh.hpp"

/// @file
/// Bodies of revolution under loads that vary round the axis: finite elements of order p in the
/// meridian section, and a wave of whole number n round the axis (FE-51).

namespace strainwave::fem {

/// Amplitudes in the directions r, theta, z.
///
/// A field of n waves is (u_r cos n theta, u_theta sin n theta, u_z cos n theta).  With n = 0, the
/// three amplitudes are constant round the axis; u_theta is then a twist.
using WaveVector = std::array<double, 3>;

/// Amplitudes of stress: rr, theta theta, zz, theta z, rz, r theta [Pa].  The fourth and the last
/// vary as sin n theta, the others as cos n theta; with n = 0 all are constant.
using WaveStress = std::array<double, 6>;

/// Traction at a place of the boundary, with its outward normal (r, z) [Pa].
using EdgeTraction = std::function<WaveVector(const SectionPoint& place, const SectionPoint& out)>;

struct HarmonicOptions {
  int order = 6;         ///< p [-]; in 2..8
  int corner_rings = 6;  ///< rings of cells round a sharp re-entrant corner [-]; in 0..16
};

/// A solution of n waves.
struct HarmonicSolution {
  int waves = 0;                     ///< n
  std::vector<double> displacement;  ///< amplitudes by unknown [m]
  /// Work of each of the loads of the same call on this solution, over the whole turn [J].
  std::vector<double> work_of_loads;
  double energy = 0.0;  ///< strain energy over the whole turn [J]
  /// largest nodal force over the largest nodal load [-]
  double equilibrium_residual = 0.0;
};

/// A place of the section, with the elements' functions there.
struct SectionPlace {
  SectionPoint point;
  std::vector<std::size_t> unknowns;  ///< of the cell, in three components
  std::vector<double> value;          ///< of the functions of one component
  std::vector<double> by_r;           ///< their derivatives by r [1/m]
  std::vector<double> by_z;           ///< and by z [1/m]
};

/// A field at a place of the section.
struct HarmonicPoint {
  WaveVector displacement{};  ///< [m]
  WaveStress stress{};        ///< [Pa]
  WaveVector by_r{};          ///< derivatives of the displacement by r [-]
  WaveVector by_z{};          ///< and by z [-]
};

/// Displacement gradient in cylindrical components: row of the displacement, column of the
/// derivative along r, theta, z [-].
using CylinderGradient = std::array<std::array<double, 3>, 3>;

/// Adds the gradient of one number of waves at an angle.
void add_gradient(CylinderGradient& to, const HarmonicPoint& point, int waves, double r,
                  double angle);

class HarmonicSection;

/// The equations of one number of waves, factorised for any number of loads.  It must not outlive
/// its section.
class HarmonicEquations {
 public:
  ~HarmonicEquations();
  HarmonicEquations(HarmonicEquations&&) noexcept;
  HarmonicEquations& operator=(HarmonicEquations&&) noexcept;

  /// Solves under one or more loads (FE-51).
  [[nodiscard]] std::vector<HarmonicSolution> solve(std::span<const EdgeTraction> loads) const;

  /// Solves under given nodal forces in addition to one load.
  /// @param forces  by unknown, in the scale of large_rotation_forces
  [[nodiscard]] HarmonicSolution solve(const EdgeTraction& load,
                                       const std::vector<double>& forces) const;

 private:
  friend class HarmonicSection;
  struct Parts;
  explicit HarmonicEquations(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

/// A body of revolution whose edges of role `held` do not move.
class HarmonicSection {
 public:
  /// @throws InputError  for a mesh that check_mesh refuses, or that reaches the axis; for a cell
  ///                     whose Jacobian is not positive; for numbers out of range
  HarmonicSection(const SectionMesh& mesh, const Elasticity& elasticity,
                  const HarmonicOptions& options = {});
  ~HarmonicSection();
  HarmonicSection(HarmonicSection&&) noexcept;
  HarmonicSection& operator=(HarmonicSection&&) noexcept;

  /// Factorises the equations for waves of one number.
  /// @param waves  n >= 0
  /// @throws InputError   for n < 2 if no edge is held, because the body can then move as a whole
  /// @throws SolverError  if the system of equations is singular
  [[nodiscard]] HarmonicEquations equations(int waves) const;

  /// Nodal forces that large rotations add to the linear equations (FE-53): those of the linear
  /// stresses minus those of the second Piola-Kirchhoff stress, sigma = C : (H + H^T + H^T H)/2.
  /// @param waves  solutions of 0, 2, 4, ... waves, symmetric about theta = 0
  /// @return for each number of waves, by unknown, over the integral of the wave's square
  [[nodiscard]] std::vector<std::vector<double>> large_rotation_forces(
      std::span<const HarmonicSolution> waves) const;

  /// Second Piola-Kirchhoff stress of a displacement gradient [Pa], as WaveStress.
  [[nodiscard]] WaveStress large_rotation_stress(const CylinderGradient& gradient) const;

  /// Finds places in the section.
  /// @param beyond  a point this far outside of a cell, over the cell's size, counts as inside [-]
  /// @throws InputError  for a point outside of the section
  [[nodiscard]] std::vector<SectionPlace> locate(std::span<const SectionPoint> points,
                                                 double beyond = 1e-7) const;

  /// The field of a solution at a place.
  [[nodiscard]] HarmonicPoint at(const HarmonicSolution& solution, const SectionPlace& place) const;

  [[nodiscard]] std::size_t unknowns() const;

 private:
  friend class HarmonicEquations;
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace strainwave::fem
