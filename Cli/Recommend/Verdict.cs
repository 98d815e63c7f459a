using Nowpose.Prediction;

namespace Nowpose.Cli.Recommend;

/// <summary>Which of the candidates to use under one condition.</summary>
/// <remarks>
/// Something else than the default is recommended only where it wins on both halves, and by more than nobody would notice: of
/// twenty candidates one is always luckier than the rest on the very file that it was chosen by.
/// </remarks>
sealed class Verdict
{
    /// <summary>Less is no reason to leave the default.</summary>
    public const double LeastGain = 0.02;

    /// <param name="subject">What they were tried on.</param>
    /// <param name="trials">The default and hold are among them.</param>
    public Verdict(ISubject subject, IReadOnlyCollection<Trial> trials)
    {
        Subject = subject;
        Trials = [.. trials.OrderBy(trial => trial.Rms)];
        Default = Trials.Single(trial => trial.Predictor == Predictors.Default);
        Recommended = Trials.FirstOrDefault(trial => IsBetter(trial, Default)) ?? Default;
    }

    /// <summary>Whoever errs so much more or less overall is told apart, whatever the halves say.</summary>
    const double GreatestTie = 0.5;

    public ISubject Subject { get; }

    /// <summary>The best one first.</summary>
    public IReadOnlyList<Trial> Trials { get; }

    public Trial Default { get; }

    public Trial Recommended { get; }

    /// <summary>Whether a candidate and the recommended one each win on one half: nobody can tell which is better.</summary>
    public bool IsTie(Trial trial) => trial != Recommended && Math.Abs(trial.GainOver(Recommended) ?? 0) < GreatestTie
        && trial.IsBetterThan(Recommended, Half.First) != trial.IsBetterThan(Recommended, Half.Second);

    /// <summary>In one sentence.</summary>
    public string Reason
    {
        get
        {
            var best = Trials[0];
            if (Recommended != Default)
                return FormattableString.Invariant($"errs {100 * Recommended.GainOver(Default):0} % less than {Default.Predictor} ")
                    + $"({Percent(Half.First)} and {Percent(Half.Second)} in the halves)";
            if (best == Default) return "no other errs less";
            return IsTie(best)
                ? $"{best.Predictor} is a tie: it wins on one half and loses on the other"
                : FormattableString.Invariant($"{best.Predictor} errs less, but by no more than {100 * LeastGain:0} %");
        }
    }

    static bool IsBetter(Trial trial, Trial standard) => trial.IsBetterThan(standard, Half.First) && trial.IsBetterThan(standard, Half.Second)
        && trial.GainOver(standard) > LeastGain;

    string Percent(Half half) => FormattableString.Invariant($"{100 * Recommended.GainOver(Default, half):0} %");
}
