#include "sim/render/painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <GL/glcorearb.h>

#include "core/check.h"
#include "core/input_error.h"
#include "sim/render/gl_functions.h"

namespace mapbed {
namespace {

constexpr int kLargestShadow = 4096;  // [pixels] of the picture that the sun sees
const Eigen::Vector3d kToSun = Eigen::Vector3d(-0.45, -0.35, 1.0).normalized();

const char* const kVertexShader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 color;
uniform mat4 camera;
uniform mat4 sun;
out vec3 surface_normal;
out vec4 surface_color;
out vec3 seen_from_sun;
void main() {
  gl_Position = camera * vec4(position, 1.0);
  surface_normal = normal;
  surface_color = color;
  seen_from_sun = (sun * vec4(position + 0.01 * normal, 1.0)).xyz * 0.5 + 0.5;
}
)";

// Lambert's law for the sun, and a sky that is brighter above than below. Colours are given as on a
// screen (gamma 2.2); light is added up in linear terms.
const char* const kFragmentShader = R"(#version 330 core
in vec3 surface_normal;
in vec4 surface_color;
in vec3 seen_from_sun;
uniform sampler2DShadow shadow;
uniform vec3 to_sun;
uniform float shadow_step;
out vec4 color;
float lit() {
  float sum = 0.0;
  for (int y = -2; y <= 2; ++y) {
    for (int x = -2; x <= 2; ++x) {
      sum += texture(shadow, seen_from_sun + vec3(vec2(x, y) * shadow_step, -0.0003));
    }
  }
  return sum / 25.0;
}
void main() {
  if (dot(surface_normal, surface_normal) < 0.1) {
    color = surface_color;
    return;
  }
  vec3 n = normalize(surface_normal);
  vec3 paint = pow(surface_color.rgb, vec3(2.2));
  float sunshine = max(dot(n, to_sun), 0.0);
  if (sunshine > 0.0 && shadow_step > 0.0) sunshine *= lit();
  vec3 sky = mix(vec3(0.26, 0.25, 0.24), vec3(0.60, 0.62, 0.66), 0.5 + 0.5 * n.z);
  vec3 light = sky + 0.60 * sunshine * vec3(1.0, 0.96, 0.88);
  color = vec4(pow(min(paint * light, 1.0), vec3(1.0 / 2.2)), surface_color.a);
}
)";

const char* const kDepthShader = R"(#version 330 core
void main() {}
)";

Eigen::AlignedBox3d bounds_of(const PaintedMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const auto* vertices : {&mesh.opaque, &mesh.clear}) {
    for (const PaintedVertex& vertex : *vertices) {
      const auto& p = vertex.position;
      box.extend(Eigen::Vector3f(p[0], p[1], p[2]).cast<double>());
    }
  }
  return box;
}

// The mean of samples x samples pixels; the rows of OpenGL start at the bottom.
RgbImage shrunk(const std::vector<std::uint8_t>& rgba, const CanvasOptions& o) {
  RgbImage image(o.width, o.height);
  const auto n = static_cast<std::size_t>(o.samples);
  const std::size_t row = n * static_cast<std::size_t>(o.width);
  const std::size_t rows = n * static_cast<std::size_t>(o.height);
  const unsigned count = static_cast<unsigned>(n * n);
  for (std::size_t y = 0; y < rows / n; ++y) {
    for (std::size_t x = 0; x < row / n; ++x) {
      std::array<unsigned, 3> sum{};
      for (std::size_t v = 0; v < n; ++v) {
        const std::size_t line = rows - 1 - (y * n + v);
        for (std::size_t u = 0; u < n; ++u) {
          const std::size_t at = 4 * (line * row + x * n + u);
          for (std::size_t i = 0; i < 3; ++i) sum[i] += rgba[at + i];
        }
      }
      const auto mean = [&](unsigned s) {
        return static_cast<std::uint8_t>((s + count / 2) / count);
      };
      image.at(static_cast<int>(x), static_cast<int>(y)) = {mean(sum[0]), mean(sum[1]),
                                                            mean(sum[2])};
    }
  }
  return image;
}

}  // namespace

struct Painter::State {
  GlContext context;
  GlFunctions gl;
  GLuint picture_program = 0;
  GLuint depth_program = 0;
  GLuint vertex_array = 0;

  explicit State(GlBackend backend) : context(backend), gl(context) {
    picture_program = program(kVertexShader, kFragmentShader);
    depth_program = program(kVertexShader, kDepthShader);
    gl.GenVertexArrays(1, &vertex_array);
    gl.BindVertexArray(vertex_array);
  }

  GLuint program(const char* vertex, const char* fragment) const {
    const GLuint result = gl.CreateProgram();
    for (const auto& [kind, text] :
         {std::pair(GL_VERTEX_SHADER, vertex), std::pair(GL_FRAGMENT_SHADER, fragment)}) {
      const GLuint shader = gl.CreateShader(static_cast<GLenum>(kind));
      gl.ShaderSource(shader, 1, &text, nullptr);
      gl.CompileShader(shader);
      gl.AttachShader(result, shader);
    }
    gl.LinkProgram(result);
    GLint linked = 0;
    gl.GetProgramiv(result, GL_LINK_STATUS, &linked);
    CHECK(linked == GL_TRUE);
    return result;
  }

  void set_matrix(GLuint program, const char* name, const Eigen::Matrix4d& matrix) const {
    const Eigen::Matrix4f columns = matrix.cast<float>();
    gl.UniformMatrix4fv(gl.GetUniformLocation(program, name), 1, GL_FALSE, columns.data());
  }

