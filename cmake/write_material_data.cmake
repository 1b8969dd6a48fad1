# Script: writes OUTPUT from INPUT with the text of DATA in it.
file(READ "${DATA}" MATERIALS)
file(READ "${INPUT}" template)
string(CONFIGURE "${template}" source @ONLY)
file(WRITE "${OUTPUT}" "${source}")
