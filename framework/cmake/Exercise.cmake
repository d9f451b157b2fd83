# Everything that is built for an exercise: here what its students get, in framework/grader/Grading.cmake, where that is,
# what grades it. Exercises are found by their folders, so that a new one needs no edit here.

# Where the four folders of an exercise lie, and the targets that build all: a test has an exercise elsewhere.
set(MUELLE_COURSE ${CMAKE_SOURCE_DIR})
set(MUELLE_ALL_GRADING muelle_grading)

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
  target_link_libraries(${target} PRIVATE muelle_flags muelle_harness)
  target_include_directories(${target} PRIVATE ${MUELLE_COURSE}/exercises/${topic})
  target_compile_definitions(${target} PRIVATE MUELLE_FUNCTIONS_HEADER="${role}" ${MUELLE_FILL_DEFINE})
  target_compile_options(${target} PRIVATE ${MUELLE_LIGHT})
  muelle_define_paths(${target} MUELLE_EXERCISE_FOLDER ${MUELLE_COURSE}/exercises/${topic})
endfunction()

# For `muelle check`: the public tests and the demo, to be linked with the student's object file. A file lists
# the objects and libraries for the compiler driver, one a line as it is: a checkout's path may have blanks and quotes.
function(muelle_check_parts topic)
  if(NOT TARGET muelle_public_main)
    return()
  endif()
  set(folder ${MUELLE_COURSE}/exercises/${topic})
  muelle_role_library(public_test_${topic} ${topic} course/testing/direct_functions.h ${folder}/public_test.cpp)
  target_link_libraries(public_test_${topic} PRIVATE muelle_testing)
  muelle_role_library(demo_${topic} ${topic} course/testing/demo_functions.h ${folder}/demo.cpp)
  add_custom_target(public_${topic} DEPENDS public_test_${topic} demo_${topic})
  file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/check/${topic}.parts CONTENT
"$<JOIN:$<TARGET_OBJECTS:public_test_${topic}>,\n>
$<JOIN:$<TARGET_OBJECTS:demo_${topic}>,\n>
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

# Names the files that an exercise still lacks; an unfinished exercise is left out of the build, not in its way.
function(muelle_missing_files topic result)
  set(needed exercises/${topic}/exercise.toml exercises/${topic}/${topic}.h exercises/${topic}/${topic}.cpp
             exercises/${topic}/public_test.cpp exercises/${topic}/demo.cpp)
  if(TARGET muelle_grader)
    list(APPEND needed ${MUELLE_GRADING_NEEDS})
    string(REPLACE "@topic@" "${topic}" needed "${needed}")
  endif()
  set(missing "")
  foreach(file ${needed})
    if(NOT EXISTS ${CMAKE_SOURCE_DIR}/${file})
      list(APPEND missing ${file})
    endif()
  endforeach()
  set(${result} "${missing}" PARENT_SCOPE)
endfunction()

function(muelle_exercise topic)
  if(TARGET muelle_grader)
    muelle_refuse_old_includes(${topic})
  endif()
  muelle_missing_files(${topic} missing)
  if(missing)
    list(JOIN missing ", " missing)
    set_property(GLOBAL APPEND_STRING PROPERTY MUELLE_UNFINISHED "${topic}: ${missing}\n")
    add_custom_target(public_${topic})  # the launcher may ask for it
    return()
  endif()
  muelle_check_parts(${topic})
  if(TARGET public_${topic})
    add_dependencies(muelle_checking public_${topic})
  endif()
  if(TARGET muelle_grader)
    muelle_grading_parts(${topic})
  endif()
endfunction()

function(muelle_all_exercises)
  muelle_compile_one_by_one()
  muelle_prelude()
  # What the checks of all exercises share. The public tests of each are built where it is first checked.
  add_custom_target(muelle_check_base DEPENDS muelle_prelude muelle_public_main muelle_testing)
  add_custom_target(muelle_checking DEPENDS muelle_check_base)
  if(TARGET muelle_grader)
    add_custom_target(muelle_grading ALL)
  endif()
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
  set(MUELLE_TOPICS "" CACHE STRING "The exercises that are built; empty: all")
  foreach(topic ${topics})
    if(NOT MUELLE_TOPICS OR topic IN_LIST MUELLE_TOPICS)
      muelle_exercise(${topic})
    endif()
  endforeach()
  # The commands read what is left out, and say it.
  get_property(unfinished GLOBAL PROPERTY MUELLE_UNFINISHED)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/unfinished_exercises.txt CONTENT "${unfinished}")
  if(TARGET muelle_grader)
    muelle_grade_tests()
  endif()
endfunction()
