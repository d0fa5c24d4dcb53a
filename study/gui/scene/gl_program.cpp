#include "study/gui/scene/gl_program.h"

#include <stdexcept>

namespace study::gui::scene {

GlProgram::GlProgram(
    QOpenGLExtraFunctions& gl, const QByteArray& vertexCode, const QByteArray& fragmentCode)
    : gl_(gl) {
  const GLuint vertex = compile(GL_VERTEX_SHADER, vertexCode.constData());
  const GLuint fragment = compile(GL_FRAGMENT_SHADER, fragmentCode.constData());
  id_ = gl_.glCreateProgram();
  for (const GLuint shader : {vertex, fragment}) {
    gl_.glAttachShader(id_, shader);
    gl_.glDeleteShader(shader);
  }
  gl_.glLinkProgram(id_);
  GLint isLinked = 0;
  gl_.glGetProgramiv(id_, GL_LINK_STATUS, &isLinked);
  if (isLinked == 0) throw std::runtime_error("its shaders cannot be linked");
}

GlProgram::~GlProgram() {
  gl_.glDeleteProgram(id_);
}

GLuint GlProgram::compile(GLenum kind, const char* code) {
  const GLuint shader = gl_.glCreateShader(kind);
  gl_.glShaderSource(shader, 1, &code, nullptr);
  gl_.glCompileShader(shader);
  GLint isCompiled = 0;
  gl_.glGetShaderiv(shader, GL_COMPILE_STATUS, &isCompiled);
  if (isCompiled != 0) return shader;
  char words[400] = {};
  gl_.glGetShaderInfoLog(shader, sizeof words - 1, nullptr, words);
  throw std::runtime_error(std::string("its shaders cannot be compiled: ") + words);
}

void GlProgram::set(const char* name, const QMatrix4x4& value) {
  gl_.glUniformMatrix4fv(at(name), 1, GL_FALSE, value.constData());
}

void GlProgram::set(const char* name, QVector3D value) {
  gl_.glUniform3f(at(name), value.x(), value.y(), value.z());
}

void GlProgram::set(const char* name, float value) {
  gl_.glUniform1f(at(name), value);
}

void GlProgram::set(const char* name, const std::array<QVector3D, 2>& values) {
  const std::array<GLfloat, 6> all{
      values[0].x(), values[0].y(), values[0].z(), values[1].x(), values[1].y(), values[1].z()};
  gl_.glUniform3fv(at(name), 2, all.data());
}

}  // namespace study::gui::scene
