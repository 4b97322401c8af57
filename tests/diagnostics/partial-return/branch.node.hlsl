[node("Test/F")]
float F(float a = 1) {
    if (a > 1) {
        if (a > 2) return 2;
    } else {
        return 1;
    }
    return 0;
}
