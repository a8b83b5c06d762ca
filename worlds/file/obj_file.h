#pragma once

#include <string>
#include <string_view>

#include "core/geometry/triangle_mesh.h"

namespace mapbed {

// The shapes of a Wavefront OBJ file: its lines `v x y z` [m] and `f a b c …`, polygons that are
// convex or not. Faces that cover nothing are left out, as are colours, normals and textures.
// Throws InputError with file and line, also for a face that crosses itself.
TriangleMesh load_obj(const std::string& path);
TriangleMesh parse_obj(const std::string& name, std::string_view text);

}  // namespace mapbed
