#pragma once

#include <memory>
#include <ostream>
#include <string>
#include <string_view>

namespace mapbed {

// When a file that is complete is on the disk, and no longer in the system's memory alone.
enum class Durability {
  synced,    // before it gets its name, so that a power cut leaves the older file or this one
  unsynced,  // when the system likes: for files that are checked before they are used again
};

// A file that is there complete or not at all: written under another name in the same folder, which
// commit() changes to the right one. An older file of that name stays until then. What a killed
// program has left under the other name is taken over by the next one that writes this file.
//
// A symbolic link stays, and what it points to is written. What is no regular file (a pipe,
// /dev/null) and what a name such as /dev/stdout stands for is written to directly.
class AtomicFile {
 public:
  // Throws InputError where it cannot be written.
  explicit AtomicFile(const std::string& path, Durability durability = Durability::synced);
  ~AtomicFile();  // without commit(): as if nothing had been written
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  std::ostream& stream() { return stream_; }
  void commit();  // once, in the end. InputError where not all of it could be written (disk full)

 private:
  class Buffer;

  void open_unfinished();
  [[noreturn]] void refuse(int reason) const;

  std::string path_;        // as it was given
  std::string target_;      // behind all links; empty: written to directly
  std::string unfinished_;  // empty before it is open and after commit
  Durability durability_;
  std::unique_ptr<Buffer> buffer_;
  std::ostream stream_{nullptr};
};

// The whole file at once.
void write_file(const std::string& path, std::string_view content,
                Durability durability = Durability::synced);

// Whether `path` can be written, asked before the work whose result shall stand there: throws
// InputError as writing would, and leaves nothing.
void check_writable(const std::string& path);

// Whether it is written to directly, so that there are no files beside it.
bool is_special_file(const std::string& path);

// Returns when files that were renamed or removed in the folder are so on the disk, too.
void sync_folder(const std::string& folder);

// The same of a file's content. Throws InputError where the disk fails.
void sync_file(const std::string& path);

}  // namespace mapbed
