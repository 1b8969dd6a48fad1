// SPDX-License-Identifier: Apache-2.0
#include "strainwave/study/table_evidence.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace strainwave {
namespace {

/// The bound that the note on an error states, and its severity.
void expect_bound(double error, const std::string& bound, Severity severity) {
  const Note note = note_of(TableEvidence{.cracks = 2, .points = 100, .largest_error = error});
  EXPECT_NE(note.text.find("by less than " + bound + " of their value"), std::string::npos)
      << error << ": " << note.text;
  EXPECT_EQ(note.severity, severity) << error;
  EXPECT_EQ(note.equation, "ST-22");
}

// Kind: behaviour (ST-22).  Source: the powers of ten, typed.
TEST(TableEvidence, BehaviourTheNoteStatesTheNextPowerOfTen) {
  expect_bound(0.0, "1e-14", Severity::information);
  expect_bound(3e-13, "1e-12", Severity::information);
  expect_bound(1e-14, "1e-13", Severity::information);  // the error is less than the bound
  expect_bound(1e-10, "1e-09", Severity::information);
  expect_bound(1.005e-10, "1e-09", Severity::care);  // more than what tables promise
  expect_bound(3e-7, "1e-06", Severity::care);
  expect_bound(5.0, "1e+01", Severity::care);
  expect_bound(std::numeric_limits<double>::infinity(), "inf", Severity::care);
}

// Kind: behaviour.
TEST(TableEvidence, BehaviourOneCrackIsNoPlural) {
  EXPECT_NE(note_of(TableEvidence{.cracks = 1, .points = 7}).text.find("of 1 crack are"),
            std::string::npos);
  EXPECT_NE(note_of(TableEvidence{.cracks = 2, .points = 7}).text.find("of 2 cracks are"),
            std::string::npos);
  EXPECT_NE(note_of(TableEvidence{.cracks = 2, .points = 7}).text.find("at 7 random drives"),
            std::string::npos);
}

}  // namespace
}  // namespace strainwave
