// Formulas of CircleMath.cl for four contacts at a time, a lane each. No kernels here; constant cost a call. Every lane gives
// the bits of the formula that is named: the same operations in the same bracketing, and where that branches, all branches
// and then the one that it would have taken.

// a where the mask has all bits set, b where it has none.
float4 choose4(int4 mask, float4 a, float4 b) { return select(b, a, mask); }

// greatest
float4 greatest4(float4 a, float4 b) { return choose4(a > b, a, b); }

// norm
float4 norm4(float4 x, float4 y) { return sqrt(x * x + y * y); }

// along
float4 along4(float4 nx, float4 ny, float4 vx, float4 vy) { return nx * vx + ny * vy; }

// carries
int4 carries4(float4 lambda, float4 s, float4 vn, float4 thr2) {
    return (lambda > 0.0f) | ((s < 0.0f) & (vn * vn <= thr2));
}

// bounceThreshold
float4 bounceThreshold4(float4 sum, float4 e, float gravityRate, float lengthRate) {
    float4 creep = lengthRate * ((1.0f - e) * sum);
    return gravityRate * sum + creep * creep;
}

// pushSpeed
float4 pushSpeed4(float4 sum, float perLength, float perRoot) { return greatest4(perLength * sum, perRoot * sqrt(sum)); }

// rigid
float4 rigid4(float4 lambda, float4 k, float4 vn, float4 b) { return greatest4(lambda - k * (vn + b), (float4)(0.0f)); }

// freeBounce
float4 freeBounce4(float4 e, float4 vn, float4 k) { return -(1.0f + e) * vn * k; }

// rigid with a gap closing at s * inverseH where s > 0, else soft, of which it is the case of scales 1 and 0: multiplying by 1
// and taking 0 away change no bit of a number that is finite.
float4 rigidOrSoft4(const StepConstants *k, float4 lambda, float4 mass, float4 vn, float4 s, float4 push) {
    int4 gap = s > 0.0f;
    float4 soft = k->massScale * greatest4(k->biasRate * s, -push);
    float4 b = choose4(gap, s * k->inverseH, soft);
    float4 massScale = choose4(gap, (float4)(1.0f), (float4)(k->massScale));
    float4 impulseScale = choose4(gap, (float4)(0.0f), (float4)(k->impulseScale));
    return greatest4((lambda - mass * (massScale * vn + b)) - impulseScale * lambda, (float4)(0.0f));
}
