using System.CommandLine;
using MathNet.Numerics;
using Nowpose.Gateway.Options;

namespace Nowpose.Cli;

/// <summary>Defines the command line: all commands, and the command that runs if none is given.</summary>
public static class CommandLine
{
    const string DefaultCommand = "demo";

    /// <summary>Creates the root command with all commands.</summary>
    public static Command Create() => Invocation.Root(
        "nowpose", "Draws virtual parts on a moving robot at its present position. Without a command: demo.",
        Demo.DemoVerb.Create(), Replay.ReplayVerb.Create(), Sync.SyncVerb.Create(), Recommend.RecommendVerb.Create(),
        Kinematics.KinematicsVerb.Create(), Headset.HeadsetVerb.Create(), Figures.FiguresVerb.Create(), Calibrate.CalibrateVerb.Create(),
        Unity.UnityVerb.Create());

    /// <summary>Runs one command and returns the exit status. Never throws for invalid user input.</summary>
    public static Task<int> RunAsync(string[] args)
    {
        // With several threads, Math.NET waits for a second core even for small matrices. On a busy machine, this made it 100 times slower.
        Control.UseSingleThread();
        return Invocation.RunAsync(Create(), WithCommand(args));
    }

    static string[] WithCommand(string[] args)
    {
        var isAboutAll = args.Length > 0 && args[0] is "--help" or "-h" or "-?" or "--version";
        var namesCommand = args.Length > 0 && !args[0].StartsWith('-');
        return isAboutAll || namesCommand ? args : [DefaultCommand, .. args];
    }
}
