using Nowpose.Prediction;

namespace Nowpose.Benchmarks.Ablation;

/// <summary>One motion under one condition.</summary>
/// <param name="Motion">Name of the motion in tables.</param>
/// <param name="Rms">Computes the RMS error in the motion's unit. Its argument creates new instances of the predictor.</param>
sealed record AblationRun(string Motion, Func<Func<JointPredictor>, double> Rms);
