namespace Nowpose.Cli.Messages;

/// <summary>Error messages about logs of sync exchanges.</summary>
static class ExchangeFileMessages
{
    public static string NoExchange(string path) => $"{path}: contains no sync exchange; at least one is needed";
    public static string TimeOrder(long ns, long previousNs) => $"t_ns: {ns} ns is not after {previousNs} ns; times must increase";
}
