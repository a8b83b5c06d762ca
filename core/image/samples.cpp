#include "core/image/samples.h"

#include "core/file/text_file.h"
#include "core/image/pgm.h"
#include "core/image/png.h"
#include "core/input_error.h"

namespace mapbed {

Samples samples_from(std::string_view picture, const std::string& name) {
  if (picture.starts_with("\x89PNG")) return samples_from_png(picture, name);
  if (picture.starts_with("P2") || picture.starts_with("P5"))
    return samples_from_pgm(picture, name);
  throw InputError(SourceLocation{name}, "is neither a PNG nor a PGM picture", "convert it to one");
}

Samples read_samples(const std::string& path) {
  return samples_from(read_text_file(path), path);
}

}  // namespace mapbed
