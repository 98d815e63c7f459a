using System.CommandLine;
using Nowpose.Gateway.Options;

namespace Nowpose.Benchmarks.Links;

/// <summary>links: measures a headset over slow and lossy links, using the kernel's TCP implementation.</summary>
static class LinksVerb
{
    static readonly Option<string[]> Profiles = TextOption.CreateList(
        "--profile", $"Link to run; can be given several times [{string.Join(", ", LinkProfile.All.Select(p => p.Name))}] [default: all]", "NAME");
    static readonly Option<int> Repeats = NumberOption.Create("--repeats", "Number of runs over each link", 5, 1, 1000, "");
    static readonly Option<double> Seconds = NumberOption.Create(
        "--seconds", "Length of a run; limits hold for 30 s or more", LinkLimits.Seconds, 5, 3600, "s");
    static readonly Option<int> Seed = NumberOption.Create("--seed", "Seed of the first run; each further run uses the next one", 1, 0, 1_000_000, "");
    static readonly Option<bool> Reorder = SwitchOption.Create("--reorder", "Allow packets to arrive in another order");
    static readonly Option<string> Out = TextOption.Create("--out", "File for the results of all runs, as JSON", "FILE");
    static readonly Option<string> Sessions = TextOption.Create(
        "--sessions", "Folder for the headset's session files; created if it does not exist", "FOLDER");

    public static Command Create()
    {
        var command = new Command(
            "links", "Run a gateway and a headset in separate network namespaces with an emulated link between them. Needs Linux and root.")
        {
            Profiles, Repeats, Seconds, Seed, Reorder, Out, Sessions,
        };
        command.SetAction((parsed, stop) => RunAsync(Settings(parsed), parsed.GetValue(Out), stop));
        return command;
    }

    static LinkSettings Settings(ParseResult parsed)
    {
        var names = parsed.GetValue(Profiles) ?? [];
        var folder = parsed.GetValue(Sessions);
        return new LinkSettings(
            names.Length == 0 ? LinkProfile.All : [.. names.Select(LinkProfile.Named)], parsed.GetValue(Repeats), parsed.GetValue(Seconds),
            parsed.GetValue(Seed), !parsed.GetValue(Reorder), folder == null ? null : Directory.CreateDirectory(folder).FullName);
    }

    static async Task<int> RunAsync(LinkSettings settings, string file, CancellationToken stop)
    {
        if (FindProblem() is string reason)
        {
            Console.Out.WriteLine($"skipped: {reason}");
            return ExitStatus.Done;
        }

        var results = new List<LinkResult>();
        try
        {
            for (var repeat = 0; repeat < settings.Repeats; repeat++)
                foreach (var profile in settings.Profiles)
                    results.Add(await PlayAsync(settings, profile, repeat, stop));
        }
        finally
        {
            // Also writes the results of an interrupted run.
            if (results.Count > 0) LinkTable.Write(results);
            if (file != null) await File.WriteAllTextAsync(file, LinkTable.Json(results), CancellationToken.None);
        }

        if (settings.Seconds < LinkLimits.Seconds) return ExitStatus.Done;
        var missed = results.GroupBy(result => result.Profile).SelectMany(runs => LinkLimits.Missed([.. runs])).ToList();
        foreach (var line in missed) Console.Error.WriteLine("error: " + line);
        return missed.Count == 0 ? ExitStatus.Done : ExitStatus.Failed;
    }

    static async Task<LinkResult> PlayAsync(LinkSettings settings, LinkProfile profile, int repeat, CancellationToken stop)
    {
        var result = await LinkRun.PlayAsync(settings, profile, settings.Seed + repeat, stop);
        Console.Error.WriteLine(FormattableString.Invariant(
            $"{profile.Name}, run {repeat + 1} of {settings.Repeats}: ")
            + (result.CurrentAfterS is double after
                ? FormattableString.Invariant($"current after {after:0.00} s, reduction {100 * result.Reduction:0.0} %") : "never current"));
        return result;
    }

    static string FindProblem()
    {
        if (!OperatingSystem.IsLinux()) return "network namespaces and TUN devices exist on Linux only";
        if (!LinuxCalls.IsRoot) return "network namespaces and TUN devices need root";
        try
        {
            LinkRun.RemoveLeftovers();
            EmulatedLink.Create().Dispose();
            return null;
        }
        catch (Exception e) when (e is IOException or System.ComponentModel.Win32Exception)
        {
            return $"this machine has no network namespaces or TUN devices ({e.Message})";
        }
    }
}
