#pragma once

#include <array>

#include <QMatrix4x4>
#include <QOpenGLExtraFunctions>
#include <QString>

namespace study::gui::scene {

/// A shader program. Its OpenGL context must outlive it and be current during every call.
class GlProgram {
 public:
  /// @throws std::runtime_error  with the driver's message if a shader does not compile.
  GlProgram(
      QOpenGLExtraFunctions& gl, const QByteArray& vertexCode, const QByteArray& fragmentCode);
  ~GlProgram();
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  void use() { gl_.glUseProgram(id_); }
  void set(const char* name, const QMatrix4x4& value);
  void set(const char* name, QVector3D value);
  void set(const char* name, float value);
  /// Sets both elements of an array.
  void set(const char* name, const std::array<QVector3D, 2>& values);

 private:
  GLuint compile(GLenum kind, const char* code);
  GLint at(const char* name) { return gl_.glGetUniformLocation(id_, name); }

  QOpenGLExtraFunctions& gl_;
  GLuint id_ = 0;
};

}  // namespace study::gui::scene
