#pragma once

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/input_error.h"

// The statement throws an InputError whose message has `part` in it and fits on one line.
#define EXPECT_INPUT_ERROR(statement, part)                                    \
  EXPECT_THAT([&] { static_cast<void>(statement); },                           \
              ::testing::ThrowsMessage<::mapbed::InputError>(::testing::AllOf( \
                  ::testing::HasSubstr(part), ::testing::Not(::testing::HasSubstr("\n")))))
