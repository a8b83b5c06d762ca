#pragma once

#include <mutex>
#include <string>
#include <vector>

#include <sys/types.h>

#include "bench/results/results.h"

namespace mapbed {

// The runs that are done, a line each as soon as it is, so that a run of a scenario that is killed
// goes on where it was. Lines carry a checksum: one that was cut short does not count. The first
// line says which configuration and program the rows are of.
//
// A kill loses the runs under way. A power cut may also lose what the system had not written yet,
// half a minute or so; `given` tells where a row got to the disk and its run's files did not.
class Journal {
 public:
  struct Entry {
    RunRow row;  // without level and variant, which follow from its number
    CostRow cost;
    std::string given = {};  // one word: checksum of all else that the run gave
  };

  // Opens or makes the file. Throws InputError where it is of another identity or cannot be
  // written.
  Journal(const std::string& path, const std::string& identity, std::size_t metrics);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  const std::vector<Entry>& found() const { return found_; }  // from an earlier start
  void append(const Entry& entry);                            // for several threads

  // One word for configuration and program; empty where no journal of that name begins.
  static std::string identity_of(const std::string& path);

  // What stands in a journal that another program may be writing on; nothing is changed.
  static std::vector<Entry> entries_of(const std::string& path, std::size_t metrics);

 private:
  void write_line(const std::string& line);

  std::string path_;
  int file_ = -1;
  off_t size_ = 0;  // [bytes] of whole lines
  std::mutex mutex_;
  std::vector<Entry> found_;
};

}  // namespace mapbed
