using Nowpose.Gateway.Options;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Simulation.Work;
using Nowpose.Sync;

namespace Nowpose.Cli.Demo;

/// <summary>Settings of one demo run. They are checked when they are created from the options.</summary>
sealed record DemoSettings
{
    public double Seconds { get; init; }
    public NetworkProfile Network { get; init; }
    public RobotModel Robot { get; init; }

    /// <summary>The robot's URDF, which the gateway publishes.</summary>
    public string RobotText { get; init; }

    /// <summary>The true motion of the cell, which has one robot.</summary>
    public CellMotion Motion { get; init; }

    /// <summary>Name of the motion in the report.</summary>
    public string MotionName { get; init; }

    /// <summary>Warnings about the recorded motion, one line each.</summary>
    public IReadOnlyList<string> MotionWarnings { get; init; } = [];

    public string Predictor { get; init; }

    /// <summary>Blend time of the prediction's sections, ms.</summary>
    public double BlendMs { get; init; } = PredictionSettings.DefaultBlendMs;
    public string Estimator { get; init; } = ClockEstimators.Default;

    /// <summary>The profile for the runtime. If null, the runtime uses the true display latency plus <see cref="VisualisationErrorMs"/>.</summary>
    public LatencyProfile Profile { get; init; }

    /// <summary>
    /// The display latency for the runtime, ms. Not used if there is a load but no profile, because the display is calibrated in that case.
    /// </summary>
    public double GivenVisualisationMs => Profile?.Visualisation.Length.TotalMilliseconds ?? VisualisationMs + VisualisationErrorMs;

    public double SamplingMs { get; init; }
    public MillisecondRange Acquisition { get; init; }
    public double VisualisationMs { get; init; }

    /// <summary>Error that is added to the true display latency for the runtime, ms.</summary>
    public double VisualisationErrorMs { get; init; }

    /// <summary>Number of vertices of the scene's load; null for a display on which no frame is late.</summary>
    public int? Load { get; init; }

    /// <summary>Constant number of vertices of a scene with render times; null for no render times. Ignored if <see cref="Load"/> is set.</summary>
    public int? SteadyVertices { get; init; }

    /// <summary>Refresh interval of the display, ms. Used only if frames have render times.</summary>
    public double RefreshMs { get; init; } = 1000.0 / DemoDisplay.FramesPerSecond;

    /// <summary>Whether frames have render times and can be late.</summary>
    public bool IsRendered => Load != null || SteadyVertices != null;

    /// <summary>Whether the interval between sync exchanges is constant, as in the paper.</summary>
    public bool HasConstantSyncInterval { get; init; }

    /// <summary>Whether the cell publishes its set-points ahead of time.</summary>
    public bool PublishesPlan { get; init; }

    public int Seed { get; init; }

    /// <summary>Whether the run is computed in virtual time, so that it depends only on the settings.</summary>
    public bool IsVirtual { get; init; }
}
