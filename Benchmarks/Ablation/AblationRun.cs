using Nowpose.Prediction;

namespace Nowpose.Benchmarks.Ablation;

/// <summary>One motion under one condition.</summary>
/// <param name="Motion">Name of the motion for tables.</param>
/// <param name="Rms">Computes the error of a predictor from new instances, in the motion's unit.</param>
sealed record AblationRun(string Motion, Func<Func<JointPredictor>, double> Rms);
