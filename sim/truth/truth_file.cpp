#include "sim/truth/truth_file.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/check.h"
#include "core/file/file_reader.h"
#include "core/file/gzip_writer.h"
#include "sim/truth/columns.h"
#include "sim/truth/truth_blocks.h"
#include "sim/truth/truth_header.h"

namespace mapbed {
namespace {

constexpr std::string_view kStates = "STAT";
constexpr std::string_view kBeams = "BEAM";
constexpr std::string_view kReads = "READ";
constexpr std::string_view kEnd = "END ";

// A block holds enough for gzip to find what repeats, and little enough for memory.
constexpr std::size_t kMostMoments = 256;
constexpr std::size_t kMostReads = 16'384;  // in a block
constexpr std::size_t kMostNumbers = std::size_t{1} << 22;
constexpr std::size_t kLongestBlock = std::size_t{1} << 26;  // [bytes]
constexpr std::size_t kLongestLine = std::size_t{1} << 16;   // [bytes]

bool have_same_parts(const StampedStates& a, const StampedStates& b) {
  return std::equal(a.moving.begin(), a.moving.end(), b.moving.begin(), b.moving.end(),
                    [](const MovingPose& p, const MovingPose& q) {
                      return p.entity == q.entity && p.part == q.part;
                    });
}

// A file as a row of lines, then of blocks.
class Input {
 public:
  explicit Input(const std::string& path) : path_(path), file_(path) {}

  TruthHeader header() {
    TruthHeaderReader lines(path_);
    std::string line;
    for (;;) {
      const std::string_view more = piece().substr(0, kLongestLine);
      const std::size_t end = more.find('\n');
      line += take(end == std::string_view::npos ? more.size() : end + 1);
      const bool is_whole = line.ends_with('\n');
      if (!is_whole && !more.empty() && line.size() < kLongestLine) continue;
      if (is_whole) line.pop_back();
      if (lines.take(line, is_whole)) return std::move(lines.header);
      line.clear();
    }
  }

  struct Block {
    std::string name;
    std::string bytes;
  };
  Block block() {
    ++count_;
    begin_ = offset_;
    const std::string head = read(8);
    const std::size_t length = ColumnReader(std::string_view(head).substr(4)).number();
    if (length > kLongestBlock) fail("is too long");
    return {head.substr(0, 4), read(length)};
  }

  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError({path_}, fmt::format("block {} at byte {} {}", count_, begin_, reason),
                     "copy the file again, or record it again with 'mapbed simulate'");
  }

  void expect_end() {
    if (!piece().empty()) fail("is followed by more");
  }

 private:
  // What is left of the present piece of the file; empty at its end.
  std::string_view piece() {
    if (piece_.empty()) piece_ = file_.next();
    return piece_;
  }

  std::string_view take(std::size_t count) {
    const std::string_view taken = piece().substr(0, count);
    piece_.remove_prefix(taken.size());
    offset_ += taken.size();
    return taken;
  }

  std::string read(std::size_t count) {
    std::string bytes;
    bytes.reserve(std::min(count, kMostNumbers));
    while (bytes.size() < count) {
      const std::string_view more = take(count - bytes.size());
      if (more.empty()) fail("is cut short");
      bytes += more;
    }
    return bytes;
  }

  std::string path_;
  FileReader file_;
  std::string_view piece_;
  std::size_t offset_ = 0;  // of the unpacked file
  std::size_t begin_ = 0;   // of the block
  int count_ = 0;           // of blocks
};

}  // namespace

struct TruthWriter::State {
  explicit State(const std::string& path) : file(path) {}

  void write_block(std::string_view name, std::string_view bytes) {
    CHECK(name.size() == 4 && bytes.size() <= kLongestBlock);
    std::string head(name);
    append_number(head, static_cast<std::uint32_t>(bytes.size()));
    file.write(head);
    file.write(bytes);
  }
  template <class Item>
  void flush(std::string_view name, std::vector<Item>& items) {
    if (items.empty()) return;
    write_block(name, bytes_of(std::span<const Item>(items)));
    items.clear();
  }
  // `numbers` of one item; a block is closed where it is full, or where `fits` says so.
  template <class Item>
  void add(std::string_view name, std::vector<Item>& items, const Item& item, std::size_t numbers,
           bool fits) {
    const bool is_full = items.size() >= kMostMoments || items.size() * numbers >= kMostNumbers;
    if (is_full || !fits) flush(name, items);
    items.push_back(item);
  }

