namespace Nowpose.Gateway.Plants;

/// <summary>State of an adapter's program that this gateway keeps running.</summary>
/// <param name="Name">Of its plant.</param>
/// <param name="RunTime">Time since its last start; null while it does not run.</param>
/// <param name="End">How it ended the last time, "status 1"; null when it has not ended yet.</param>
readonly record struct AdapterState(string Name, TimeSpan? RunTime, string End);
