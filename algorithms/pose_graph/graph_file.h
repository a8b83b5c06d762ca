#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "algorithms/pose_graph/pose_graph.h"
#include "core/config/option.h"

// Files of pose graphs, plain or gzipped, a line for each node or constraint:
//
//   g2o   VERTEX_SE2 id x y theta            EDGE_SE2 from to x y theta I11 I12 I13 I22 I23 I33
//         VERTEX_SE3:QUAT id x y z qx qy qz qw
//         EDGE_SE3:QUAT from to x y z qx qy qz qw I11 I12 … I66 (upper triangle by rows)
//         FIX id …
//   TORO  VERTEX2 id x y theta               EDGE2 from to x y theta Ixx Ixy Iyy Itt Ixt Iyt
//         VERTEX3 id x y z roll pitch yaw
//         EDGE3 from to x y z roll pitch yaw I11 I12 … I66 (the same, of angles)
//
// TORO's order of a plane's information entries is that of its own description of the format
// (openslam.org/toro; GTSAM's load2D reads it so too); that description calls the first id the
// observed one, all its files, and MRPT and GTSAM, have it as the one that observes.

namespace mapbed {

enum class GraphFormat : int { g2o, toro };

// Which constraints close a loop, so that they may be doubted.
enum class LoopRule : int {
  not_consecutive,  // those that do not join an id with the next
  all,
  none
};

struct GraphFileOptions {
  LoopRule loops = LoopRule::not_consecutive;
};

template <class Visitor>
void visit_fields(GraphFileOptions& o, Visitor&& visit) {
  visit("loops", o.loops, {"not_consecutive", "all", "none"},
        "which constraints may be doubted: those that do not join an id with the next one, all, or "
        "none");
}

using AnyPoseGraph = std::variant<PoseGraph<Pose2>, PoseGraph<Pose3>>;

struct GraphFile {
  AnyPoseGraph graph;             // nodes in the order of their ids
  std::vector<std::int64_t> ids;  // of the nodes
  bool has_poses = true;          // false: of edges alone; all nodes stand at the origin
  GraphFormat format = GraphFormat::g2o;
  std::vector<std::string> remarks;
};

// Throw InputError where it is no such file or a line of it makes no sense: numbers that are
// missing or not finite, a matrix that is no information matrix, nodes that no line tells the pose
// of, poses in the plane and in space in one file.
GraphFile load_graph(const std::string& path, const GraphFileOptions& options = {});
GraphFile parse_graph(const std::string& name, std::string_view text,
                      const GraphFileOptions& options = {});

// With all digits, so that what is read again is the same, in TORO's form but for rounding of
// angles in space.
std::string graph_text(const AnyPoseGraph& graph, const std::vector<std::int64_t>& ids,
                       GraphFormat format = GraphFormat::g2o);
// The same with the nodes' indices for ids, in g2o's form.
std::string graph_text(const PoseGraph<Pose2>& graph);
// TORO's form where the name ends in .toro, .graph or these and .gz, else g2o's.
GraphFormat format_for(std::string_view path);
void write_graph(const std::string& path, const AnyPoseGraph& graph,
                 const std::vector<std::int64_t>& ids);

}  // namespace mapbed
