# strainwave_module(<name> SOURCES ... [DEPENDS <module>...] [NOT_INSTALLED])
# Library target strainwave::<name>, from src/<name>/ and include/strainwave/<name>/.  The module
# finds only its own private headers, even in sources that are written at build time.
function(strainwave_module name)
  cmake_parse_arguments(ARG "NOT_INSTALLED" "" "SOURCES;DEPENDS" ${ARGN})
  list(TRANSFORM ARG_SOURCES PREPEND "src/${name}/")
  list(TRANSFORM ARG_DEPENDS PREPEND "strainwave::")
  add_library(strainwave_${name} ${ARG_SOURCES})
  add_library(strainwave::${name} ALIAS strainwave_${name})
  set_target_properties(strainwave_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(strainwave_${name} PUBLIC cxx_std_20)
  target_include_directories(strainwave_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE "${PROJECT_SOURCE_DIR}/src/${name}")
  target_link_libraries(strainwave_${name} PUBLIC ${ARG_DEPENDS}
    PRIVATE $<IF:$<BOOL:${STRAINWAVE_SELF_CONTAINED}>,fmt::fmt-header-only,fmt::fmt>)
  strainwave_flags(strainwave_${name})
  set_property(GLOBAL APPEND PROPERTY STRAINWAVE_ALL_MODULES ${name})
  if(NOT ARG_NOT_INSTALLED)
    set_property(GLOBAL APPEND PROPERTY STRAINWAVE_MODULES strainwave_${name})
  endif()
endfunction()

# strainwave_test(<folder> SOURCES <name>... DEPENDS <module>... [INSIDE <module>] [PARTS <number>])
# GoogleTest program test_<folder> of tests/<folder>/<name>_test.cpp, labelled with the folder:
# `ctest -L fracture`.  INSIDE: the tests see the private headers of one module.  ctest runs each
# test by itself, or in the presets of ./check the tests of a folder in PARTS parts, which are four if left out.
function(strainwave_test folder)
  cmake_parse_arguments(ARG "" "INSIDE;PARTS" "SOURCES;DEPENDS" ${ARGN})
  list(TRANSFORM ARG_SOURCES REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/tests/${folder}/\\1_test.cpp")
  list(TRANSFORM ARG_DEPENDS PREPEND "strainwave::")
  set(target test_${folder})
  add_executable(${target} ${ARG_SOURCES})
  if(STRAINWAVE_UNITY_TESTS)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  endif()
  target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}/tests"
    $<$<BOOL:${ARG_INSIDE}>:${PROJECT_SOURCE_DIR}/src/${ARG_INSIDE}>)
  target_compile_definitions(${target} PRIVATE
    STRAINWAVE_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data"
    STRAINWAVE_EXAMPLES="${PROJECT_SOURCE_DIR}/examples"
    STRAINWAVE_CLI="$<TARGET_FILE:strainwave_cli>")
  target_link_libraries(${target} PRIVATE ${ARG_DEPENDS} GTest::gtest_main)
  strainwave_flags(${target})
  # The code of most tests need not be fast; with -O0 it compiles in three quarters of the time.
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O0>)
  if(TARGET test_headers)
    target_precompile_headers(${target} REUSE_FROM test_headers)
  endif()
  if((STRAINWAVE_SANITIZE OR STRAINWAVE_BUILD_FE) AND NOT ARG_PARTS)
    set(ARG_PARTS 4)
  endif()
  if(ARG_PARTS)
    # A program, above all a sanitized one or one with 200 libraries, takes longer to start than most tests to run.
    # Therefore ctest starts it for a few parts and not for each test.
    math(EXPR last "${ARG_PARTS} - 1")
    foreach(part RANGE ${last})
      # Open MPI's programs share a folder of sessions, which two that start at once both want to make.
      set(sessions "${CMAKE_BINARY_DIR}/mpi/${folder}.${part}")
      file(MAKE_DIRECTORY "${sessions}")
      add_test(NAME ${folder}.${part} COMMAND ${target} --gtest_brief=1)
      set_tests_properties(${folder}.${part} PROPERTIES LABELS "${folder}" TIMEOUT 900
        ENVIRONMENT "GTEST_TOTAL_SHARDS=${ARG_PARTS};GTEST_SHARD_INDEX=${part};OMPI_MCA_orte_tmpdir_base=${sessions}")
    endforeach()
  else()
    gtest_discover_tests(${target} NO_PRETTY_VALUES DISCOVERY_TIMEOUT 60
      PROPERTIES LABELS "${folder}" TIMEOUT 120)
  endif()
