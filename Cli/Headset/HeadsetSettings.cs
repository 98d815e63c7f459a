using Nowpose.Latency;
using Nowpose.Network;

namespace Nowpose.Cli.Headset;

/// <summary>What a run of <c>headset</c> is told.</summary>
sealed record HeadsetSettings
{
    public required ConnectionSettings Connection { get; init; }

    /// <summary>youbot, ur5 or a file; null for the robot that the gateway describes.</summary>
    public string Robot { get; init; }

    public string Predictor { get; init; }
    public VisualisationLatency Visualisation { get; init; }
    public double Seconds { get; init; }
    public double FramesPerSecond { get; init; }

    /// <summary>Where the session is recorded; null for nowhere.</summary>
    public string RecordingPath { get; init; }
}
