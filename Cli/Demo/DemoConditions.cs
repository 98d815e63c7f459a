using System.Text.Json.Serialization;

namespace Nowpose.Cli.Demo;

/// <summary>The conditions of a demo run, as in result.json: the version of the program, and the main settings.</summary>
/// <param name="Time"><c>real</c> or <c>virtual</c>.</param>
/// <param name="NotIncluded">Parts of a real run that virtual time does not have; null in real time.</param>
/// <param name="VisuErrorMs">Assumed minus true display latency, ms; null if the headset calibrates the latency under load.</param>
sealed record DemoConditions(
    string Version, string Robot, string Motion, string Network, string Predictor, double BlendMs, string Estimator, double SamplingMs,
    double AcquisitionMinMs, double AcquisitionMaxMs, double VisuMs, double? VisuErrorMs, double Fps, int? LoadVertices, bool Trajectory,
    double Seconds, int Seed, string Time, [property: JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)] IReadOnlyList<string> NotIncluded)
{
    public static DemoConditions Of(DemoSettings settings) => new(
        ProgramVersion.Text, settings.Robot.Name, settings.MotionName, settings.Network.Name, settings.Predictor, settings.BlendMs,
        settings.Estimator, settings.SamplingMs, settings.Acquisition.Min, settings.Acquisition.Max, settings.VisualisationMs,
        settings.Load != null && settings.Profile == null ? null : settings.GivenVisualisationMs - settings.VisualisationMs,
        DemoDisplay.FramesPerSecond,
        settings.Load ?? settings.SteadyVertices, settings.PublishesPlan, settings.Seconds, settings.Seed,
        settings.IsVirtual ? "virtual" : "real", settings.IsVirtual ? DemoTexts.NotInVirtualTime : null);
}
