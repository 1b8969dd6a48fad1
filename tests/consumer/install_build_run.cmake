# This script installs BUILD into a fresh prefix, builds this folder against it, and runs it on
# INPUT.
set(work "${BUILD}/consumer")
file(REMOVE_RECURSE "${work}")

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${work}/prefix")
run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}" -B "${work}/build" -G "${GENERATOR}"
  "-DCMAKE_BUILD_TYPE=${CONFIG}" "-DCMAKE_CXX_COMPILER=${COMPILER}"
  "-DCMAKE_PREFIX_PATH=${work}/prefix")
run("${CMAKE_COMMAND}" --build "${work}/build")
run("${work}/build/consumer" "${INPUT}")
execute_process(COMMAND "${work}/build/consumer" RESULT_VARIABLE status ERROR_VARIABLE said)
if(NOT status EQUAL 2 OR NOT said MATCHES "usage: ")
  message(FATAL_ERROR "without an argument the consumer ends with ${status}: ${said}")
endif()
foreach(file IN ITEMS doc/strainwave/LICENSE doc/strainwave/README.md doc/strainwave/docs/guide/input_file.md
    doc/strainwave/docs/theory/ST.md doc/strainwave/examples/article.toml man/man1/strainwave-stiffness.1
    bash-completion/completions/strainwave zsh/site-functions/_strainwave
    fish/vendor_completions.d/strainwave.fish strainwave/strainwave-drive-1.schema.json)
  if(NOT EXISTS "${work}/prefix/share/${file}")
    message(FATAL_ERROR "share/${file} is not installed")
  endif()
endforeach()
run("${work}/build/consumer_in_c")
run("${work}/prefix/bin/strainwave" stiffness "${INPUT}")
