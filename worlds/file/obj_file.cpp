#include "worlds/file/obj_file.h"

#include <cmath>
#include <vector>

#include "core/file/text_file.h"
#include "core/file/tokens.h"
#include "core/input_error.h"
#include "worlds/geometry/triangulate.h"

namespace mapbed {
namespace {

constexpr std::size_t kLargestFile = std::size_t{1} << 27;  // [bytes]
constexpr std::size_t kMostTriangles = 4'000'000;           // rays are cast against all of them

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

void add_face(TriangleMesh& mesh, const std::vector<std::uint32_t>& face,
              const SourceLocation& place) {
  std::vector<Eigen::Vector3d> corners;
  for (const std::uint32_t corner : face) corners.push_back(mesh.vertices[corner]);
  const auto triangles = triangulate_face(corners);
  if (!triangles) {
    throw InputError(place,
                     "the face crosses itself, or has more than " + std::to_string(kMostCorners) +
                         " corners and is not convex",
                     "list its corners in order, once round, or split it into triangles");
  }
  for (const auto& [a, b, c] : *triangles) mesh.triangles.push_back({face[a], face[b], face[c]});
  if (mesh.triangles.size() > kMostTriangles) {
    throw InputError(place,
                     "the mesh has more than " + std::to_string(kMostTriangles) + " triangles",
                     "simplify it in the program that made it");
  }
}

}  // namespace

TriangleMesh load_obj(const std::string& path) {
  return parse_obj(path, read_text_file(path, kLargestFile));
}

TriangleMesh parse_obj(const std::string& name, std::string_view text) {
  TriangleMesh mesh;
  std::string_view rest = text;
  for (long number = 1; !rest.empty(); ++number) {
    const SourceLocation place{name, number};
    std::string_view line = next_line(rest);
    const std::string_view keyword = next_word(line);
    if (keyword == "v") mesh.vertices.push_back(vertex(line, place));
    if (keyword == "f") add_face(mesh, face(line, mesh.vertices.size(), place), place);
  }
  if (mesh.triangles.empty())
    throw InputError({name}, "there is no face in it that covers anything");
  return mesh;
}

}  // namespace mapbed
