[node("Test/F")]
float F(float amount = 1) {
    float doubled = amuont * 2;
    other = 3;
    return doubled + uv0.x;
}
