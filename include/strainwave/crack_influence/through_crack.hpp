// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

/// @file
/// A through crack in the wall of a tube under any stress of the sound wall, with faces that touch:
/// K from a table of unit tractions.

namespace strainwave {

/// Tractions that a crack releases, as polynomials over its faces.
///
/// s runs from -1 at the lower tip to 1 at the upper tip, zeta from -1 at the inner face of the
/// wall to 1 at the outer face.  The coefficients belong to 1, zeta, s, s zeta, s^2, s^2 zeta.
struct FaceTractions {
  /// Number of coefficients of each direction.
  static constexpr std::size_t kShapes = 6;
  std::array<double, kShapes> normal{};   ///< across the crack, tension > 0 [Pa]
  std::array<double, kShapes> along{};    ///< shear along the crack [Pa]
  std::array<double, kShapes> outward{};  ///< shear through the wall [Pa]
};

/// K_I, K_II, K_III at one place of a front [Pa*m^0.5].
using StationModes = std::array<double, 3>;

/// A crack in one state.
struct ThroughCrackState {
  /// Of the upper tip, at ThroughCrackResponse::stations.
  std::vector<StationModes> upper;
  /// Of the lower tip, at the same stations.
  std::vector<StationModes> lower;
  std::vector<double> pressure;  ///< at the places of the contact [Pa]
};

/// The response of one crack.
class ThroughCrackResponse {
 public:
  /// zeta of the stations of a front [-], from the inner face of the wall to the outer one.
  [[nodiscard]] std::span<const double> stations() const { return stations_; }
  /// Solves the contact of the faces without friction (IN-2).
  /// @param tractions  of the sound wall on the faces of the crack [Pa]
  /// @param start      pressures of a neighbouring state; empty: none
  /// @throws SolverError  if the contact does not settle
  [[nodiscard]] ThroughCrackState state(const FaceTractions& tractions,
                                        std::span<const double> start = {}) const;
  /// The same without contact: faces may pass through each other, and K_I may be < 0.
  [[nodiscard]] ThroughCrackState state_without_contact(const FaceTractions& tractions) const;

 private:
  friend class ThroughCrackTable;
  [[nodiscard]] ThroughCrackState factors(std::span<const double> loads,
                                          std::vector<double> pressure) const;
  double unit_{};         ///< sqrt(pi a) [m^0.5]
  std::size_t across_{};  ///< places of contact through the wall
  std::vector<double> stations_;
  std::vector<double> K_;        ///< rows: station, mode; columns: tractions, pressures
  std::vector<double> gap_;      ///< rows: places; columns: tractions
  std::vector<double> pressed_;  ///< rows and columns: places
};

/// Responses over length, radius and angle.
class ThroughCrackTable {
 public:
  /// Reads the text of a table (IN-1).
  /// @throws InputError  if the text is not such a table
  explicit ThroughCrackTable(std::string_view text);
  ~ThroughCrackTable();
  /// A table can be moved, not copied.
  /// @{
  ThroughCrackTable(ThroughCrackTable&&) noexcept;
  ThroughCrackTable& operator=(ThroughCrackTable&&) noexcept;
  /// @}

  /// The response of a crack (IN-1).
  /// @param half_length  a [m]
  /// @param thickness    t [m]; > 0
  /// @param mean_radius  R [m]
  /// @param angle        beta from +z toward -theta [rad]
  /// @throws InputError  beyond the range of the table
  [[nodiscard]] ThroughCrackResponse at(double half_length, double thickness, double mean_radius,
                                        double angle) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// The table that the program carries: nu = 0.3, a/t from 0.5 to 16, R/t from 30 to 120, every
/// angle, written by `strainwave fe influence` (FE-56).
[[nodiscard]] const ThroughCrackTable& through_crack_table();

}  // namespace strainwave
