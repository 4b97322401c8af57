float fib(float n) {
    return n < 2 ? n : fib(n - 1) + fib(n - 2);
}
float even(float n) { return odd(n - 1); }
float odd(float n) { return even(n - 1); }
[node("Test/F")]
float F(float a = 1) {
    return fib(a) + even(a);
}
