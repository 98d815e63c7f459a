using Nowpose.Gateway.Options;
using Nowpose.Kinematics;
using Nowpose.Motion;
using Nowpose.Simulation;

namespace Nowpose.Cli.Demo;

/// <summary>What one demo run is told; checked when it is made of the options.</summary>
sealed record DemoSettings
{
    public double Seconds { get; init; }
    public NetworkProfile Network { get; init; }
    public RobotModel Robot { get; init; }

    /// <summary>The robot's URDF, as the gateway publishes it.</summary>
    public string RobotText { get; init; }

    /// <summary>How the robot truly moves.</summary>
    public IMotion Motion { get; init; }

    /// <summary>What the report calls the motion.</summary>
    public string MotionName { get; init; }

    public string Predictor { get; init; }
    public double SamplingMs { get; init; }
    public MillisecondRange Acquisition { get; init; }
    public double VisualisationMs { get; init; }

    /// <summary>Added to the true display latency before the runtime is told.</summary>
    public double VisualisationErrorMs { get; init; }

    /// <summary>Vertices of the scene's load; null for a display whose frames never take long.</summary>
    public int? Load { get; init; }

    /// <summary>Whether the cell publishes its set-points ahead of time.</summary>
    public bool PublishesPlan { get; init; }

    public int Seed { get; init; }
}
