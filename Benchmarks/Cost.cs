namespace Nowpose.Benchmarks;

/// <param name="Nanoseconds">Median.</param>
/// <param name="Bytes">Allocated.</param>
readonly record struct Cost(double Nanoseconds, long Bytes);
