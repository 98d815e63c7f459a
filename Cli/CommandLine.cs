using MathNet.Numerics;
using Nowpose.Gateway.Options;

namespace Nowpose.Cli;

/// <summary>The command line as a whole: its verbs, and the default verb when none is given.</summary>
public static class CommandLine
{
    const string DefaultVerb = "demo";

    /// <summary>Runs one command and returns the exit status. Never throws for invalid user input.</summary>
    public static Task<int> RunAsync(string[] args)
    {
        // Math.NET's loops over small matrices wait for a second core. With that core busy, they took a hundred times as long.
        Control.UseSingleThread();
        return Invocation.RunAsync(
            Invocation.Root(
                "nowpose", "Shows a moving robot where it is, not where it was. Without a command: demo.",
                Demo.DemoVerb.Create(), Replay.ReplayVerb.Create(), Sync.SyncVerb.Create(), Recommend.RecommendVerb.Create(),
                Kinematics.KinematicsVerb.Create(), Headset.HeadsetVerb.Create(), Figures.FiguresVerb.Create(), Calibrate.CalibrateVerb.Create(),
                Unity.UnityVerb.Create()),
            WithVerb(args));
    }

    static string[] WithVerb(string[] args)
    {
        var isAboutAll = args.Length > 0 && args[0] is "--help" or "-h" or "-?" or "--version";
        var namesVerb = args.Length > 0 && !args[0].StartsWith('-');
        return isAboutAll || namesVerb ? args : [DefaultVerb, .. args];
    }
}
