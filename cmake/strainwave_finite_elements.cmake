# The finite elements (docs/adr/0011).  deal.II is found only here.  It is linked into the modules
# that call strainwave_finite_elements(<module>) and into everything that is built from them.
find_package(deal.II 9.4 REQUIRED HINTS /usr)
foreach(feature IN ITEMS MPI PETSC P4EST)
  if(NOT DEAL_II_WITH_${feature})
    message(FATAL_ERROR "deal.II was built without ${feature}, which the finite elements need")
  endif()
endforeach()

# Every build uses the Release library of deal.II, because its Debug library is ten times as slow.
function(strainwave_finite_elements module)
  target_include_directories(strainwave_${module} SYSTEM PRIVATE ${DEAL_II_INCLUDE_DIRS})
  target_compile_definitions(strainwave_${module} PRIVATE ${DEAL_II_USER_DEFINITIONS})
  # The headers of deal.II call into some of the 200 libraries that it is linked with.
  target_link_libraries(strainwave_${module} PRIVATE Eigen3::Eigen
    -Wl,--as-needed ${DEAL_II_LIBRARIES_RELEASE})
  # deal.II asks for this linker, because the default linker takes ten times as long.
  target_link_options(strainwave_${module} INTERFACE -fuse-ld=gold)
  # The headers of deal.II convert their own numbers; the compiler would report that as our code.
  target_compile_options(strainwave_${module} PRIVATE -Wno-conversion -Wno-double-promotion
    $<$<CONFIG:Debug>:-O2>)
endfunction()