  GzipWriter file;
  std::vector<StampedStates> states;
  std::map<int, std::vector<BeamTruthOfScan>> beams;  // of each laser
  std::vector<TruthRead> reads;
};

TruthWriter::TruthWriter(const std::string& path, const TruthHeader& header)
    : state_(std::make_unique<State>(path)) {
  state_->file.write(header_text(header));
}

TruthWriter::~TruthWriter() = default;

void TruthWriter::add(const StampedStates& states) {
  std::vector<StampedStates>& items = state_->states;
  const bool fits = items.empty() || have_same_parts(items.front(), states);
  state_->add(kStates, items, states, 8 * states.moving.size(), fits);
}

void TruthWriter::add(const BeamTruthOfScan& beams) {
  std::vector<BeamTruthOfScan>& items = state_->beams[beams.laser];
  const bool fits = items.empty() || items.front().beams.size() == beams.beams.size();
  state_->add(kBeams, items, beams, 5 * beams.beams.size(), fits);
}

void TruthWriter::add(const TruthRead& read) {
  if (state_->reads.size() >= kMostReads) state_->flush(kReads, state_->reads);
  state_->reads.push_back(read);
}

void TruthWriter::finish() {
  state_->flush(kStates, state_->states);
  for (auto& [laser, items] : state_->beams) state_->flush(kBeams, items);
  state_->flush(kReads, state_->reads);
  state_->write_block(kEnd, {});
  state_->file.commit();
}

void read_truth(const std::string& path, const TruthSink& sink) {
  Input input(path);
  const TruthHeader header = input.header();
  if (sink.header) sink.header(header);
  for (;;) {
    const Input::Block block = input.block();
    const auto hand_on = [&](auto items, const auto& take) {
      if (!items) input.fail("(" + block.name + ") is damaged");
      for (auto& item : *items) {
        if (take) take(std::move(item));
      }
    };
    if (block.name == kStates) hand_on(states_in(block.bytes, header), sink.states);
    if (block.name == kBeams) hand_on(beams_in(block.bytes, header), sink.beams);
    if (block.name == kReads) hand_on(reads_in(block.bytes, header), sink.reads);
    if (block.name != kEnd) continue;
    if (!block.bytes.empty()) input.fail("is damaged");
    return input.expect_end();
  }
}

Truth load_truth(const std::string& path, std::size_t max_bytes) {
  Truth truth;
  std::size_t memory = 0;
  const auto keep = [&](auto& list, auto&& item, std::size_t bytes) {
    memory += 3 * sizeof item + bytes;  // a list takes up to so much while it grows
    if (memory > max_bytes) {
      throw InputError(
          {path},
          fmt::format("takes more than {:.3g} GB of memory", static_cast<double>(max_bytes) / 1e9),
          "is it a truth file of a drive?");
    }
    list.push_back(std::move(item));
  };
  read_truth(
      path,
      {.header = [&](const TruthHeader& header) { static_cast<TruthHeader&>(truth) = header; },
       .states =
           [&](StampedStates&& s) { keep(truth.states, s, s.moving.size() * sizeof(MovingPose)); },
       .beams =
           [&](BeamTruthOfScan&& b) { keep(truth.beams, b, b.beams.size() * sizeof(BeamTruth)); },
       .reads = [&](TruthRead&& r) { keep(truth.reads, r, 0); }});
  // Each laser has blocks of its own.
  std::stable_sort(truth.beams.begin(), truth.beams.end(),
                   [](const BeamTruthOfScan& a, const BeamTruthOfScan& b) {
                     return a.time < b.time || (a.time == b.time && a.laser < b.laser);
                   });
  return truth;
}

void write_truth(const std::string& path, const Truth& truth) {
  TruthWriter writer(path, truth);
  for (const StampedStates& states : truth.states) writer.add(states);
  for (const BeamTruthOfScan& beams : truth.beams) writer.add(beams);
  for (const TruthRead& read : truth.reads) writer.add(read);
  writer.finish();
}

}  // namespace mapbed
