#pragma once

#include <string>

#include "core/geometry/triangle_mesh.h"

namespace mapbed {

// The shapes of a Wavefront OBJ file: its lines `v x y z` [m] and `f a b c …`, polygons as fans of
// triangles. Colours, normals and textures are left out. Throws InputError with file and line.
TriangleMesh load_obj(const std::string& path);

}  // namespace mapbed
