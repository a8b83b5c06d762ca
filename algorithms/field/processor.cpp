#include "algorithms/field/processor.h"

namespace mapbed {

Processor this_processor() {
#if defined(__x86_64__) && defined(__GNUC__)
  static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
  return has_avx2 ? Processor::avx2 : Processor::any;
#else
  return Processor::any;
#endif
}

}  // namespace mapbed
