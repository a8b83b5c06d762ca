#pragma once

#include <string>
#include <vector>

#include "bench/results/result_file.h"
#include "bench/results/results.h"

namespace mapbed {

// How a finished result takes the place of the older one of its folder, as a whole: what comes is
// made below .publication/ and synced to the disk, and then listed there, with what goes. Up to
// that list the older result stands as it was. From it on the new one takes its place, whatever
// stops the program on the way: the next one in the folder goes on. In between there is no
// config.yaml, so that nobody takes a part of each for a result. What no result lists stays.
class Publication {
 public:
  // What differs from what the folder has is made, and waits. `staging`, below the folder, has the
  // files that the results list below files/, and goes in the end; empty: they are in place
  // already. `page` is the results' report.html; where there is none, one of other results goes.
  // The folder is locked, and nothing is being published. Throws InputError where it cannot be
  // written.
  Publication(const std::string& folder, const Results& results, const std::string& staging = "",
              const std::string& page = "");

  // Files with content that are no result's, as the pages over many results.
  Publication(const std::string& folder, const std::vector<ResultFile>& files);

  // Nothing yet, to be added. `mark`: the file that says that those of the folder belong together,
  // to be added last.
  Publication(const std::string& folder, const std::string& mark);

  // Where the file is to be written that shall stand at `path` below the folder.
  std::string add(const std::string& path);

  // A file below the folder that goes, unless it comes as well.
  void remove(const std::string& path);

  ~Publication();  // without commit(): as if nothing had been made
  Publication(const Publication&) = delete;
  Publication& operator=(const Publication&) = delete;

  void commit();

 private:
  explicit Publication(const std::string& folder) : folder_(folder) {}
  void make(const std::vector<ResultFile>& files);
  void sync() const;  // what has come to the disk

  std::string folder_;
  std::vector<std::vector<std::string>> list_ = {};  // what is to be done; empty: nothing
};

// Both at once.
void publish(const std::string& folder, const Results& results, const std::string& staging = "");

// Ends what a program that was killed has begun. The folder is locked.
void finish_publication(const std::string& folder);

// Whether there is such a thing.
bool is_being_published(const std::string& folder);

}  // namespace mapbed
