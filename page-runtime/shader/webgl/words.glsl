// The words of the volume, 4096 a row.
#define VOXC_VOLUME int
#define VOXC_LOAD(volume, index) texelFetch(words, ivec2(int((index) & 4095u), int((index) >> 12)), 0).x
