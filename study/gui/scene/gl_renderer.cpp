#include "study/gui/scene/gl_renderer.h"

#include <cstddef>
#include <stdexcept>

#include "study/gui/scene/gl_shaders.h"

namespace study::gui::scene {
namespace {

constexpr GLenum kBgra = 0x80E1;         // GL_BGRA
constexpr GLenum kWholePixels = 0x8367;  // GL_UNSIGNED_INT_8_8_8_8_REV
constexpr GLenum kPointSizes = 0x8642;   // GL_PROGRAM_POINT_SIZE
constexpr int kSamples = 4;              // samples per pixel on a graphics card

QSurfaceFormat wantedFormat() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  return format;
}

bool isProcessorRenderer(const QString& renderer) {
  for (const char* name : {"llvmpipe", "softpipe", "swrast", "Software", "SWR"}) {
    if (renderer.contains(QLatin1String(name), Qt::CaseInsensitive)) return true;
  }
  return false;
}

const void* offset(std::size_t bytes) {
  return reinterpret_cast<const void*>(bytes);
}

QVector3D colourOf(Tint tint) {
  constexpr float kFull = 255.0F;
  return QVector3D(tint.red, tint.green, tint.blue) / kFull;
}

GLsizeiptr bytesOf(std::size_t count, std::size_t size) {
  return static_cast<GLsizeiptr>(count * size);
}

}  // namespace

GlRenderer::GlRenderer(Detail detail) {
  context_.setFormat(wantedFormat());
  if (!context_.create()) throw std::runtime_error("this display offers no OpenGL");
  surface_.setFormat(context_.format());
  surface_.create();
  if (!surface_.isValid() || !context_.makeCurrent(&surface_)) {
    throw std::runtime_error("OpenGL cannot be used on this display");
  }
  const auto version = context_.format().version();
  if (version < std::pair(3, 3)) {
    throw std::runtime_error(
        "this display offers OpenGL " + std::to_string(version.first) + "." +
        std::to_string(version.second) + " where 3.3 is needed");
  }
  gl_.initializeOpenGLFunctions();
  name_ = QString::fromUtf8(reinterpret_cast<const char*>(gl_.glGetString(GL_RENDERER)));
  isOnProcessor_ = isProcessorRenderer(name_);
  isFullDetail_ = detail == Detail::FullDetail || !isOnProcessor_;
  samples_ = isFullDetail_ ? kSamples : 0;
  makePrograms();
}

GlRenderer::~GlRenderer() {
  context_.makeCurrent(&surface_);
  for (auto& body : parts_) {
    gl_.glDeleteVertexArrays(1, &body.array);
    gl_.glDeleteBuffers(1, &body.vertices);
    gl_.glDeleteBuffers(1, &body.triangles);
  }
  gl_.glDeleteVertexArrays(1, &sphereArray_);
  gl_.glDeleteBuffers(1, &sphereBuffer_);
  freeCanvas(drawCanvas_);
  freeCanvas(readCanvas_);
  bodyProgram_.reset();
  sphereProgram_.reset();
  context_.doneCurrent();
}

void GlRenderer::makePrograms() {
  const QByteArray shading =
      QByteArray(isFullDetail_ ? kPerPixelShading : kPerVertexShading) + kShadingCode;
  bodyProgram_.emplace(gl_, shading + kBodyVertexCode, shading + kBodyFragmentCode);
  sphereProgram_.emplace(gl_, shading + kSphereVertexCode, shading + kSphereFragmentCode);
  gl_.glGenVertexArrays(1, &sphereArray_);
  gl_.glGenBuffers(1, &sphereBuffer_);
  gl_.glBindVertexArray(sphereArray_);
  gl_.glBindBuffer(GL_ARRAY_BUFFER, sphereBuffer_);
  constexpr GLsizei kStride = sizeof(SphereInstance);
  gl_.glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, kStride, offset(0));
  gl_.glVertexAttribPointer(
      1, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, offset(offsetof(SphereInstance, tint)));
  for (const GLuint i : {0U, 1U}) {
    gl_.glEnableVertexAttribArray(i);
    if (isFullDetail_) gl_.glVertexAttribDivisor(i, 1);
  }
}

