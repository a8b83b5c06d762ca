#include "worlds/file/obj_file.h"

#include <cmath>
#include <vector>

#include "core/file/text_file.h"
#include "core/file/tokens.h"
#include "core/input_error.h"

namespace mapbed {
namespace {

Eigen::Vector3d vertex(std::string_view line, const SourceLocation& place) {
  Eigen::Vector3d result;
  for (int axis = 0; axis < 3; ++axis) {
    if (!parse_number(next_word(line), result[axis]) || std::abs(result[axis]) > 1e6) {
      throw InputError(place, "a vertex needs three numbers below 1e6", "write 'v x y z'");
    }
  }
  return result;
}

// Corners as indices from 1, or from the last vertex backwards; what follows a '/' is left out.
std::vector<std::uint32_t> face(std::string_view line, std::size_t vertices,
                                const SourceLocation& place) {
  std::vector<std::uint32_t> corners;
  for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
    double index = 0.0;
    const bool is_number = parse_number(word.substr(0, word.find('/')), index);
    if (index < 0.0) index += static_cast<double>(vertices) + 1.0;
    if (!is_number || index != std::floor(index) || index < 1.0 ||
        index > static_cast<double>(vertices)) {
      throw InputError(place, "face corner " + in_quotes(word) + " names no vertex above it",
                       "vertices are counted from 1");
    }
    corners.push_back(static_cast<std::uint32_t>(index) - 1);
  }
  if (corners.size() < 3) throw InputError(place, "a face needs three corners", "write 'f 1 2 3'");
  return corners;
}

}  // namespace

TriangleMesh load_obj(const std::string& path) {
  const std::string text = read_text_file(path);
  TriangleMesh mesh;
  std::string_view rest = text;
  for (long number = 1; !rest.empty(); ++number) {
    const SourceLocation place{path, number};
    std::string_view line = next_line(rest);
    const std::string_view keyword = next_word(line);
    if (keyword == "v") mesh.vertices.push_back(vertex(line, place));
    if (keyword == "f") {
      const std::vector<std::uint32_t> corners = face(line, mesh.vertices.size(), place);
      for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        mesh.triangles.push_back({corners[0], corners[i], corners[i + 1]});
      }
    }
  }
  if (mesh.triangles.empty()) throw InputError({path}, "there is no face in it");
  return mesh;
}

}  // namespace mapbed
