/* GLFW and Vulkan for the window, loaded when it is opened: late_window.py makes the functions that come through the table here. What
 * the window asks first is whether GLFW can begin, and else why not. */
#include <GLFW/glfw3.h>
#include <dlfcn.h>
#include <stddef.h>
#include <string.h>

struct Function {
  const char *name;
  void **slot;
};
extern const struct Function voxcWindowFunctions[];

static int (*theirInit)(void);
static int (*theirGetError)(const char **text);
static const char *failure;

/* A library that is to stay, or null. */
static void *load(const char *name) {
  void *const library = dlopen(name, RTLD_NOW | RTLD_LOCAL);
  if (!library)
    failure = dlerror();
  return library;
}

static int fill(void) {
  void *const vulkan = load("libvulkan.so.1"); /* GLFW says where there is none. */
  void *const glfw = load("libglfw.so.3");
  if (!glfw)
    return 0;
  for (const struct Function *function = voxcWindowFunctions; function->name; ++function) {
    void *const library = strncmp(function->name, "vk", 2) == 0 ? vulkan : glfw;
    *function->slot = library ? dlsym(library, function->name) : NULL;
    if (library == glfw && !*function->slot) {
      failure = "the library of GLFW that is there is too old";
      return 0;
    }
  }
  *(void **)&theirInit = dlsym(glfw, "glfwInit");
  *(void **)&theirGetError = dlsym(glfw, "glfwGetError");
  return theirInit && theirGetError;
}

int glfwInit(void) { return (theirInit || fill()) && theirInit(); }

int glfwGetError(const char **text) {
  if (theirGetError)
    return theirGetError(text);
  if (text)
    *text = failure;
  return failure ? GLFW_PLATFORM_ERROR : GLFW_NO_ERROR;
}
