using Nowpose.Prediction;

namespace Nowpose.Benchmarks.Ablation;

/// <summary>One motion under one condition.</summary>
/// <param name="Names">Names of the errors in tables: one for a joint or several joints, two for the position and rotation of an object.</param>
/// <param name="Rms">Computes the RMS errors of a predictor, without the given parts if it is the default one, in the units of the motion.</param>
sealed record AblationRun(IReadOnlyList<string> Names, Func<string, PredictionParts, double[]> Rms);
