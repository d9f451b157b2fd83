#pragma once
#include <functional>
#include <memory>
#include <utility>

namespace muelle {

/// Whose functions a demo calls.
enum class DemoOf { Submission, Oracle };

/// Has the demo call these from now on; in the beginning they are the submission's.
void setDemoOf(DemoOf whose);

/// \param function a std::function of the signature that the contract gives to this name
void bindToDemo(DemoOf whose, const char* name, std::shared_ptr<const void> function);

/// The std::function that a demo calls by this name. Throws std::logic_error when there is none.
const void* boundToDemo(const char* name);

/// Binds a function for as long as the program runs.
template <class Signature>
struct DemoBinding {
  [[gnu::noinline]] DemoBinding(DemoOf whose, const char* name, std::function<Signature> function) {
    bindToDemo(whose, name, std::make_shared<const std::function<Signature>>(std::move(function)));
  }
};

}  // namespace muelle
