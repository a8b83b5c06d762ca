#include "core/testing/throws_input_error.h"

#include <exception>
#include <string>

#include "core/input_error.h"

namespace mapbed {

::testing::AssertionResult throws_input_error(const std::function<void()>& statement,
                                              std::string_view part) {
  using ::testing::AssertionFailure;
  try {
    statement();
  } catch (const InputError& error) {
    const std::string message = error.what();
    if (message.find(part) == std::string::npos) {
      return AssertionFailure() << "says '" << message << "', not '" << part << "'";
    }
    if (message.find('\n') != std::string::npos) {
      return AssertionFailure() << "says more than one line: '" << message << "'";
    }
    return ::testing::AssertionSuccess();
  } catch (const std::exception& error) {
    return AssertionFailure() << "throws another error: '" << error.what() << "'";
  }
  return AssertionFailure() << "throws nothing";
}

}  // namespace mapbed
