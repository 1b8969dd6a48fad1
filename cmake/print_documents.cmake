# Makes the program PROGRAM, called NAME, print the documents that are installed with it into FOLDER: man/man1
# gets a page for each command, man/man5 the page of the input file, and share/ the completions for shells and the
# schema of the input.
function(print file)
  execute_process(COMMAND "${PROGRAM}" ${ARGN} OUTPUT_FILE "${FOLDER}/${file}" COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}/man/man1" "${FOLDER}/man/man5" "${FOLDER}/share/strainwave" "${FOLDER}/share/bash-completion/completions"
  "${FOLDER}/share/zsh/site-functions" "${FOLDER}/share/fish/vendor_completions.d")
execute_process(COMMAND "${PROGRAM}" man --list OUTPUT_VARIABLE commands COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n]+" commands "${commands}")
print(man/man1/${NAME}.1 man)
foreach(command IN LISTS commands)
  print("man/man1/${NAME}-${command}.1" man "${command}")
endforeach()
print(man/man5/strainwave-drive.5 man strainwave-drive)
print(share/strainwave/strainwave-drive-1.schema.json schema)
print(share/bash-completion/completions/${NAME} completion bash)
print(share/zsh/site-functions/_${NAME} completion zsh)
print(share/fish/vendor_completions.d/${NAME}.fish completion fish)
file(TOUCH "${FOLDER}/done")
