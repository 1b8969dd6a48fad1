// SPDX-License-Identifier: Apache-2.0
#include "manual.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>

#include "strainwave/core/version.hpp"

namespace strainwave::cli {
namespace {

const std::array<CommandManual, 15> kCommands = {{
    {"stiffness", "Torsional stiffness of a drive, sound and cracked",
     "Reads a drive and its cracks and prints the compliance of each member at the output with the "
     "input locked, without and with its cracks, the stiffness K_HD for both senses of torque, "
     "what the cracks changed, the accuracy of each number, the validity notes and the equations "
     "of the theory manual. Where a material gives toughness and yield strength, also the strength "
     "of "
     "each crack at the given load: stress intensity against toughness, net section against yield, "
     "reserve and critical size by a failure assessment diagram (option 1 of BS 7910), which "
     "--plot "
     "draws and --fad tabulates; a crack that fractures is answered, with a warning. Three "
     "methods: as-printed evaluates every equation of the article, "
     "misprints included; repaired mends its outright errors; corrected is the one to use. The "
     "json format carries all digits, units, uncertainties and the input as it was understood.",
     "strainwave stiffness examples/article.toml --format json --output article.json"},
    {"audit", "The article's worked example, number by number",
     "Recomputes every number and equation of the article's worked example: the printed value, "
     "what its own printed equation gives with the printed inputs, what the corrected theory "
     "gives, and a verdict with one sentence; where one exists, also the input that would "
     "reproduce the printed number, found by root finding.",
     "strainwave audit --format json"},
    {"sweep", "All outputs over one or two fields",
     "Varies one or two fields of the input over a range and tabulates all outputs. A field is "
     "named by its path, such as output_shaft.crack[0].depth; the ends of the range carry units. "
     "The first field varies slowest. Points that a method refuses stay in the table with the "
     "reason.",
     "strainwave sweep examples/article.toml --vary 'output_shaft.crack[0].depth=0.05 mm..8 "
     "mm:60:log' --plot sweep.svg --output sweep.csv"},
    {"solve", "The value of a field that gives a wanted output",
     "Inverts the stiffness: the crack size that lowers it by one per cent, the wall that gives a "
     "wanted value. All solutions in the range are found by scanning it and refining each change "
     "of sign; without a range, three decades on either side of the present value are searched. "
     "It says so when there is none, and lists them when there are several.",
     "strainwave solve examples/article.toml --vary 'output_shaft.crack[0].depth' --target "
     "'cracked.positive.stiffness_change=-1 %'"},
    {"sensitivity", "What stiffness and its loss depend on, and how much",
     "Prints the elasticities of the stiffness K_HD, sound and cracked under both senses of "
     "torque, "
     "and of its loss by cracks, to every number of the file: per cent of output per per cent of "
     "input, exact by automatic differentiation of the corrected method, the largest first. Their "
     "sums must reproduce the dimensions of the outputs; if not, the answer is refused. With "
     "--scatter, the relative standard deviations that the file gives under [[scatter]] are "
     "propagated by first order and by Monte Carlo, with the share of each input; draws that "
     "break a rule of the input are counted.",
     "strainwave sensitivity examples/article_scatter.toml --scatter --plot tornado.svg"},
    {"torsion", "Torsion curve in the maker's numbers: K1, K2, K3",
     "Solves the drive as one system, elastic rings on one-sided balls and flanks, and prints the "
     "twist over the torque for both senses: K1, K2, K3 over the maker's torques, lost motion, "
     "hysteresis loop of the flank friction, tangent stiffness and what each member has of it, "
     "forces and contacts. The file must give bearing, flexspline by sections and mesh. Ranges in "
     "the file are drawn from and give a band. With --compare, the same without the cracks, and "
     "the changes over a turn of the wave generator.",
     "strainwave torsion examples/catalogue_size25.toml --plot torsion.svg"},
    {"material", "The material library: steels with sources",
     "Lists the steels that are built in, or shows all that is known of one: elastic constants, "
     "strength, toughness, fatigue limit, growth constants and threshold, each with unit, source, "
     "confidence and scatter. A member of a drive may name one of them in place of a table of the "
     "input file. What nobody has published is not there; what could not be confirmed is called "
     "unverified.",
     "strainwave material show '17-4PH H900'"},
    {"catalogue", "What makers state: K1, K2, K3 and torques",
     "Prints the stiffness tables of the makers' catalogues, 35 rows of size and ratio, and 36 "
     "rows "
     "of ratings, each with its source. A ratio selects the class of the stiffness table, which "
     "has 30, 50, and 80 and more in one, and the very ratio of the ratings.",
     "strainwave catalogue --size 25 --ratio 100"},
    {"validate", "The torsion curve against the makers' tables",
     "Predicts every row of the stiffness tables and compares. Mode geometry fits nothing: every "
     "drive has the typical proportions. Mode leave-one-size-out fits up to three factors to all "
     "other sizes and predicts the one left out. Mode per-row fits up to three factors to each "
     "row and shows what the model can follow, not what it predicts. With --draws, the "
     "proportions are drawn between their limits: the band that a drive of unknown geometry has.",
     "strainwave validate --mode geometry --draws 200 --plot validation.svg"},
    {"calibrate", "Factors of a drive from its catalogue or measured stiffness",
     "Fits named factors of a drive, by least squares of the logarithm of stiffness, to the "
     "catalogue's K1, K2, K3 of the nearest size and ratio, or to a measured curve with the "
     "columns torque and twist. Prints each factor with its uncertainty, which combinations of "
     "them the values identify, and refuses to call one identified that is uncertain by more "
     "than half. A factor changes fields of the drive; the calibrated drive is written as a new "
     "input file.",
     "strainwave calibrate examples/catalogue_size25.toml --catalogue --output calibrated.toml"},
    {"sif", "Stress intensity library: list, show, eval, plot",
     "Solutions for cracks in plates, tubes, round bars and stress gradients, each with its modes, "
     "validity range, accuracy and source. list names them; show prints what one says about "
     "itself; eval gives geometry factors, stress intensities under the loads that are set, the "
     "added compliance matrix, and says what is outside the validity range; plot draws the "
     "geometry factors over the crack size and along the front. Fields and loads are set by name, "
     "with units; a field left out takes the value that show prints.",
     "strainwave sif eval plate-surface --set 'depth=1 mm' --set 'half_length=2 mm' --set "
     "'tension=200 MPa'"},
    {"report", "Report on a drive as one HTML file",
     "Writes what an engineer attaches to a decision: a verdict, the drive drawn to scale in "
     "section with its cracks, the inputs and who gave each, compliance and stiffness sound and "
     "cracked, the shares of members and cracks, the torsion curve where the geometry is "
     "complete, stress intensities against toughness, validity notes, accuracies, the equations "
     "used, and the provenance with the input word for word. The file stands alone: no script and "
     "nothing from a network; it is made for light, dark and narrow screens and for A4 paper. The "
     "same input gives the same bytes. A result that may not be used is reported too, with the "
     "reason on top.",
     "strainwave report examples/cracked_size25.toml -o report.html"},
    {"fe", "Finite elements of shaft and cup, without any closed form",
     "Starts strainwave-fe, a program of its own that is built on request, and passes everything "
     "on to it: strainwave fe --help prints its options. It calculates an output shaft with "
     "annular cracks, cracks of the flexspline's wall and a sound flexspline by sections, "
     "with the evidence whether the answer may be used. strainwave fe tabulate makes a table of "
     "many runs, which a crack can name as its compliance_table; strainwave fe "
     "render draws pictures of the strain energy and of the opened crack.",
     "strainwave fe examples/solid_shaft.toml --member output-shaft"},
    {"new", "Print a commented starting file",
     "Prints an input file that is valid as it stands, with every field that there is and its "
     "meaning; those that are not needed are commented out. With --size and --ratio, the typical "
     "drive of that size of the makers' catalogues instead: every number with what is known of "
     "it, its limits and where they come from, and ranges for the torsion curve.",
     "strainwave new --size 25 --ratio 100 --output drive.toml"},
    {"schema", "Print the JSON Schema of the input",
     "Prints the schema (draft 2020-12) of the input file, which editors use to complete and "
     "check it; or the reference of all fields as Markdown.",
     "strainwave schema --output strainwave-drive-1.schema.json"},
}};

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n'))
      result += fmt::format("\\&{}", c);
    else
      result += c;
  }
  return result;
}

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

