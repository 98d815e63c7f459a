namespace Nowpose.Benchmarks;

/// <param name="Nanoseconds">Median time, ns.</param>
/// <param name="Bytes">Allocated bytes.</param>
readonly record struct Cost(double Nanoseconds, long Bytes);
