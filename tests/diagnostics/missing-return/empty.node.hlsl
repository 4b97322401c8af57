[node("Test/F")]
float F(float a = 1) {
    return;
}
