#pragma once

// CHECK(condition): our own code is wrong where this fails. On in every build; ends the program
// with the place and the condition. Wrong input is not checked with this: it throws InputError.

namespace mapbed {
[[noreturn]] void check_failed(const char* condition, const char* file, int line);
}

#define CHECK(condition) \
  ((condition) ? static_cast<void>(0) : ::mapbed::check_failed(#condition, __FILE__, __LINE__))
