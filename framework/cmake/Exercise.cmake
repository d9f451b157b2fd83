# Everything that is built for an exercise. Exercises are found by their folders, so that a new one needs no edit here.

include(${CMAKE_CURRENT_LIST_DIR}/OldIncludes.cmake)

# The precompiled header of the students' files: Eigen/Core and the harness's exercise.h, with the students' own flags.
function(muelle_prelude)
  set(header ${CMAKE_SOURCE_DIR}/framework/harness/exercise.h)
  set(product ${CMAKE_BINARY_DIR}/prelude/prelude.h.gch)
  set(wrapper ${CMAKE_BINARY_DIR}/prelude/prelude.h)  # a name that no source includes: a .gch is used once only
  file(CONFIGURE OUTPUT ${wrapper} CONTENT "#include \"harness/exercise.h\"\n")
  add_custom_command(
    OUTPUT ${product}
    COMMAND ${CMAKE_CXX_COMPILER} ${MUELLE_STUDENT_FLAGS} -I${CMAKE_SOURCE_DIR}/framework
            -isystem ${MUELLE_EIGEN_INCLUDE} -x c++-header ${wrapper} -o ${product}
    DEPENDS ${header} ${CMAKE_SOURCE_DIR}/framework/harness/types.h
            ${CMAKE_SOURCE_DIR}/framework/harness/eigen_assertion.h
            ${CMAKE_SOURCE_DIR}/framework/harness/eigen_fill.h
    COMMENT "Precompiling Eigen and the harness for students' files"
    VERBATIM)
  add_custom_target(muelle_prelude ALL DEPENDS ${product})
endfunction()

# A source compiled with one meaning of MUELLE_FUNCTIONS.
function(muelle_role_library target topic role)
  add_library(${target} OBJECT ${ARGN})
  target_link_libraries(${target} PRIVATE muelle_flags muelle_harness muelle_testing)
  target_include_directories(${target} PRIVATE ${CMAKE_SOURCE_DIR}/exercises/${topic})
  target_compile_definitions(${target} PRIVATE MUELLE_FUNCTIONS_HEADER="${role}" ${MUELLE_FILL_DEFINE})
  target_compile_options(${target} PRIVATE ${MUELLE_LIGHT})
  muelle_define_paths(${target} MUELLE_EXERCISE_FOLDER ${CMAKE_SOURCE_DIR}/exercises/${topic})
endfunction()

# For `muelle check`: the public tests and the demo, to be linked with the student's object file. A file lists
# the objects and libraries for the compiler driver, one a line as it is: a checkout's path may have blanks and quotes.
function(muelle_check_parts topic)
  if(NOT TARGET muelle_public_main)
    return()
  endif()
  set(folder ${CMAKE_SOURCE_DIR}/exercises/${topic})
  muelle_role_library(public_${topic} ${topic} course/testing/direct_functions.h
                      ${folder}/public_test.cpp ${folder}/demo.cpp)
  file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/check/${topic}.parts CONTENT
"$<JOIN:$<TARGET_OBJECTS:public_${topic}>,\n>
$<JOIN:$<TARGET_OBJECTS:muelle_public_main>,\n>
$<TARGET_FILE:muelle_testing>
$<TARGET_FILE:muelle_check>
$<TARGET_FILE:muelle_figures>
$<TARGET_FILE:muelle_harness>
$<TARGET_FILE:muelle_base>
$<TARGET_FILE:GTest::gtest>
$<TARGET_FILE:fmt::fmt>
${MUELLE_UTF8PROC_LIBRARY}
-pthread
${MUELLE_SANITIZER_LINK_FLAG}
")
endfunction()

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
  file(STRINGS ${source} includes REGEX "^#include \"engine/")
  if(includes)
    target_link_libraries(${target} PRIVATE muelle_engine)
  endif()
endfunction()

