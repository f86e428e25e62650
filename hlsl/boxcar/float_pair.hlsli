// float_pair.hlsli: numbers of 48 bits, each the sum of two floats.
//
// For sums and quotients that are to be right to the last bit of a float, where the hardware has no doubles. Each lane
// of a pair is a number of its own: high + low, with |low| at most half a unit in the last place of high.
//
//   FloatPairOf, FloatPairSplat, FloatPairSum, FloatPairProduct    pairs from floats; all exact
//   FloatPairLane                                                  a lane of a pair in all four
//   FloatPairAdd, .. Sub, .. Mul, .. Div, .. Sqrt                  arithmetic on pairs
//   FloatPairToFloat                                               rounded to the nearest float
//
// Range:  magnitudes up to 2^100; where a product's low part falls below 2^-126 it is lost.
// Error:  2^-46 of the larger operand for FloatPairAdd and FloatPairSub; of the result 2^-45 for FloatPairMul, 2^-44
//         for FloatPairDiv and FloatPairSqrt (FloatPair.ErrorsStayWithinTheirBounds).
// Needs:  floats that round as IEEE 754 does. `precise` keeps compilers from simplifying what is exactly 0 in theory:
//         fxc, dxc and glslang heed it; vkd3d up to 2.1 drops it when it compiles HLSL.
//
// Dekker 1971, "A floating-point technique for extending the available precision"; Knuth, TAOCP 2, sect. 4.2.2
#ifndef BOXCAR_FLOAT_PAIR_HLSLI
#define BOXCAR_FLOAT_PAIR_HLSLI

struct FloatPair
{
    float4 high;
    float4 low;
};

FloatPair FloatPairOf(float4 high, float4 low)
{
    FloatPair r;
    r.high = high;
    r.low = low;
    return r;
}

// FloatPairSplat: the same float in every lane.
FloatPair FloatPairSplat(float value)
{
    return FloatPairOf((float4)value, (float4)0);
}

// FloatPairLane: one lane's number in every lane.
FloatPair FloatPairLane(FloatPair a, int lane)
{
    return FloatPairOf((float4)a.high[lane], (float4)a.low[lane]);
}

// FloatPairSum: a + b, exactly.
FloatPair FloatPairSum(float4 a, float4 b)
{
    precise float4 sum = a + b;
    precise float4 ofB = sum - a;
    precise float4 lost = (a - (sum - ofB)) + (b - ofB);
    return FloatPairOf(sum, lost);
}

// FloatPairOrdered: a + b, exactly, where |a| >= |b| or a is 0.
FloatPair FloatPairOrdered(float4 a, float4 b)
{
    precise float4 sum = a + b;
    precise float4 lost = b - (sum - a);
    return FloatPairOf(sum, lost);
}

// FloatPairSplit: a as two floats of 12 bits each, whose products with such halves are exact.
FloatPair FloatPairSplit(float4 a)
{
    precise float4 scaled = 4097.0 * a;
    precise float4 high = scaled - (scaled - a);
    precise float4 low = a - high;
    return FloatPairOf(high, low);
}

// FloatPairProduct: a * b, exactly.
FloatPair FloatPairProduct(float4 a, float4 b)
{
    FloatPair sa = FloatPairSplit(a);
    FloatPair sb = FloatPairSplit(b);
    precise float4 product = a * b;
    precise float4 lost = ((sa.high * sb.high - product) + sa.high * sb.low + sa.low * sb.high) + sa.low * sb.low;
    return FloatPairOf(product, lost);
}

FloatPair FloatPairAdd(FloatPair a, FloatPair b)
{
    FloatPair high = FloatPairSum(a.high, b.high);
    FloatPair low = FloatPairSum(a.low, b.low);
    precise float4 middle = high.low + low.high;
    FloatPair sum = FloatPairOrdered(high.high, middle);
    precise float4 rest = sum.low + low.low;
    return FloatPairOrdered(sum.high, rest);
}

FloatPair FloatPairSub(FloatPair a, FloatPair b)
{
    return FloatPairAdd(a, FloatPairOf(-b.high, -b.low));
}

FloatPair FloatPairMul(FloatPair a, FloatPair b)
{
    FloatPair product = FloatPairProduct(a.high, b.high);
    precise float4 low = product.low + (a.high * b.low + a.low * b.high);
    return FloatPairOrdered(product.high, low);
}

// FloatPairDiv: a / b; b is not 0.
FloatPair FloatPairDiv(FloatPair a, FloatPair b)
{
    precise float4 quotient = a.high / b.high;
    FloatPair product = FloatPairProduct(quotient, b.high);
    precise float4 rest = (((a.high - product.high) - product.low) + a.low) - quotient * b.low;
    precise float4 correction = rest / b.high;
    return FloatPairOrdered(quotient, correction);
}

// FloatPairSqrt: of a float above 0.
FloatPair FloatPairSqrt(float4 a)
{
    precise float4 root = sqrt(a);
    FloatPair square = FloatPairProduct(root, root);
    precise float4 correction = ((a - square.high) - square.low) / (2.0 * root);
    return FloatPairOrdered(root, correction);
}

float4 FloatPairToFloat(FloatPair a)
{
    return a.high + a.low;
}

#endif
