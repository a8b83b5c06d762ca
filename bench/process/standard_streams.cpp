#include "bench/process/standard_streams.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <initializer_list>
#include <string>

#include <fcntl.h>
#include <unistd.h>

#include "core/input_error.h"

namespace mapbed {

// Each is open the wrong way round.
void reserve_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) >= 0) continue;
    (void)open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);  // the lowest free one
  }
}

void check_standard_output() {
  errno = 0;
  const bool is_written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (is_written) return;
  const std::string reason = errno != 0 ? std::string(": ") + std::strerror(errno) : "";
  throw InputError("standard output cannot be written completely" + reason +
                   "; is its disk full, or was it closed?");
}

}  // namespace mapbed
