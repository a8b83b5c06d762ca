#pragma once

#include <cstdint>
#include <vector>

#include "algorithms/field/surface_map.h"
#include "algorithms/submaps/submap.h"
#include "core/config/option.h"

namespace mapbed {

struct SubmapEvidenceOptions {
  double unseen = 3.5;        // what a point costs where nobody looked before
  double contradicted = 5.4;  // where others looked through, or see a surface beside it
  double point_weight = 0.1;  // as points err alike
};

template <class Visitor>
void visit_fields(SubmapEvidenceOptions& o, Visitor&& visit) {
  visit("unseen", o.unseen, kNotNegative,
        "-ln p of a point where no local map looked before, against one on a known surface");
  visit("contradicted", o.contradicted, kNotNegative,
        "the same of a point that contradicts what was seen before");
  visit("point_weight", o.point_weight, between(1e-4, 1.0),
        "fraction with which each of 64 points counts, as they err alike");
}

// How likely is what a local map saw, given those before it and where all of them lie: the
// positive and the negative information of section 6.3.4. Of each 64 points count, and each by what
// explains it best: a surface that some map before has there (0); ground where nobody looked, so
// that a surface may stand there or not (-unseen, the density of a hit on a known surface over that
// of one anywhere within the laser's range); ground that was looked through, or where a surface was
// seen beside it (-contradicted). The same of points of maps before that this one looked through.
// Never positive, and 0 for a map that lies on itself.
class SubmapEvidence {
 public:
  explicit SubmapEvidence(const SubmapEvidenceOptions& options) : options_(options) {}

  void add(const Submap& submap);

  // Of a local map among those of lower number, map_from_submap of each in `poses`.
  double log_likelihood(int submap, const std::vector<Pose2>& poses);
  // What it costs where it shows a new place: whatever the last few maps before it do not explain
  // stands where nobody looked.
  double of_a_new_place(int submap, const std::vector<Pose2>& poses, int neighbours);
  // Of all of them, as many as there are poses.
  double log_likelihood(const std::vector<Pose2>& poses);

 private:
  // Which of its points lie on surfaces of another map, or against what that saw.
  struct Marks {
    std::uint64_t matched = 0, contradicted = 0;
    int looked_through = 0;  // points of the other that this one looked through
  };
  struct Known {  // of a local map
    Submap submap;
    SurfaceMap surfaces{kCell};
    std::vector<Eigen::Vector2d> points;
    std::vector<PointMotion> robots_from_submap;
    double radius = 0.0;  // [m] about its frame
  };
  struct Compared {
    Pose2 earlier_from_later;
    Marks marks;
  };
  static constexpr double kCell = 0.2;  // [m]
  static constexpr int kPoints = 64;

  static bool is_on_surface(const Known& known, const Eigen::Vector2d& point);
  static Marks compared(const Known& earlier, const Known& later, const Pose2& earlier_from_later);
  const Marks& marks_of(int earlier, int later, const Pose2& earlier_from_later);

  SubmapEvidenceOptions options_;
  std::vector<Known> known_;
  // The last few of each pair: by the later one, by the earlier one.
  std::vector<std::vector<std::vector<Compared>>> compared_;
};

}  // namespace mapbed
