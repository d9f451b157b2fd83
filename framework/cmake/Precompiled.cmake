# Precompiled headers for all of our own code: Eigen/Core, {fmt}, the standard library's heavy headers and, for tests,
# GoogleTest are read a few times instead of some hundred. A student's tree has too few sources for that.

set(default ON)
if(MUELLE_STUDENTS_TREE)
  set(default OFF)
endif()
option(MUELLE_PCH "Read the large headers once, as a precompiled header" ${default})

# With `useful` headers besides those that all of our code reads.
function(muelle_precompiled_target target useful)
  add_library(${target} OBJECT ${CMAKE_BINARY_DIR}/generated/precompiled.cpp)
  target_link_libraries(${target} PRIVATE muelle_flags)
  target_compile_options(${target} PRIVATE ${ARGN})
  # harness/types.h first: it sets Eigen's assertion before Eigen is read.
  target_precompile_headers(${target} PRIVATE
    ${CMAKE_SOURCE_DIR}/framework/harness/types.h <fmt/format.h> ${useful} <algorithm> <filesystem> <functional> <map>
    <string> <vector>)
endfunction()

# One for each optimisation level, for GCC takes the level from the header, whatever the command line says; one for the
# engine, where Eigen asserts nothing; and two for what is linked with a student's file, whose Eigen objects are filled:
# public tests and demos.
# GoogleTest is in those of tests only: what its own functions need of templates GCC makes again for every source that
# reads the header, used or not, which takes as long as all the rest of a small source.
function(muelle_make_precompiled_headers)
  if(NOT MUELLE_PCH)
    return()
  endif()
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/precompiled.cpp CONTENT "")
  muelle_precompiled_target(muelle_precompiled "")
  muelle_precompiled_target(muelle_precompiled_engine "" ${MUELLE_ENGINE})
  muelle_precompiled_target(muelle_precompiled_light "" ${MUELLE_LIGHT})
  muelle_precompiled_target(muelle_precompiled_tests <gtest/gtest.h> ${MUELLE_LIGHT})
  muelle_precompiled_target(muelle_precompiled_filled <gtest/gtest.h> ${MUELLE_LIGHT})
  muelle_precompiled_target(muelle_precompiled_demo "" ${MUELLE_LIGHT})
  foreach(target IN ITEMS muelle_precompiled_filled muelle_precompiled_demo)
    target_compile_definitions(${target} PRIVATE ${MUELLE_FILL_DEFINE})
  endforeach()
endfunction()

# The one that fits a target's options, definitions and libraries.
function(muelle_fitting_header target result)
  get_target_property(options ${target} COMPILE_OPTIONS)
  get_target_property(definitions ${target} COMPILE_DEFINITIONS)
  get_target_property(libraries ${target} LINK_LIBRARIES)
  set(header muelle_precompiled)
  if(MUELLE_FILL_DEFINE IN_LIST definitions)
    set(header muelle_precompiled_demo)
    if("muelle_testing" IN_LIST libraries)
      set(header muelle_precompiled_filled)
    endif()
  elseif(options MATCHES "EIGEN_NO_DEBUG")
    set(header muelle_precompiled_engine)
  elseif(MUELLE_LIGHT IN_LIST options)
    set(header muelle_precompiled_light)
    if(libraries MATCHES "GTest::|muelle_hidden_main")
      set(header muelle_precompiled_tests)
    endif()
  endif()
  set(${result} ${header} PARENT_SCOPE)
endfunction()

# Every target that is compiled with muelle_flags reads the one that fits it.
function(muelle_use_precompiled_header)
  if(NOT MUELLE_PCH)
    return()
  endif()
  muelle_targets_below(${CMAKE_SOURCE_DIR} targets)
  foreach(target ${targets})
    get_target_property(libraries ${target} LINK_LIBRARIES)
    get_target_property(own ${target} PRECOMPILE_HEADERS)
    if(NOT own AND NOT "muelle_plain_flags" IN_LIST libraries AND NOT target MATCHES "^muelle_precompiled")
      muelle_fitting_header(${target} header)
      target_precompile_headers(${target} REUSE_FROM ${header})
    endif()
  endforeach()
endfunction()
