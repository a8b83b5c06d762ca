#pragma once

#include <functional>
#include <string_view>

#include <gtest/gtest.h>

namespace mapbed {

// Success where the statement throws an InputError whose message has `part` in it and fits on one
// line. A plain function: a matcher of a lambda is compiled anew for each one.
::testing::AssertionResult throws_input_error(const std::function<void()>& statement,
                                              std::string_view part);

}  // namespace mapbed

#define EXPECT_INPUT_ERROR(statement, part) \
  EXPECT_TRUE(::mapbed::throws_input_error([&] { static_cast<void>(statement); }, part))
