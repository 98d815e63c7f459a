using Nowpose.Sync;

namespace Nowpose.Cli.Sync;

/// <summary>An exchange of a log.</summary>
/// <param name="T4Nanoseconds">t4 as in the log, ns. The time types round to 100 ns.</param>
/// <param name="Stamps">Time stamps of a log that does not state the resolution of the control clock; null if it does.</param>
readonly record struct LoggedExchange(long T4Nanoseconds, SyncExchange Exchange, LoggedStamps? Stamps)
{
    /// <summary>Creates an exchange of a log that does not state the resolution of the control clock.</summary>
    public static LoggedExchange Of(LoggedStamps stamps) => new(stamps.T4, stamps.ExchangeWith(TimeSpan.Zero), stamps);

    /// <summary>Returns the exchange, with a resolution that the log itself does not state.</summary>
    public SyncExchange ExchangeWith(TimeSpan resolution) => Stamps?.ExchangeWith(resolution) ?? Exchange;
}

/// <summary>The four time stamps of an exchange as in a log, ns.</summary>
readonly record struct LoggedStamps(long T1, long T2, long T3, long T4)
{
    public SyncExchange ExchangeWith(TimeSpan resolution) => new(
        HeadsetTime.FromNanoseconds(T1), ControlTime.FromNanoseconds(T2), ControlTime.FromNanoseconds(T3), HeadsetTime.FromNanoseconds(T4),
        resolution);
}
