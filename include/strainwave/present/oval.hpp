// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "strainwave/chart/chart.hpp"
#include "strainwave/model/result/oval_stress.hpp"

/// @file
/// Tables and curves of the stress of an oval flexspline, for every model of the oval.

namespace strainwave {

/// The largest von Mises stress and its place, the contact of the cam, the coning angle and the
/// effect of large rotations, as sentences.
[[nodiscard]] std::string oval_sentences(const OvalState& oval, const WaveContact& contact);
/// A table for each torque, with every second place and both ends of each part.
[[nodiscard]] std::string oval_tables(std::span<const LoadedOval> torques);
/// Each station under each torque as a row.
[[nodiscard]] std::string oval_csv(std::span<const LoadedOval> torques);
/// Three panels for each torque: the extremes of hoop, meridional and shear stress along the wall.
[[nodiscard]] std::vector<PlotPanel> oval_panels(std::span<const LoadedOval> torques);

}  // namespace strainwave
