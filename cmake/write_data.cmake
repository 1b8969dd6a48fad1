# Script: writes OUTPUT from INPUT with the text of DATA in it, whole as DATA_TEXT, and as DATA_LINES
# in one raw string for each line, because compilers need not take a string of any length.
file(READ "${DATA}" DATA_TEXT)
string(REPLACE "\n" "\n)DATA\",\n    R\"DATA(" DATA_LINES "${DATA_TEXT}")
file(READ "${INPUT}" template)
string(CONFIGURE "${template}" source @ONLY)
file(WRITE "${OUTPUT}" "${source}")
