#pragma once

#include <exception>
#include <string>

namespace mapbed {

// What a person is told of an exception: of an InputError its own message, of one that a library
// has thrown the place, the reason and a remedy in its stead ("vector::_M_default_append" means
// nothing to anybody).
std::string failure_text(const std::exception& error);

}  // namespace mapbed
