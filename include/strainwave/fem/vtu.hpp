// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/fem/fields.hpp"
#include "strainwave/fem/solid.hpp"

/// @file
/// Sampled fields as VTK's XML files, for ParaView and whatever else reads them.  All SI.

namespace strainwave::fem {

/// The cells of this rank as a .vtu document, each divided into n^3 hexahedra (n^2 quadrilaterals)
/// with plane faces.  Fields: displacement [m], stress (3x3) [Pa], strain_energy_density [J/m^3],
/// and strain_energy_density_added (cracked minus sound) where the sound one is known; single
/// precision.
[[nodiscard]] std::string vtu_text(const SampledFields& fields);

/// The crack faces of this rank, each of the two as surfaces of their own: displacement [m] and
/// opening [m].
[[nodiscard]] std::string crack_faces_vtu_text(const SampledFields& fields);

/// Crack fronts as lines from station to station: K_I, K_II, K_III [Pa*m^0.5],
/// energy_release_rate [J/m^2] and the number of the front.
[[nodiscard]] std::string fronts_vtu_text(std::span<const CrackFront> fronts);

/// The .pvtu document that names the files of several ranks with the fields of `vtu_text`.
[[nodiscard]] std::string pvtu_text(const std::vector<std::string>& pieces,
                                    const SampledFields& fields);

/// The same of `crack_faces_vtu_text`.
[[nodiscard]] std::string crack_faces_pvtu_text(const std::vector<std::string>& pieces);

}  // namespace strainwave::fem
