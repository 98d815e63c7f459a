using Nowpose.Gateway.Options;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Motion;
using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Simulation.Work;
using Nowpose.Sync;

namespace Nowpose.Cli.Demo;

/// <summary>Settings of one demo run. Checked when they are created from the options.</summary>
sealed record DemoSettings
{
    public double Seconds { get; init; }
    public NetworkProfile Network { get; init; }
    public RobotModel Robot { get; init; }

    /// <summary>The robot's URDF, which the gateway publishes.</summary>
    public string RobotText { get; init; }

    /// <summary>The true motion of the robot.</summary>
    public IMotion Motion { get; init; }

    /// <summary>The work of the robot, which moves objects; null for a motion that is not known to grip.</summary>
    public CellWork Work { get; init; }

    /// <summary>Name of the motion in the report.</summary>
    public string MotionName { get; init; }

    public string Predictor { get; init; }

    /// <summary>Blend time of the prediction's sections, ms.</summary>
    public double BlendMs { get; init; } = PredictionSettings.DefaultBlendMs;
    public string Estimator { get; init; } = ClockEstimators.Default;

    /// <summary>The profile that the runtime is given; null for the true display latency with <see cref="VisualisationErrorMs"/>.</summary>
    public LatencyProfile Profile { get; init; }

    /// <summary>The display latency that the runtime is given, ms. With a load, it is calibrated unless there is a profile.</summary>
    public double GivenVisualisationMs => Profile?.Visualisation.Length.TotalMilliseconds ?? VisualisationMs + VisualisationErrorMs;

    public double SamplingMs { get; init; }
    public MillisecondRange Acquisition { get; init; }
    public double VisualisationMs { get; init; }

    /// <summary>Error added to the true display latency before it is given to the runtime, ms.</summary>
    public double VisualisationErrorMs { get; init; }

    /// <summary>Vertices of the scene's load; null for a display whose frames are never late.</summary>
    public int? Load { get; init; }

    /// <summary>Constant number of vertices of a scene whose frames have render times; null for none. Ignored if <see cref="Load"/> is set.</summary>
    public int? SteadyVertices { get; init; }

    /// <summary>Refresh interval of a display with render times, ms.</summary>
    public double RefreshMs { get; init; } = 1000.0 / DemoDisplay.FramesPerSecond;

    /// <summary>Whether frames have render times, and may be late.</summary>
    public bool IsRendered => Load != null || SteadyVertices != null;

    /// <summary>Whether sync exchanges have the same interval at all times, as in the paper.</summary>
    public bool HasConstantSyncInterval { get; init; }

    /// <summary>Whether the cell publishes its set-points in advance.</summary>
    public bool PublishesPlan { get; init; }

    public int Seed { get; init; }
}
