# Script: writes OUTPUT, a table of code and text of every note, from the sources in SOURCES, which
# make notes as {.code = "x.y", .text = "...", ...}, {"x.y", "...", ...} or upper_bound("x.y", "...").  A text is the
# literal in the source, with {} in place of values; it is empty if the source has no literal.
# A list of CMake ends at a semicolon and may not break off inside brackets.
set(marks ";" "<semicolon>" "[" "<left>" "]" "<right>")
set(entries "")
file(GLOB_RECURSE sources "${SOURCES}/*.cpp" "${SOURCES}/*.hpp")
list(SORT sources)
set(code "\"[a-z_]+\\.[a-z_]+\"")
set(literals "(\"([^\"\\]|\\\\.)*\"[ \n]*)+")
set(made "(\\.code =[ \n]*|_back\\([ \n]*{|upper_bound\\([ \n]*)")
foreach(source IN LISTS sources)
  file(READ "${source}" text)
  string(REPLACE ";" "<semicolon>" text "${text}")
  string(REPLACE "[" "<left>" text "${text}")
  string(REPLACE "]" "<right>" text "${text}")
  string(REGEX MATCHALL "\\.code = [a-z]+ \\? ${code} : ${code}" either "${text}")
  string(REGEX MATCHALL "${code}" either "${either}")
  foreach(name IN LISTS either)
    string(APPEND entries "    {${name}, \"\"},\n")
  endforeach()
  string(REGEX MATCHALL
    "${made}${code}(,[ \n]*(\\.text =[ \n]*)?(fmt::format\\([ \n]*)?${literals})?" notes "${text}")
  foreach(note IN LISTS notes)
    string(REGEX MATCH "${code}" name "${note}")
    string(REGEX REPLACE "^[^\"]*${code}[^\"]*" "" said "${note}")
    string(REPLACE "<left>" "[" said "${said}")
    string(REPLACE "<right>" "]" said "${said}")
    string(REPLACE "<semicolon>" ";" said "${said}")
    if(said STREQUAL "")
      set(said "\"\"")
    endif()
    string(APPEND entries "    {${name}, ${said}},\n")
  endforeach()
endforeach()
if(entries STREQUAL "")
  message(FATAL_ERROR "no note found in ${SOURCES}")
endif()
set(content "// Made from src by cmake/write_note_texts.cmake.
#include \"strainwave/present/note_texts.hpp\"

namespace strainwave {
namespace {

constexpr NoteText kNotes[] = {
${entries}};

}  // namespace

std::span<const NoteText> note_texts() { return kNotes; }

}  // namespace strainwave
")
# An unchanged table is not written again: most changes of a source change no note.
if(EXISTS "${OUTPUT}")
  file(READ "${OUTPUT}" before)
endif()
if(NOT "${before}" STREQUAL "${content}")
  file(WRITE "${OUTPUT}" "${content}")
endif()