# For the grader: the worker's trusted half, and the hidden tests with the demo compiled for the submission (through
# the worker) and for the oracle.
function(muelle_grading_parts topic)
  set(folder ${CMAKE_SOURCE_DIR}/exercises/${topic})
  set(hidden ${CMAKE_SOURCE_DIR}/tests/hidden/${topic})

  add_library(glue_${topic} STATIC ${CMAKE_SOURCE_DIR}/framework/grader/worker/glue.cpp
                                   $<TARGET_OBJECTS:muelle_worker_codec>)
  target_link_libraries(glue_${topic} PRIVATE muelle_plain_flags Eigen3::Eigen)
  target_include_directories(glue_${topic} PRIVATE ${folder})
  target_compile_definitions(glue_${topic} PRIVATE MUELLE_CONTRACT="${topic}.h"
                             MUELLE_FUNCTIONS_HEADER="grader/worker/dispatch_functions.h" ${MUELLE_FILL_DEFINE})
  set_target_properties(glue_${topic} PROPERTIES ARCHIVE_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)

  muelle_reference(${topic})
  muelle_role_library(reference_demo_${topic} ${topic} grader/remote/oracle_functions.h ${folder}/demo.cpp)
  target_compile_definitions(reference_demo_${topic} PRIVATE MUELLE_DEMO_NAME=muelleReferenceDemo)

  add_executable(hidden_${topic} ${hidden}/${topic}_test.cpp ${hidden}/oracle.cpp ${hidden}/mistakes.cpp
                                 ${folder}/demo.cpp)
  target_link_libraries(hidden_${topic} PRIVATE reference_demo_${topic} muelle_hidden_main)
  muelle_link_engine_if_asked(hidden_${topic} ${hidden}/${topic}_test.cpp)
  target_include_directories(hidden_${topic} PRIVATE ${folder})
  target_compile_options(hidden_${topic} PRIVATE ${MUELLE_LIGHT})
  muelle_define_paths(hidden_${topic} MUELLE_EXERCISE_FOLDER ${folder})
  target_compile_definitions(hidden_${topic} PRIVATE
                             MUELLE_FUNCTIONS_HEADER="grader/remote/remote_functions.h")
  # Calls to the worker are templates of some size: compiled once, beside the history of calls that mistakes read.
  set_source_files_properties(${hidden}/mistakes.cpp TARGET_DIRECTORY hidden_${topic}
                              PROPERTIES COMPILE_DEFINITIONS MUELLE_REMOTE_CALLS_HERE)
  set_source_files_properties(${hidden}/${topic}_test.cpp ${hidden}/oracle.cpp ${folder}/demo.cpp TARGET_DIRECTORY hidden_${topic}
                              PROPERTIES COMPILE_DEFINITIONS MUELLE_REMOTE_CALLS_ELSEWHERE)
  set_target_properties(hidden_${topic} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/hidden)
  add_dependencies(muelle_grading hidden_${topic} glue_${topic})
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
    DEPENDS hidden_${topic} ${CMAKE_SOURCE_DIR}/${manifest} ${CMAKE_SOURCE_DIR}/${public}
    WORKING_DIRECTORY ${CMAKE_SOURCE_DIR}
    COMMENT "Comparing criteria and tests of ${topic}"
    VERBATIM)
  add_custom_target(agreement_${topic} DEPENDS ${stamp})
  add_dependencies(muelle_grading agreement_${topic})
endfunction()

# Names the files that an exercise still lacks; an unfinished exercise is left out of the build, not in its way.
function(muelle_missing_files topic result)
  set(needed exercises/${topic}/exercise.toml exercises/${topic}/${topic}.h exercises/${topic}/${topic}.cpp
             exercises/${topic}/public_test.cpp exercises/${topic}/demo.cpp)
  if(TARGET muelle_grader)
    list(APPEND needed tests/hidden/${topic}/${topic}_test.cpp tests/hidden/${topic}/oracle.cpp
                       tests/hidden/${topic}/mistakes.cpp)
  endif()
  set(missing "")
  foreach(file ${needed})
    if(NOT EXISTS ${CMAKE_SOURCE_DIR}/${file})
      list(APPEND missing ${file})
    endif()
  endforeach()
  set(${result} "${missing}" PARENT_SCOPE)
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

function(muelle_exercise topic)
  muelle_refuse_old_includes(${topic})
  muelle_missing_files(${topic} missing)
  if(missing)
    list(JOIN missing ", " missing)
    set_property(GLOBAL APPEND_STRING PROPERTY MUELLE_UNFINISHED "${topic}: ${missing}\n")
    return()
  endif()
  muelle_check_parts(${topic})
  if(TARGET public_${topic})
    add_dependencies(muelle_checking public_${topic} muelle_public_main muelle_testing)
  endif()
  if(TARGET muelle_grader)
    muelle_grading_parts(${topic})
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

function(muelle_all_exercises)
  muelle_compile_one_by_one()
  muelle_prelude()
  add_custom_target(muelle_checking DEPENDS muelle_prelude)
  add_custom_target(muelle_grading ALL)
  # Every file that makes an exercise complete, so that CMake runs again when one comes or goes.
  file(GLOB files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/exercises/*/*.toml ${CMAKE_SOURCE_DIR}/exercises/*/*.h
       ${CMAKE_SOURCE_DIR}/exercises/*/*.cpp ${CMAKE_SOURCE_DIR}/tests/hidden/*/*.cpp)
  set(topics "")
  foreach(file ${files})
    get_filename_component(folder ${file} DIRECTORY)
    get_filename_component(topic ${folder} NAME)
    list(APPEND topics ${topic})
  endforeach()
  list(REMOVE_DUPLICATES topics)
  foreach(topic ${topics})
    muelle_exercise(${topic})
  endforeach()
  # The commands read what is left out, and say it.
  get_property(unfinished GLOBAL PROPERTY MUELLE_UNFINISHED)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/unfinished_exercises.txt CONTENT "${unfinished}")
  if(TARGET muelle_grader)
    muelle_grade_tests()
  endif()
endfunction()
