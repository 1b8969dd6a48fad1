// SPDX-License-Identifier: Apache-2.0 One solution of the 45 degree through crack of
// examples/through_crack.toml, as a whole process, which benchmarks/compare_fe.py compares with
// CalculiX.
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>

#include "strainwave/fem/mpi_session.hpp"
#include "strainwave/fem/solid.hpp"
#include "strainwave/gear_fem/tube_through_crack.hpp"

namespace {

using namespace strainwave;  // NOLINT(google-build-using-namespace)

/// Values that the command line gives as name=value; the library chooses all others.
std::map<std::string, double> settings(int argc, char** argv) {
  std::map<std::string, double> given;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const auto equals = argument.find('=');
    if (equals == std::string::npos) throw std::runtime_error("not name=value: " + argument);
    given[argument.substr(0, equals)] = std::stod(argument.substr(equals + 1));
  }
  return given;
}

void solve(std::map<std::string, double> given, const fem::MpiSession& session) {
  const auto value = [&given](const char* name, double otherwise) {
    const auto it = given.find(name);
    if (it == given.end()) return otherwise;
    const double found = it->second;
    given.erase(it);
    return found;
  };
  gear_fem::TubeWithThroughCrack tube;
  tube.material = {.youngs_modulus = 210e9, .poissons_ratio = 0.3};
  tube.mean_radius = 78.88e-3;
  tube.wall_thickness = 2.24e-3;
  tube.length = 160e-3;
  tube.half_length = value("half_length", 10e-3);
  tube.angle = std::numbers::pi / 4;
  tube.torque = 100;
  tube.crack_faces = fem::CrackFaces::free;  // the torque opens it
  tube.check_growth = false;                 // one solution
  tube.order = static_cast<int>(value("order", 3));
  tube.rings = static_cast<int>(value("rings", 0));
  tube.layers = static_cast<int>(value("layers", 0));
  tube.sectors = static_cast<int>(value("sectors", 0));
  if (!given.empty()) throw std::runtime_error("unknown setting: " + given.begin()->first);
  const gear_fem::TubeCrackResult result = gear_fem::solve_tube_with_through_crack(tube);
  if (session.rank() != 0) return;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const double K0_squared_over_E = std::pow(result.nominal_shear, 2) * std::numbers::pi *
                                   tube.half_length / tube.material.youngs_modulus;
  const fem::SolidResult& solid = result.solid;
  std::printf(
      "{\"G\": %.8f, \"added\": %.10e, \"unknowns\": %zu, \"cells\": %zu, \"assembly_s\": %.3f, "
      "\"solver_s\": %.3f, \"factor_MB\": %.0f, \"factor_GFlop\": %.3f, \"peak_MB\": %.1f}\n",
      result.energy_release_rate / K0_squared_over_E,
      result.added_compliance / result.compliance_without, solid.dofs, solid.cells,
      solid.assembly_seconds, solid.solver_seconds, solid.factor_megabytes,
      solid.factor_operations / 1e9, static_cast<double>(usage.ru_maxrss) / 1024);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const fem::MpiSession session(argc, argv);
    solve(settings(argc, argv), session);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
