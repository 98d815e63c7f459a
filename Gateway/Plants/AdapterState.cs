namespace Nowpose.Gateway.Plants;

/// <summary>State of an adapter's program that this gateway supervises.</summary>
/// <param name="Name">Name of its plant.</param>
/// <param name="RunTime">Time since its last start; null while it does not run.</param>
/// <param name="End">How it last ended, for example "status 1"; null if it has not ended yet.</param>
readonly record struct AdapterState(string Name, TimeSpan? RunTime, string End);
