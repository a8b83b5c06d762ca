#pragma once

#include <atomic>
#include <cstddef>
#include <limits>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace mapbed {

// A server of files for tests, on 127.0.0.1 at a port of its own, as good or as bad as it is asked
// to be.
class LocalServer {
 public:
  struct Answer {
    std::string bytes;
    int status = 200;
    std::string redirect = {};  // to this address; empty: none
    bool has_ranges = true;     // gives a second half alone
    // Of one answer [bytes]: then the connection ends, or for `stalls` nothing comes any more.
    std::size_t most = std::numeric_limits<std::size_t>::max();
    bool stalls = false;
  };

  LocalServer();
  ~LocalServer();
  LocalServer(const LocalServer&) = delete;
  LocalServer& operator=(const LocalServer&) = delete;

  void put(const std::string& name, Answer answer);  // "a/b.log"; all others are answered by 404
  std::string address(const std::string& name = "") const;
  std::vector<std::string> requests() const;  // "a/b.log", or "a/b.log from 100"

 private:
  void serve();
  void answer(int connection);

  int socket_ = -1;
  int port_ = 0;
  mutable std::mutex mutex_;
  std::map<std::string, Answer> answers_;
  std::vector<std::string> requests_;
  std::atomic<bool> ended_ = false;
  std::thread thread_;
};

}  // namespace mapbed
