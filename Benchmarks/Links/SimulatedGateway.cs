using System.Diagnostics;

namespace Nowpose.Benchmarks.Links;

/// <summary>Runs <c>gateway simulate</c> in a separate process, which ends with its network namespace.</summary>
sealed class SimulatedGateway
{
    static readonly TimeSpan StartTimeout = TimeSpan.FromSeconds(60);

    readonly Dictionary<string, string> _values = [];

    /// <param name="robot">Name of an included robot, such as "youbot", or path of a URDF.</param>
    public static async Task<SimulatedGateway> StartAsync(EmulatedLink link, string robot, int seed, CancellationToken stop)
    {
        var process = Process.Start(link.InGateway(
            "dotnet", Path.Combine(AppContext.BaseDirectory, "Nowpose.Gateway.dll"), "simulate", "--bind", "any", "--insecure-lan",
            "--robot", robot, "--seed", FormattableString.Invariant($"{seed}")));
        var gateway = new SimulatedGateway();
        // Reads the error stream all the time, because a full pipe would block the gateway.
        var errors = process.StandardError.ReadToEndAsync(CancellationToken.None);
        if (!await gateway.ReadAsync(process.StandardOutput).WaitAsync(StartTimeout, stop))
            throw new InputException("the gateway ended before it was ready: " + (await errors).ReplaceLineEndings(" "));
        _ = process.StandardOutput.ReadToEndAsync(CancellationToken.None);
        return gateway;
    }

    /// <summary>Gets the value of a line "key value" that the gateway printed when it started.</summary>
    public string this[string key] => _values.TryGetValue(key, out var value)
        ? value : throw new InputException($"the gateway printed no line '{key}'");

    // Reads the lines of the start. Returns false if the gateway exited before it was ready.
    async Task<bool> ReadAsync(StreamReader output)
    {
        while (await output.ReadLineAsync() is string line)
        {
            if (line == "state serving") return true;
            if (line.Split(' ', 2) is [var key, var value]) _values[key] = value;
        }

        return false;
    }
}
