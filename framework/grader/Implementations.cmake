# Submissions of earlier exercises, compiled into the hidden tests of one that judges them: those that
# tests/hidden/TOPIC/implementations.txt lists (framework/grader/testing/implementation.h says how).
#
# All of one corpus are one source, which the build writes: each is included inside a namespace of its own, after what
# any of them includes of the system and after the contract, which stands in a namespace of its corpus. So their
# symbols are kept apart, and Eigen is read once. A file that cannot be included so (it calls ::f, defines a macro that
# another one minds) is not listed.

# The functions that a contract names in MUELLE_FUNCTIONS(f, g).
function(muelle_contract_functions header result)
  file(READ ${header} text)
  string(REGEX MATCH "\nMUELLE_FUNCTIONS\\(([^)]*)\\)" found "${text}")
  string(REGEX REPLACE "[ \n]" "" names "${CMAKE_MATCH_1}")
  string(REPLACE "," ";" names "${names}")
  set(${result} "${names}" PARENT_SCOPE)
endfunction()

# The text that includes one submission; what it includes of the system is appended to `system`, and the contract's
# functions are declared first, so that any of them may call any other.
function(muelle_include_submission result exercise submission name)
  set(source ${MUELLE_COURSE}/tests/submissions/${exercise}/${submission}/${exercise}.cpp)
  if(NOT EXISTS ${source})
    message(FATAL_ERROR "${list}: there is no submission tests/submissions/${exercise}/${submission}")
  endif()
  set_property(DIRECTORY ${CMAKE_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
  file(STRINGS ${source} includes REGEX "^ *#include *<")
  set(declared "")
  foreach(function ${functions})
    string(APPEND declared "decltype(corpus::contract_${function}) ${function};\n")
  endforeach()
  set(${result} "namespace corpus::${name} {\n${declared}#include \"${source}\"\n}\n" PARENT_SCOPE)
  set(system ${system} ${includes} PARENT_SCOPE)
endfunction()

# Writes the source of one corpus. The list's lines of it follow, each as "submission|group|what is said of it".
function(muelle_implementations_source file exercise)
  set(contract ${MUELLE_COURSE}/exercises/${exercise}/${exercise}.h)
  muelle_contract_functions(${contract} functions)
  set(system "")
  set(bodies "")
  set(included "")
  set(lines 0)
  foreach(line ${ARGN})
    string(REGEX MATCH "^([^|]*)\\|([^|]*)\\|(.*)$" found "${line}")
    set(submission ${CMAKE_MATCH_1})
    set(group ${CMAKE_MATCH_2})
    set(says ${CMAKE_MATCH_3})
    string(MAKE_C_IDENTIFIER ${submission} name)
    if(NOT submission IN_LIST included)  # one may stand in several lines
      list(APPEND included ${submission})
      muelle_include_submission(body ${exercise} ${submission} ${name})
      string(APPEND bodies "${body}")
    endif()
    set(pairs "")
    foreach(function ${functions})
      string(APPEND pairs "    {\"${function}\", &corpus::${name}::${function}},\n")
    endforeach()
    math(EXPR lines "${lines} + 1")
    string(APPEND bodies "static const muelle::grader::ImplementationRegistration line${lines}(\n"
           "    \"${exercise}\", {\"${submission}\", \"${group}\", \"${says}\", {\n${pairs}}});\n\n")
  endforeach()
  list(REMOVE_DUPLICATES system)
  list(JOIN system "\n" system)
  # The contract's own declarations under other names: a call with one of its structs would find them, too.
  set(renamed "")
  set(restored "")
  foreach(function ${functions})
    string(APPEND renamed "#define ${function} contract_${function}\n")
    string(APPEND restored "#undef ${function}\n")
  endforeach()
  file(CONFIGURE OUTPUT ${file} @ONLY CONTENT
"// Made by the build (framework/grader/Implementations.cmake).
#include \"harness/exercise.h\"
#include \"grader/testing/implementation.h\"
${system}

namespace {
namespace corpus {
${renamed}#include \"${contract}\"
${restored}}

${bodies}}
")
endfunction()

# The corpora that the hidden tests of `topic` list, linked with them; nothing where they list none.
function(muelle_implementations topic)
  set(list ${MUELLE_COURSE}/tests/hidden/${topic}/implementations.txt)
  if(NOT EXISTS ${list})
    return()
  endif()
  set_property(DIRECTORY ${CMAKE_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list})
  file(STRINGS ${list} lines REGEX "^[a-z]")
  set(exercises "")
  foreach(line ${lines})
    if(NOT line MATCHES "^([a-z0-9_]+) +((right|wrong)/[a-z0-9_]+) +([a-z_]+) *([^;|\\\"[]*)$")
      message(FATAL_ERROR "${list}: no line of this list: ${line}")
    endif()
    list(APPEND exercises ${CMAKE_MATCH_1})
    list(APPEND lines_of_${CMAKE_MATCH_1} "${CMAKE_MATCH_2}|${CMAKE_MATCH_4}|${CMAKE_MATCH_5}")
  endforeach()
  list(REMOVE_DUPLICATES exercises)
  foreach(exercise ${exercises})
    set(target implementations_${topic}_${exercise})
    set(source ${CMAKE_BINARY_DIR}/generated/${target}.cpp)
    muelle_implementations_source(${source} ${exercise} ${lines_of_${exercise}})
    add_library(${target} OBJECT ${source})
    target_link_libraries(${target} PRIVATE muelle_flags muelle_harness)
    target_include_directories(${target} PRIVATE ${MUELLE_COURSE}/exercises/${exercise})
    # Submissions are left as their authors wrote them, warnings and all.
    target_compile_options(${target} PRIVATE ${MUELLE_LIGHT} -w)
    target_link_libraries(hidden_${topic} PRIVATE ${target})
  endforeach()
endfunction()
