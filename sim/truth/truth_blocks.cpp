#include "sim/truth/truth_blocks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/check.h"
#include "sim/truth/columns.h"

namespace mapbed {
namespace {

constexpr double kRangeStep = 1e-6;     // [m]
constexpr double kFarthest = 2147.0;    // [m] what is farther is written as this
constexpr double kPositionStep = 1e-4;  // [m]
constexpr double kRotationStep = 1e-5;
constexpr std::int32_t kNothing = -1;  // range and indices where nothing was hit
constexpr std::size_t kMotions = 3;

using Column = std::vector<std::int32_t>;

std::int32_t steps(double value, double step) {
  const double count = std::round(value / step);
  CHECK(std::abs(count) <= std::numeric_limits<std::int32_t>::max());
  return static_cast<std::int32_t>(count);
}

// x, y, z of the position, then x, y, z, w of the rotation.
std::array<double, 7> coordinates_of(const Pose3& pose) {
  const Eigen::Vector3d& p = pose.position;
  const Eigen::Vector4d& q = pose.rotation.coeffs();
  return {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()};
}

double step_of(std::size_t coordinate) {
  return coordinate < 3 ? kPositionStep : kRotationStep;
}

// A number for each of `rows` things (outer) and each moment (inner).
template <class Value>
Column column(std::size_t rows, std::size_t moments, Value value) {
  Column numbers(rows * moments);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = 0; i < moments; ++i) numbers[row * moments + i] = value(row, i);
  }
  return numbers;
}

Column range_column(std::span<const BeamTruthOfScan> scans, std::size_t beams) {
  Column ranges = column(beams, scans.size(), [&](std::size_t k, std::size_t i) {
    const double range = scans[i].beams[k].range;
    return std::isfinite(range) ? steps(std::min(range, kFarthest), kRangeStep) : kNothing;
  });
  difference(ranges, scans.size());
  return ranges;
}

Column pose_columns(std::span<const StampedStates> states, std::size_t parts) {
  Column poses;
  for (std::size_t c = 0; c < 7; ++c) {
    const Column coordinate = column(parts, states.size(), [&](std::size_t part, std::size_t i) {
      return steps(coordinates_of(states[i].moving[part].world_from_part)[c], step_of(c));
    });
    poses.insert(poses.end(), coordinate.begin(), coordinate.end());
  }
  difference(poses, states.size());
  return poses;
}

// The poses of `parts` things (outer) at `moments` moments (inner); none where a rotation is none.
std::optional<std::vector<Pose3>> poses_in(ColumnReader& reader, std::size_t parts,
                                           std::size_t moments) {
  Column numbers = reader.planes(7 * parts * moments);
  if (!reader.ok()) return {};
  accumulate(numbers, moments);
  std::vector<Pose3> poses(parts * moments);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const auto value = [&](std::size_t c) { return step_of(c) * numbers[c * poses.size() + i]; };
    poses[i].position = {value(0), value(1), value(2)};
    poses[i].rotation.coeffs() = {value(3), value(4), value(5), value(6)};
    if (std::abs(poses[i].rotation.norm() - 1.0) > 1e-3) return {};
    poses[i].rotation.normalize();
  }
  return poses;
}

bool is_in_order(const std::vector<double>& times) {
  return std::all_of(times.begin(), times.end(), [](double t) { return std::isfinite(t); }) &&
         std::is_sorted(times.begin(), times.end());
}

bool is_index(std::int32_t index, std::size_t size) {
  return index >= 0 && static_cast<std::size_t>(index) < size;
}

bool is_part(std::int32_t entity, std::int32_t part, const TruthHeader& header) {
  return is_index(entity, header.entities.size()) &&
         is_index(part, header.entities[static_cast<std::size_t>(entity)].parts.size());
}

bool is_of_header(const BeamTruth& beam, const TruthHeader& header) {
  if (beam.entity == kNothing) return beam.part == kNothing && beam.material == kNothing;
  return is_part(beam.entity, beam.part, header) &&
         is_index(beam.material, header.materials.size());
}

}  // namespace

std::string bytes_of(std::span<const StampedStates> states) {
  const std::size_t n = states.size();
  CHECK(n > 0);
  const std::vector<MovingPose>& first = states[0].moving;
  const std::size_t m = first.size();
  std::array<std::vector<double>, 4> robot;
  for (const StampedStates& s : states) {
    const Pose2& p = s.world_from_robot;
    const std::array<double, 4> values{s.time, p.x, p.y, p.theta};
    for (std::size_t c = 0; c < 4; ++c) robot[c].push_back(values[c]);
  }

  std::string bytes;
  append_number(bytes, static_cast<std::uint32_t>(n));
  append_number(bytes, static_cast<std::uint32_t>(m));
  for (const std::vector<double>& values : robot) append_numbers(bytes, values);
  append_planes(bytes, column(m, 1, [&](auto part, auto) { return first[part].entity; }));
  append_planes(bytes, column(m, 1, [&](auto part, auto) { return first[part].part; }));
  append_planes(bytes, column(m, n, [&](auto part, auto i) {
                  return static_cast<std::int32_t>(states[i].moving[part].motion);
                }));
  append_planes(bytes, pose_columns(states, m));
  return bytes;
}

