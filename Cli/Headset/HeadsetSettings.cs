using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Session;

namespace Nowpose.Cli.Headset;

/// <summary>Settings of a run of <c>headset</c>.</summary>
sealed record HeadsetSettings
{
    public required ConnectionSettings Connection { get; init; }

    /// <summary>"youbot", "ur5" or a file; null for the robot that the gateway describes.</summary>
    public string Robot { get; init; }

    public string Predictor { get; init; }
    public string Estimator { get; init; }

    /// <summary>Replaces <see cref="Visualisation"/>; null for none.</summary>
    public LatencyProfile Profile { get; init; }

    public VisualisationLatency Visualisation { get; init; }

    /// <summary>Settings of the session. Nothing is rendered, so that the profile's range does not apply.</summary>
    public SessionSettings Session =>
        new(Connection, Visualisation, new PredictionSettings(Predictor), clockEstimator: Estimator, profile: Profile?.WithoutRange());

    public double Seconds { get; init; }
    public double FramesPerSecond { get; init; }

    /// <summary>Path of the session's recording; null for none.</summary>
    public string RecordingPath { get; init; }
}
