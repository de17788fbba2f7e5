# Options of the build. "Found" options start ON and turn themselves off when the package is missing, unless the user
# asked for them by name (-DBRECCIA_ENABLE_MPI=ON): then a missing package is an error (dependencies.cmake).

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)

foreach(part MPI HDF5 METIS GMSH TESTS BENCHMARKS)
  if(DEFINED BRECCIA_ENABLE_${part})
    set(BRECCIA_${part}_REQUESTED ${BRECCIA_ENABLE_${part}})
  else()
    set(BRECCIA_${part}_REQUESTED auto)
  endif()
endforeach()

set(BRECCIA_ARCH native CACHE STRING "native: this processor. portable: x86-64-v3 on x86-64, the baseline elsewhere")
set_property(CACHE BRECCIA_ARCH PROPERTY STRINGS native portable)
if(NOT BRECCIA_ARCH MATCHES "^(native|portable)$")
  message(FATAL_ERROR "BRECCIA_ARCH is '${BRECCIA_ARCH}'; it must be native or portable")
endif()

set(BRECCIA_FP_CONTRACT off CACHE STRING "Fused multiply-add made by the host compiler: off or fast (decision 0001)")
set_property(CACHE BRECCIA_FP_CONTRACT PROPERTY STRINGS off fast)

set(BRECCIA_KOKKOS auto CACHE STRING "auto: an installed Kokkos if there is one. fetch: always build it. installed: never")
set_property(CACHE BRECCIA_KOKKOS PROPERTY STRINGS auto fetch installed)

option(BRECCIA_WARNINGS_AS_ERRORS "Warnings stop the build (presets switch this on)" OFF)
option(BRECCIA_SANITIZE "Address and undefined-behaviour sanitizers in our own targets" OFF)
option(BRECCIA_PRECOMPILED_HEADERS "Precompile Kokkos and the standard library (host compilers only)" ON)

# The compiler cache must be told that a precompiled header may stand in for its text, or it gives up on every file, and
# where the tree begins, so that a fresh clone elsewhere finds what an earlier one left.
# Kokkos's CUDA compiler launcher does not share its place with another launcher.
find_program(BRECCIA_CCACHE ccache)
mark_as_advanced(BRECCIA_CCACHE)
if(BRECCIA_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER AND NOT Kokkos_ENABLE_CUDA)
  set(breccia_ccache ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros
                     CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${BRECCIA_CCACHE})
  set(CMAKE_C_COMPILER_LAUNCHER ${breccia_ccache})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${breccia_ccache})
endif()
