using Nowpose.Cli.Messages;
using Nowpose.Prediction;

namespace Nowpose.Cli.Recommend;

/// <summary>The recommended candidate under one condition.</summary>
/// <remarks>
/// Another predictor than the default is recommended only if it wins on both halves, and by a noticeable amount: of twenty candidates, one
/// always fits the given file best by chance.
/// </remarks>
sealed class Verdict
{
    /// <summary>Minimum gain for a recommendation other than the default.</summary>
    public const double MinGain = 0.02;

    /// <param name="subject">The subject on which the candidates were tried.</param>
    /// <param name="trials">The trials, including those of the default and of hold.</param>
    public Verdict(ISubject subject, IReadOnlyCollection<Trial> trials)
    {
        Subject = subject;
        Trials = [.. trials.OrderBy(trial => trial.Rms)];
        Default = Trials.Single(trial => trial.Predictor == Predictors.Default);
        Recommended = Trials.FirstOrDefault(trial => IsBetter(trial, Default)) ?? Default;
    }

    /// <summary>Maximum difference of a tie. Candidates with a larger overall difference never tie.</summary>
    const double MaxTieDifference = 0.5;

    public ISubject Subject { get; }

    /// <summary>The trials, the best first.</summary>
    public IReadOnlyList<Trial> Trials { get; }

    public Trial Default { get; }

    public Trial Recommended { get; }

    /// <summary>Whether a candidate and the recommended one each win on one half, so that the better one cannot be determined.</summary>
    public bool IsTie(Trial trial) => trial != Recommended && Math.Abs(trial.GainOver(Recommended) ?? 0) < MaxTieDifference
        && trial.IsBetterThan(Recommended, Half.First) != trial.IsBetterThan(Recommended, Half.Second);

    /// <summary>The reason in one sentence.</summary>
    public string Reason
    {
        get
        {
            var best = Trials[0];
            if (Recommended != Default)
                return RecommendTexts.SmallerError(100 * Recommended.GainOver(Default), Default.Predictor, Percent(Half.First), Percent(Half.Second));
            if (best == Default) return RecommendTexts.NoneBetter;
            return IsTie(best)
                ? RecommendTexts.EquallyGood(best.Predictor)
                : RecommendTexts.LittleBetter(best.Predictor, 100 * MinGain);
        }
    }

    static bool IsBetter(Trial trial, Trial standard) => trial.IsBetterThan(standard, Half.First) && trial.IsBetterThan(standard, Half.Second)
        && trial.GainOver(standard) > MinGain;

    string Percent(Half half) => FormattableString.Invariant($"{100 * Recommended.GainOver(Default, half):0} %");
}
