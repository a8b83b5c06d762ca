#pragma once

#include <string>

namespace mapbed {

// The root of the tree that the tests were built from, for tests that read its files. A function,
// so that one object file knows the path and all others are the same for every clone.
std::string source_tree();

}  // namespace mapbed
