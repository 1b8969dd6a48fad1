// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/core/error.hpp"
#include "strainwave/model/result/stiffness_result.hpp"
#include "support/reference.hpp"

namespace strainwave::test {

/// Compares with a reference number within its tolerance.
inline void expect_reference(double actual, const Reference& reference) {
  EXPECT_NEAR(actual, reference.value, std::abs(reference.value) * reference.relative_tolerance)
      << "in " << reference.unit << "; " << reference.source
      << "; tolerance: " << reference.tolerance_is;
}

/// |actual/expected - 1| <= tolerance, for an expected value other than zero.
inline void expect_relative(double actual, double expected, double tolerance) {
  EXPECT_NEAR(actual, expected, std::abs(expected) * tolerance);
}

/// The message of the InputError that a call throws; "no error" if it throws none.
template <class F>
std::string broken_rule(const F& f) {
  try {
    (void)f();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// How many notes carry a code; `path` narrows the search.
inline long count_notes(const std::vector<Note>& notes, std::string_view code,
                        std::string_view path = "") {
  return std::ranges::count_if(notes, [&](const Note& note) {
    return note.code == code && (path.empty() || note.path == path);
  });
}

inline bool has_note(const StiffnessResult& result, std::string_view code,
                     std::string_view path = "") {
  return count_notes(result.notes, code, path) > 0;
}

/// The sorted codes of all notes of a result.
inline std::vector<std::string> note_codes(const std::vector<Note>& notes) {
  std::vector<std::string> codes;
  for (const Note& note : notes) codes.push_back(note.code);
  std::ranges::sort(codes);
  return codes;
}

inline bool uses_equation(const std::vector<std::string>& equations, std::string_view tag) {
  return std::ranges::find(equations, tag) != equations.end();
}

}  // namespace strainwave::test
