# Headers that an author's exercise may still include by the name that they had: the build stops with one line that
# names what has taken its place. The one list of them; the old names lead nowhere else.

set(MUELLE_OLD_INCLUDES
    "harness/simulate.h|harness/march.h (march() of step functions)"
    "harness/integrator.h|harness/march.h (march() takes a step function)"
    "harness/testing/expect.h|course/testing/expect.h"
    "harness/testing/random.h|course/testing/random.h"
    "harness/testing/call_record.h|course/testing/call_record.h"
    "harness/testing/print_value.h|course/testing/print_value.h"
    "harness/testing/struct_fields.h|course/testing/struct_fields.h"
    "harness/testing/direct_functions.h|course/testing/direct_functions.h"
    "harness/file.h|base/file.h"
    "harness/text/nearest.h|base/text/nearest.h"
    "harness/text/printable.h|base/text/printable.h"
    "harness/course/manifest.h|course/manifest.h"
    "harness/figure_script.h|harness/figure.h (a demo returns figures, and draws none)"
    "harness/figure_data.h|harness/figure.h (a demo returns figures, and draws none)"
    "harness/gnuplot.h|harness/figure.h (a demo returns figures, and draws none)"
    "grader/remote/mistakes.h|grader/testing/mistakes.h"
    "grader/remote/call_history.h|grader/testing/call_history.h"
    "engine/method.h|engine/integrator.h"
    "engine/system.h|engine/dynamical_system.h"
    "engine/scene/run_scene.h|lab/run/run_scene.h"
    "engine/scene/scene_figures.h|lab/run/scene_figures.h")

# Sets `result` to `FILE: #include "OLD" is now NEW` for the first old header that one of the files includes, else to "".
# FILE is relative to `base`.
function(muelle_old_include result base)
  set(${result} "" PARENT_SCOPE)
  foreach(file ${ARGN})
    file(STRINGS ${file} lines REGEX "^[ \t]*#[ \t]*include[ \t]*[\"<]")
    foreach(line IN LISTS lines)
      if(NOT line MATCHES "[\"<]([^\">]+)[\">]")
        continue()
      endif()
      set(header ${CMAKE_MATCH_1})
      foreach(entry IN LISTS MUELLE_OLD_INCLUDES)
        string(REPLACE "|" ";" names "${entry}")
        list(GET names 0 old)
        list(GET names 1 new)
        if(header STREQUAL old)
          file(RELATIVE_PATH place ${base} ${file})
          set(${result} "${place}: #include \"${old}\" is now ${new}" PARENT_SCOPE)
          return()
        endif()
      endforeach()
    endforeach()
  endforeach()
endfunction()
