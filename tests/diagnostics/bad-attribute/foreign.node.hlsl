[foreign]
float declared(float x);
[foreign("other")]
float spelled(float x) { return x; }
[node("Test/F")]
float F(float x) { return declared(x) + spelled(x); }
