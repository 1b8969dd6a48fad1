# Script: writes OUTPUT from INPUT; does not touch the file when nothing changed.
# A release archive unpacked inside somebody's own git tree must not report that tree's revision,
# hence the look for .git in SOURCE_DIR itself.
set(STRAINWAVE_GIT_REVISION "unknown")
find_program(GIT git)
if(GIT AND EXISTS "${SOURCE_DIR}/.git")
  execute_process(
    COMMAND "${GIT}" --no-optional-locks describe --always --dirty
    WORKING_DIRECTORY "${SOURCE_DIR}"
    RESULT_VARIABLE failed OUTPUT_VARIABLE described ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT failed)
    set(STRAINWAVE_GIT_REVISION "${described}")
  endif()
endif()
configure_file("${INPUT}" "${OUTPUT}" @ONLY)
