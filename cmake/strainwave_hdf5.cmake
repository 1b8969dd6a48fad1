# strainwave_hdf5(<module> WITH <source> WITHOUT <source>)
# The source of a module that needs HDF5 (docs/adr/0031), or in its place the one that says that HDF5
# is missing.  Debian has several forms of HDF5 beside each other; this is the one without MPI.
# The archive comes first, because the shared library needs thirty others, such as those of Kerberos, and
# loading them takes ten times as long as all else that the program does before it works.
function(strainwave_hdf5 module)
  cmake_parse_arguments(ARG "" "WITH;WITHOUT" "" ${ARGN})
  if(STRAINWAVE_HDF5)
    set_source_files_properties("src/${module}/${ARG_WITHOUT}" PROPERTIES HEADER_FILE_ONLY ON)
    find_path(HDF5_SERIAL_INCLUDE hdf5.h PATH_SUFFIXES hdf5/serial REQUIRED NO_CMAKE_SYSTEM_PATH
      PATHS /usr/include)
    find_library(HDF5_SERIAL NAMES libhdf5_serial.a hdf5_serial hdf5 REQUIRED)
    target_include_directories(strainwave_${module} SYSTEM PRIVATE "${HDF5_SERIAL_INCLUDE}")
    target_link_libraries(strainwave_${module} PRIVATE "${HDF5_SERIAL}")
    if(HDF5_SERIAL MATCHES "\\.a$")
      target_link_libraries(strainwave_${module} PRIVATE sz z m ${CMAKE_DL_LIBS})
    endif()
  else()
    set_source_files_properties("src/${module}/${ARG_WITH}" PROPERTIES HEADER_FILE_ONLY ON)
  endif()
endfunction()
