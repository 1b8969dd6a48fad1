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
/// Descriptions of the solutions in the stress intensity library.

namespace strainwave {

namespace sif {
/// Notes on quantities outside the range of a solution, and on fracture of the crack.
[[nodiscard]] ResultEvidence evidence_of(const Evaluation& evaluation);
}  // namespace sif

/// A field of a solution, as `sif show` presents it.
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
    field({"meaning", "", "meaning of the field"}, &SolutionField::meaning);
    field({"rule", "", "allowed values"}, &SolutionField::rule);
    field({"example", "", "value used if the field is left out"}, &SolutionField::example);
  }
};

/// The description of one solution of the library.
struct DescribedSolution {
  const sif::Row* row = nullptr;  ///< the solution in the library; not null

  /// The fields of the solution, in the order of the library.
  [[nodiscard]] std::vector<SolutionField> fields() const;
  /// Limits of the validity range.
  [[nodiscard]] std::vector<std::string_view> validity() const;
  /// Rules between fields; input that breaks a rule is refused.
  [[nodiscard]] std::vector<std::string_view> rules() const;

  template <class Visitor>
  static void describe(Visitor&& field) {
    using S = DescribedSolution;
    sif::SolutionInfo::describe([&](const Field& what, auto member) {
      field(what, [member](const S& s) { return std::invoke(member, s.row->info); });
    });
    field({"fields", "", "fields of the crack"}, &S::fields);
    field({"loads", "", "loads that the solution takes"}, [](const S& s) { return s.row->loads; });
    field({"points", "", "named points of the front"}, [](const S& s) { return s.row->points; });
    field({"validity", "", "limits of the range in which the accuracy holds"}, &S::validity);
    field({"rules", "", "rules between fields; input that breaks a rule is refused"}, &S::rules);
  }
};

/// Solutions of the library.
struct SolutionList {
  std::vector<DescribedSolution> solutions;

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"solutions", "", "description of each solution"}, &SolutionList::solutions);
  }
};

/// The solutions of a family, or all solutions if the name is empty.
/// @throws InputError  if the family does not exist
[[nodiscard]] SolutionList sif_list(std::string_view family);

/// Reads "depth=2 mm" or "tension=100 MPa" for a solution.
/// @throws InputError  if the name is unknown, or the quantity has another dimension
[[nodiscard]] sif::Assignments sif_assignments(const sif::Row& row,
                                               std::span<const std::string> texts);

}  // namespace strainwave
