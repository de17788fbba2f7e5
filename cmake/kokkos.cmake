# Kokkos: an installed one of the right version, or the pinned release built as part of this build.
#
# The archive comes from the project's release page or, byte for byte the same, from the Debian pool behind whatever
# mirror this machine's apt is set up with. It is kept in the user's cache folder, so only the first configure needs
# a network.

set(BRECCIA_KOKKOS_VERSION 5.0.2)
set(BRECCIA_KOKKOS_SHA256 188817bb452ca805ee8701f1c5adbbb4fb83dc8d1c50624566a18a719ba0fa5e)

function(breccia_cache_folder result)
  if(DEFINED ENV{XDG_CACHE_HOME} AND NOT "$ENV{XDG_CACHE_HOME}" STREQUAL "")
    set(folder $ENV{XDG_CACHE_HOME}/breccia)
  elseif(DEFINED ENV{HOME})
    set(folder $ENV{HOME}/.cache/breccia)
  else()
    set(folder ${PROJECT_BINARY_DIR}/download)
  endif()
  set(${result} ${folder} PARENT_SCOPE)
endfunction()

function(breccia_kokkos_addresses result)
  set(version ${BRECCIA_KOKKOS_VERSION})
  set(addresses "https://github.com/kokkos/kokkos/releases/download/${version}/kokkos-${version}.tar.gz")
  find_program(BRECCIA_APT_GET apt-get)
  mark_as_advanced(BRECCIA_APT_GET)
  if(BRECCIA_APT_GET)
    execute_process(
      COMMAND ${BRECCIA_APT_GET} indextargets --format "$(REPO_URI)"
      OUTPUT_VARIABLE mirrors
      OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    string(REPLACE "\n" ";" mirrors "${mirrors}")
    list(REMOVE_DUPLICATES mirrors)
    foreach(mirror IN LISTS mirrors)
      if(mirror MATCHES "^(https?|file):" AND NOT mirror MATCHES "security")
        string(REGEX REPLACE "/+$" "" mirror "${mirror}")
        list(APPEND addresses "${mirror}/pool/main/k/kokkos/kokkos_${version}.orig.tar.gz")
      endif()
    endforeach()
  endif()
  set(${result} "${addresses}" PARENT_SCOPE)
endfunction()

# Fetches the archive into the cache by a name of its own and renames it when its hash is right, so that two builds
# at the same time, or one that is interrupted, never see half a file.
function(breccia_kokkos_archive result)
  breccia_cache_folder(cache)
  set(archive ${cache}/kokkos-${BRECCIA_KOKKOS_VERSION}.tar.gz)
  if(EXISTS ${archive})
    file(SHA256 ${archive} hash)
    if(hash STREQUAL BRECCIA_KOKKOS_SHA256)
      set(${result} ${archive} PARENT_SCOPE)
      return()
    endif()
    message(WARNING "${archive} has the wrong hash and is fetched again")
  endif()
  breccia_kokkos_addresses(addresses)
  string(RANDOM LENGTH 8 suffix)
  set(part ${archive}.${suffix})
  set(report "")
  foreach(address IN LISTS addresses)
    message(STATUS "Kokkos: fetching ${address}")
    file(DOWNLOAD ${address} ${part} STATUS status INACTIVITY_TIMEOUT 20 TIMEOUT 600)
    list(GET status 0 code)
    list(GET status 1 text)
    if(code EQUAL 0)
      file(SHA256 ${part} hash)
      if(hash STREQUAL BRECCIA_KOKKOS_SHA256)
        file(RENAME ${part} ${archive})
        set(${result} ${archive} PARENT_SCOPE)
        return()
      endif()
      set(text "SHA-256 is ${hash}")
    endif()
    string(APPEND report "\n  ${address}: ${text}")
  endforeach()
  file(REMOVE ${part})
  message(
    FATAL_ERROR
      "Kokkos ${BRECCIA_KOKKOS_VERSION} could not be fetched:${report}\n"
      "Put the release archive (SHA-256 ${BRECCIA_KOKKOS_SHA256}) at\n  ${archive}\n"
      "or give an installed Kokkos with -DKokkos_ROOT=<its prefix>.")
endfunction()

macro(breccia_build_kokkos)
  breccia_kokkos_archive(breccia_kokkos_archive_file)
  set(Kokkos_ENABLE_SERIAL ON CACHE BOOL "Serial backend")
  if(NOT DEFINED Kokkos_ENABLE_OPENMP)
    find_package(OpenMP QUIET COMPONENTS CXX)
    set(Kokkos_ENABLE_OPENMP ${OpenMP_CXX_FOUND} CACHE BOOL "OpenMP backend")
  endif()
  if(BRECCIA_ARCH STREQUAL "native")
    set(Kokkos_ARCH_NATIVE ON CACHE BOOL "This processor")
  endif()
  set(Kokkos_ENABLE_DEPRECATED_CODE_5 OFF CACHE BOOL "Names that Kokkos will drop")
  include(FetchContent)
  set(breccia_system "")
  if(CMAKE_VERSION VERSION_GREATER_EQUAL 3.25)
    set(breccia_system SYSTEM)
  endif()
  FetchContent_Declare(
    Kokkos
    ${breccia_system}
    URL ${breccia_kokkos_archive_file}
    URL_HASH SHA256=${BRECCIA_KOKKOS_SHA256}
    DOWNLOAD_EXTRACT_TIMESTAMP OFF)
  FetchContent_MakeAvailable(Kokkos)
  set(BRECCIA_KOKKOS_ORIGIN "built here")
endmacro()

set(BRECCIA_KOKKOS_ORIGIN "installed")
if(NOT BRECCIA_KOKKOS STREQUAL "fetch")
  set(breccia_kokkos_mode QUIET)
  if(BRECCIA_KOKKOS STREQUAL "installed")
    set(breccia_kokkos_mode REQUIRED)
  endif()
  find_package(Kokkos 5.0 ${breccia_kokkos_mode} CONFIG)
endif()
if(NOT TARGET Kokkos::kokkos)
  breccia_build_kokkos()
endif()

# CUDA goes through Kokkos's own compiler launcher: it hands every file of a target that links Kokkos to nvcc_wrapper.
# (CUDA as a CMake language needs CMake 3.25.2 for C++20, one step above the one in Debian 12.) Neither the precompiled
# header nor the compiler cache works there.
set(BRECCIA_CUDA FALSE)
if("CUDA" IN_LIST Kokkos_DEVICES OR Kokkos_ENABLE_CUDA)
  set(BRECCIA_CUDA TRUE)
endif()
