#pragma once

namespace muelle::grader::worker {

/// Calls `action` once, when the dynamic loader has mapped the next shared object and before any code of it runs
/// (constructors, resolvers of indirect functions). Sets the breakpoint that the loader offers to debuggers: `r_brk` of
/// <link.h>, a function that does nothing, is made to jump here.
/// \param action must not throw and must not load anything
/// Throws std::runtime_error when this loader's function is not as expected.
void callWhenMapped(void (*action)());

/// True once the action has been called.
bool mappedActionCalled();

}  // namespace muelle::grader::worker
