# Script: writes OUTPUT, a table of the terms of the glossary GLOSSARY, from its rows
# "| term | meaning | symbol | unit |".  Symbols lose what only typesetting needs.
set(entries "")
# A list of CMake ends at a semicolon and may not break off inside brackets.
file(READ "${GLOSSARY}" text)
string(REPLACE ";" "<semicolon>" text "${text}")
string(REPLACE "[" "<left>" text "${text}")
string(REPLACE "]" "<right>" text "${text}")
string(REGEX MATCHALL "\n\\|[^|\n]*\\|[^|\n]*\\|[^|\n]*\\|[^|\n]*\\|" rows "${text}")
foreach(row IN LISTS rows)
  string(REGEX REPLACE "\n\\| *([^|]*[^ |]) *\\| *([^|]*[^ |]) *\\| *([^|]*[^ |]|) *\\| *([^|]*[^ |]|) *\\|"
    "\\1|\\2|\\3|\\4" cells "${row}")
  if(cells MATCHES "^(term\\|meaning|---)")
    continue()
  endif()
  string(REGEX REPLACE "\\\\text{([^}]*)}" "\\1" cells "${cells}")
  string(REGEX REPLACE "([A-Za-z])\\\\" "\\1 \\\\" cells "${cells}")
  string(REGEX REPLACE "[$\\`]" "" cells "${cells}")
  string(REPLACE "\\" "" cells "${cells}")
  string(REPLACE "varphi" "phi" cells "${cells}")
  string(REPLACE "<left>" "[" cells "${cells}")
  string(REPLACE "<right>" "]" cells "${cells}")
  string(REPLACE "<semicolon>" ";" cells "${cells}")
  string(REPLACE "|" ")x\", R\"x(" cells "${cells}")
  string(APPEND entries "    {R\"x(${cells})x\"},\n")
endforeach()
if(entries STREQUAL "")
  message(FATAL_ERROR "no term found in ${GLOSSARY}")
endif()
file(WRITE "${OUTPUT}" "// Made from the glossary by cmake/write_glossary.cmake.
#include \"strainwave/present/glossary.hpp\"

namespace strainwave {
namespace {

constexpr GlossaryTerm kTerms[] = {
${entries}};

}  // namespace

std::span<const GlossaryTerm> glossary() { return kTerms; }

}  // namespace strainwave
")
