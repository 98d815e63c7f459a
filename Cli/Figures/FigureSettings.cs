using Nowpose.Cli.Figures.Sweeps;
using Nowpose.Cli.Studies;
using Nowpose.Latency;
using Nowpose.Prediction;

namespace Nowpose.Cli.Figures;

/// <summary>Number and duration of the runs. All settings compute the same set of figures.</summary>
sealed record FigureSettings
{
    /// <summary>The predictors that are not in the paper. Must be declared before the settings below, whose initialisers use this list.</summary>
    public static IReadOnlyList<string> OurPredictors { get; } = ["adaptive", "gp"];

    public static readonly FigureSettings Full = new() { Phases = 32, ClockRuns = 32, ClockSeconds = 300 };

    public static readonly FigureSettings Quick = new() { Phases = 8, ClockRuns = 8, PicturesPerLoad = 5 };

    /// <summary>Number of runs with random phases of sampling and frames. The phase alone can change a ratio by 10 %.</summary>
    public required int Phases { get; init; }

    /// <summary>Number of simulated logs of sync exchanges.</summary>
    public required int ClockRuns { get; init; }

    /// <summary>Duration of each log of sync exchanges, s.</summary>
    public double ClockSeconds { get; init; } = 120;

    /// <summary>Duration of the paper's swing in the sweeps, s.</summary>
    public double SwingSeconds { get; init; } = 12;

    /// <summary>Limits of the swing in the sweeps.</summary>
    public MotionLimits Limits { get; init; } = MotionLimits.Default;

    /// <summary>Duration of the random moves in the sweeps, s.</summary>
    public double RandomSeconds { get; init; } = 30;

    public int Seed { get; init; } = 1;

    /// <summary>Number of pictures per load for measuring the L_visu of the swing's display.</summary>
    public int PicturesPerLoad { get; init; } = 20;

    /// <summary>Profile of the display for the swing. If null, the profile is measured.</summary>
    public LatencyProfile Profile { get; init; }

    /// <summary>Nowpose's predictors that the sweeps compare with the paper's: all or some of <see cref="OurPredictors"/>, or others.</summary>
    public IReadOnlyList<string> Ours { get; init; } = OurPredictors;

    /// <summary>Gets <see cref="OurPredictors"/> with a further predictor, unless the sweeps contain it anyway.</summary>
    /// <param name="predictor">Name of the predictor; null for none.</param>
    public static IReadOnlyList<string> With(string predictor) =>
        predictor == null ? OurPredictors : [.. OurPredictors.Append(predictor).Except([.. SweepStudy.OfThePaper, Predictors.Hold])];

    /// <summary>The paper's conditions: T_s 50 ms, L 100 ms, 60 frames per second.</summary>
    public StudySettings Study => new() { Phases = Phases, Seed = Seed };

    /// <summary>Creates a predictor without limits and horizon cap, as in the paper.</summary>
    public static JointPredictor Predictor(string name) => Predictors.Create(name, PredictionLimits.Unlimited);
}
