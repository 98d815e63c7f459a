using Nowpose.Sync;

namespace Nowpose.Cli.SessionFiles;

/// <summary>A received sync exchange.</summary>
/// <param name="T4Nanoseconds">t4 as in the file, ns. The time types round to 100 ns.</param>
sealed record SyncLine(long T4Nanoseconds, SyncExchange Exchange) : SessionLine;
