#include "core/log/dialects/bag.h"

#include "core/log/bags/mcap.h"
#include "core/log/bags/rosbag1.h"
#include "core/log/bags/rosbag2.h"
#include "core/log/log_reader.h"

namespace mapbed {
namespace {

template <class Reader>
class BagReader : public LogReader {
 public:
  BagReader(const std::string& name, const LogOptions& options)
      : log_(name, options), reader_(log_) {}

  void add(std::string_view piece) override { reader_.add(piece); }
  RecordedLog finish() override {
    reader_.finish();
    return log_.finish(std::string(Reader::kFormat));
  }

 private:
  BagLog log_;
  Reader reader_;
};

template <class Reader>
LogDialect dialect_of(const char* name) {
  return {.name = name,
          .fits = [](const LogBeginning& beginning) { return Reader::fits(beginning.bytes); },
          .make_reader = [](const std::string& file,
                            const LogOptions& options) -> std::unique_ptr<LogReader> {
            return std::make_unique<BagReader<Reader>>(file, options);
          },
          .is_bag = true};
}

}  // namespace

LogDialect rosbag1_dialect() {
  return dialect_of<Rosbag1Reader>("bags of ROS 1");
}

LogDialect rosbag2_dialect() {
  return dialect_of<Rosbag2Reader>("bags of ROS 2");
}

LogDialect mcap_dialect() {
  return dialect_of<McapReader>("MCAP");
}

}  // namespace mapbed
