#include "core/check.h"

#include <cstdio>
#include <cstdlib>

namespace mapbed {

void check_failed(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: CHECK(%s) failed; this is a bug in mapbed\n", file, line, condition);
  std::abort();
}

}  // namespace mapbed
