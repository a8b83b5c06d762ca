#include "bench/process/version.h"

namespace mapbed {

std::string version_text() {
  const Version& v = version();
  std::string text = "mapbed " + v.program + " (revision " + v.revision + ", " + v.compiler + ", " +
                     v.build + ")\n";
  for (const LibraryVersion& library : v.libraries) {
    text += "  " + library.name + " " + library.version + "\n";
  }
  return text;
}

}  // namespace mapbed
