# Flags of our own targets. They hang on a target (breccia::flags), never on the whole build.
#
# Same bits for any number of threads: a vectorised loop and its scalar remainder must round alike, and which entity
# falls into the remainder depends on the number of threads. So the compiler makes no fused multiply-add of its own
# (docs/decisions/0001-rounding.md), and -ffast-math is out. Errno and traps are not read by anybody; giving them up
# lets loops with sqrt and select vectorise. On the GPU every entity runs the same instructions, so nvcc keeps its
# fused multiply-add.

add_library(breccia_flags INTERFACE)
add_library(breccia::flags ALIAS breccia_flags)

set(breccia_host_flags -ffp-contract=${BRECCIA_FP_CONTRACT} -fno-math-errno -fno-trapping-math)
if(BRECCIA_ARCH STREQUAL "native")
  list(APPEND breccia_host_flags -march=native)
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
  list(APPEND breccia_host_flags -march=x86-64-v3)
endif()
set(breccia_warning_flags -Wall -Wextra -Wshadow -Wnon-virtual-dtor)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC 12 warns about the undefined lanes of its own AVX-512 intrinsics (GCC bug 105593) and about copies of impossible
  # length inside its own std::string (105329, 105651). The sanitizer build and newer compilers still look for what these
  # warnings would find in our code.
  list(APPEND breccia_warning_flags -Wno-uninitialized -Wno-maybe-uninitialized -Wno-restrict
       -Wno-stringop-overflow -Wno-array-bounds)
endif()
if(BRECCIA_CUDA)
  # Names that nvcc makes up for the host compiler.
  list(APPEND breccia_warning_flags -Wno-unused-local-typedefs)
  # fmt 9 takes nvcc for a compiler without constexpr.
  target_compile_definitions(breccia_flags INTERFACE FMT_USE_CONSTEXPR=1)
endif()
if(BRECCIA_WARNINGS_AS_ERRORS)
  list(APPEND breccia_warning_flags -Werror)
endif()
if(BRECCIA_SANITIZE)
  set(breccia_sanitize -fsanitize=address,undefined -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  list(APPEND breccia_host_flags ${breccia_sanitize})
  target_link_options(breccia_flags INTERFACE ${breccia_sanitize})
endif()

target_compile_options(
  breccia_flags INTERFACE "$<$<COMPILE_LANGUAGE:CXX>:${breccia_host_flags};${breccia_warning_flags}>")

# One precompiled header for all floors. lint.headers compiles each header without it, so it cannot hide a missing
# include.
if(BRECCIA_PRECOMPILED_HEADERS AND NOT BRECCIA_CUDA)
  set(BRECCIA_PCH breccia_pch)
  add_library(breccia_pch STATIC ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
  target_link_libraries(breccia_pch PRIVATE breccia_flags Kokkos::kokkos)
  target_precompile_headers(breccia_pch PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.hpp)
endif()
