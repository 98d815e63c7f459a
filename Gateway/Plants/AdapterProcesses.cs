using Nowpose.Gateway.Options;
using Nowpose.Gateway.Security;

namespace Nowpose.Gateway.Plants;

/// <summary>The adapter programs that a gateway starts, one for each control system.</summary>
sealed class AdapterProcesses : IAsyncDisposable
{
    readonly AdapterProcess[] _processes;

    // One log per adapter, so that many lines of one adapter do not suppress the lines of another.
    readonly RateLimitedLog[] _logs;

    AdapterProcesses(PlantFile[] plants, GatewayServer gateway)
    {
        var access = AdapterAccess.To(gateway);
        _logs = [.. plants.Select(_ => gateway.NewLog())];
        _processes = [.. plants.Zip(_logs, (plant, log) => new AdapterProcess(plant, access, gateway.Time, log.Write))];
    }

    /// <summary>Checks that adapters can connect to the address of the gateway.</summary>
    /// <param name="encrypts">Whether the gateway uses TLS.</param>
    /// <exception cref="InputException">There are adapters, and they would have to connect to another address than loopback without TLS.</exception>
    public static void CheckAddress(IReadOnlyCollection<string> files, GatewayOptions options, bool encrypts)
    {
        if (files.Count > 0 && !encrypts && !OwnHosts.IsLocalhostReachable(options.Bind))
            throw new InputException(AdapterMessages.NoTls(options.Bind));
    }

    /// <summary>Checks all plant configurations.</summary>
    /// <exception cref="InputException">A configuration has invalid entries. The message lists the invalid entries of all files.</exception>
    public static async Task<IReadOnlyList<PlantFile>> CheckAsync(IReadOnlyCollection<string> files, CancellationToken stop)
    {
        var good = new List<PlantFile>();
        var bad = new List<string>();
        foreach (var file in files)
        {
            if (!File.Exists(file))
            {
                bad.Add(PathMessages.NotFound(file));
                continue;
            }

            try
            {
                var plant = await AdapterProgram.CheckAsync(file, stop);
                if (good.Find(other => other.Name == plant.Name) is { } other)
                    bad.Add(AdapterMessages.SameName(file, plant.Name, other.Path));
                else if (plant.PasswordVariable is { } variable && good.Find(reader => reader.PasswordVariable == variable) is { } reading)
                    bad.Add(AdapterMessages.SamePassword(file, variable, reading.Path));
                if (plant.SoleConnectionTo is { } machine && good.Find(connected => connected.SoleConnectionTo == machine) is { } first)
                    bad.Add(AdapterMessages.SecondConnection(file, machine, first.Path));
                good.Add(plant);
            }
            catch (WrongEntriesException wrong)
            {
                bad.AddRange(wrong.Lines);
            }
        }

        return bad.Count == 0 ? good : throw new WrongEntriesException(bad);
    }

    /// <summary>Starts an adapter for each plant.</summary>
    /// <param name="gateway">The running gateway. It logs the programs' output, and becomes ready when all adapters have reported.</param>
    public static AdapterProcesses Start(IEnumerable<PlantFile> plants, GatewayServer gateway)
    {
        var started = new AdapterProcesses([.. plants], gateway);
        gateway.Expect([.. started._processes.Select(process => (Func<AdapterState>)(() => process.State))]);
        return started;
    }

    public async ValueTask DisposeAsync()
    {
        await Task.WhenAll(_processes.Select(process => process.DisposeAsync().AsTask()));
        foreach (var log in _logs) log.Dispose();
    }
}
