using Nowpose.Cli.Studies;

namespace Nowpose.Benchmarks.Comparison;

/// <summary>The conditions of the comparison. The numbers in their names are T_s and L in ms.</summary>
public static class ComparedMotions
{
    static readonly StudySettings Usual = new() { Phases = 4 };
    static readonly StudySettings Quick = Usual with { SamplingInterval = 0.020 };

    /// <summary>Seeds for tuning the competitors.</summary>
    public static IReadOnlyList<int> TuningSeeds { get; } = [4101, 4102, 4103];

    /// <summary>Seeds for the published results. They were not used for tuning.</summary>
    public static IReadOnlyList<int> CheckingSeeds { get; } = [5201, 5202, 5203];

    public static IReadOnlyList<ComparedMotion> All { get; } =
    [
        new("paper's swing, 50/100", _ => Motions.PaperSwing(30), Usual),
        new("fast moves, 50/100", seed => Motions.FastMoves(seed), Usual),
        new("– stamps wrong by up to ±5 ms", seed => Motions.FastMoves(seed), Usual with { StampError = 0.005 }),
        new("– positions with noise, sd 0.5 mm", seed => Motions.FastMoves(seed), Usual with { Noise = 0.5 }),
        new("– WiFi: delays of 62–180 ms, 1 % lost, some overtaken", seed => Motions.FastMoves(seed),
            Usual with { Latency = 0.060, DelayMedian = 0.012, Loss = 0.01 }),
        new("gentle pick and place, 50/100", seed => Motions.GentleMoves(seed), Usual),
        new("emergency stops, 50/100", seed => Motions.EmergencyStops(seed), Usual),
        new("waves that never rest, 50/100", seed => Motions.Waves(seed), Usual),
        new("cycles that repeat exactly, after 10 s, 50/100", seed => Motions.Repeats(seed, default), Usual with { WarmUp = 10 }),
        new("fast moves, 20/100", seed => Motions.FastMoves(seed), Quick),
        new("gentle pick and place, 20/100", seed => Motions.GentleMoves(seed), Quick),
    ];
}
