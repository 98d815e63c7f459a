namespace Nowpose.Gateway.Plants;

/// <summary>State of an adapter program that this gateway supervises.</summary>
/// <param name="Name">Name of the adapter's plant.</param>
/// <param name="RunTime">Time since the last start; null while the program is not running.</param>
/// <param name="End">Result of the last run, for example "status 1"; null if the program has not ended yet.</param>
readonly record struct AdapterState(string Name, TimeSpan? RunTime, string End);
