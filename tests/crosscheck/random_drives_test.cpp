// SPDX-License-Identifier: Apache-2.0 Laws that every drive obeys, tested on many random drives.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/core/units.hpp"
#include "strainwave/model/input/gear_set.hpp"
#include "strainwave/model/result/result_fields.hpp"
#include "strainwave/stiffness/torsional_stiffness.hpp"
#include "support/random_drive.hpp"

namespace strainwave {
namespace {

using namespace units;  // NOLINT(google-build-using-namespace): 0.1 * mm reads as it should

constexpr int kDrives = 500;

using test::random_drive;

/// The drives of all tests, the same for each.
const std::vector<GearSet>& drives() {
  static const std::vector<GearSet> all = [] {
    std::vector<GearSet> result;
    for (std::uint64_t seed = 1; result.size() < kDrives; ++seed)
      result.push_back(random_drive(seed));
    return result;
  }();
  return all;
}

TEST(RandomDrives, InputIsAcceptedAndVaried) {
  int n_cracks = 0;
  int n_usable = 0;
  std::array<int, 4> opens{};
  std::vector<std::string> codes;
  for (std::size_t i = 0; i < drives().size(); ++i) {
    ASSERT_NO_THROW(check(drives()[i])) << i;
    const StiffnessResult result = torsional_stiffness(drives()[i]);
    n_usable += result.usable() ? 1 : 0;
    n_cracks += static_cast<int>(result.cracks.size());
    for (const CrackReport& crack : result.cracks)
      ++opens[static_cast<std::size_t>(crack.opens_under)];
    for (const Note& note : result.notes) codes.push_back(note.code);
  }
  std::ranges::sort(codes);
  codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
  EXPECT_GT(n_cracks, 2 * kDrives);
  EXPECT_GT(n_usable, kDrives / 2);
  for (const int n : opens) EXPECT_GT(n, 20);
  EXPECT_GT(codes.size(), 20U);  // nearly all note codes occur
}

TEST(RandomDrives, LimitEveryNumberIsFinite) {
  for (std::size_t i = 0; i < drives().size(); ++i) {
    const StiffnessResult result = torsional_stiffness(drives()[i]);
    for_each_quantity(result, [&](const std::string& path, const Quantity& quantity) {
      EXPECT_TRUE(std::isfinite(quantity.value)) << i << ' ' << path;
      ASSERT_TRUE(quantity.relative_uncertainty.has_value()) << i << ' ' << path;
      EXPECT_TRUE(std::isfinite(*quantity.relative_uncertainty)) << i << ' ' << path;
      EXPECT_GE(*quantity.relative_uncertainty, 0.0) << i << ' ' << path;
    });
    EXPECT_GT(result.intact.stiffness.value, 0.0) << i;
    EXPECT_GT(result.positive.stiffness.value, 0.0) << i;
    EXPECT_GT(result.negative.stiffness.value, 0.0) << i;
  }
}

TEST(RandomDrives, IdentityCrackedIsNeverStifferThanSound) {
  for (std::size_t i = 0; i < drives().size(); ++i) {
    const StiffnessResult result = torsional_stiffness(drives()[i]);
    for (const CrackedDrive& drive : {result.positive, result.negative}) {
      EXPECT_LE(drive.stiffness.value, result.intact.stiffness.value) << i;
      EXPECT_LE(drive.stiffness_change.value, 0.0) << i;
      EXPECT_GE(drive.wind_up.value, result.intact.wind_up.value) << i;
      EXPECT_GE(drive.compliance.total.value, result.intact.compliance.total.value) << i;
      // The change is K/K_intact - 1, in every computation.
      EXPECT_NEAR(drive.stiffness_change.value,
                  drive.stiffness.value / result.intact.stiffness.value - 1, 1e-13)
          << i;
    }
  }
}

TEST(RandomDrives, IdentityCompliancesArePositiveSemidefinite) {
  for (std::size_t i = 0; i < drives().size(); ++i)
    for (const CrackReport& crack : torsional_stiffness(drives()[i]).cracks)
      for (const AddedCompliance& added : {crack.positive, crack.negative}) {
        EXPECT_GE(added.at_output.value, 0.0) << i << ' ' << crack.path;
        if (!added.axial_torsion) continue;
        const double PP = (*added.axial_torsion)[0].value;
        const double PT = (*added.axial_torsion)[1].value;
        const double TT = (*added.axial_torsion)[2].value;
        EXPECT_GE(PP, 0.0) << i << ' ' << crack.path;
        EXPECT_GE(TT, 0.0) << i << ' ' << crack.path;
        EXPECT_GE(PP * TT - PT * PT, -1e-12 * PP * TT) << i << ' ' << crack.path;
        EXPECT_EQ(TT, added.at_output.value) << i << ' ' << crack.path;
      }
}

TEST(RandomDrives, IdentityOrderOfTheCracksDoesNotMatter) {
  for (std::size_t i = 0; i < drives().size(); ++i) {
    GearSet reversed = drives()[i];
    if (reversed.wave_generator) std::ranges::reverse(reversed.wave_generator->crack);
    if (reversed.flexspline) std::ranges::reverse(reversed.flexspline->crack);
    if (reversed.output_shaft) std::ranges::reverse(reversed.output_shaft->crack);
    const StiffnessResult one = torsional_stiffness(drives()[i]);
    const StiffnessResult other = torsional_stiffness(reversed);
    EXPECT_NEAR(other.positive.stiffness.value / one.positive.stiffness.value, 1, 1e-14) << i;
    EXPECT_NEAR(other.negative.stiffness.value / one.negative.stiffness.value, 1, 1e-14) << i;
    EXPECT_EQ(one.usable(), other.usable()) << i;
  }
}

TEST(RandomDrives, IdentityAnotherCrackNeverStiffens) {
  for (std::size_t i = 0; i < drives().size(); ++i) {
    // Add cracks of the same member from other drives, as far as they fit.
    const GearSet& donor = drives()[(i + 1) % drives().size()];
    GearSet more = drives()[i];
    const auto take = [](auto& to, const auto& from) {
      if (to && from && !from->crack.empty()) to->crack.push_back(from->crack[0]);
    };
    take(more.wave_generator, donor.wave_generator);
    take(more.flexspline, donor.flexspline);
    take(more.output_shaft, donor.output_shaft);
    try {
      check(more);
    } catch (const InputError&) {
      continue;  // deeper than this wall
    }
    const StiffnessResult before = torsional_stiffness(drives()[i]);
    const StiffnessResult after = torsional_stiffness(more);
    EXPECT_LE(after.positive.stiffness.value, before.positive.stiffness.value) << i;
    EXPECT_LE(after.negative.stiffness.value, before.negative.stiffness.value) << i;
    EXPECT_EQ(after.intact.stiffness.value, before.intact.stiffness.value) << i;
  }
}

TEST(RandomDrives, IdentityADeeperCrackNeverStiffens) {
  for (std::size_t i = 0; i < drives().size(); ++i) {
    GearSet deeper = drives()[i];
    const auto grow = [](auto& member) {
      if (!member) return;
      for (auto& any : member->crack)
        std::visit(
            [](auto& crack) {
              if constexpr (requires { crack.depth; }) crack.depth *= 1.01;
              // Keep the length, because the ring may have no room for a longer crack.
              if constexpr (requires { crack.aspect_ratio; })
                crack.aspect_ratio = std::min(1.0, 1.01 * crack.aspect_ratio);
              if constexpr (requires { crack.half_length; }) crack.half_length *= 1.01;
            },
            any);
    };
    grow(deeper.wave_generator);
    grow(deeper.flexspline);
    grow(deeper.output_shaft);
    const StiffnessResult before = torsional_stiffness(drives()[i]);
    const StiffnessResult after = torsional_stiffness(deeper);
    EXPECT_LE(after.positive.stiffness_change.value, before.positive.stiffness_change.value) << i;
    EXPECT_LE(after.negative.stiffness_change.value, before.negative.stiffness_change.value) << i;
  }
}

TEST(RandomDrives, ScalingBySimilarity) {
  // All lengths are multiplied by s at constant stress: forces scale with s^2, torque and stiffness
  // with s^3.  This tests all relations between lengths at once, including forgotten ones.
  constexpr double s = 1.7;
  for (std::size_t i = 0; i < drives().size(); ++i) {
    GearSet scaled = drives()[i];
    for_each_number(scaled, [&](const FieldPath&, const Field& field, double& value) {
      if (field.unit == "m" || field.unit == "N/m") value *= s;
      if (field.unit == "N") value *= s * s;
      if (field.unit == "N*m") value *= s * s * s;
    });
    const StiffnessResult one = torsional_stiffness(drives()[i]);
    const StiffnessResult other = torsional_stiffness(scaled);
    // The tolerance is rounding, because the quadrature takes the same steps.
    const double tolerance = 1e-12;
    for (const auto drive : {&StiffnessResult::positive, &StiffnessResult::negative}) {
      EXPECT_NEAR((other.*drive).stiffness.value / (one.*drive).stiffness.value / (s * s * s), 1,
                  tolerance)
          << i;
      EXPECT_NEAR((other.*drive).wind_up.value / (one.*drive).wind_up.value, 1, tolerance) << i;
      EXPECT_NEAR((other.*drive).stiffness_change.value, (one.*drive).stiffness_change.value,
                  1e-11 * std::abs((one.*drive).stiffness_change.value))
          << i;
    }
    ASSERT_EQ(one.cracks.size(), other.cracks.size());
    for (std::size_t n = 0; n < one.cracks.size(); ++n) {
      EXPECT_EQ(one.cracks[n].opens_under, other.cracks[n].opens_under) << i;
      const StressIntensities K = one.cracks[n].largest.value();
      const StressIntensities K_scaled = other.cracks[n].largest.value();
      for (const auto mode :
           {&StressIntensities::K_I, &StressIntensities::K_II, &StressIntensities::K_III})
        EXPECT_NEAR(
            (K_scaled.*mode).value, (K.*mode).value * std::sqrt(s),
            1e-11 * (std::abs(K.K_I.value) + std::abs(K.K_II.value) + std::abs(K.K_III.value)))
            << i;
    }
  }
}

TEST(RandomDrives, IdentityTheSignOfTheGivenTorqueDoesNotMatter) {
  // Both senses are computed for either sign of the given torque.
  for (std::size_t i = 0; i < drives().size(); ++i) {
    GearSet other_sense = drives()[i];
    other_sense.load.torque *= -1;
    const StiffnessResult one = torsional_stiffness(drives()[i]);
    const StiffnessResult other = torsional_stiffness(other_sense);
    EXPECT_EQ(one.positive.stiffness.value, other.positive.stiffness.value) << i;
    EXPECT_EQ(one.negative.stiffness.value, other.negative.stiffness.value) << i;
  }
}

TEST(RandomDrives, IdentityMirroredDriveMirrorsTheSenses) {
  // Reflection in a plane that contains the axis changes every beta to -beta and reverses the
  // torque.
  for (std::size_t i = 0; i < drives().size(); ++i) {
    GearSet mirrored = drives()[i];
    if (!mirrored.flexspline) continue;
    for (FlexsplineCrack& any : mirrored.flexspline->crack)
      std::visit(
          [](auto& crack) {
            if constexpr (requires { crack.angle; }) {
              if (crack.angle < 90 * deg) crack.angle *= -1;
            }
          },
          any);
    const StiffnessResult one = torsional_stiffness(drives()[i]);
    const StiffnessResult other = torsional_stiffness(mirrored);
    EXPECT_NEAR(one.positive.stiffness.value / other.negative.stiffness.value, 1, 1e-13) << i;
    EXPECT_NEAR(one.negative.stiffness.value / other.positive.stiffness.value, 1, 1e-13) << i;
  }
}

TEST(RandomDrives, IdentitySameInputSameBytes) {
  for (std::size_t i = 0; i < drives().size(); i += 10) {
    std::vector<double> first;
    std::vector<double> second;
    const auto collect = [&](std::vector<double>& values) {
      for_each_quantity(torsional_stiffness(drives()[i]),
                        [&](const std::string&, const Quantity& q) { values.push_back(q.value); });
    };
    collect(first);
    collect(second);
    EXPECT_EQ(first, second) << i;
  }
}

}  // namespace
}  // namespace strainwave
