[node("Test/F")]
float F(vec3 a = 1, flaot3 b = 1) {
    double c = 1;
    return c;
}
