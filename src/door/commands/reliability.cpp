// SPDX-License-Identifier: Apache-2.0
#include "strainwave/layouts/reliability.hpp"

#include "strainwave/door/door.hpp"

namespace strainwave {
namespace {

struct ReliabilityOptions {
  std::vector<std::string> require;
  std::optional<int> draws;
  std::uint64_t seed = 1;
  int threads = 0;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({.name = "require",
           .unit = "",
           .doc = "OUTPUT OP VALUE, where OP is one of >=, >, <=, < and VALUE has a unit; once or "
                  "more",
           .names = "output"},
          &ReliabilityOptions::require);
    field({.name = "draws",
           .unit = "",
           .doc = "plain draws; by default 200000 for an output of the sum of the members, 20000 "
                  "for a strength margin and 2000 for any other",
           .range = {.lower = 2,
                     .lower_open = false,
                     .upper = kMaxReliabilityDraws,
                     .upper_open = false}},
          &ReliabilityOptions::draws);
    field({.name = "seed",
           .unit = "",
           .doc = "seed of the draws",
           .range = kNonNegative,
           .fallback = "1"},
          &ReliabilityOptions::seed);
    field({.name = "threads",
           .unit = "",
           .doc = "number of threads; 0 for all of the machine; the answer does not depend on it",
           .range = {.lower = 0, .lower_open = false, .upper = 256, .upper_open = false},
           .fallback = "0"},
          &ReliabilityOptions::threads);
  }
};

ReliabilityReport probabilities_of(const Request& request, const ReliabilityOptions& options) {
  const GearSet& gear = request.drive.gear;
  const std::vector<Requirement> requirements =
      from_option([&] { return requirements_on(gear, options.require); });
  return reliability_of(gear, requirements,
                        {.draws = options.draws, .seed = options.seed, .threads = options.threads},
                        request.progress);
}

}  // namespace

Command reliability_command() {
  return command<ReliabilityOptions, ReliabilityReport>({
      .name = "reliability",
      .summary = "Find the probability that scatter breaks a requirement",
      .description =
          "Lets the inputs scatter as the file says under [[scatter]], and finds the probability "
          "that a drive does not meet a requirement on one of its outputs. First-order and "
          "second-order reliability give the design point: the most likely inputs at which the "
          "requirement fails, or is met if the drive of the file fails, with the importance of "
          "each "
          "input. Importance sampling about the "
          "design point and plain Monte Carlo judge these two. The answer says which road to "
          "trust, with an interval of 95 % confidence; where no road is precise enough, it says so "
          "and gives limits. Drives that break a rule of the input, such as a crack deeper than "
          "its wall, count as failures in the upper limit. The probability does not contain the "
          "uncertainty of the model.",
      .example = "strainwave reliability examples/article_scatter.toml --require "
                 "'cracked.positive.stiffness >= 5.8e5 N*m/rad'",
      .function = probabilities_of,
      .documents = {{Format::text, reliability_text}},
  });
}

}  // namespace strainwave
