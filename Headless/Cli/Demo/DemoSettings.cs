using Nowpose.Gateway.Options;
using Nowpose.Kinematics;
using Nowpose.Simulation;

namespace Nowpose.Cli.Demo;

/// <summary>What one demo run is told; checked when it is made of the options.</summary>
/// <param name="Recording">File that the cell plays forth and back; null for its own cycle.</param>
/// <param name="VisualisationErrorMs">Added to the true display latency before the runtime is told.</param>
sealed record DemoSettings(
    double Seconds,
    NetworkProfile Network,
    RobotModel Robot,
    string RobotText,
    string Recording,
    string Predictor,
    double SamplingMs,
    MillisecondRange Acquisition,
    double VisualisationMs,
    double VisualisationErrorMs,
    int Seed,
    string OutputFolder);
