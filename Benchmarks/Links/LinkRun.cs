using System.Diagnostics;
using System.Globalization;
using System.Text.Json;

namespace Nowpose.Benchmarks.Links;

/// <summary>Runs a gateway and a headset in separate processes over one emulated link.</summary>
static class LinkRun
{
    const string Robot = "youbot";
    const double FramesPerSecond = 60;
    static readonly TimeSpan Visualisation = TimeSpan.FromMilliseconds(40);

    /// <summary>Timeout of the headset in addition to its run time.</summary>
    static readonly TimeSpan HeadsetTimeout = TimeSpan.FromSeconds(60);

    public static async Task<LinkResult> PlayAsync(LinkSettings settings, LinkProfile profile, int seed, CancellationToken stop)
    {
        var file = settings.SessionFolder == null
            ? Path.Combine(Path.GetTempPath(), RunName.Create("session.jsonl"))
            : Path.Combine(settings.SessionFolder, FormattableString.Invariant($"{profile.Name}-{seed}.jsonl"));
        try
        {
            using var link = EmulatedLink.Create();
            using var gateway = await GatewayProcess.StartAsync(
                link.InGateway(
                    "dotnet", GatewayProcess.OwnProgram, "simulate", "--bind", "any", "--insecure-lan", "--robot", Robot,
                    "--seed", FormattableString.Invariant($"{seed}")),
                stop);
            var truth = new LinkTruth(gateway["clock"], gateway["motion_start_ns"], Robot);
            var start = link.Start(profile, seed, settings.KeepsOrder);
            using var output = JsonDocument.Parse(await RunHeadsetAsync(link, settings.Seconds, file, stop));
            link.Stop();
            var clock = output.RootElement.GetProperty("clock");
            return new LinkScore(RecordedFrames.Read(file), truth, Robot, Visualisation, FramesPerSecond).Result(profile, start, seed) with
            {
                FinalClockErrorUs = ErrorUs(clock, truth),
                FinalStatedErrorUs = Number(clock, "estimated_error_us"),
                Packets = link.Sent,
                LostPackets = link.Lost,
                ReleaseLateUsP99 = link.Lateness.Quantile(0.99).TotalMicroseconds,
                ReleaseLateUsMax = link.Lateness.Maximum.TotalMicroseconds,
            };
        }
        finally
        {
            if (settings.SessionFolder == null) File.Delete(file);
        }
    }

    /// <summary>Removes namespaces and files of earlier runs that were killed.</summary>
    public static void RemoveLeftovers()
    {
        NetworkNamespace.RemoveLeftovers();
        foreach (var file in RunName.Leftovers(Path.GetTempPath())) File.Delete(Path.Combine(Path.GetTempPath(), file));
    }

    static async Task<string> RunHeadsetAsync(EmulatedLink link, double seconds, string file, CancellationToken stop)
    {
        var headset = Process.Start(link.InHeadset(
            "dotnet", Path.Combine(AppContext.BaseDirectory, "Nowpose.Cli.dll"), "headset", "--host", EmulatedLink.GatewayAddress, "--insecure-lan",
            "--robot", Robot, "--seconds", seconds.ToString(CultureInfo.InvariantCulture), "--record", file, "--json",
            "--fps", FramesPerSecond.ToString(CultureInfo.InvariantCulture),
            "--visu-ms", Visualisation.TotalMilliseconds.ToString(CultureInfo.InvariantCulture)));
        var errors = headset.StandardError.ReadToEndAsync(CancellationToken.None);
        var output = await headset.StandardOutput.ReadToEndAsync(stop).WaitAsync(TimeSpan.FromSeconds(seconds) + HeadsetTimeout, stop);
        // A headset with a bad result exits with an error but is scored like any other. Only a headset without a result is an error here.
        return output.Length > 0 ? output : throw new InputException("the headset printed no result: " + (await errors).ReplaceLineEndings(" "));
    }

    static double? ErrorUs(JsonElement clock, LinkTruth truth)
    {
        if (clock.GetProperty("offset_ns").ValueKind == JsonValueKind.Null) return null;
        var at = HeadsetTime.FromNanoseconds(clock.GetProperty("at_ns").GetInt64());
        var trueNs = at.Nanoseconds - truth.ControlAt(at).Nanoseconds;
        return Math.Abs(clock.GetProperty("offset_ns").GetInt64() - trueNs) / 1000.0;
    }

    static double? Number(JsonElement fields, string name) =>
        fields.GetProperty(name) is { ValueKind: JsonValueKind.Number } value ? value.GetDouble() : null;
}

/// <summary>Options of <c>links</c>.</summary>
/// <param name="KeepsOrder">Whether packets in one direction keep their order, as on most real links.</param>
/// <param name="SessionFolder">Folder for the session files; null to delete them.</param>
sealed record LinkSettings(IReadOnlyList<LinkProfile> Profiles, int Repeats, double Seconds, int Seed, bool KeepsOrder, string SessionFolder);
