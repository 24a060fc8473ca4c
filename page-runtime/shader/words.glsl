#version 300 es
precision highp float;
precision highp int;
uniform highp usampler2D words;
#define VOXC_VOLUME int
#define VOXC_LOAD(volume, index) texelFetch(words, ivec2(int((index) & 4095u), int((index) >> 12)), 0).x