std::string head(std::string_view page, std::string_view summary) {
  return fmt::format(".TH {} 1 \"\" \"strainwave {}\" \"strainwave manual\"\n.SH NAME\n{} \\- {}\n",
                     upper(std::string(page)), version(), escaped(page), escaped(summary));
}

/// "--method TEXT", as the synopsis and the list of options show it.
std::string usage(const CLI::Option& option) {
  if (option.get_positional()) return fmt::format("\\fI{}\\fR", escaped(option.get_name()));
  const std::string name = escaped("--" + option.get_lnames().front());
  if (option.get_items_expected() == 0) return fmt::format("\\fB{}\\fR", name);
  std::string type = option.get_type_name();
  type.erase(std::min(type.find(':'), type.size()));  // without the list of choices
  return fmt::format("\\fB{}\\fR \\fI{}\\fR", name, escaped(type));
}

struct Options {
  std::string synopsis;
  std::string list;
};

/// The options of a command, without those of commands below it.
Options options_of(const CLI::App& command) {
  Options result;
  for (const CLI::Option* const option : command.get_options()) {
    if (option == command.get_help_ptr()) continue;
    const std::string text = usage(*option);
    result.synopsis += option->get_required() ? " " + text : " [" + text + "]";
    std::string description = option->get_description();
    if (!option->get_default_str().empty())
      description += fmt::format("; default {}", option->get_default_str());
    result.list += fmt::format(".TP\n{}\n{}\n", text, escaped(description));
  }
  return result;
}

