using System.Diagnostics;
using System.Text.Json;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.Recording;
using Nowpose.Web;

namespace Nowpose.Gateway.Plants;

/// <summary>The Node.js program that reads a control system, built from Gateway/Adapters.</summary>
static class AdapterProgram
{
    static readonly TimeSpan CheckTimeout = TimeSpan.FromSeconds(30);
    static readonly JsonSerializerOptions Names = new() { PropertyNamingPolicy = JsonNamingPolicy.SnakeCaseLower };
    static readonly string Script = Path.Combine(AppContext.BaseDirectory, "adapters", "plant.mjs");

    /// <summary>Runs the program to check a configuration file, without connecting to the plant.</summary>
    /// <exception cref="InputException">
    /// The file has invalid entries, which the message lists with their lines, or the program cannot run.
    /// </exception>
    /// <exception cref="IOException">The machine is too busy for the check.</exception>
    public static async Task<PlantFile> CheckAsync(string file, CancellationToken stop)
    {
        using var process = Start(file, ["--check"], null);
        process.StandardInput.Close();
        using var timeout = CancellationTokenSource.CreateLinkedTokenSource(stop);
        timeout.CancelAfter(CheckTimeout);
        try
        {
            var good = process.StandardOutput.ReadToEndAsync(timeout.Token);
            var bad = process.StandardError.ReadToEndAsync(timeout.Token);
            await process.WaitForExitAsync(timeout.Token);
            if (process.ExitCode != 0) throw new WrongEntriesException((await bad).Trim().Split('\n'));
            var lines = (await good).Trim().Split('\n', 2);
            var plant = Read(file, lines[0].Trim(), lines.Length == 2 ? lines[1] : "");
            RequireValidRobots(plant);
            return plant;
        }
        catch (OperationCanceledException) when (!stop.IsCancellationRequested)
        {
            throw new IOException(AdapterMessages.CheckTooSlow(file, CheckTimeout.TotalSeconds));
        }
        finally
        {
            if (!process.HasExited) process.Kill();
        }
    }

    /// <summary>Starts the program with redirected standard input and outputs.</summary>
    /// <param name="access">Access to the gateway; null for a run that does not connect to it.</param>
    /// <exception cref="InputException">Node.js is missing, or was missing when the gateway was built.</exception>
    public static Process Start(string file, IEnumerable<string> options, AdapterAccess access)
    {
        return NodeProgram.Start(AdapterMessages.NodeNeeded, Script, [file, .. options], process =>
        {
            // With this variable, the program ends when its standard input is closed, which also happens when this process is killed.
            process.StartInfo.Environment["NOWPOSE_SUPERVISED"] = "1";
            // Trusts the certificates of this machine's store too. Without it, Node.js trusts only the authorities on its own list.
            process.StartInfo.Environment.TryAdd("NODE_USE_SYSTEM_CA", "1");
            access?.AddTo(process.StartInfo.Environment);
        });
    }

    /// <summary>Parses the result that the program printed.</summary>
    /// <exception cref="InputException">The result has another format, for example because the program has another version.</exception>
    internal static PlantFile Read(string file, string summary, string json)
    {
        try
        {
            if (JsonSerializer.Deserialize<PlantFile>(json, Names) is { Name: not null, Joints: not null } plant)
                return plant with { Path = file, Summary = summary };
        }
        catch (JsonException)
        {
            // The exception below reports it.
        }

        throw new InputException(AdapterMessages.CheckUnreadable(file));
    }

    // Checks the robot descriptions of a valid file, because the program reads only the names in them. An invalid description from a source is only an
    // event, because the gateway has no entry that the user could correct.
    static void RequireValidRobots(PlantFile plant)
    {
        var wrong = new List<string>();
        foreach (var (robot, urdf) in plant.Robots.Append(KeyValuePair.Create("", plant.Robot)))
            if (new DescribedRobot(urdf, plant.DescribedBy.GetValueOrDefault(robot) ?? plant.Path).Fault is { } fault) wrong.Add(fault);
        // The message names the entry of the file, and the line in the description.
        if (wrong.Count > 0) throw new WrongEntriesException(wrong);
    }
}
