// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "strainwave/core/dual.hpp"
#include "strainwave/core/lift.hpp"
#include "strainwave/crack_tables/crack_tables.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"

namespace strainwave {

/// The compliances of the series model at the output, without a report.
template <class Real>
struct SeriesCompliance {
  Real intact{};          ///< compliance of the sound drive [rad/(N*m)]
  Real positive{};        ///< compliance of the cracked drive, torque about +z [rad/(N*m)]
  Real negative{};        ///< compliance of the cracked drive, torque about -z [rad/(N*m)]
  Real positive_added{};  ///< compliance added by cracks, torque about +z [rad/(N*m)]
  Real negative_added{};  ///< compliance added by cracks, torque about -z [rad/(N*m)]
  Real output_shaft{};    ///< compliance of the sound shaft, a part of `intact` [rad/(N*m)]
  /// Compliance added by the cracks of flexspline and shaft, which are in line with the teeth
  /// [rad/(N*m)].
  Real positive_in_line{};
  Real negative_in_line{};  ///< the same, torque about -z [rad/(N*m)]
  bool usable = true;       ///< as StiffnessResult::usable

  /// Stiffness K_HD of the sound drive [N*m/rad]; eq. (ST-1).
  [[nodiscard]] Real intact_stiffness() const { return 1 / intact; }
  /// Stiffness of the cracked drive, torque about +z [N*m/rad].
  [[nodiscard]] Real positive_stiffness() const { return 1 / positive; }
  /// Stiffness of the cracked drive, torque about -z [N*m/rad].
  [[nodiscard]] Real negative_stiffness() const { return 1 / negative; }
  /// Share of its stiffness that the drive has lost, -(K/K_intact - 1) [-]; eq. (ST-15).
  [[nodiscard]] Real positive_loss() const { return positive_added / positive; }
  /// The same share under torque about -z [-].
  [[nodiscard]] Real negative_loss() const { return negative_added / negative; }
};

/// The numbers of `torsional_stiffness` alone: the same values to the last bit in a third of the
/// time, or the values with their derivatives.  `SeriesDerivatives` serves many inputs.
///
/// Implements theory manual eqs. (ST-1), (ST-15); derivatives by (SN-2).
///
/// @param gear     has passed `check`
/// @param lift     reads the numbers; a Lift<DualReal> also knows which numbers are the inputs
/// @param options  tolerance of the crack integrals and of their derivatives
/// @throws InputError  if a member refuses a number
template <class Real>
[[nodiscard]] SeriesCompliance<Real> series_compliance(const GearSet& gear,
                                                       const Lift<Real>& lift = Lift<Real>(),
                                                       const StiffnessOptions& options = {});

/// The series model of one drive with its derivatives with respect to more inputs than a number
/// carries: the engine differentiates each crack once (SN-10).
class SeriesDerivatives {
 public:
  /// @param gear     has passed `check`; must outlive this object and stay as it is
  /// @param options  tolerance of the crack integrals and of their derivatives
  explicit SeriesDerivatives(const GearSet& gear, const StiffnessOptions& options = {});
  ~SeriesDerivatives();
  SeriesDerivatives(const SeriesDerivatives&) = delete;
  SeriesDerivatives& operator=(const SeriesDerivatives&) = delete;

  /// `series_compliance` with respect to the inputs of a lift.
  /// @throws InputError  if a member refuses a number
  [[nodiscard]] SeriesCompliance<DualReal> of(const Lift<DualReal>& lift);

  struct Cracks;  ///< derivatives of each crack with respect to its own arguments

 private:
  const GearSet& gear_;
  QuadratureOptions options_;
  std::unique_ptr<Cracks> cracks_;
};

/// The same by tables of similar cracks (ST-21), for a drive whose numbers vary: within 1e-10 of
/// the engine, many times faster.  The engine answers for a crack that the tables do not contain.
///
/// @param gear    has passed `check`; a drive like those for which the tables were planned
/// @param tables  of one thread
[[nodiscard]] SeriesCompliance<double> series_compliance(const GearSet& gear,
                                                         CrackTables::Reader& tables);

/// Notes on kinks and steps of the series model exactly at this drive, where a derivative is
/// one-sided or does not exist: a crack between open and closed, an arc crack at a station of the
/// diaphragm's profile, a cracked shaft with a bore of 0.
/// @param gear  has passed `check`
[[nodiscard]] std::vector<Note> smoothness_notes(const GearSet& gear);

/// In plain numbers, and in numbers with their derivatives.
/// @{
template <>
SeriesCompliance<double> series_compliance(const GearSet&, const Lift<double>&,
                                           const StiffnessOptions&);
template <>
SeriesCompliance<DualReal> series_compliance(const GearSet&, const Lift<DualReal>&,
                                             const StiffnessOptions&);
/// @}

}  // namespace strainwave
