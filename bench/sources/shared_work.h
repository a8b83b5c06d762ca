#pragma once

#include <any>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace mapbed {

// What several runs need and is the same for all of them, as the path that a method finds in the
// clean log: the first that asks works it out, others wait for it. For several threads at a time.
class SharedWork {
 public:
  // `make` gives the same whoever calls it, and does not ask for shared work itself. Where it
  // throws, the next one tries again.
  template <class Value>
  const Value& once(const std::string& key, const std::function<Value()>& make) {
    return std::any_cast<const Value&>(made(key, [&make]() -> std::any { return make(); }));
  }

 private:
  struct Entry {
    std::once_flag flag;
    std::any value;
  };
  const std::any& made(const std::string& key, const std::function<std::any()>& make);

  std::mutex mutex_;
  std::map<std::string, std::unique_ptr<Entry>> entries_;
};

// One for each key; references stay valid.
class SharedWorks {
 public:
  SharedWork& of(const std::string& key);

 private:
  std::mutex mutex_;
  std::map<std::string, SharedWork> by_key_;
};

}  // namespace mapbed
