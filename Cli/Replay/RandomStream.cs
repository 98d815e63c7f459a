namespace Nowpose.Cli.Replay;

/// <summary>Uniform numbers that depend on seed and purpose only: jitter stays as it is when loss changes.</summary>
/// <remarks>
/// SplitMix64 (Steele, Lea, Flood 2014): the same on every machine, and neighbouring seeds are independent, which
/// <see cref="Random"/> does not promise.
/// </remarks>
sealed class RandomStream
{
    const ulong Golden = 0x9E3779B97F4A7C15;

    ulong _state;

    public RandomStream(int seed, int purpose) => _state = Mix(Mix((uint)seed + Golden) ^ (uint)purpose);

    /// <summary>From 0 up to but not including 1.</summary>
    public double Next()
    {
        _state += Golden;
        return (Mix(_state) >> 11) * (1.0 / (1UL << 53));
    }

    static ulong Mix(ulong z)
    {
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
        return z ^ (z >> 31);
    }
}
