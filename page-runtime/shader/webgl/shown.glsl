layout(location = 0) out vec4 shown;

void main() { shown = vec4(colour_at(gl_FragCoord.xy), 1.0); }
