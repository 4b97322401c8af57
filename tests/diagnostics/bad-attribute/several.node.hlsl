[node("Test/F")]
[color]
float F([rnage(0, 1)] float a = 1, [range(0)] float b = 1) {
    [branch] for (int i = 0; i < 3; i++) { a += b; }
    return a;
}
[node("Test/G")]
[inFloat(1)] float G() { return 1; }