  GLuint upload(const std::vector<PaintedVertex>& vertices) const {
    GLuint buffer = 0;
    gl.GenBuffers(1, &buffer);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(PaintedVertex)),
                  vertices.data(), GL_STATIC_DRAW);
    return buffer;
  }

  void draw(GLuint buffer, std::size_t vertices) const {
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    const auto attribute = [&](GLuint index, GLint size, std::size_t offset) {
      gl.EnableVertexAttribArray(index);
      gl.VertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, sizeof(PaintedVertex),
                             reinterpret_cast<const void*>(offset));
    };
    attribute(0, 3, offsetof(PaintedVertex, position));
    attribute(1, 3, offsetof(PaintedVertex, normal));
    attribute(2, 4, offsetof(PaintedVertex, color));
    gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices));
  }

  // What the sun sees, as a texture of depths.
  GLuint draw_shadow(GLuint opaque, std::size_t vertices, const Eigen::Matrix4d& sun,
                     int size) const {
    GLuint texture = 0;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, size, size, 0, GL_DEPTH_COMPONENT,
                  GL_UNSIGNED_INT, nullptr);
    for (const GLenum edge : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
      gl.TexParameteri(GL_TEXTURE_2D, edge, GL_CLAMP_TO_EDGE);
    }
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
      gl.TexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
    }
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    GLuint frame = 0;
    gl.GenFramebuffers(1, &frame);
    gl.BindFramebuffer(GL_FRAMEBUFFER, frame);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture, 0);
    gl.DrawBuffer(GL_NONE);
    gl.ReadBuffer(GL_NONE);
    gl.Viewport(0, 0, size, size);
    gl.Clear(GL_DEPTH_BUFFER_BIT);
    gl.UseProgram(depth_program);
    set_matrix(depth_program, "camera", sun);
    draw(opaque, vertices);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.DeleteFramebuffers(1, &frame);
    return texture;
  }

  // A framebuffer with colour and depth; both renderbuffers are given back through `buffers`.
  GLuint new_frame(int width, int height, std::array<GLuint, 2>& buffers) const {
    GLuint frame = 0;
    gl.GenFramebuffers(1, &frame);
    gl.BindFramebuffer(GL_FRAMEBUFFER, frame);
    gl.GenRenderbuffers(2, buffers.data());
    gl.BindRenderbuffer(GL_RENDERBUFFER, buffers[0]);
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers[0]);
    gl.BindRenderbuffer(GL_RENDERBUFFER, buffers[1]);
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, buffers[1]);
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
      throw InputError("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                       " samples is too large; take fewer pixels or samples");
    }
    return frame;
  }

  void draw_picture(const PaintedMesh& mesh, const std::array<GLuint, 2>& buffers,
                    const Eigen::Matrix4d& camera, const Eigen::Matrix4d& sun,
                    double shadow_step) const {
    gl.UseProgram(picture_program);
    set_matrix(picture_program, "camera", camera);
    set_matrix(picture_program, "sun", sun);
    gl.Uniform1i(gl.GetUniformLocation(picture_program, "shadow"), 0);
    gl.Uniform1f(gl.GetUniformLocation(picture_program, "shadow_step"),
                 static_cast<float>(shadow_step));
    gl.Uniform3f(gl.GetUniformLocation(picture_program, "to_sun"), static_cast<float>(kToSun.x()),
                 static_cast<float>(kToSun.y()), static_cast<float>(kToSun.z()));
    gl.Disable(GL_BLEND);
    gl.DepthMask(GL_TRUE);
    draw(buffers[0], mesh.opaque.size());
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl.DepthMask(GL_FALSE);
    draw(buffers[1], mesh.clear.size());
    gl.DepthMask(GL_TRUE);
    gl.Disable(GL_BLEND);
  }
};

Painter::Painter(GlBackend backend) : state_(std::make_unique<State>(backend)) {}
Painter::~Painter() = default;

RgbImage Painter::draw(const PaintedMesh& mesh, const Camera& camera,
                       const CanvasOptions& options) {
  CHECK(options.width > 0 && options.height > 0 && options.samples > 0);
  const GlFunctions& gl = state_->gl;
  const int width = options.width * options.samples;
  const int height = options.height * options.samples;
  const Eigen::AlignedBox3d box = bounds_of(mesh);
  CHECK(!box.isEmpty());
  const Eigen::Matrix4d sun = light_projection(kToSun, box);

  // As fine as the picture itself.
  const int shadow_size = std::min(2 * std::max(width, height), kLargestShadow);

  gl.Enable(GL_DEPTH_TEST);
  const std::array<GLuint, 2> buffers = {state_->upload(mesh.opaque), state_->upload(mesh.clear)};
  const GLuint shadow = state_->draw_shadow(buffers[0], mesh.opaque.size(), sun, shadow_size);
  std::array<GLuint, 2> targets{};
  const GLuint frame = state_->new_frame(width, height, targets);
  gl.Viewport(0, 0, width, height);
  const Eigen::Vector3f b = options.background.cast<float>();
  gl.ClearColor(b.x(), b.y(), b.z(), 1.0F);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const double aspect = static_cast<double>(width) / height;
  state_->draw_picture(mesh, buffers, projection(camera, aspect, box), sun,
                       options.shadows ? 1.0 / shadow_size : 0.0);

  std::vector<std::uint8_t> rgba(4 * static_cast<std::size_t>(width) *
                                 static_cast<std::size_t>(height));
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  CHECK(gl.GetError() == GL_NO_ERROR);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.DeleteFramebuffers(1, &frame);
  gl.DeleteRenderbuffers(2, targets.data());
  gl.DeleteTextures(1, &shadow);
  gl.DeleteBuffers(2, buffers.data());
  return shrunk(rgba, options);
}

}  // namespace mapbed