std::string bytes_of(std::span<const BeamTruthOfScan> scans) {
  const std::size_t n = scans.size();
  CHECK(n > 0);
  const std::size_t k = scans[0].beams.size();
  std::vector<double> times;
  for (const BeamTruthOfScan& scan : scans) times.push_back(scan.time);
  const auto of_beams = [&](auto number) {
    return column(k, n, [&](auto beam, auto i) {
      return static_cast<std::int32_t>(number(scans[i].beams[beam]));
    });
  };

  std::string bytes;
  append_number(bytes, static_cast<std::uint32_t>(n));
  append_number(bytes, static_cast<std::uint32_t>(k));
  append_number(bytes, static_cast<std::uint32_t>(scans[0].laser));
  append_numbers(bytes, times);
  append_planes(bytes, range_column(scans, k));
  append_planes(bytes, of_beams([](const BeamTruth& b) { return b.entity; }));
  append_planes(bytes, of_beams([](const BeamTruth& b) { return b.part; }));
  append_planes(bytes, of_beams([](const BeamTruth& b) { return b.material; }));
  append_planes(bytes, of_beams([](const BeamTruth& b) { return b.motion; }));
  return bytes;
}

std::string bytes_of(std::span<const TruthRead> reads) {
  std::vector<double> times;
  for (const TruthRead& read : reads) times.push_back(read.time);
  const auto of_reads = [&](auto number) {
    return column(1, reads.size(), [&](auto, auto i) { return number(reads[i]); });
  };
  std::string bytes;
  append_number(bytes, static_cast<std::uint32_t>(reads.size()));
  append_numbers(bytes, times);
  append_planes(bytes, of_reads([](const TruthRead& r) { return r.antenna; }));
  append_planes(bytes, of_reads([](const TruthRead& r) { return r.tag; }));
  append_planes(
      bytes, of_reads([](const TruthRead& r) { return static_cast<std::int32_t>(r.mechanism); }));
  return bytes;
}

std::optional<std::vector<StampedStates>> states_in(std::string_view bytes,
                                                    const TruthHeader& header) {
  ColumnReader reader(bytes);
  const std::size_t n = reader.number();
  const std::size_t m = reader.number();
  std::array<std::vector<double>, 4> robot;
  for (std::vector<double>& values : robot) values = reader.numbers(n);
  const Column entities = reader.planes(m);
  const Column parts = reader.planes(m);
  const Column motions = reader.planes(m * n);
  const std::optional<std::vector<Pose3>> poses = poses_in(reader, m, n);
  if (!poses || !reader.at_end() || !is_in_order(robot[0])) return {};
  for (std::size_t part = 0; part < m; ++part) {
    if (!is_part(entities[part], parts[part], header)) return {};
  }

  std::vector<StampedStates> states(n);
  for (std::size_t i = 0; i < n; ++i) {
    states[i].time = robot[0][i];
    states[i].world_from_robot = {robot[1][i], robot[2][i], robot[3][i]};
    if (!is_finite(states[i].world_from_robot)) return {};
    for (std::size_t part = 0; part < m; ++part) {
      const std::int32_t motion = motions[part * n + i];
      if (!is_index(motion, kMotions)) return {};
      states[i].moving.push_back(
          {entities[part], parts[part], (*poses)[part * n + i], static_cast<Motion>(motion)});
    }
  }
  return states;
}

std::optional<std::vector<BeamTruthOfScan>> beams_in(std::string_view bytes,
                                                     const TruthHeader& header) {
  ColumnReader reader(bytes);
  const std::size_t n = reader.number();
  const std::size_t k = reader.number();
  const auto laser = static_cast<int>(reader.number());
  const std::vector<double> times = reader.numbers(n);
  Column ranges = reader.planes(k * n);
  const Column entities = reader.planes(k * n);
  const Column parts = reader.planes(k * n);
  const Column materials = reader.planes(k * n);
  const Column motions = reader.planes(k * n);
  if (!reader.ok() || !reader.at_end() || !is_in_order(times) || laser < 0) return {};
  accumulate(ranges, n);

  std::vector<BeamTruthOfScan> scans(n);
  for (std::size_t i = 0; i < n; ++i) {
    scans[i].time = times[i];
    scans[i].laser = laser;
    scans[i].beams.resize(k);
    for (std::size_t b = 0; b < k; ++b) {
      const std::size_t at = b * n + i;
      const std::int32_t range = ranges[at];
      BeamTruth& beam = scans[i].beams[b];
      beam.range = range == kNothing ? std::numeric_limits<float>::infinity()
                                     : static_cast<float>(kRangeStep * range);
      beam.entity = entities[at];
      beam.part = parts[at];
      beam.material = materials[at];
      beam.motion = static_cast<Motion>(motions[at]);
      const bool makes_sense = range >= kNothing && is_index(motions[at], kMotions) &&
                               (range == kNothing) == (beam.entity == kNothing);
      if (!makes_sense || !is_of_header(beam, header)) return {};
    }
  }
  return scans;
}

std::optional<std::vector<TruthRead>> reads_in(std::string_view bytes, const TruthHeader& header) {
  constexpr std::size_t kMechanisms = 4;
  ColumnReader reader(bytes);
  const std::size_t n = reader.number();
  const std::vector<double> times = reader.numbers(n);
  const Column antennas = reader.planes(n);
  const Column tags = reader.planes(n);
  const Column mechanisms = reader.planes(n);
  if (!reader.ok() || !reader.at_end()) return {};
  std::vector<TruthRead> reads(n);
  for (std::size_t i = 0; i < n; ++i) {
    const bool makes_sense =
        std::isfinite(times[i]) && antennas[i] >= 0 && is_index(tags[i], header.tags.size()) &&
        is_index(mechanisms[i], kMechanisms) && (i == 0 || times[i] >= times[i - 1]);
    if (!makes_sense) return {};
    reads[i] = {times[i], antennas[i], tags[i], static_cast<ReadMechanism>(mechanisms[i])};
  }
  return reads;
}

}  // namespace mapbed
