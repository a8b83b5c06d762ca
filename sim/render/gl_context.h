#pragma once

#include <memory>

namespace mapbed {

// OpenGL 3.3 without a screen: Mesa's renderer in memory (OSMesa) or, where that library is not
// installed, EGL without a surface. The library is loaded with the first context, so that programs
// that draw nothing need neither. A context belongs to the thread that made it.
enum class GlBackend : int { any, osmesa, egl };

class GlContext {
 public:
  // Throws InputError where the libraries are missing, with the package to install.
  explicit GlContext(GlBackend backend = GlBackend::any);
  ~GlContext();
  GlContext(GlContext&&) noexcept;
  GlContext& operator=(GlContext&&) noexcept;

  void* function(const char* name) const;  // of OpenGL; null where there is none of that name

  class Library;

 private:
  std::unique_ptr<Library> library_;
};

}  // namespace mapbed
