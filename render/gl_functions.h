#pragma once

#include <GL/glcorearb.h>

/// The OpenGL functions that we use: X(name without gl, the name in capitals as glcorearb.h has
/// it).
#define ENFILADE_GL_FUNCTIONS(X)                      \
  X(ActiveTexture, ACTIVETEXTURE)                     \
  X(AttachShader, ATTACHSHADER)                       \
  X(BindAttribLocation, BINDATTRIBLOCATION)           \
  X(BindBuffer, BINDBUFFER)                           \
  X(BindFramebuffer, BINDFRAMEBUFFER)                 \
  X(BindRenderbuffer, BINDRENDERBUFFER)               \
  X(BindSampler, BINDSAMPLER)                         \
  X(BindTexture, BINDTEXTURE)                         \
  X(BindVertexArray, BINDVERTEXARRAY)                 \
  X(BlendFuncSeparate, BLENDFUNCSEPARATE)             \
  X(BlitFramebuffer, BLITFRAMEBUFFER)                 \
  X(BufferData, BUFFERDATA)                           \
  X(CheckFramebufferStatus, CHECKFRAMEBUFFERSTATUS)   \
  X(Clear, CLEAR)                                     \
  X(ClearColor, CLEARCOLOR)                           \
  X(ClearDepth, CLEARDEPTH)                           \
  X(ColorMask, COLORMASK)                             \
  X(CompileShader, COMPILESHADER)                     \
  X(CreateProgram, CREATEPROGRAM)                     \
  X(CreateShader, CREATESHADER)                       \
  X(CullFace, CULLFACE)                               \
  X(DeleteBuffers, DELETEBUFFERS)                     \
  X(DeleteFramebuffers, DELETEFRAMEBUFFERS)           \
  X(DeleteProgram, DELETEPROGRAM)                     \
  X(DeleteRenderbuffers, DELETERENDERBUFFERS)         \
  X(DeleteSamplers, DELETESAMPLERS)                   \
  X(DeleteShader, DELETESHADER)                       \
  X(DeleteTextures, DELETETEXTURES)                   \
  X(DeleteVertexArrays, DELETEVERTEXARRAYS)           \
  X(DepthFunc, DEPTHFUNC)                             \
  X(DepthMask, DEPTHMASK)                             \
  X(Disable, DISABLE)                                 \
  X(DrawArrays, DRAWARRAYS)                           \
  X(DrawElements, DRAWELEMENTS)                       \
  X(Enable, ENABLE)                                   \
  X(EnableVertexAttribArray, ENABLEVERTEXATTRIBARRAY) \
  X(Finish, FINISH)                                   \
  X(FramebufferRenderbuffer, FRAMEBUFFERRENDERBUFFER) \
  X(FrontFace, FRONTFACE)                             \
  X(GenBuffers, GENBUFFERS)                           \
  X(GenFramebuffers, GENFRAMEBUFFERS)                 \
  X(GenRenderbuffers, GENRENDERBUFFERS)               \
  X(GenSamplers, GENSAMPLERS)                         \
  X(GenTextures, GENTEXTURES)                         \
  X(GenVertexArrays, GENVERTEXARRAYS)                 \
  X(GetError, GETERROR)                               \
  X(GetIntegerv, GETINTEGERV)                         \
  X(GetProgramInfoLog, GETPROGRAMINFOLOG)             \
  X(GetProgramiv, GETPROGRAMIV)                       \
  X(GetShaderInfoLog, GETSHADERINFOLOG)               \
  X(GetShaderiv, GETSHADERIV)                         \
  X(GetString, GETSTRING)                             \
  X(GetUniformLocation, GETUNIFORMLOCATION)           \
  X(LinkProgram, LINKPROGRAM)                         \
  X(MultiDrawElements, MULTIDRAWELEMENTS)             \
  X(PixelStorei, PIXELSTOREI)                         \
  X(PolygonMode, POLYGONMODE)                         \
  X(ReadPixels, READPIXELS)                           \
  X(RenderbufferStorage, RENDERBUFFERSTORAGE)         \
  X(SamplerParameterf, SAMPLERPARAMETERF)             \
  X(SamplerParameteri, SAMPLERPARAMETERI)             \
  X(Scissor, SCISSOR)                                 \
  X(ShaderSource, SHADERSOURCE)                       \
  X(TexImage2D, TEXIMAGE2D)                           \
  X(TexParameteri, TEXPARAMETERI)                     \
  X(TexSubImage2D, TEXSUBIMAGE2D)                     \
  X(Uniform1f, UNIFORM1F)                             \
  X(Uniform1i, UNIFORM1I)                             \
  X(Uniform2f, UNIFORM2F)                             \
  X(UniformMatrix4fv, UNIFORMMATRIX4FV)               \
  X(UseProgram, USEPROGRAM)                           \
  X(VertexAttribPointer, VERTEXATTRIBPOINTER)         \
  X(Viewport, VIEWPORT)

namespace enfilade {

/// The OpenGL functions that we use, filled by a context's own getProcAddress: gl.Clear(…).
struct GlFunctions {
#define ENFILADE_GL_MEMBER(name, upper) PFNGL##upper##PROC name = nullptr;
  ENFILADE_GL_FUNCTIONS(ENFILADE_GL_MEMBER)
#undef ENFILADE_GL_MEMBER
};

/// As OSMesaGetProcAddress, eglGetProcAddress and glfwGetProcAddress all are, up to a cast.
using GlProc = void (*)();
using GlGetProcAddress = GlProc (*)(const char* name);

/// The table of the current context.  Throws Error (kMachine) naming a function that is missing.
GlFunctions loadGlFunctions(GlGetProcAddress get_proc_address);

}  // namespace enfilade
