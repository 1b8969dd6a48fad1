// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "strainwave/fe_study/output_files.hpp"
#include "strainwave/fem/solid.hpp"

namespace strainwave::fe_study {

/// A tube of the body that is drawn.
struct DrawnTube {
  double inner_radius{};  ///< [m]
  double outer_radius{};  ///< [m]
  double from{};          ///< z [m]
  double to{};            ///< z [m]
};

/// A crack of a tube's wall whose middle is at theta = 0, of whatever shape: what pictures need.
struct CrackedWall {
  std::string path;                ///< "flexspline.crack[0]"
  std::string description;         ///< "through crack 2a = 20 mm at 45° from the generator, ..."
  double mean_radius{};            ///< [m]
  double wall_thickness{};         ///< [m]
  double length{};                 ///< [m]
  std::string body;                ///< "tube", "cup"
  std::vector<DrawnTube> outline;  ///< of the body, from the lowest to the open end
  double place{};                  ///< z of the crack's middle [m]
  double half_length{};            ///< a, on the face that is seen [m]
  double angle{};                  ///< from +z toward -theta [rad]
  bool inside = false;             ///< seen is the wall's inner face, which the crack starts from
  double torque{};                 ///< with its sense [N*m]
  std::string state;               ///< "open", "partly closed", "closed"
  bool closed = false;             ///< K_I = 0 is exact
  std::string fault;               ///< why the result may not be used; empty if it may
  const fem::SolidResult* solid = nullptr;
  std::vector<std::string> front_names;  ///< of each front: "upper tip"
  std::string along;                     ///< what runs along a front: "from the inner face"
  bool corners = false;                  ///< K is not defined at a front's two ends
};

/// Energy on the face, the same less that of the sound wall, the crack opened, and the stress
/// intensity along its fronts.
[[nodiscard]] std::vector<OutputFile> wall_pictures(const CrackedWall& wall);

}  // namespace strainwave::fe_study
