using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Session;

namespace Nowpose.Cli.Headset;

/// <summary>Settings of a <c>headset</c> run.</summary>
sealed record HeadsetSettings
{
    public required ConnectionSettings Connection { get; init; }

    /// <summary>The robot; null to use the robot that the gateway describes.</summary>
    public RobotModel Robot { get; init; }

    /// <summary>Namespace of the robot; empty for the robot without a namespace.</summary>
    public string RobotNamespace { get; init; } = "";

    /// <summary>Maximum time to wait for the gateway's description of the robot.</summary>
    public TimeSpan DescriptionTimeout { get; init; } = TimeSpan.FromSeconds(10);

    public string Predictor { get; init; }
    public string Estimator { get; init; }

    /// <summary>Profile that replaces <see cref="Visualisation"/>; null to use <see cref="Visualisation"/>.</summary>
    public LatencyProfile Profile { get; init; }

    public VisualisationLatency Visualisation { get; init; }

    /// <summary>Settings of the session. They exclude the profile's display, because nothing is rendered.</summary>
    public SessionSettings Session =>
        new(Connection, Visualisation, new PredictionSettings(Predictor), clockEstimator: Estimator, profile: Profile?.WithoutDisplay(),
            robotNamespace: RobotNamespace);

    public double Seconds { get; init; }
    public double FramesPerSecond { get; init; }

    /// <summary>Path of the session's recording; null to record nothing.</summary>
    public string RecordingPath { get; init; }

    /// <summary>Maximum size of the recording, MB of 10⁶ bytes.</summary>
    public double RecordingMegabytes { get; init; } = DefaultRecordingMegabytes;

    public const double DefaultRecordingMegabytes = 500;
}
