/// A wave.
[node("Mine/Wave")]
float Wave(float x = 0) {
    return sin(x);
}