void GlRenderer::makeCanvas(Canvas& canvas, QSize size, int samples) {
  freeCanvas(canvas);
  gl_.glGenFramebuffers(1, &canvas.frame);
  gl_.glBindFramebuffer(GL_FRAMEBUFFER, canvas.frame);
  const auto add = [&](GLuint& buffer, GLenum format, GLenum where) {
    gl_.glGenRenderbuffers(1, &buffer);
    gl_.glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    gl_.glRenderbufferStorageMultisample(
        GL_RENDERBUFFER, samples, format, size.width(), size.height());
    gl_.glFramebufferRenderbuffer(GL_FRAMEBUFFER, where, GL_RENDERBUFFER, buffer);
  };
  add(canvas.colours, GL_RGBA8, GL_COLOR_ATTACHMENT0);
  add(canvas.depths, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT);
}

void GlRenderer::freeCanvas(Canvas& canvas) {
  gl_.glDeleteFramebuffers(1, &canvas.frame);
  gl_.glDeleteRenderbuffers(1, &canvas.colours);
  gl_.glDeleteRenderbuffers(1, &canvas.depths);
  canvas = {};
}

void GlRenderer::upload(Body& body, const Part& part) {
  if (body.revision == part.revision) return;
  body.revision = part.revision;
  if (body.array == 0) {
    gl_.glGenVertexArrays(1, &body.array);
    gl_.glGenBuffers(1, &body.vertices);
    gl_.glGenBuffers(1, &body.triangles);
  }
  const Mesh& mesh = part.mesh;
  gl_.glBindVertexArray(body.array);
  gl_.glBindBuffer(GL_ARRAY_BUFFER, body.vertices);
  gl_.glBufferData(
      GL_ARRAY_BUFFER,
      bytesOf(mesh.vertices.size(), sizeof(Vertex)),
      mesh.vertices.data(),
      GL_DYNAMIC_DRAW);
  // A body's triangles stay the same when its shape changes.
  if (body.count == mesh.triangles.size()) return;
  body.count = mesh.triangles.size();
  gl_.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, body.triangles);
  gl_.glBufferData(
      GL_ELEMENT_ARRAY_BUFFER,
      bytesOf(mesh.triangles.size(), sizeof(Triangle)),
      mesh.triangles.data(),
      GL_STATIC_DRAW);
  constexpr GLsizei kStride = sizeof(Vertex);
  gl_.glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(Vertex, position)));
  gl_.glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(Vertex, normal)));
  gl_.glVertexAttribPointer(
      2, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, offset(offsetof(Vertex, tint)));
  for (const GLuint i : {0U, 1U, 2U}) gl_.glEnableVertexAttribArray(i);
}

void GlRenderer::uploadSpheres(SphereCloud& spheres) {
  gl_.glBindBuffer(GL_ARRAY_BUFFER, sphereBuffer_);
  const std::size_t needed = spheres.instances().size();
  if (needed > sphereCapacity_) {
    sphereCapacity_ = needed + needed / 2;
    gl_.glBufferData(
        GL_ARRAY_BUFFER,
        bytesOf(sphereCapacity_, sizeof(SphereInstance)),
        nullptr,
        GL_DYNAMIC_DRAW);
    spheres.forgetUploads();  // the new buffer is empty
  }
  sphereBytes_ +=
      sizeof(SphereInstance) * spheres.uploadChanges([this](std::size_t first, auto some) {
        gl_.glBufferSubData(
            GL_ARRAY_BUFFER,
            bytesOf(first, sizeof(SphereInstance)),
            bytesOf(some.size(), sizeof(SphereInstance)),
            some.data());
      });
}

const QImage& GlRenderer::draw(const Scene& scene, QSize size) {
  context_.makeCurrent(&surface_);
  if (picture_.size() != size) {
    picture_ = QImage(size, QImage::Format_RGB32);
    makeCanvas(drawCanvas_, size, samples_);
    if (samples_ > 0) makeCanvas(readCanvas_, size, 0);
  }
  parts_.resize(scene.parts.size());
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (scene.parts[i].isShown) upload(parts_[i], scene.parts[i]);
  }
  if (scene.spheres != nullptr) uploadSpheres(*scene.spheres);
  gl_.glBindFramebuffer(GL_FRAMEBUFFER, drawCanvas_.frame);
  gl_.glDisable(GL_SCISSOR_TEST);
  const QVector3D ground = colourOf(scene.ground);
  gl_.glClearColor(ground.x(), ground.y(), ground.z(), 1.0F);
  gl_.glClear(GL_COLOR_BUFFER_BIT);
  gl_.glFrontFace(GL_CW);  // counterclockwise, upside down
  gl_.glEnable(GL_DEPTH_TEST);
  gl_.glEnable(GL_SCISSOR_TEST);
  for (const auto& shot : scene.shots) drawShot(scene, shot, size);
  readBack(size);
  return picture_;
}

