// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace strainwave {

/// Ordinary differential equations that CVODE advances step by step, by backward differences with
/// Newton's method on a dense matrix of differences.
class Cvode {
 public:
  struct System {
    std::vector<double> tolerance;  ///< error that one step may add to each entry; > 0
    /// The rate of the state at a time.
    std::function<void(double time, std::span<const double> state, std::span<double> rate)> rate;
    std::size_t guard_count = 0;
    /// Functions whose change of sign ends a step.
    std::function<void(double time, std::span<const double> state, std::span<double> values)>
        guards;
  };
  /// @throws SolverError  if there is no memory
  explicit Cvode(System system);
  Cvode(const Cvode&) = delete;
  Cvode& operator=(const Cvode&) = delete;
  Cvode(Cvode&&) = delete;
  Cvode& operator=(Cvode&&) = delete;
  ~Cvode();

  /// Starts anew.  No step evaluates the rate behind the end.
  void begin(double time, std::span<const double> state, double end);

  struct Step {
    bool failed = false;                    ///< whether no step is short enough for the tolerance
    double time = 0.0;                      ///< [s]
    std::vector<std::size_t> changed = {};  ///< guards that change their sign there
  };
  /// Advances to the next change of sign, at most by one step, and leaves the state there.
  /// @param longest  length of the step [s]; > 0, also infinite
  /// @throws whatever `rate` or `guards` threw
  [[nodiscard]] Step step(double longest);
  [[nodiscard]] std::span<const double> state() const;
  /// Dense output within the last step.
  [[nodiscard]] std::vector<double> state_at(double time) const;

  struct Counts {
    std::uint64_t steps = 0;     ///< accepted [-]
    std::uint64_t rejected = 0;  ///< [-]
  };
  /// Since the construction.
  [[nodiscard]] Counts counts() const;

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace strainwave
