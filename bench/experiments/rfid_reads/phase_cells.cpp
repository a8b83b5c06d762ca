#include "bench/experiments/rfid_reads/phase_cells.h"

#include <map>
#include <tuple>
#include <utility>

namespace mapbed {
namespace {

constexpr double kSpeedOfLight = 299'792'458.0;  // [m/s]

// The best shift of the cells that are chosen, beside what there is already.
template <class Chosen>
Eigen::Vector3d shift_of(const std::vector<PhaseCell>& cells, const PhaseShifts& shifts,
                         const Chosen& is_chosen, double reach, int turns) {
  std::vector<PhaseReading> readings;
  std::vector<Eigen::Vector3d> besides;
  for (const PhaseCell& cell : cells) {
    if (!is_chosen(cell)) continue;
    readings.push_back(cell.reading);
    besides.push_back(shifts.of(cell));
  }
  return best_shift(readings, besides, reach, turns);
}

}  // namespace

std::vector<PhaseCell> phase_cells(const PlacedReads& reads, int port, int turns) {
  struct Sum {
    std::complex<double> sum;
    double reads = 0.0;
  };
  std::map<std::tuple<int, double, int, int>, Sum> sums;
  for (const PlacedRead& read : reads.reads) {
    if (!read.frequency) continue;
    Sum& sum = sums[{read.antenna, *read.frequency, read.tag, read.place}];
    sum.sum += std::polar(1.0, turns * read.phase[static_cast<std::size_t>(port - 1)]);
    sum.reads += 1.0;
  }
  std::map<std::tuple<int, double, int>, int> channels;
  std::vector<PhaseCell> cells;
  for (const auto& [key, sum] : sums) {
    const auto [antenna, frequency, tag, place] = key;
    const int next = static_cast<int>(channels.size());
    PhaseCell cell{.place = place, .antenna = antenna, .tag = tag};
    cell.reading = {channels.try_emplace({antenna, frequency, tag}, next).first->second,
                    reads.places[static_cast<std::size_t>(place)], kSpeedOfLight / frequency,
                    sum.reads, sum.sum / sum.reads};
    cells.push_back(cell);
  }
  return cells;
}

PhaseShifts fitted_shifts(const std::vector<PhaseCell>& cells, int antennas, int tags,
                          const PhaseShiftOptions& options, int turns) {
  PhaseShifts shifts{
      std::vector<Eigen::Vector3d>(static_cast<std::size_t>(tags), Eigen::Vector3d::Zero()),
      std::vector<Eigen::Vector3d>(static_cast<std::size_t>(antennas), Eigen::Vector3d::Zero())};
  const int rounds = options.tags && options.antennas ? options.rounds : 1;
  for (int round = 0; round < rounds; ++round) {
    for (int antenna = 0; options.antennas && antenna < antennas; ++antenna) {
      Eigen::Vector3d& shift = shifts.antennas[static_cast<std::size_t>(antenna)];
      shift.setZero();
      shift = -shift_of(
          cells, shifts, [antenna](const PhaseCell& cell) { return cell.antenna == antenna; },
          options.reach, turns);
    }
    for (int tag = 0; options.tags && tag < tags; ++tag) {
      Eigen::Vector3d& shift = shifts.tags[static_cast<std::size_t>(tag)];
      shift.setZero();
      shift = shift_of(
          cells, shifts, [tag](const PhaseCell& cell) { return cell.tag == tag; }, options.reach,
          turns);
    }
  }
  return shifts;
}

}  // namespace mapbed
