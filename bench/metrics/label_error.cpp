#include "bench/metrics/label_error.h"

#include <cmath>
#include <limits>

#include "core/check.h"

namespace mapbed {
namespace {

double fraction_of(long part, long whole) {
  if (whole == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(part) / static_cast<double>(whole);
}

void count(bool is_dynamic, LabelCounts& counts) {
  ++counts.beams;
  if (is_dynamic) ++counts.dynamic;
}

void count(bool is_dynamic, const BeamCause& cause, LabelErrors& errors) {
  switch (cause.cause) {
    case Cause::none:
      return;
    case Cause::place:
      count(is_dynamic, errors.place);
      count(is_dynamic, errors.of_place[cause.entity]);
      break;
    case Cause::resting:
      count(is_dynamic, errors.resting);
      break;
    case Cause::moving:
      count(is_dynamic, errors.moving);
      break;
    case Cause::waiting:
      count(is_dynamic, errors.waiting);
      break;
  }
  count(is_dynamic, errors.by_kind[{cause.kind, cause.cause}]);
}

}  // namespace

double LabelCounts::fraction() const {
  return fraction_of(dynamic, beams);
}

LabelCounts LabelErrors::of_movers(EntityKind kind) const {
  LabelCounts sum;
  for (const Cause cause : {Cause::moving, Cause::waiting}) {
    const auto found = by_kind.find({kind, cause});
    if (found == by_kind.end()) continue;
    sum.beams += found->second.beams;
    sum.dynamic += found->second.dynamic;
  }
  return sum;
}

double LabelErrors::precision() const {
  const long right = moving.dynamic + waiting.dynamic;
  return fraction_of(right, right + place.dynamic);
}

double LabelErrors::recall() const {
  return fraction_of(moving.dynamic + waiting.dynamic, moving.beams + waiting.beams);
}

double LabelErrors::static_accuracy() const {
  return 1.0 - place.fraction();
}

double LabelErrors::associated_accuracy() const {
  return std::sqrt(static_accuracy() * dynamic_accuracy());
}

LabelErrors label_errors(const BeamLabels& labels, const SensorLog& log, const TrueCauses& causes) {
  LabelErrors errors;
  auto next = labels.begin();
  for (const Measurement& measurement : log) {
    if (next == labels.end()) break;
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr || scan->time != next->time || scan->laser != next->laser) continue;
    const std::vector<float>& of_scan = next->static_probability;
    CHECK(of_scan.size() == scan->ranges.size());
    const std::vector<BeamCause> of_beams = causes.of(*scan);
    for (std::size_t n = 0; n < of_scan.size(); ++n) {
      if (!std::isnan(of_scan[n])) count(is_dynamic(of_scan[n]), of_beams[n], errors);
    }
    ++next;
  }
  CHECK(next == labels.end());
  return errors;
}

}  // namespace mapbed
