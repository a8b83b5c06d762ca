#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/results/results.h"
#include "bench/scenario/journal.h"
#include "bench/scenario/runner.h"

namespace mapbed {

// The folder runs/ of a result, in which everything is kept until all runs are done: the journal,
// the runs' own files and tables. A run of a scenario that is killed goes on from there. Where
// several programs share the work, each has such a folder elsewhere below the result's.
class StagingFolder {
 public:
  // Makes it, or opens what an earlier start left; `afresh` throws that away. Throws InputError
  // where it is of another `identity` or cannot be written.
  StagingFolder(const std::string& folder, const Results& planned, const std::string& identity,
                bool afresh, const std::string& staging = kStaging);

  // Runs of before of which all is there that they gave.
  const std::vector<Journal::Entry>& found() const { return found_; }

  // A run that is over, with all it gave. Throws InputError where a file of it has the name of
  // another run's, of a plot's, or of somebody else's in the result's folder.
  void commit(const RunResult& result);

  // Takes over the runs that the other one has and this one has not, with all they gave. The other
  // one stays as it is.
  void take_over(const StagingFolder& other);

  // Adds the series and the list of files of all runs of `results`, committed by this start or one
  // before.
  void collect(Results& results) const;

  // The result takes the place of the folder's older one, and the staging folder, runs/, goes.
  void finish(const Results& results);

  static constexpr const char* kStaging = "runs";

 private:
  std::vector<FileOfRun> files_of(int run) const;
  std::string table_path(const std::string& kind, int run) const;
  std::string table(const std::string& kind, int run) const;  // empty where there is none
  void write_table(const std::string& kind, int run, const std::string& csv) const;
  std::string checksum_of(int run) const;
  void resume();
  void own(const std::string& path, int run);

  const Results& planned_;
  std::filesystem::path folder_;
  std::filesystem::path staging_;
  std::optional<Journal> journal_;
  std::vector<Journal::Entry> found_;
  std::map<std::string, int> run_by_file_;
};

// Throws the folder runs/ of a folder away, unless its runs are of another identity.
void discard_staging(const std::string& folder, const std::string& identity);

// What the finished result of a folder says it is of; empty where there is none.
std::string finished_identity(const std::string& folder);

}  // namespace mapbed
