#include "sim/render/gl_context.h"

#include <array>
#include <string>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/osmesa.h>
#include <dlfcn.h>

#include "core/input_error.h"

namespace mapbed {

class GlContext::Library {
 public:
  virtual ~Library() = default;
  virtual void* function(const char* name) const = 0;
};

namespace {

using Library = std::unique_ptr<GlContext::Library>;

// A shared library; null where it is not installed. It stays loaded when it is closed: what Mesa
// still points to would be lost, anew each time it is opened.
struct Handle {
  void* handle = nullptr;

  explicit Handle(std::initializer_list<const char*> names) {
    for (const char* name : names) {
      if (handle == nullptr) handle = dlopen(name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    }
  }
  ~Handle() {
    if (handle != nullptr) dlclose(handle);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  template <class Function>
  Function symbol(const char* name) const {
    return handle == nullptr ? nullptr : reinterpret_cast<Function>(dlsym(handle, name));
  }
};

class OsMesa : public GlContext::Library {
 public:
  OsMesa() : handle_({"libOSMesa.so.8", "libOSMesa.so.6"}) {
    const auto create =
        handle_.symbol<decltype(&OSMesaCreateContextAttribs)>("OSMesaCreateContextAttribs");
    const auto make_current = handle_.symbol<decltype(&OSMesaMakeCurrent)>("OSMesaMakeCurrent");
    if (create == nullptr || make_current == nullptr) return;
    const std::array<int, 11> attributes = {OSMESA_FORMAT,
                                            OSMESA_RGBA,
                                            OSMESA_PROFILE,
                                            OSMESA_CORE_PROFILE,
                                            OSMESA_CONTEXT_MAJOR_VERSION,
                                            3,
                                            OSMESA_CONTEXT_MINOR_VERSION,
                                            3,
                                            OSMESA_DEPTH_BITS,
                                            0,
                                            0};
    context_ = create(attributes.data(), nullptr);
    // We draw into framebuffers of our own; the context asks for some memory all the same.
    constexpr GLenum kUnsignedByte = 0x1401;
    if (context_ != nullptr && make_current(context_, memory_.data(), kUnsignedByte, 4, 4)) {
      get_ = handle_.symbol<decltype(&OSMesaGetProcAddress)>("OSMesaGetProcAddress");
    }
  }
  ~OsMesa() override {
    const auto destroy = handle_.symbol<decltype(&OSMesaDestroyContext)>("OSMesaDestroyContext");
    if (context_ != nullptr) destroy(context_);
  }
  bool works() const { return get_ != nullptr; }
  void* function(const char* name) const override { return reinterpret_cast<void*>(get_(name)); }

 private:
  Handle handle_;
  OSMesaContext context_ = nullptr;
  decltype(&OSMesaGetProcAddress) get_ = nullptr;
  std::array<unsigned char, 64> memory_{};
};

class Egl : public GlContext::Library {
 public:
  Egl() : handle_({"libEGL.so.1"}) {
    get_ = handle_.symbol<decltype(&eglGetProcAddress)>("eglGetProcAddress");
    if (get_ != nullptr) make_context();
  }
  ~Egl() override {
    if (display_ == EGL_NO_DISPLAY) return;
    named<decltype(&eglMakeCurrent)>("eglMakeCurrent")(display_, EGL_NO_SURFACE, EGL_NO_SURFACE,
                                                       EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) {
      named<decltype(&eglDestroyContext)>("eglDestroyContext")(display_, context_);
    }
  }
  bool works() const { return works_; }
  void* function(const char* name) const override { return reinterpret_cast<void*>(get_(name)); }

 private:
  template <class Function>
  Function named(const char* name) const {
    return reinterpret_cast<Function>(get_(name));
  }

  void make_context() {
    const auto get_display = named<decltype(&eglGetPlatformDisplay)>("eglGetPlatformDisplay");
    const auto initialize = handle_.symbol<decltype(&eglInitialize)>("eglInitialize");
    const auto bind = handle_.symbol<decltype(&eglBindAPI)>("eglBindAPI");
    const auto choose = handle_.symbol<decltype(&eglChooseConfig)>("eglChooseConfig");
    const auto create = handle_.symbol<decltype(&eglCreateContext)>("eglCreateContext");
    const auto make_current = handle_.symbol<decltype(&eglMakeCurrent)>("eglMakeCurrent");
    if (get_display == nullptr || initialize == nullptr || choose == nullptr) return;
    const EGLDisplay display =
        get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || !initialize(display, nullptr, nullptr)) return;
    display_ = display;
    bind(EGL_OPENGL_API);
    const std::array<EGLint, 5> wanted = {EGL_SURFACE_TYPE, EGL_DONT_CARE, EGL_RENDERABLE_TYPE,
                                          EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!choose(display_, wanted.data(), &config, 1, &count) || count == 0) return;
    const std::array<EGLint, 7> version = {EGL_CONTEXT_MAJOR_VERSION,
                                           3,
                                           EGL_CONTEXT_MINOR_VERSION,
                                           3,
                                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                           EGL_NONE};
    context_ = create(display_, config, EGL_NO_CONTEXT, version.data());
    works_ = context_ != EGL_NO_CONTEXT &&
             make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
  }

  Handle handle_;
  decltype(&eglGetProcAddress) get_ = nullptr;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
  bool works_ = false;
};

template <class Kind>
Library opened() {
  auto library = std::make_unique<Kind>();
  return library->works() ? Library(std::move(library)) : nullptr;
}

}  // namespace

GlContext::GlContext(GlBackend backend) {
  if (backend != GlBackend::egl) library_ = opened<OsMesa>();
  if (library_ == nullptr && backend != GlBackend::osmesa) library_ = opened<Egl>();
  if (library_ == nullptr) {
    throw InputError(
        "pictures of worlds need a library that draws without a screen; "
        "install it with: apt-get install libosmesa6");
  }
}

GlContext::~GlContext() = default;
GlContext::GlContext(GlContext&&) noexcept = default;
GlContext& GlContext::operator=(GlContext&&) noexcept = default;

void* GlContext::function(const char* name) const {
  return library_->function(name);
}

}  // namespace mapbed
