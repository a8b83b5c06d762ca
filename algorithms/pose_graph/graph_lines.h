#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "algorithms/pose_graph/pose_graph.h"
#include "core/file/tokens.h"
#include "core/input_error.h"

// Lines of graph files, read and written; see graph_file.h.

namespace mapbed {

struct GraphKind {
  bool is_edge = false;
  bool is_in_space = false;
  bool is_toro = false;
};

std::optional<GraphKind> graph_kind(std::string_view tag);  // none: of something else
std::string_view graph_tag(const GraphKind& kind);

// The next words of a line. Throw InputError where they are not what they should be.
std::int64_t read_id(Tokens& tokens, const SourceLocation& place);
template <class Pose>
Pose read_pose(const GraphKind& kind, Tokens& tokens, const SourceLocation& place);
template <class Pose>
PoseInformation<Pose> read_information(const GraphKind& kind, Tokens& tokens,
                                       const SourceLocation& place);
void check_line_end(Tokens& tokens, const SourceLocation& place);

// " x y theta" and the like.
template <class Pose>
std::string pose_words(const GraphKind& kind, const Pose& pose);
template <class Pose>
std::string information_words(const GraphKind& kind, const PoseInformation<Pose>& information);

}  // namespace mapbed
