# breccia_test(<area> SOURCES ... LINKS ... [THREADS 1 2 4] [LABELS ...] [ALONE])
#
# One GoogleTest executable test_<area> from several sources; each TEST becomes one ctest test named
# <area>.<Suite>.<Name>, with the label <area> and the label quick, or slow when the suite or the test has "Slow" in
# its name. THREADS runs the whole executable with so many threads; several numbers, once for each
# (<area>.t2.<Suite>.<Name>). ALONE: no other test runs beside it (those that measure time). The default is 2; bodies of a few hundred elements are quicker with 1. A second executable in the same area is named <area>.<name>.
#
# breccia_command_test(<area>.<name> COMMAND ... [LABELS quick|slow|long ...] [THREADS n] [TIMEOUT s] [NEEDS targets...])
#
# A test that runs a program, mostly a Python script. It is left out if one of the NEEDS targets is not built.
#
# breccia_benchmark(<name> SOURCES ... LINKS ...)
#
# A Google Benchmark executable bench_<name>, run at tiny size as the test perf-smoke.<name>. The environment variable
# BRECCIA_PERF_SMOKE tells the benchmark to choose its tiny size.

find_package(Threads REQUIRED)
find_program(BRECCIA_PYTHON NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH)
if(NOT BRECCIA_PYTHON)
  find_program(BRECCIA_PYTHON NAMES python3 REQUIRED)
endif()

# Threads that wait must not spin: tests share the machine. Open MPI refuses to start as root (a container, for example)
# unless it is told twice that this is meant.
set(BRECCIA_TEST_ENVIRONMENT OMP_PROC_BIND=false OMP_WAIT_POLICY=passive OMPI_ALLOW_RUN_AS_ROOT=1
                             OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1)

if(BRECCIA_ENABLE_TESTS)
  include(GoogleTest)
  find_package(GTest REQUIRED)
  add_library(breccia_test_main STATIC ${PROJECT_SOURCE_DIR}/tests/harness/main.cpp)
  target_link_libraries(breccia_test_main PUBLIC GTest::gmock GTest::gtest Kokkos::kokkos Threads::Threads)
  target_include_directories(breccia_test_main PUBLIC ${PROJECT_SOURCE_DIR}/tests)
  breccia_common(breccia_test_main PRIVATE)
  if(BRECCIA_PCH)
    add_library(breccia_test_pch STATIC ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
    target_link_libraries(breccia_test_pch PRIVATE breccia_flags GTest::gmock GTest::gtest Kokkos::kokkos)
    target_precompile_headers(breccia_test_pch PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.hpp <gtest/gtest.h>)
  endif()
endif()

function(breccia_register_tests target prefix area threads alone labels)
  foreach(speed quick slow)
    if(speed STREQUAL "quick")
      set(filter "-*Slow*")
    else()
      set(filter "*Slow*")
    endif()
    set(list ${target}_${threads}_${speed})
    gtest_discover_tests(
      ${target}
      DISCOVERY_MODE PRE_TEST
      DISCOVERY_TIMEOUT 60
      WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}
      TEST_PREFIX ${prefix}.
      TEST_FILTER ${filter}
      TEST_LIST ${list})
    # Discovery mangles properties that are lists, so ctest sets them afterwards, on the names that were found.
    set(file ${CMAKE_CURRENT_BINARY_DIR}/${list}_properties.cmake)
    set(environment "OMP_NUM_THREADS=${threads};${BRECCIA_TEST_ENVIRONMENT}")
    file(
      WRITE ${file}
      "if(${list})\n"
      "  set_tests_properties(\${${list}} PROPERTIES LABELS [[${area};${speed};${labels}]] PROCESSORS ${threads} "
      "RUN_SERIAL ${alone} "
      "TIMEOUT 600 ENVIRONMENT [[${environment}]])\n"
      "endif()\n")
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${file})
  endforeach()
endfunction()

function(breccia_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "ALONE" "" "SOURCES;LINKS;THREADS;LABELS")
  if(NOT arg_SOURCES)
    return()
  endif()
  string(REGEX REPLACE "\\..*" "" area ${name})
  string(REPLACE "." "_" target test_${name})
  breccia_missing_links(missing ${arg_LINKS})
  if(missing)
    breccia_left_out(${target} "needs ${missing}")
    return()
  endif()
  add_executable(${target} ${arg_SOURCES})
  target_link_libraries(${target} PRIVATE ${arg_LINKS} breccia_test_main)
  target_compile_definitions(${target} PRIVATE BRECCIA_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                                               BRECCIA_BINARY_DIR="${PROJECT_BINARY_DIR}")
  if(BRECCIA_PCH)
    set(BRECCIA_PCH breccia_test_pch)
  endif()
  breccia_common(${target} PRIVATE)
  if(NOT arg_THREADS)
    set(arg_THREADS 2)
  endif()
  list(LENGTH arg_THREADS several)
  foreach(threads IN LISTS arg_THREADS)
    set(prefix ${name})
    if(several GREATER 1)
      string(APPEND prefix .t${threads})
    endif()
    breccia_register_tests(${target} ${prefix} ${area} ${threads} ${arg_ALONE} "${arg_LABELS}")
  endforeach()
endfunction()

function(breccia_command_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "THREADS;TIMEOUT" "COMMAND;LABELS;NEEDS")
  string(REGEX REPLACE "\\..*" "" area ${name})
  foreach(target IN LISTS arg_NEEDS)
    if(NOT TARGET ${target})
      breccia_left_out(${name} "needs ${target}")
      return()
    endif()
  endforeach()
  if(NOT arg_THREADS)
    set(arg_THREADS 1)
  endif()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 600)
  endif()
  if(NOT arg_LABELS)
    set(arg_LABELS quick)
  endif()
  add_test(NAME ${name} COMMAND ${arg_COMMAND})
  set_tests_properties(
    ${name} PROPERTIES LABELS "${area};${arg_LABELS}" PROCESSORS ${arg_THREADS} TIMEOUT ${arg_TIMEOUT} ENVIRONMENT
                       "OMP_NUM_THREADS=${arg_THREADS};${BRECCIA_TEST_ENVIRONMENT}")
endfunction()

if(BRECCIA_ENABLE_BENCHMARKS)
  find_package(benchmark REQUIRED)
  add_library(breccia_benchmark_main STATIC ${PROJECT_SOURCE_DIR}/perf/harness/main.cpp)
  target_link_libraries(breccia_benchmark_main PUBLIC benchmark::benchmark Kokkos::kokkos Threads::Threads)
  target_include_directories(breccia_benchmark_main PUBLIC ${PROJECT_SOURCE_DIR}/perf)
  breccia_common(breccia_benchmark_main PRIVATE)
endif()

function(breccia_benchmark name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINKS")
  if(NOT arg_SOURCES)
    return()
  endif()
  breccia_missing_links(missing ${arg_LINKS})
  if(missing)
    breccia_left_out(bench_${name} "needs ${missing}")
    return()
  endif()
  add_executable(bench_${name} ${arg_SOURCES})
  target_link_libraries(bench_${name} PRIVATE ${arg_LINKS} breccia_benchmark_main)
  breccia_common(bench_${name} PRIVATE)
  add_test(NAME perf-smoke.${name} COMMAND bench_${name} --benchmark_min_time=0.001)
  set_tests_properties(
    perf-smoke.${name} PROPERTIES LABELS "perf-smoke;quick" PROCESSORS 2 TIMEOUT 120 ENVIRONMENT
                                  "OMP_NUM_THREADS=2;OMP_PROC_BIND=false;BRECCIA_PERF_SMOKE=1")
endfunction()
