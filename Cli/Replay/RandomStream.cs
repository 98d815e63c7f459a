namespace Nowpose.Cli.Replay;

/// <summary>
/// Uniform random numbers that depend only on the seed and on the purpose for which they are used. A different loss, for example, does not change the
/// jitter.
/// </summary>
/// <remarks>
/// Uses SplitMix64 (Steele, Lea, Flood 2014). The numbers are the same on every machine and independent for consecutive seeds, which
/// <see cref="Random"/> does not guarantee.
/// </remarks>
sealed class RandomStream
{
    const ulong Golden = 0x9E3779B97F4A7C15;

    ulong _state;

    public RandomStream(int seed, int purpose) => _state = Mix(Mix((uint)seed + Golden) ^ (uint)purpose);

    /// <summary>Gets the next number, from 0 inclusive to 1 exclusive.</summary>
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