std::string exit_status() {
  return ".SH EXIT STATUS\n"
         ".TP\n0\nan answer was printed\n"
         ".TP\n2\nthe command line is wrong\n"
         ".TP\n3\nthe input breaks a rule; the message names file, line, field, value and rule\n"
         ".TP\n4\nthere is no answer, or none that may be used; the message says why\n"
         ".TP\n70\ninternal error, or the output cannot be written\n";
}

}  // namespace

const CommandManual& manual_of(std::string_view command) {
  const auto* const found = std::ranges::find(kCommands, command, &CommandManual::name);
  if (found == kCommands.end()) throw std::out_of_range("no manual for " + std::string(command));
  return *found;
}

std::string program_page(const CLI::App& app) {
  std::string page = head("strainwave", app.get_description());
  page += ".SH SYNOPSIS\n\\fBstrainwave\\fR \\fICOMMAND\\fR [\\fIOPTION\\fR ...]\n.SH COMMANDS\n";
  for (const CommandManual& command : kCommands)
    page += fmt::format(".TP\n\\fBstrainwave {}\\fR\n{}\n", command.name, escaped(command.summary));
  page +=
      ".SH OPTIONS\n.TP\n\\fB\\-\\-help\\fR\nprint help, also of a command\n"
      ".TP\n\\fB\\-\\-version\\fR\nprint version and revision\n";
  page += exit_status();
  page += ".SH SEE ALSO\n";
  for (const CommandManual& command : kCommands)
    page += fmt::format(".BR strainwave\\-{} (1){}\n", command.name,
                        command.name == kCommands.back().name ? "" : ",");
  return page;
}

std::string command_page(const CLI::App& command) {
  const CommandManual& manual = manual_of(command.get_name());
  std::string page = head("strainwave-" + manual.name, manual.summary);
  const auto parts = command.get_subcommands([](const CLI::App*) { return true; });
  const Options own = options_of(command);
  std::string list = own.list;
  page += ".SH SYNOPSIS\n";
  if (parts.empty()) page += fmt::format("\\fBstrainwave {}\\fR{}\n", manual.name, own.synopsis);
  for (const CLI::App* const part : parts) {
    const Options options = options_of(*part);
    page += fmt::format("{}\\fBstrainwave {} {}\\fR{}\n", part == parts.front() ? "" : ".br\n",
                        manual.name, part->get_name(), options.synopsis);
    list += fmt::format(".SS {}\n{}\n{}", part->get_name(), escaped(part->get_description()),
                        options.list);
  }
  page += ".SH DESCRIPTION\n" + escaped(manual.description) + "\n";
  page += ".SH OPTIONS\n" + list + exit_status();
  page += ".SH EXAMPLE\n.nf\n" + escaped(manual.example) + "\n.fi\n";
  page += ".SH SEE ALSO\n.BR strainwave (1)\n";
  return page;
}

}  // namespace strainwave::cli
