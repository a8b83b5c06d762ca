#pragma once

#include <mutex>
#include <string>
#include <vector>

#include "bench/results/results.h"

namespace mapbed {

// The runs that are done, a line each as soon as it is, so that a run of a scenario that is killed
// goes on where it was. Lines carry a checksum: one that was cut short does not count. The first
// line says which configuration and program the rows are of.
class Journal {
 public:
  struct Entry {
    RunRow row;  // without level and variant, which follow from its number
    CostRow cost;
  };

  // Opens or makes the file. Throws InputError where it is of another configuration or cannot be
  // written; `identity` is one word.
  Journal(const std::string& path, const std::string& identity, std::size_t metrics);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  const std::vector<Entry>& found() const { return found_; }  // from an earlier start
  void append(const Entry& entry);                            // for several threads

 private:
  void read(const std::string& text, const std::string& identity, std::size_t metrics);
  void write_line(const std::string& line);

  std::string path_;
  int file_ = -1;
  std::mutex mutex_;
  std::vector<Entry> found_;
};

}  // namespace mapbed
