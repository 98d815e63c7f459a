using Nowpose.Sync;

namespace Nowpose.Cli.Sessions;

/// <summary>A sync exchange as it came over the wire.</summary>
/// <param name="T4Nanoseconds">As written; the time types round to 100 ns.</param>
sealed record SyncLine(long T4Nanoseconds, SyncExchange Exchange) : SessionLine;
