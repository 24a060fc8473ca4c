/* JBIG for libtiff, which compresses pages of fax by it: its library is under the GPL, which binaries that hold it would be under too.
 * Without it, such a page is an error that says so, and nothing else of TIFF is missing. */
#include <stddef.h>

enum { kNotHere = 1 };

void jbg_dec_init(void *state) { (void)state; }
void jbg_dec_free(void *state) { (void)state; }
void jbg_newlen(unsigned char *data, size_t size) { (void)data, (void)size; }
int jbg_dec_in(void *state, unsigned char *data, size_t size, size_t *taken) {
  (void)state, (void)data, (void)size;
  if (taken)
    *taken = 0;
  return kNotHere;
}
unsigned long jbg_dec_getsize(const void *state) {
  (void)state;
  return 0;
}
unsigned char *jbg_dec_getimage(const void *state, int plane) {
  (void)state, (void)plane;
  return NULL;
}
const char *jbg_strerror(int error) { return error == kNotHere ? "this voxc is built without JBIG" : ""; }

/* Nothing is written by it. */
void jbg_enc_init(void *state) { (void)state; }
void jbg_enc_out(void *state) { (void)state; }
void jbg_enc_free(void *state) { (void)state; }
