using Nowpose.Latency;
using Nowpose.Prediction;
using Nowpose.Studies;

namespace Nowpose.Cli.Figures;

/// <summary>Sets the number and length of the runs. All settings compute the same figures.</summary>
sealed record FigureSettings
{
    /// <summary>The predictors that are not in the paper. Declared before the settings below, which use it.</summary>
    public static IReadOnlyList<string> OurPredictors { get; } = ["adaptive", "gp"];

    public static readonly FigureSettings Full = new() { Phases = 32, ClockRuns = 32, ClockSeconds = 300 };

    public static readonly FigureSettings Quick = new() { Phases = 8, ClockRuns = 8, PicturesPerLoad = 5 };

    /// <summary>Number of runs with random phases of sampling and frames. The phase alone changes a ratio by a tenth.</summary>
    public required int Phases { get; init; }

    /// <summary>Number of simulated sync logs.</summary>
    public required int ClockRuns { get; init; }

    /// <summary>Length of each sync log, s.</summary>
    public double ClockSeconds { get; init; } = 120;

    /// <summary>Length of the paper's swing in the sweeps, s.</summary>
    public double SwingSeconds { get; init; } = 12;

    /// <summary>Length of the random moves in the sweeps, s.</summary>
    public double RandomSeconds { get; init; } = 30;

    public int Seed { get; init; } = 1;

    /// <summary>Number of pictures at each load from which the swing's L_visu is measured.</summary>
    public int PicturesPerLoad { get; init; } = 20;

    /// <summary>The profile of the swing's display; null to measure it.</summary>
    public LatencyProfile Profile { get; init; }

    /// <summary>The predictors of <see cref="OurPredictors"/> that the sweeps compare with the paper's.</summary>
    public IReadOnlyList<string> Ours { get; init; } = OurPredictors;

    /// <summary>The paper's conditions: T_s 50 ms, L 100 ms, 60 frames a second.</summary>
    public StudySettings Study => new() { Phases = Phases, Seed = Seed };

    /// <summary>Creates a predictor without limits and without a horizon cap, as in the paper.</summary>
    public static JointPredictor Predictor(string name) => Predictors.Create(name, PredictionLimits.Unlimited);
}
