using System.Net;
using Nowpose.Gateway.Options;

namespace Nowpose.Gateway.Plants;

/// <summary>The adapters that a gateway brings with it, one for each control system.</summary>
sealed class AdapterProcesses : IAsyncDisposable
{
    readonly AdapterProcess[] _processes;

    AdapterProcesses(AdapterProcess[] processes) => _processes = processes;

    /// <summary>Checks all configurations, and says what they read.</summary>
    /// <param name="options">Of the gateway that they are for.</param>
    /// <exception cref="InputException">Any has wrong entries: all of them, of all files.</exception>
    public static async Task<IReadOnlyList<string>> CheckAsync(
        IReadOnlyCollection<string> files, GatewayOptions options, CancellationToken stop)
    {
        if (files.Count > 0 && options.Certificate == null && !options.IsLoopback && !IsAny(options.Bind))
            throw new InputException(
                $"--plant with --bind {options.Bind} and no --tls: adapters come over TLS or loopback only; add --tls, or bind to any");
        var good = new List<string>();
        var bad = new List<string>();
        foreach (var file in files)
        {
            if (!File.Exists(file))
            {
                bad.Add($"{file}: there is no such file");
                continue;
            }

            try
            {
                good.Add(await AdapterProgram.CheckAsync(file, stop));
            }
            catch (WrongEntriesException wrong)
            {
                bad.AddRange(wrong.Lines);
            }
        }

        return bad.Count == 0 ? good : throw new WrongEntriesException(bad);
    }

    /// <summary>Starts an adapter for each file.</summary>
    /// <param name="gateway">Serves already; their lines go into its log.</param>
    public static AdapterProcesses Start(IEnumerable<string> files, GatewayServer gateway)
    {
        var access = AdapterAccess.To(gateway);
        return new AdapterProcesses([.. files.Select(file => new AdapterProcess(file, access, gateway.Log, gateway.Events.Note))]);
    }

    static bool IsAny(IPAddress bind) => bind.Equals(IPAddress.Any) || bind.Equals(IPAddress.IPv6Any);

    public async ValueTask DisposeAsync() => await Task.WhenAll(_processes.Select(process => process.DisposeAsync().AsTask()));
}
