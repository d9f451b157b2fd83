# One precompiled header for all of our own code: Eigen/Core, GoogleTest, {fmt} and the standard library's heavy headers
# are read once instead of a hundred times.

function(muelle_make_precompiled_header)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/precompiled.cpp CONTENT "")
  add_library(muelle_precompiled OBJECT ${CMAKE_BINARY_DIR}/generated/precompiled.cpp)
  target_link_libraries(muelle_precompiled PRIVATE muelle_flags)
  # harness/types.h first: it sets Eigen's assertion before Eigen is read.
  target_precompile_headers(muelle_precompiled PRIVATE
    ${CMAKE_SOURCE_DIR}/framework/harness/types.h <fmt/format.h> <gtest/gtest.h> <algorithm> <filesystem> <functional>
    <map> <string> <vector>)
endfunction()

# Every target below `folder` that is compiled with muelle_flags reads it.
function(muelle_use_precompiled_header folder)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target ${targets})
    get_target_property(type ${target} TYPE)
    if(NOT type MATCHES "EXECUTABLE|STATIC_LIBRARY|OBJECT_LIBRARY" OR target STREQUAL "muelle_precompiled")
      continue()
    endif()
    get_target_property(libraries ${target} LINK_LIBRARIES)
    get_target_property(own ${target} PRECOMPILE_HEADERS)
    # What is compiled for a student's file fills Eigen's objects, which the header's Eigen does not.
    get_target_property(definitions ${target} COMPILE_DEFINITIONS)
    if(NOT own AND NOT "muelle_plain_flags" IN_LIST libraries AND NOT MUELLE_FILL_DEFINE IN_LIST definitions)
      target_precompile_headers(${target} REUSE_FROM muelle_precompiled)
    endif()
  endforeach()
  get_property(subfolders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(subfolder ${subfolders})
    muelle_use_precompiled_header(${subfolder})
  endforeach()
endfunction()
