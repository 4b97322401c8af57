/// A value, squared, by text.
[node("Custom/Square")]
[foreign]
float Square(float x) { return x * x; }
