// Versions, errors and blocks of the C interface.
#include "C/Handles.h"

#include <cstdlib>

using namespace voxc;

uint32_t voxc_abi_version(void) { return VOXC_ABI_VERSION; }

const char *voxc_version(void) { return VOXC_VERSION; }

voxc_error_kind voxc_error_get_kind(const voxc_error *error) {
  switch (error->error.kind) {
  case ErrorKind::Input:
    return VOXC_ERROR_INPUT;
  case ErrorKind::Usage:
    return VOXC_ERROR_USAGE;
  case ErrorKind::Environment:
    return VOXC_ERROR_ENVIRONMENT;
  case ErrorKind::Interrupted:
    return VOXC_ERROR_INTERRUPTED;
  }
  return VOXC_ERROR_INPUT;
}

const char *voxc_error_message(const voxc_error *error) { return error->error.message.c_str(); }

void voxc_error_free(voxc_error *error) {
  if (error != &c::outOfMemory())
    delete error;
}

void voxc_free(void *block) { std::free(block); }
