using System.Diagnostics;
using System.Text.Json;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.Recording;
using Nowpose.Web;

namespace Nowpose.Gateway.Plants;

/// <summary>The Node.js program that reads a control system, built from Gateway/Adapters.</summary>
static class AdapterProgram
{
    static readonly TimeSpan CheckTimeout = TimeSpan.FromSeconds(30);
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
            var content = PlantContent.Read(file, lines.Length == 2 ? lines[1] : "");
            content.RequireValidRobots(file);
            return new PlantFile(file, content.Name, lines[0].Trim())
            {
                Joints = content.Joints, PassesUnlisted = content.PassesUnlisted, HasObjects = content.HasObjects, Robot = content.Robot,
                Robots = content.Robots ?? [], Warnings = content.Warnings ?? [], Frames = content.Frames ?? [],
                Signals = content.Signals ?? [], OffersClock = content.OffersClock, SoleConnectionTo = content.SoleConnectionTo,
                PasswordVariable = content.PasswordVariable,
            };
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

    internal sealed record PlantContent(
        string Name, string[] Joints, bool PassesUnlisted, string Robot, Dictionary<string, string> Robots = null, bool HasObjects = false,
        string[] Warnings = null, Dictionary<string, string[]> Frames = null, string[] Signals = null, Dictionary<string, string> DescribedBy = null,
        bool OffersClock = true, string SoleConnectionTo = null, string PasswordVariable = null)
    {
        static readonly JsonSerializerOptions Names = new() { PropertyNamingPolicy = JsonNamingPolicy.SnakeCaseLower };

        /// <summary>Parses the result that the program printed.</summary>
        /// <exception cref="InputException">The result has another format, for example because the program has another version.</exception>
        public static PlantContent Read(string file, string json)
        {
            try
            {
                if (JsonSerializer.Deserialize<PlantContent>(json, Names) is { Name: not null, Joints: not null } content) return content;
            }
            catch (JsonException)
            {
                // The exception below reports it.
            }

            throw new InputException(AdapterMessages.CheckUnreadable(file));
        }

        /// <summary>Checks the robot descriptions of a valid file, because the program reads only the names in them.</summary>
        /// <remarks>An invalid description from a source is only an event, because the gateway has no entry that the user could correct.</remarks>
        /// <exception cref="WrongEntriesException">At least one description is invalid. The message names the entry of the file, and the line in the description.</exception>
        public void RequireValidRobots(string file)
        {
            var wrong = new List<string>();
            foreach (var (robot, urdf) in (Robots ?? []).Append(KeyValuePair.Create("", Robot)))
                if (new DescribedRobot(urdf, DescribedBy?.GetValueOrDefault(robot) ?? file).Fault is { } fault) wrong.Add(fault);
            if (wrong.Count > 0) throw new WrongEntriesException(wrong);
        }
    }
}
