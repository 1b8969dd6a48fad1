// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "chapters.hpp"
#include "equation_titles.hpp"
#include "html.hpp"
#include "markup.hpp"
#include "strainwave/core/sha256.hpp"

namespace strainwave::report {
namespace {

struct Weight {
  std::string_view code;
  Severity severity;
};
/// Codes that are more than an assumption.  A code that is not here, and is not known to be one
/// below, counts as outside: a new note is not played down before somebody has read it.
constexpr std::array kWeights = {Weight{"strength.breaks", Severity::critical},
                                 Weight{"article.negative_compliance", Severity::critical},
                                 Weight{"article.ignored", Severity::left_out},
                                 Weight{"article.not_read", Severity::left_out},
                                 Weight{"article.axial_force", Severity::left_out},
                                 Weight{"article.no_closure", Severity::left_out},
                                 Weight{"crack.closed", Severity::left_out},
                                 Weight{"crack.contact_path", Severity::left_out},
                                 Weight{"curve.none", Severity::left_out},
                                 Weight{"flexspline.dynamic_load", Severity::left_out},
                                 Weight{"flexspline.ovalisation", Severity::left_out},
                                 Weight{"hysteresis.no_load", Severity::left_out},
                                 Weight{"member.absent", Severity::left_out},
                                 Weight{"strength.scope", Severity::left_out},
                                 Weight{"torsion.rigid_spline", Severity::left_out},
                                 Weight{"wave_generator.held_ring", Severity::left_out},
                                 Weight{"wave_generator.shaft_bending", Severity::left_out},
                                 Weight{"article.accuracy", Severity::assumption},
                                 Weight{"article.factor_squared", Severity::assumption},
                                 Weight{"crack.axial_coupling", Severity::assumption},
                                 Weight{"crack.contact_edge", Severity::assumption},
                                 Weight{"crack.flat_plate", Severity::assumption},
                                 Weight{"crack.ring_bending", Severity::assumption},
                                 Weight{"crack.superposed", Severity::assumption},
                                 Weight{"crack.surface_shear", Severity::assumption},
                                 Weight{"crack.under_a_ball", Severity::assumption},
                                 Weight{"rating.convention", Severity::assumption},
                                 Weight{"torsion.interference", Severity::assumption},
                                 Weight{"wave_generator.crack_under_lobe", Severity::assumption},
                                 Weight{"wave_generator.hertz", Severity::assumption}};

std::string note_item(const Draft& draft, const Note& note) {
  std::string text =
      note.path.empty() ? std::string() : fmt::format("<code>{}</code>: ", escaped(note.path));
  text += escaped(note.text);
  if (!note.equation.empty())
    text += std::ranges::find(draft.equations, note.equation) != draft.equations.end()
                ? fmt::format(" (<a href=\"#{0}\">{0}</a>)", escaped(note.equation))
                : fmt::format(" ({})", escaped(note.equation));
  return fmt::format("<li data-code=\"{}\">{}</li>\n", escaped(note.code), text);
}

}  // namespace

Severity severity_of(const Note& note) {
  if (note.code == "material.library")
    return note.text.find("unverified") == std::string::npos ? Severity::assumption
                                                             : Severity::outside;
  const auto* const found = std::ranges::find(kWeights, note.code, &Weight::code);
  return found == kWeights.end() ? Severity::outside : found->severity;
}

std::string_view severity_title(Severity severity) {
  switch (severity) {
    case Severity::critical:
      return "Critical";
    case Severity::outside:
      return "Doubtful, or outside a range";
    case Severity::left_out:
      return "Left out";
    case Severity::assumption:
      return "Assumed by the models";
  }
  return {};
}

ReportSection notes_chapter(const Draft& draft) {
  std::string html;
  for (const Severity severity :
       {Severity::critical, Severity::outside, Severity::left_out, Severity::assumption}) {
    std::string items;
    for (const Note& note : draft.notes)
      if (severity_of(note) == severity) items += note_item(draft, note);
    if (!items.empty())
      html += fmt::format("<h3>{}</h3>\n<ul class=\"notes s{}\">\n{}</ul>\n",
                          severity_title(severity), static_cast<int>(severity), items);
  }
  if (html.empty()) html = paragraph("There is nothing to remark.");
  return {"notes", "Validity notes", html};
}

ReportSection accuracy_chapter(const Draft& draft) {
  if (draft.result.accuracies.empty())
    return {"accuracy", "Accuracy of the models",
            paragraph("This method states no accuracy: its formulas are repeated as they are.")};
  std::vector<Row> rows;
  for (const AccuracyBasis& basis : draft.result.accuracies)
    rows.push_back({{fmt::format("<code>{}</code>", escaped(basis.path)),
                     percent(basis.relative_uncertainty), escaped(basis.source)},
                    {}});
  return {"accuracy", "Accuracy of the models",
          paragraph("One standard relative uncertainty of the model's form, as it enters the "
                    "compliance. What is not known of the inputs is not in it.") +
              table("What the accuracies rest on", {"of", "uncertainty", "what it rests on"},
                    {{"", rows}}, {.style = "evidence", .numbers = 99})};
}

ReportSection equations_chapter(const Draft& draft) {
  std::string items;
  for (const EquationTitle& equation : equation_titles()) {
    if (std::ranges::find(draft.equations, equation.tag) == draft.equations.end()) continue;
    items +=
        fmt::format("<li id=\"{0}\"><b>{0}</b> {1}</li>\n", equation.tag, escaped(equation.title));
  }
  return {"equations", "Equations used",
          paragraph("Tags and titles of the theory manual of this version, where each is derived "
                    "or cited.") +
              fmt::format("<ul class=\"equations\">\n{}</ul>\n", items)};
}

ReportSection provenance_chapter(const Draft& draft) {
  const Provenance& p = draft.provenance;
  std::string list;
  const auto add = [&](std::string_view name, std::string_view value) {
    list += fmt::format("<dt>{}</dt><dd>{}</dd>\n", name, escaped(value));
  };
  add("Program", fmt::format("strainwave {} ({})", p.version, p.revision));
  add("Method", enum_name(draft.result.method));
  if (!draft.options.date.empty()) add("Date", draft.options.date);
  add("Input file", p.input_file);
  add("SHA-256 of the input", sha256_hex(draft.input_text));
  add("Size of the input", fmt::format("{} bytes", draft.input_text.size()));
  add("Crack integrals",
      fmt::format("relative tolerance {}", typeset(fmt::format("{:g}", p.quadrature_tolerance))));
  add("Torsion curve",
      fmt::format("{} positions over a turn where cracks move, {} draws of the ranges",
                  draft.options.angles, draft.options.draws));
  return {"provenance", "Provenance",
          paragraph("The same input, version and options give this report again, byte by byte.") +
              fmt::format("<dl>\n{}</dl>\n<details open=\"open\">\n<summary>The input file, word "
                          "for word</summary>\n<pre>{}</pre>\n</details>\n",
                          list, escaped(draft.input_text))};
}

}  // namespace strainwave::report
