#include "bench/sources/shared_work.h"

#include <tbb/task_arena.h>

namespace mapbed {

const std::any& SharedWork::made(const std::string& key, const std::function<std::any()>& make) {
  Entry* entry = nullptr;
  {
    const std::scoped_lock lock(mutex_);
    std::unique_ptr<Entry>& found = entries_[key];
    if (!found) found = std::make_unique<Entry>();
    entry = found.get();
  }
  // Isolated: a thread that waits within `make` for its own tasks shall not begin another run,
  // which may ask for the very same.
  std::call_once(entry->flag,
                 [&] { tbb::this_task_arena::isolate([&] { entry->value = make(); }); });
  return entry->value;
}

SharedWork& SharedWorks::of(const std::string& key) {
  const std::scoped_lock lock(mutex_);
  return by_key_[key];
}

}  // namespace mapbed
