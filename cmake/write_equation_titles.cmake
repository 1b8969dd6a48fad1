# Script: writes OUTPUT, a table of tag and title of every equation, from the headings
# "### (FR-2) Added compliance {#FR-2}" of the theory manual in MANUAL.
file(GLOB chapters "${MANUAL}/*.md")
list(SORT chapters)
set(entries "")
foreach(chapter IN LISTS chapters)
  file(READ "${chapter}" text)
  string(REGEX MATCHALL "\n### \\([A-Z]+-[0-9]+\\) [^\n{]*{#" headings "${text}")
  foreach(heading IN LISTS headings)
    string(REGEX REPLACE "\n### \\(([A-Z]+-[0-9]+)\\) ([^\n{]*[^ ]) *{#" "    {\"\\1\", R\"x(\\2)x\"},\n"
      entry "${heading}")
    string(APPEND entries "${entry}")
  endforeach()
endforeach()
if(entries STREQUAL "")
  message(FATAL_ERROR "no equation found in ${MANUAL}")
endif()
file(WRITE "${OUTPUT}" "// Made from docs/theory by cmake/write_equation_titles.cmake.
#include \"strainwave/present/equation_titles.hpp\"

namespace strainwave {
namespace {

constexpr EquationTitle kTitles[] = {
${entries}};

}  // namespace

std::span<const EquationTitle> equation_titles() { return kTitles; }

}  // namespace strainwave
")
