#include "core/testing/source_tree.h"

namespace mapbed {

std::string source_tree() {
  return MAPBED_SOURCE_DIR;
}

}  // namespace mapbed