endfunction()

# strainwave_test_headers()
# Target test_headers, whose precompiled headers all programs of tests use that strainwave_test adds later.
# They are used only where a folder of tests is one file, so other presets find a missing #include.  clang
# reads of them what a test needs, and saves two seconds for each folder; g++ reads all of its 127 MB, and saves
# nothing.  ccache does not store what uses them, so they are left out where it runs.
function(strainwave_test_headers)
  if(NOT CMAKE_UNITY_BUILD OR NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang" OR CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache")
    return()
  endif()
  add_executable(test_headers EXCLUDE_FROM_ALL support/headers.cpp)
  target_include_directories(test_headers PRIVATE "${PROJECT_SOURCE_DIR}/tests")
  target_link_libraries(test_headers PRIVATE strainwave::core GTest::gtest_main)
  strainwave_flags(test_headers)
  target_precompile_headers(test_headers PRIVATE support/headers.hpp)
endfunction()

# strainwave_sight_tests()
# For each module a test structure.sight.<module>, which asks the compiler, given the module's own
# include directories, for every private header of the tree by both its spellings.
function(strainwave_sight_tests)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}/src" "${PROJECT_SOURCE_DIR}/src/*.hpp")
  get_property(modules GLOBAL PROPERTY STRAINWAVE_ALL_MODULES)
  foreach(module IN LISTS modules)
    set(own ${headers})
    list(FILTER own INCLUDE REGEX "^${module}/")
    set(foreign ${headers})
    list(REMOVE_ITEM foreign "" ${own})
    list(TRANSFORM own REPLACE "^${module}/" "")
    set(hidden ${foreign})
    list(TRANSFORM hidden REPLACE "^[^/]*/" "")
    list(REMOVE_ITEM hidden "" ${own})
    set(code "")
    foreach(header IN LISTS own)
      string(APPEND code "#if !__has_include(\"${header}\")\n#error not seen: ${header}\n#endif\n")
    endforeach()
    foreach(header IN LISTS foreign hidden)
      string(APPEND code "#if __has_include(\"${header}\")\n#error seen: ${header}\n#endif\n")
    endforeach()
    set(probe "${PROJECT_BINARY_DIR}/sight/${module}.cpp")
    file(CONFIGURE OUTPUT "${probe}" CONTENT "${code}" @ONLY)
    add_test(NAME structure.sight.${module} COMMAND_EXPAND_LISTS COMMAND "${CMAKE_CXX_COMPILER}" -E
      "-I$<JOIN:$<TARGET_PROPERTY:strainwave_${module},INCLUDE_DIRECTORIES>,;-I>" "${probe}")
    set_tests_properties(structure.sight.${module} PROPERTIES LABELS structure)
  endforeach()
endfunction()

function(strainwave_flags target)
  target_compile_options(${target} PRIVATE
    $<$<BOOL:${STRAINWAVE_SELF_CONTAINED}>:-ffunction-sections;-fdata-sections>
    -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion
    # clang warns of names that other namespaces hide.  g++ 12 falsely warns of overlapping strings and of
    # members of empty classes and variants without a value.
    $<$<CXX_COMPILER_ID:GNU>:-Wshadow;-Wno-restrict;-Wno-maybe-uninitialized>
    # g++ warns of anonymous namespaces in all files that a module compiled as one file includes.
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:${CMAKE_UNITY_BUILD}>>:-Wno-subobject-linkage>
    $<$<BOOL:${STRAINWAVE_WERROR}>:-Werror>)
  if(STRAINWAVE_SANITIZE)
    # The address sanitizer sees null pointers and wrong sizes too; nothing checks the alignment.  Without these
    # checks at each access, the files compile a quarter faster, and clang inlines the index of an array.
    target_compile_options(${target} PRIVATE
      -fsanitize=${STRAINWAVE_SANITIZE} -fno-sanitize-recover=all
      -fno-sanitize=null,alignment,object-size -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=${STRAINWAVE_SANITIZE})
  endif()
