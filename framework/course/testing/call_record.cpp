#include "course/testing/call_record.h"

#include <utility>

namespace muelle {

namespace {

std::string& lastCallText() {
  static std::string text;
  return text;
}

}  // namespace

CallRecord*& CallRecord::current() {
  static CallRecord* record = nullptr;
  return record;
}

long& CallRecord::count() {
  static long calls = 0;
  return calls;
}

const std::string& CallRecord::lastCall() { return lastCallText(); }
void CallRecord::setLastCall(std::string call) { lastCallText() = std::move(call); }

std::string& CallRecord::neverWritten() {
  static std::string function;
  return function;
}

std::string& CallRecord::badQuestion() {
  static std::string text;
  return text;
}

bool& CallRecord::printsArguments() {
  static bool prints = true;
  return prints;
}

}  // namespace muelle
