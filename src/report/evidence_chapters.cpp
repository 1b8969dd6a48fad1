// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "chapters.hpp"
#include "html.hpp"
#include "markup.hpp"
#include "strainwave/core/sha256.hpp"
#include "strainwave/core/shown_text.hpp"
#include "strainwave/present/equation_titles.hpp"

namespace strainwave::report {
namespace {

/// A text that leads to a page of the documentation, if its address is known.
std::string linked(const Draft& draft, std::string_view page, std::string_view text) {
  if (draft.options.site.empty()) return escaped(text);
  const std::string_view slash = draft.options.site.ends_with('/') ? "" : "/";
  return fmt::format("<a href=\"{0}{1}{2}#{3}\">{3}</a>", escaped(draft.options.site), slash, page,
                     escaped(text));
}

std::string note_item(const Draft& draft, const Note& note) {
  std::string text =
      note.path.empty() ? std::string() : fmt::format("<code>{}</code>: ", escaped(note.path));
  text += escaped(note.text);
  if (!note.equation.empty())
    text += std::ranges::find(draft.equations, note.equation) != draft.equations.end()
                ? fmt::format(" (<a href=\"#{0}\">{0}</a>)", escaped(note.equation))
                : fmt::format(" ({})", escaped(note.equation));
  if (!note.next_step.empty()) text += " " + escaped(note.next_step);
  if (!draft.options.site.empty())
    text += fmt::format(" [{}]", linked(draft, "notes.html", note.code));
  return fmt::format("<li data-code=\"{}\">{}</li>\n", escaped(note.code), text);
}

struct NoteGroup {
  Severity severity;
  std::string_view title;
  std::string_view style;
};
constexpr std::array kNoteGroups = {NoteGroup{Severity::critical, "Critical", "critical"},
                                    NoteGroup{Severity::cannot_tell, "Cannot be told", "open"},
                                    NoteGroup{Severity::care, "Take with care", "care"},
                                    NoteGroup{Severity::information, "For information", "info"}};

}  // namespace

ReportSection notes_chapter(const Draft& draft) {
  std::string html;
  for (const NoteGroup& group : kNoteGroups) {
    std::string items;
    for (const Note& note : draft.notes)
      if (note.severity == group.severity) items += note_item(draft, note);
    if (!items.empty())
      html += fmt::format("<h3>{}</h3>\n<ul class=\"notes {}\">\n{}</ul>\n", group.title,
                          group.style, items);
  }
  if (html.empty()) html = paragraph("There are no notes.");
  return {"notes", "Validity notes", html};
}

ReportSection accuracy_chapter(const Draft& draft) {
  if (draft.result.accuracies.empty())
    return {
        "accuracy", "Accuracy of the models",
        paragraph("This method states no accuracy, because it repeats the formulas as printed.")};
  std::vector<Row> rows;
  for (const AccuracyBasis& basis : draft.result.accuracies)
    rows.push_back({{fmt::format("<code>{}</code>", escaped(basis.path)),
                     percent(basis.relative_uncertainty), escaped(basis.source)},
                    {}});
  return {"accuracy", "Accuracy of the models",
          paragraph("One standard relative uncertainty of the model's form, as it enters the "
                    "compliance. The uncertainty of the inputs is not included.") +
              table("Basis of the accuracies", {"of", "uncertainty", "basis"}, {{"", rows}},
                    {.style = "evidence", .numbers = 99})};
}

ReportSection equations_chapter(const Draft& draft) {
  std::string items;
  for (const EquationTitle& equation : equation_titles()) {
    if (std::ranges::find(draft.equations, equation.tag) == draft.equations.end()) continue;
    items += fmt::format("<li id=\"{}\"><b>{}</b> {}</li>\n", equation.tag,
                         linked(draft, "docs/theory/manual.html", equation.tag),
                         escaped(equation.title));
  }
  return {
      "equations", "Equations used",
      paragraph("Tags and titles of the theory manual of this version, which derives or cites each "
                "equation.") +
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