/// Draws upside down, so that the first row read back is the top row.
void GlRenderer::drawShot(const Scene& scene, const Shot& shot, QSize size) {
  const QRect place = placeOf(shot, size);
  QMatrix4x4 upsideDown;
  upsideDown.scale(1.0F, -1.0F, 1.0F);
  const QMatrix4x4 projection = upsideDown * projectionOf(shot, place.size());
  gl_.glViewport(place.x(), place.y(), place.width(), place.height());
  gl_.glScissor(place.x(), place.y(), place.width(), place.height());
  gl_.glClear(GL_DEPTH_BUFFER_BIT);
  bodyProgram_->use();
  setLight(*bodyProgram_, shot, place);
  const auto shadows = inEyeFrame(scene.shadows, shot);
  setShadows(*bodyProgram_, shadows);
  bodyProgram_->set("ground", colourOf(scene.ground));
  bodyProgram_->set("projection", projection);
  for (const auto i : shot.parts) {
    if (!scene.parts[i].isShown) continue;
    bodyProgram_->set("toEye", shot.view * scene.parts[i].pose);
    setDepths(*bodyProgram_, shadows, !scene.parts[i].isTool);
    scene.parts[i].isTool ? gl_.glEnable(GL_CULL_FACE) : gl_.glDisable(GL_CULL_FACE);
    gl_.glBindVertexArray(parts_[i].array);
    gl_.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, parts_[i].triangles);
    gl_.glDrawElements(
        GL_TRIANGLES, static_cast<GLsizei>(3 * parts_[i].count), GL_UNSIGNED_INT, nullptr);
  }
  if (!shot.showsSpheres || scene.spheres == nullptr) return;
  gl_.glDisable(GL_CULL_FACE);
  sphereProgram_->use();
  setLight(*sphereProgram_, shot, place);
  setShadows(*sphereProgram_, shadows);
  sphereProgram_->set("lampPlace", shot.light.place.normalized());
  sphereProgram_->set("projection", projection);
  sphereProgram_->set("toEye", shot.view);
  sphereProgram_->set("pointScale", 0.5F * static_cast<float>(place.height()) * -projection(1, 1));
  gl_.glBindVertexArray(sphereArray_);
  const auto count = static_cast<GLsizei>(scene.spheres->instances().size());
  if (isFullDetail_) {
    gl_.glDrawArraysInstanced(GL_TRIANGLES, 0, 3, count);
  } else {
    gl_.glEnable(kPointSizes);
    gl_.glDrawArrays(GL_POINTS, 0, count);
  }
}

void GlRenderer::setLight(GlProgram& program, const Shot& shot, QRect place) {
  program.set("lampPlace", shot.light.place);
  program.set("lampReach", shot.light.reach);
  program.set("lampPower", shot.light.power);
  program.set("ambientLight", shot.light.ambient);
  const QPointF middle = QRectF(place).center();
  program.set(
      "disc",
      QVector3D(
          static_cast<float>(middle.x()),
          static_cast<float>(middle.y()),
          shot.isRound ? 0.5F * static_cast<float>(place.width()) : 0.0F));
}

void GlRenderer::setShadows(GlProgram& program, const Shadows& shadows) {
  program.set("shadowFrom", std::array{shadows[0].from, shadows[1].from});
  program.set("shadowAlong", std::array{shadows[0].along, shadows[1].along});
  setDepths(program, shadows, true);
}

void GlRenderer::setDepths(GlProgram& program, const Shadows& shadows, bool areCast) {
  const auto sizeOf = [areCast](const ContactShadow& shadow) {
    return QVector3D(shadow.radius, shadow.reach, areCast ? shadow.depth : 0.0F);
  };
  program.set("shadowSize", std::array{sizeOf(shadows[0]), sizeOf(shadows[1])});
}

void GlRenderer::readBack(QSize size) {
  gl_.glDisable(GL_SCISSOR_TEST);
  if (samples_ > 0) {
    gl_.glBindFramebuffer(GL_READ_FRAMEBUFFER, drawCanvas_.frame);
    gl_.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, readCanvas_.frame);
    const int w = size.width();
    const int h = size.height();
    gl_.glBlitFramebuffer(0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl_.glBindFramebuffer(GL_READ_FRAMEBUFFER, readCanvas_.frame);
  }
  gl_.glReadPixels(0, 0, size.width(), size.height(), kBgra, kWholePixels, picture_.bits());
}

}  // namespace study::gui::scene
