using Nowpose.Sync;

namespace Nowpose.Cli.Messages;

/// <summary>Error messages about logs of sync exchanges.</summary>
static class ExchangeFileMessages
{
    public static string NoExchange(string path) => $"{path}: contains no sync exchange; at least one is needed";
    public static string AllDropped(string path, int exchanges, IReadOnlyCollection<SyncExchangeFault> faults) =>
        $"{path}: all {exchanges} exchanges were dropped: {string.Join(", ", faults)}; {string.Join("; ", faults.Select(Remedy).Distinct())}";

    public static string Remedy(SyncExchangeFault fault) => fault switch
    {
        SyncExchangeFault.NotNewer => "the rows must be in the order of t4",
        SyncExchangeFault.ImplausibleTime => "the times must be in ns",
        _ => "t1 and t4 must be times of C2 (headset), t2 and t3 of C1 (control system), with t1 before t4 and t2 not after t3",
    };

    public static string TimeOrder(long ns, long previousNs) => $"t_ns: {ns} ns is not after {previousNs} ns; times must increase";
}
