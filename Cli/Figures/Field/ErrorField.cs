using Nowpose.Cli.Studies;

namespace Nowpose.Cli.Figures.Field;

/// <summary>Computes the errors of hold and of all predictors for motions at constant velocity and the latencies of the paper.</summary>
sealed class ErrorField
{
    /// <summary>A sampling interval T_s that is negligible, s.</summary>
    const double Fresh = 0.0005;

    static readonly double[] SpeedsMmPerS = [100, 250, 500, 750, 1000];
    static readonly double[] LatenciesMs = [30, 50, 75, 100, 150, 200, 250];

    readonly FieldPoint[] _points = new FieldPoint[SpeedsMmPerS.Length * LatenciesMs.Length];

    public ErrorField(FigureSettings settings) => Work = [.. Enumerable.Range(0, _points.Length).Select(
        i => (Action)(() => _points[i] = Play(settings, SpeedsMmPerS[i / LatenciesMs.Length], LatenciesMs[i % LatenciesMs.Length])))];

    public static IReadOnlyList<string> Predicted { get; } = ["quadratic", .. FigureSettings.OurPredictors];

    public IReadOnlyList<Action> Work { get; }

    /// <summary>The points, sorted by speed and then by latency.</summary>
    public IReadOnlyList<FieldPoint> Points => _points;

    static FieldPoint Play(FigureSettings settings, double speed, double latencyMs)
    {
        var motion = new AxisMotion("constant velocity", 3, t => speed * t);
        var study = settings.Study with { Latency = latencyMs / 1000 };
        double Mean(StudySettings with, string predictor, Func<StudyFrame, double> error) => Enumerable.Range(0, with.Phases)
            .SelectMany(phase => PredictionStudy.Frames(motion, with, FigureSettings.Predictor(predictor), phase).Select(error)).Average();

        return new FieldPoint(speed, latencyMs,
            Mean(study with { SamplingInterval = Fresh, Phases = 1 }, "hold", f => f.Truth - f.Held),
            Mean(study, "hold", f => f.Truth - f.Held),
            [.. Predicted.Select(name => Mean(study, name, f => Math.Abs(f.Truth - f.Predicted)))]);
    }
}

/// <summary>Mean errors, mm, of an axis that moves at constant velocity.</summary>
/// <param name="FreshMm">Error of hold if each frame has a new sample.</param>
/// <param name="SampledMm">Error of hold at the paper's T_s.</param>
/// <param name="PredictedMm">Error of each predictor at the paper's T_s.</param>
sealed record FieldPoint(double SpeedMmPerS, double LatencyMs, double FreshMm, double SampledMm, IReadOnlyList<double> PredictedMm)
{
    /// <summary>Error by the paper's formula e = v·L, mm.</summary>
    public double FormulaMm => SpeedMmPerS * LatencyMs / 1000;
}
