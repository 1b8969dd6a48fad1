// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/fem/fields.hpp"
#include "strainwave/fem/solid.hpp"

/// @file
/// Sampled fields as VTK XML files, for ParaView and other readers, in SI units.

namespace strainwave::fem {

/// The cells of this rank as a .vtu document, each divided into n^3 hexahedra (n^2 quadrilaterals)
/// with plane faces.  The fields, in single precision, are displacement [m], stress (3x3) [Pa] and
/// strain_energy_density [J/m^3].  If the sound solution is known, strain_energy_density_added
/// (cracked minus sound) follows.
[[nodiscard]] std::string vtu_text(const SampledFields& fields);

/// The crack faces of this rank, both faces as separate surfaces, with displacement [m] and opening
/// [m].
[[nodiscard]] std::string crack_faces_vtu_text(const SampledFields& fields);

/// Crack fronts as lines from station to station: K_I, K_II, K_III [Pa*m^0.5],
/// energy_release_rate [J/m^2] and the number of the front.
[[nodiscard]] std::string fronts_vtu_text(std::span<const CrackFront> fronts);

/// The .pvtu document that names the files of several ranks with the fields of `vtu_text`.
[[nodiscard]] std::string pvtu_text(const std::vector<std::string>& pieces,
                                    const SampledFields& fields);

/// A file of a series.
struct SeriesFile {
  double at{};       ///< time of the file, or what stands for time
  std::string name;  ///< of a .vtu or .pvtu file in the same folder
};

/// The .pvd document that names the files of a series with their times.
[[nodiscard]] std::string pvd_text(std::span<const SeriesFile> files);

/// The .pvtu document for the files of `crack_faces_vtu_text`.
[[nodiscard]] std::string crack_faces_pvtu_text(const std::vector<std::string>& pieces);

}  // namespace strainwave::fem
