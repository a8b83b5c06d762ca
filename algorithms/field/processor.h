#pragma once

namespace mapbed {

// What inner loops are compiled for. They are written once, in plain C++, and compiled twice: for
// every processor, and with wider vectors for those that have them. Nothing is contracted or
// reordered, so that both give the same bytes.
enum class Processor { any, avx2 };

Processor this_processor();  // the best of them that this machine can run

#if defined(__x86_64__) && defined(__GNUC__)
#define MAPBED_INLINE_LOOP __attribute__((always_inline))

// The loop comes as a lambda, [&]() MAPBED_INLINE_LOOP { … }, on plain arrays.
template <class Loop>
__attribute__((target("avx2"))) void run_with_avx2(const Loop& loop) {
  loop();
}
template <class Loop>
void run(Processor processor, const Loop& loop) {
  processor == Processor::avx2 ? run_with_avx2(loop) : loop();
}
#else
#define MAPBED_INLINE_LOOP
template <class Loop>
void run(Processor, const Loop& loop) {
  loop();
}
#endif

}  // namespace mapbed
