namespace Nowpose.Benchmarks.Load;

/// <summary>The memory of a gateway after a number of sessions.</summary>
readonly record struct MemorySample(int Sessions, double ResidentBytes, double ManagedBytes)
{
    const double Mebibyte = 1024 * 1024;

    public double ResidentMiB => ResidentBytes / Mebibyte;
    public double ManagedMiB => ManagedBytes / Mebibyte;
}
