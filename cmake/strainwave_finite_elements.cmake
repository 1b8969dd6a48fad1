# The finite-element road (docs/adr/0011): deal.II is found here and nowhere else, and linked into
# the modules that call strainwave_finite_elements(<module>) and what is made of them.
find_package(deal.II 9.4 REQUIRED HINTS /usr)
foreach(feature IN ITEMS MPI PETSC P4EST)
  if(NOT DEAL_II_WITH_${feature})
    message(FATAL_ERROR "deal.II was built without ${feature}, which the finite elements need")
  endif()
endforeach()

# The library is compiled as Release whatever our own build is: its Debug twin is ten times as slow.
function(strainwave_finite_elements module)
  target_include_directories(strainwave_${module} SYSTEM PRIVATE ${DEAL_II_INCLUDE_DIRS})
  target_compile_definitions(strainwave_${module} PRIVATE ${DEAL_II_USER_DEFINITIONS})
  # Its headers call into some of the 200 libraries that it is linked with.
  target_link_libraries(strainwave_${module} PRIVATE Eigen3::Eigen
    -Wl,--as-needed ${DEAL_II_LIBRARIES_RELEASE})
  # As deal.II asks for: the default linker takes ten times as long over them.
  target_link_options(strainwave_${module} INTERFACE -fuse-ld=gold)
  # Its headers bring numbers of their own to conversions that we would see as ours.
  target_compile_options(strainwave_${module} PRIVATE -Wno-conversion -Wno-double-promotion
    $<$<CONFIG:Debug>:-O2>)
endfunction()
