// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "strainwave/model/result/evidence.hpp"
#include "strainwave/sif/evaluation.hpp"

/// @file
/// The stress intensity library in its own words.

namespace strainwave {

namespace sif {
/// What is outside of the range of a solution, and whether the crack runs.
[[nodiscard]] ResultEvidence evidence_of(const Evaluation& evaluation);
}  // namespace sif

/// A field of a solution, as `sif show` tells it.
struct SolutionField {
  std::string_view name;
  std::string_view unit;
  std::string_view meaning;
  std::string rule;
  std::string_view example;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"name", "", "name of the field"}, &SolutionField::name);
    field({"unit", "", "SI unit"}, &SolutionField::unit);
    field({"meaning", "", "what it is"}, &SolutionField::meaning);
    field({"rule", "", "values that it may have"}, &SolutionField::rule);
    field({"example", "", "value taken when it is left out"}, &SolutionField::example);
  }
};

/// A solution of the library in its own words.
struct DescribedSolution {
  const sif::Row* row = nullptr;

  [[nodiscard]] std::vector<SolutionField> fields() const;
  /// The limits of the validity range.
  [[nodiscard]] std::vector<std::string_view> validity() const;
  /// The rules between fields; what breaks one is refused.
  [[nodiscard]] std::vector<std::string_view> rules() const;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using S = DescribedSolution;
    sif::SolutionInfo::describe([&](const Field& what, auto member) {
      field(what, [member](const S& s) { return std::invoke(member, s.row->info); });
    });
    field({"fields", "", "of the crack"}, &S::fields);
    field({"loads", "", "that the solution takes"}, [](const S& s) { return s.row->loads; });
    field({"points", "", "named points of the front"}, [](const S& s) { return s.row->points; });
    field({"validity", "", "limits of the range in which the accuracy holds"}, &S::validity);
    field({"rules", "", "between fields; what breaks one is refused"}, &S::rules);
  }
};

/// Solutions of the library.
struct SolutionList {
  std::vector<DescribedSolution> solutions;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"solutions", "", "each solution in its own words"}, &SolutionList::solutions);
  }
};

/// The solutions of a family; of all if it is empty.
/// @throws InputError  there is no such family
[[nodiscard]] SolutionList sif_list(std::string_view family);

/// Reads "depth=2 mm" or "tension=100 MPa" for a solution.
/// @throws InputError  unknown name, or a quantity of another dimension
[[nodiscard]] sif::Assignments sif_assignments(const sif::Row& row,
                                               std::span<const std::string> texts);

}  // namespace strainwave
