[node("Test/F")]
float F(float a = 1) {
    while (a > 1) { a -= 1; }
    switch (a) { }
    int i = 0;
    i++;
    float x = 1, y = 2;
    for (float k = 0; k < 3; k += 0.5) { a += k; }
    return a;
}
