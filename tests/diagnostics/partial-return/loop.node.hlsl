[node("Test/F")]
float F(float a = 1) {
    for (int i = 0; i < 4; i++) {
        if (a > float(i)) return a;
    }
    return 0;
}
