#pragma once
/// \file
/// MUELLE_FOR_EACH(macro, a, b, c) expands to macro(a) macro(b) macro(c); up to 80 arguments.
/// MUELLE_FOR_EACH_WITH(macro, extra, a, b) expands to macro(extra, a) macro(extra, b).

#define MUELLE_PARENS ()
// The preprocessor expands one argument a scan; four to the third power and the scans between make 85.
#define MUELLE_EXPAND(...) MUELLE_EXPAND3(MUELLE_EXPAND3(MUELLE_EXPAND3(MUELLE_EXPAND3(__VA_ARGS__))))
#define MUELLE_EXPAND3(...) MUELLE_EXPAND2(MUELLE_EXPAND2(MUELLE_EXPAND2(MUELLE_EXPAND2(__VA_ARGS__))))
#define MUELLE_EXPAND2(...) MUELLE_EXPAND1(MUELLE_EXPAND1(MUELLE_EXPAND1(MUELLE_EXPAND1(__VA_ARGS__))))
#define MUELLE_EXPAND1(...) __VA_ARGS__

#define MUELLE_FOR_EACH(macro, ...) __VA_OPT__(MUELLE_EXPAND(MUELLE_FOR_EACH_STEP(macro, __VA_ARGS__)))
#define MUELLE_FOR_EACH_STEP(macro, first, ...) \
  macro(first) __VA_OPT__(MUELLE_FOR_EACH_AGAIN MUELLE_PARENS(macro, __VA_ARGS__))
#define MUELLE_FOR_EACH_AGAIN() MUELLE_FOR_EACH_STEP

#define MUELLE_FOR_EACH_WITH(macro, extra, ...) \
  __VA_OPT__(MUELLE_EXPAND(MUELLE_FOR_EACH_WITH_STEP(macro, extra, __VA_ARGS__)))
#define MUELLE_FOR_EACH_WITH_STEP(macro, extra, first, ...) \
  macro(extra, first) __VA_OPT__(MUELLE_FOR_EACH_WITH_AGAIN MUELLE_PARENS(macro, extra, __VA_ARGS__))
#define MUELLE_FOR_EACH_WITH_AGAIN() MUELLE_FOR_EACH_WITH_STEP
