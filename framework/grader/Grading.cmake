# What grades an exercise, beside what its students get (framework/cmake/Exercise.cmake).

include(${CMAKE_CURRENT_LIST_DIR}/authoring/OldIncludes.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/Implementations.cmake)

# The files that it needs besides; @topic@ stands for its name.
set(MUELLE_GRADING_NEEDS tests/hidden/@topic@/@topic@_test.cpp tests/hidden/@topic@/oracle.cpp
                         tests/hidden/@topic@/mistakes.cpp)

# The solution as one object, compiled as a student's file is: a criterion that follows a lower function may be judged
# with the solution's in the place of the student's. An exercise without a solution does without.
function(muelle_reference topic)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/solutions/${topic}/*.cpp)
  if(NOT sources)
    return()
  endif()
  set(object ${CMAKE_BINARY_DIR}/lib/reference_${topic}.o)
  add_custom_command(
    OUTPUT ${object}
    COMMAND ${CMAKE_CXX_COMPILER} ${MUELLE_STUDENT_FLAGS} -I${CMAKE_SOURCE_DIR}/framework
            -I${CMAKE_SOURCE_DIR}/exercises/${topic} -isystem ${MUELLE_EIGEN_INCLUDE}
            -include ${CMAKE_SOURCE_DIR}/framework/harness/exercise.h -r -nostdlib ${sources} -o ${object}
    DEPENDS ${sources} ${CMAKE_SOURCE_DIR}/exercises/${topic}/${topic}.h ${CMAKE_BINARY_DIR}/prelude/prelude.h.gch
    COMMENT "Compiling the solution of ${topic} for grading"
    VERBATIM)
  add_custom_target(reference_${topic} DEPENDS ${object})
  add_dependencies(muelle_grading reference_${topic})
endfunction()

# Hidden tests may ask the engine; only those that do wait for it to be built.
function(muelle_link_engine_if_asked target source)
  cmake_path(IS_PREFIX CMAKE_BINARY_DIR ${source} is_written_by_the_build)
  if(is_written_by_the_build)
    return()  # a scaffold: it asks nothing yet, and to configure would wait for the program that writes it
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
  file(STRINGS ${source} includes REGEX "^#include \"engine/")
  if(includes)
    target_link_libraries(${target} PRIVATE muelle_engine)
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:muelle_engine_opens_nothing>)  # a hand-in's objects least of all
  endif()
endfunction()

# For the grader: the worker's trusted half, and the hidden tests with the demo compiled for the submission (through
# the worker) and for the oracle.
function(muelle_grading_parts topic)
  set(folder ${MUELLE_COURSE}/exercises/${topic})
  set(hidden ${MUELLE_COURSE}/tests/hidden/${topic})

  add_library(glue_${topic} STATIC ${CMAKE_SOURCE_DIR}/framework/grader/worker/glue.cpp)
  target_link_libraries(glue_${topic} PRIVATE muelle_plain_flags Eigen3::Eigen)
  target_include_directories(glue_${topic} PRIVATE ${folder})
  target_compile_definitions(glue_${topic} PRIVATE MUELLE_CONTRACT="${topic}.h"
                             MUELLE_FUNCTIONS_HEADER="grader/worker/dispatch_functions.h" ${MUELLE_FILL_DEFINE})
  set_target_properties(glue_${topic} PROPERTIES ARCHIVE_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)

  if(MUELLE_COURSE STREQUAL CMAKE_SOURCE_DIR)
    muelle_reference(${topic})
  endif()
  add_executable(hidden_${topic} ${hidden}/${topic}_test.cpp ${hidden}/oracle.cpp ${hidden}/mistakes.cpp)
  target_link_libraries(hidden_${topic} PRIVATE demo_${topic} muelle_hidden_main)
  muelle_link_engine_if_asked(hidden_${topic} ${hidden}/${topic}_test.cpp)
  muelle_implementations(${topic})
  target_include_directories(hidden_${topic} PRIVATE ${folder})
  target_compile_options(hidden_${topic} PRIVATE ${MUELLE_LIGHT})
  muelle_define_paths(hidden_${topic} MUELLE_EXERCISE_FOLDER ${folder})
  target_compile_definitions(hidden_${topic} PRIVATE
                             MUELLE_FUNCTIONS_HEADER="grader/remote/remote_functions.h")
  # Calls to the worker are templates of some size: compiled once, beside the history of calls that mistakes read.
  set_source_files_properties(${hidden}/mistakes.cpp TARGET_DIRECTORY hidden_${topic}
                              PROPERTIES COMPILE_DEFINITIONS MUELLE_REMOTE_CALLS_HERE)
  set_source_files_properties(${hidden}/${topic}_test.cpp ${hidden}/oracle.cpp TARGET_DIRECTORY hidden_${topic}
                              PROPERTIES COMPILE_DEFINITIONS MUELLE_REMOTE_CALLS_ELSEWHERE)
  set_target_properties(hidden_${topic} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/hidden)
  add_dependencies(${MUELLE_ALL_GRADING} hidden_${topic} glue_${topic})
  muelle_agreement(${topic})
endfunction()

# A suite that pays nothing, a criterion that nothing tests: the build fails and names both files.
function(muelle_agreement topic)
  set(manifest exercises/${topic}/exercise.toml)
  set(public exercises/${topic}/public_test.cpp)
  set(stamp ${CMAKE_BINARY_DIR}/hidden/${topic}.agrees)
  add_custom_command(
    OUTPUT ${stamp}
    COMMAND hidden_${topic} --agree ${manifest} tests/hidden/${topic}/${topic}_test.cpp ${public}
    COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
    DEPENDS hidden_${topic} ${MUELLE_COURSE}/${manifest} ${MUELLE_COURSE}/${public}
    WORKING_DIRECTORY ${MUELLE_COURSE}
    COMMENT "Comparing criteria and tests of ${topic}"
    VERBATIM)
  add_custom_target(agreement_${topic} DEPENDS ${stamp})
  add_dependencies(${MUELLE_ALL_GRADING} agreement_${topic})
endfunction()

# Stops at a header that an author's file includes by an old name. CMake runs again when such a file changes.
function(muelle_refuse_old_includes topic)
  file(GLOB files ${CMAKE_SOURCE_DIR}/exercises/${topic}/${topic}.h ${CMAKE_SOURCE_DIR}/exercises/${topic}/public_test.cpp
       ${CMAKE_SOURCE_DIR}/exercises/${topic}/demo.cpp ${CMAKE_SOURCE_DIR}/tests/hidden/${topic}/*.cpp)
  set_property(DIRECTORY ${CMAKE_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
  muelle_old_include(old ${CMAKE_SOURCE_DIR} ${files})
  if(old)
    message(FATAL_ERROR " ${old}")  # the blank keeps CMake from breaking the line
  endif()
endfunction()

# CTest learns the criteria from the manifests, when they are read: no list of them is kept in CMake.
function(muelle_grade_tests)
  set(file ${CMAKE_BINARY_DIR}/grade_tests.cmake)
  file(GLOB manifests CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/exercises/*/exercise.toml)
  add_custom_command(OUTPUT ${file} COMMAND muelle-grade-step ctest-file ${file}
                     DEPENDS muelle-grade-step ${manifests} COMMENT "Listing the criteria for CTest" VERBATIM)
  add_custom_target(muelle_grade_tests ALL DEPENDS ${file})
  add_dependencies(muelle_grading muelle_grade_tests muelle-worker muelle-worker-asan muelle-confine muelle-grade-step
                   muelle_prelude)
  if(NOT EXISTS ${file})
    file(WRITE ${file} "")  # ctest reads it even before the first build
  endif()
  set_property(DIRECTORY ${CMAKE_SOURCE_DIR} APPEND PROPERTY TEST_INCLUDE_FILES ${file})
endfunction()