endfunction()

# strainwave_shared_library(<module>)
# libstrainwave.so.0 of a module and of the modules it uses; it exports only the functions of
# strainwave.h.
function(strainwave_shared_library module)
  set(exports "${PROJECT_SOURCE_DIR}/cmake/strainwave.map")
  add_library(strainwave_shared SHARED $<TARGET_OBJECTS:strainwave_${module}>)
  add_library(strainwave::shared ALIAS strainwave_shared)
  set_target_properties(strainwave_shared PROPERTIES OUTPUT_NAME strainwave EXPORT_NAME shared
    VERSION "${PROJECT_VERSION}" SOVERSION 0 LINKER_LANGUAGE CXX LINK_DEPENDS "${exports}")
  target_include_directories(strainwave_shared INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(strainwave_shared PRIVATE $<BUILD_INTERFACE:strainwave_${module}>)
  target_link_options(strainwave_shared PRIVATE "-Wl,--version-script=${exports}"
    $<$<BOOL:${STRAINWAVE_SELF_CONTAINED}>:-static-libstdc++;-static-libgcc;-Wl,--gc-sections;-Wl,--as-needed>)
  if(STRAINWAVE_SELF_CONTAINED)
    include(CheckLinkerFlag)
    check_linker_flag(CXX -fuse-ld=gold strainwave_gold)
    if(strainwave_gold)  # joins functions of equal code
      target_link_options(strainwave_shared PRIVATE -fuse-ld=gold -Wl,--icf=safe)
    endif()
  endif()
  set_property(GLOBAL APPEND PROPERTY STRAINWAVE_MODULES strainwave_shared)
  file(RELATIVE_PATH includes "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/${CMAKE_INSTALL_INCLUDEDIR}")
  configure_file(cmake/strainwave.pc.in "${PROJECT_BINARY_DIR}/strainwave.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/strainwave.pc"
    DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
endfunction()

# strainwave_version(<module>)
# Adds version.cpp, written at build time and only if the version or the git revision changed.
function(strainwave_version module)
  set(output "${PROJECT_BINARY_DIR}/generated/version.cpp")
  add_custom_target(strainwave_revision BYPRODUCTS "${output}" VERBATIM COMMENT "" COMMAND
    "${CMAKE_COMMAND}" "-DSOURCE_DIR=${PROJECT_SOURCE_DIR}" "-DPROJECT_VERSION=${PROJECT_VERSION}"
    "-DINPUT=${PROJECT_SOURCE_DIR}/src/${module}/version.cpp.in" "-DOUTPUT=${output}"
    -P "${PROJECT_SOURCE_DIR}/cmake/write_version.cmake")
  target_sources(strainwave_${module} PRIVATE "${output}")
  set_source_files_properties("${output}" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  add_dependencies(strainwave_${module} strainwave_revision)
endfunction()

# strainwave_equation_titles(<module>)
# Adds equation_titles.cpp, made from the headings of the theory manual.
function(strainwave_equation_titles module)
  set(output "${PROJECT_BINARY_DIR}/generated/equation_titles.cpp")
  set(script "${PROJECT_SOURCE_DIR}/cmake/write_equation_titles.cmake")
  file(GLOB chapters CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/docs/theory/*.md")
  add_custom_command(OUTPUT "${output}" DEPENDS ${chapters} "${script}" VERBATIM COMMAND
    "${CMAKE_COMMAND}" "-DMANUAL=${PROJECT_SOURCE_DIR}/docs/theory" "-DOUTPUT=${output}"
    -P "${script}")
  target_sources(strainwave_${module} PRIVATE "${output}")
endfunction()

# strainwave_glossary(<module>)
# Adds glossary.cpp, made from the glossary of the guide.
function(strainwave_glossary module)
  set(input "${PROJECT_SOURCE_DIR}/docs/guide/glossary.md")
  set(output "${PROJECT_BINARY_DIR}/generated/glossary.cpp")
  set(script "${PROJECT_SOURCE_DIR}/cmake/write_glossary.cmake")
  add_custom_command(OUTPUT "${output}" DEPENDS "${input}" "${script}" VERBATIM COMMAND
    "${CMAKE_COMMAND}" "-DGLOSSARY=${input}" "-DOUTPUT=${output}" -P "${script}")
  target_sources(strainwave_${module} PRIVATE "${output}")
endfunction()

# strainwave_note_texts(<module>)
# Adds note_texts.cpp, made from the sources, where each note is written.
function(strainwave_note_texts module)
  set(output "${PROJECT_BINARY_DIR}/generated/note_texts.cpp")
  set(script "${PROJECT_SOURCE_DIR}/cmake/write_note_texts.cmake")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/*.cpp"
    "${PROJECT_SOURCE_DIR}/src/*.hpp")
  add_custom_command(OUTPUT "${output}" DEPENDS ${sources} "${script}" VERBATIM COMMAND
    "${CMAKE_COMMAND}" "-DSOURCES=${PROJECT_SOURCE_DIR}/src" "-DOUTPUT=${output}" -P "${script}")
  target_sources(strainwave_${module} PRIVATE "${output}")
endfunction()

# strainwave_data(<module> <name> <file>)
# Adds <name>.cpp, written at build time from data/<file>; the file is installed too.
function(strainwave_data module name file)
  set(input "${PROJECT_SOURCE_DIR}/src/${module}/${name}.cpp.in")
  set(data "${PROJECT_SOURCE_DIR}/data/${file}")
  set(script "${PROJECT_SOURCE_DIR}/cmake/write_data.cmake")
  set(output "${PROJECT_BINARY_DIR}/generated/${name}.cpp")
  add_custom_command(OUTPUT "${output}" DEPENDS "${data}" "${input}" "${script}" VERBATIM COMMAND
    "${CMAKE_COMMAND}" "-DDATA=${data}" "-DINPUT=${input}" "-DOUTPUT=${output}" -P "${script}")
  target_sources(strainwave_${module} PRIVATE "${output}")
  install(FILES "${data}" DESTINATION "${CMAKE_INSTALL_DATADIR}/strainwave")
endfunction()

# Rules for `cmake --install`: afterwards find_package(strainwave) gives strainwave::<module>.
function(strainwave_install)
  include(CMakePackageConfigHelpers)
  set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/strainwave")
  get_property(modules GLOBAL PROPERTY STRAINWAVE_MODULES)
  install(TARGETS ${modules} EXPORT strainwaveTargets)
  install(DIRECTORY include/ DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
    PATTERN "strainwave/core/toml_*" EXCLUDE
    PATTERN "strainwave/fem" EXCLUDE
    PATTERN "strainwave/gear_fem" EXCLUDE
    PATTERN "strainwave/fe_study" EXCLUDE)
  install(FILES LICENSE README.md CHANGELOG.md CITATION.cff DESTINATION "${CMAKE_INSTALL_DOCDIR}")
  # Install the manual with its pictures and the examples too, because the guides refer to them.
  install(DIRECTORY docs/guide docs/theory docs/images DESTINATION "${CMAKE_INSTALL_DOCDIR}/docs")
  install(DIRECTORY examples DESTINATION "${CMAKE_INSTALL_DOCDIR}" PATTERN CMakeLists.txt EXCLUDE)
  install(EXPORT strainwaveTargets NAMESPACE strainwave:: DESTINATION "${package_dir}")
  configure_package_config_file(cmake/strainwaveConfig.cmake.in strainwaveConfig.cmake
    INSTALL_DESTINATION "${package_dir}")
  write_basic_package_version_file(strainwaveConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  install(FILES
    "${PROJECT_BINARY_DIR}/strainwaveConfig.cmake"
    "${PROJECT_BINARY_DIR}/strainwaveConfigVersion.cmake" DESTINATION "${package_dir}")
endfunction()
