using Nowpose.Prediction;

namespace Nowpose.Benchmarks.Ablation;

/// <summary>One motion under one condition.</summary>
/// <param name="Motion">For tables.</param>
/// <param name="Rms">Error of a predictor, of which it makes fresh ones, in the motion's unit.</param>
sealed record AblationRun(string Motion, Func<Func<JointPredictor>, double> Rms);
